// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include "ui/services/shift_service.h"

namespace kerf::ui {

/// Why nothing was cut, as offered to a touch: keys of stopReasonText().
[[nodiscard]] const std::vector<std::string>& stopReasons();
[[nodiscard]] QString stopReasonText(const std::string& key);
/// "12 made: 10 good, 1 rework, 1 scrap; 48 min in the cut"
[[nodiscard]] QString shiftPartsText(const ShiftParts& parts);
[[nodiscard]] QString shiftSavingText(const ShiftSaving& saving);
/// What was changed, in one line: the words of the log, old and new value, reason.
[[nodiscard]] QString changeText(const ShiftChange& change);

}  // namespace kerf::ui
