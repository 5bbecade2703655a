// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "engine/core/result.h"
#include "engine/process/thermal/thermal_types.h"
#include "engine/quality/verdict.h"
#include "ui/services/recipe_history.h"

/// Thermal models outside the engine's cycle: training on a worker, comparison, going live and back, gap-sensor
/// sessions, history. The page sees values. Drift and shift in µm, temperatures in °C, times in minutes of the machine.
namespace kerf {

/// A thermocouple and where it sits on the drawing of the machine.
struct ThermalSensorView {
    std::string name{};
    const char* place{""};    ///< KERF_TEXT: "front bearing"; empty: unknown
    std::string placeText{};  ///< as the machine's own sensor file says it, not translated
    double x{0.0};            ///< 0…1 over the drawing, left to right
    double y{0.0};            ///< 0…1, top to bottom
};

struct ThermalCoursePoint {
    double minutes{0.0};
    bool predicted{false};
    bool measured{false};
    std::array<float, kAxisCount> drift_um{};
    std::array<float, kAxisCount> half_um{};
    std::array<float, kAxisCount> shift_um{};
    std::array<float, kAxisCount> measured_um{};
};

/// How well a model does on days it has not seen.
struct ThermalJudgementView {
    std::string kind{};  ///< "gmdh-paper", "gmdh", "regression", "hierarchical"
    std::uint32_t sensors{0};
    bool heldOut{false};  ///< false: one day only, nothing could be left out
    std::array<double, kAxisCount> rms_um{};
    std::array<double, kAxisCount> worst_um{};
    bool chosen{false};
};

struct ThermalModelCard {
    std::uint32_t revision{0};  ///< 0: no model
    ThermalJudgementView judgement{};
    std::vector<std::string> sensors{};
    std::vector<std::string> formula{};
    std::vector<std::string> trainedOn{};
    std::uint32_t rows{0};
    std::int64_t createdUtc_ms{0};  ///< since when it is live
    std::string author{};
};

/// One day that can be trained on.
struct ThermalDayView {
    std::string id{};  ///< "file:…", "session:…", "built-in:…"
    std::string label{};
    std::uint32_t rows{0};  ///< 0: not known before it is read
    bool leftOut{false};    ///< not to be trained on
    std::string leftOutReason{};
    std::string leftOutAuthor{};
};

enum class TrainingState : std::uint8_t { Idle, Running, Ready, Failed, Cancelled };
struct ThermalTrainingView {
    TrainingState state{TrainingState::Idle};
    double progress{0.0};
    std::vector<ThermalJudgementView> compared{};
    ThermalModelCard candidate{};  ///< of Ready
    Sentence problem{};            ///< of Failed
    std::string detail{};  ///< of Failed: file, line and column as read; of Ready: what was left out; not translated
};

struct ThermalShiftRow {
    std::int64_t utc_ms{0};
    double minutes{0.0};
    std::array<double, kAxisCount> shift_um{};
    std::array<double, kAxisCount> drift_um{};
};
struct ThermalGapRow {
    std::int64_t utc_ms{0};
    std::array<double, kAxisCount> measured_um{};
    std::array<double, kAxisCount> predicted_um{};
    std::array<double, kAxisCount> half_um{};
    bool predictionKnown{false};
    bool byPart{false};                                      ///< from a part, not from the gap sensors
    std::array<bool, kAxisCount> known{{true, true, true}};  ///< axes measured
    /// What a part cut then shows of it: drift and shift together, against what the part allows in the recipe.
    std::array<double, kAxisCount> left_um{};
    bool leftKnown{false};   ///< the control's shift was readable
    double allowed_um{0.0};  ///< 0: not kept (measured by a version before)

