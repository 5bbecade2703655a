// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>

namespace kerf::ui {

/// Context of the help's texts in the translations.
struct Help {
    Q_DECLARE_TR_FUNCTIONS(Help)
};

}  // namespace kerf::ui
