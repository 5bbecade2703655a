// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include "db/api/rows.h"
#include "engine/core/result.h"
#include "ui/services/quality_service.h"
#include "ui/units/unit_system.h"

namespace kerf::console {

/// One page about one part, as PDF (A4): what it is, each characteristic with tolerance and verdict, the feed it was
/// cut with against its schedule, its figures, and every measurement with what became of it. Any thread. The file
/// appears under its name when it is whole; a file that is there is replaced.
/// `decided`: what was done with it, where it is out of tolerance.
[[nodiscard]] Result<void> writePartReport(const PartDetail& part, const std::vector<Characteristic>& characteristics,
                                           const std::optional<Disposition>& decided, const ui::UnitSystem& units,
                                           const QString& file);

}  // namespace kerf::console