    /// Good when every measured axis is within ± allowed_um.
    [[nodiscard]] quality::Verdict verdict(std::size_t axis) const noexcept {
        const bool judged = leftKnown && allowed_um > 0.0 && known[axis];
        return quality::judge(judged ? std::optional(left_um[axis]) : std::nullopt,
                              {-allowed_um, allowed_um, quality::ReworkSide::None});
    }
};

struct ThermalSessionView {
    bool recording{false};
    std::uint32_t rows{0};  ///< measured minutes so far
    Sentence whyNotKept{};  ///< not empty: as it stands the session cannot be trained on
};

/// Error of the cutting point over one plane of the work space, from the machine's error elements.
struct ThermalErrorMap {
    bool known{false};
    std::array<std::pair<double, double>, kAxisCount> range_mm{};
    std::uint32_t columns{0};                                ///< over X
    std::uint32_t rows{0};                                   ///< over Y
    std::vector<std::array<double, kAxisCount>> error_um{};  ///< row by row
};

struct ThermalServiceView {
    std::uint64_t revision{0};  ///< rises with each change
    std::vector<ThermalSensorView> sensors{};
    std::vector<ThermalCoursePoint> course{};  ///< since the baseline
    ThermalModelCard live{};
    bool canRollBack{false};
    ThermalTrainingView training{};
    std::vector<ThermalShiftRow> shifts{};  ///< newest first
    std::vector<ThermalGapRow> gaps{};      ///< newest first
    ThermalSessionView session{};
    std::vector<ThermalDayView> days{};
    ThermalSetup setup{};
    std::string dayFolder{};  ///< where history files are looked for
    Sentence storeProblem{};
};

class ThermalService {
 public:
    ThermalService() = default;
    ThermalService(const ThermalService&) = delete;
    ThermalService& operator=(const ThermalService&) = delete;
    virtual ~ThermalService() = default;

    [[nodiscard]] virtual const ThermalServiceView& view() const = 0;
    /// Readings of one thermocouple since the baseline: minutes and °C.
    [[nodiscard]] virtual std::vector<std::pair<double, double>> temperatures(std::size_t sensor) const = 0;
    /// First-order error over the plane at this Z, or exact.
    [[nodiscard]] virtual ThermalErrorMap errorMap(double z_mm, bool exact) const = 0;

    /// Look again for days to train on.
    virtual void findDays() = 0;
    /// On a worker; `kind` is "auto", "hierarchical", "regression" or "gmdh". Refused while one runs, without a day,
    /// and with one that is left out.
    [[nodiscard]] virtual Result<void> train(const std::string& kind, const std::vector<std::string>& dayIds) = 0;
    virtual void cancelTraining() = 0;
    /// Leave a day out of what models are trained on, or take it in again, for a reason that is kept beside it.
    virtual void leaveOut(const std::string& dayId, bool out, const std::string& author, const std::string& reason,
                          RecipeHistory::Done done) = 0;
    /// The trained candidate is stored, then takes the live one's place between two cycles.
    [[nodiscard]] virtual Result<void> goLive(const std::string& author) = 0;
    /// The model that was live before.
    [[nodiscard]] virtual Result<void> rollBack(const std::string& author) = 0;
    /// The revisions of the limits. Null: there is no store behind the service.
    [[nodiscard]] virtual RecipeHistory* recipes() { return nullptr; }
    /// As a revision of the recipe; `done` as in RecipeHistory, with every no on the way.
    virtual void changeSetup(const ThermalSetup& setup, const std::string& author, const std::string& reason,
                             RecipeHistory::Done done) = 0;
    /// The part finished last has been measured: deviation of its surface along +axis; a diameter counts half. Empty:
    /// not measured. It is a measurement of the origin made when the part was finished.
    [[nodiscard]] virtual Result<void> measureByPart(const std::array<std::optional<double>, kAxisCount>& deviation_um,
                                                     const std::string& author) = 0;
    /// Gap-sensor session: from a new reference on every minute is measured, until it ends and is kept as a day.
    [[nodiscard]] virtual Result<void> beginSession(const std::string& author) = 0;
    [[nodiscard]] virtual Result<void> endSession(const std::string& author) = 0;
    /// Look for news of engine and worker; `view().revision` rises when there are any. On a timer of the GUI thread.
    virtual void poll() = 0;
};

}  // namespace kerf
