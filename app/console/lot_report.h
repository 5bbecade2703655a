// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <functional>
#include <map>
#include <vector>

#include "app/service/quality/stored_quality_service.h"
#include "ui/units/unit_system.h"

namespace kerf::console {

/// The report of a lot as PDF: header, every characteristic with tolerance, verdicts and indices, residual and raw
/// chart, parts out of tolerance with what was done with them, corrections with old value, author and reason, signals,
/// gauges, a line to sign. The data it was made from is attached as DFQ and CSV. In the language of the program. Any
/// thread with fonts.
/// papers.firstArticle: the first part alone, each characteristic with what was found, without indices.
using AlarmSpecOf = std::function<const AlarmSpec*(AlarmCode)>;
[[nodiscard]] Result<void> writeLotReport(const QualityLot& lot, const LotPapers& papers, const ui::UnitSystem& units,
                                          const AlarmSpecOf& specOf, const QString& file);

/// Every value of the lot with limits and verdict, as attached to the report.
[[nodiscard]] std::string lotCsv(const QualityLot& lot);

}  // namespace kerf::console
