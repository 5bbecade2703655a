// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "db/api/room_records.h"
#include "ui/services/quality_service.h"

/// Gauges, their studies and what was done with bad parts, as room records keep them.
namespace kerf {

inline constexpr const char* kGaugeRecord = "gauge";              ///< subject: identity
inline constexpr const char* kStudyRecord = "gauge_study";        ///< subject: identity
inline constexpr const char* kDispositionRecord = "disposition";  ///< subject: the part's number in the data file

/// What was decided last about each part, of every process.
[[nodiscard]] std::map<PartId, Disposition> dispositionsIn(RoomRecordReader& records);

[[nodiscard]] std::string gaugeJson(const Gauge& gauge);
[[nodiscard]] std::optional<Gauge> gaugeFromJson(const std::string& text);
/// Empty when usable.
[[nodiscard]] std::optional<Sentence> whyInvalid(const Gauge& gauge);

/// What a study finds: the repeatability with its 95 % interval, and whether the gauge passes for the tolerance
/// (type 1: indices at least 1.33; crossed: at most 30 % of the tolerance).
struct StudyFinding {
    double sigma_mm{0.0};
    double low_mm{0.0};
    double high_mm{0.0};
    bool pass{false};
    std::optional<quality::TypeOneStudy> typeOne{};
    std::optional<quality::CrossedStudy> crossed{};
};
[[nodiscard]] Result<StudyFinding> findingOf(const GaugeStudyRecord& study, double ring_mm);
/// The repeatability and the figures of a study into the register. `study` with its author and time.
void takeOver(const GaugeStudyRecord& study, const StudyFinding& finding, Gauge& gauge);
/// With its readings and what was found, so that it can be computed again.
[[nodiscard]] std::string studyJson(const GaugeStudyRecord& study, const StudyFinding& finding);

}  // namespace kerf
