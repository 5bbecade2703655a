// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractButton>
#include <QPointer>
#include <QTest>

namespace kerf::test {

/// Touches it as a person does. A save on its way rests its button, and once taken it closes the sheet: who has touched
/// one looks what came of it before touching anything else.
inline void touchAndWait(QAbstractButton* button) {
    const QPointer<QAbstractButton> touched(button);
    QTest::mouseClick(button, Qt::LeftButton);
    (void)QTest::qWaitFor(
        [&] {
            const QAbstractButton* still = touched.data();
            return still == nullptr || still->isHidden() || still->isEnabled();
        },
        1000);
}

}  // namespace kerf::test
