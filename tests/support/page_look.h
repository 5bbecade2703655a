// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QMetaType>
#include <QSize>
#include <QTest>

#include "ui/theme/look.h"

namespace kerf::test {

/// One way in which a page is looked at for text that does not fit.
struct PageLook {
    QSize size{};
    double scale{1.0};
    bool korean{false};
    bool full{false};  ///< with work on it, else as after the first start
    bool inch{false};

    [[nodiscard]] ui::Preferences preferences() const {
        ui::Preferences chosen;
        chosen.scale = scale;
        chosen.language = korean ? ui::Language::Korean : ui::Language::English;
        chosen.brightness = korean != full ? ui::Brightness::Dark : ui::Brightness::Light;
        chosen.length = inch ? ui::LengthUnit::Inch : ui::LengthUnit::Millimetre;
        return chosen;
    }
};

/// Rows of a test function's data in column "look": both languages, empty and full, both units, three screens. `small`
/// and `middle`: what the shell leaves a page at 1280 × 800 and 1920 × 1080.
inline void addPageLooks(QSize small, QSize middle) {
    QTest::addColumn<PageLook>("look");
    for (const bool korean : {false, true}) {
        const char* language = korean ? "ko" : "en";
        for (const bool full : {false, true}) {
            const char* state = full ? "full" : "empty";
            QTest::addRow("1280x800_%s_%s", language, state) << PageLook{small, 1.0, korean, full, false};
            QTest::addRow("1920x1080_%s_%s", language, state) << PageLook{middle, 1.0, korean, full, true};
        }
        QTest::addRow("1280x800_%s_inch", language) << PageLook{small, 1.0, korean, true, true};
        QTest::addRow("3840x2160_%s_x2", language) << PageLook{2 * middle, 2.0, korean, true, false};
    }
}

}  // namespace kerf::test

Q_DECLARE_METATYPE(kerf::test::PageLook)
