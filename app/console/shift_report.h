// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/console/lot_report.h"
#include "ui/services/shift_service.h"

namespace kerf::console {

/// One page: parts with verdicts, stops with reasons, what was changed by whom, alarms, notes, a line to sign. What
/// does not fit is counted, not printed. Any thread with fonts.
[[nodiscard]] Result<void> writeShiftReport(const ShiftView& shift, const ui::UnitSystem& units,
                                            const AlarmSpecOf& specOf, const QString& file);

}  // namespace kerf::console
