// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/core/result.h"
#include "engine/core/subscription.h"
#include "engine/process/boring/boring_types.h"

/// What happens to bore measurements outside the cycle: the lot's parts, the entry gate, the estimator, the next
/// schedule. The page sees values; the service stores first, then accepts, then sends the new schedule to the engine.
namespace kerf {

using PartId = std::int64_t;
using MeasurementId = std::int64_t;

/// One diameter typed or gauged by the operator.
struct BoreEntry {
    PartId part{0};
    std::uint8_t depth{0};  ///< index into BoringServiceView::depths
    double diameter_mm{0.0};
    std::string author{};  ///< operator signed on
    bool fromGauge{false};
    bool confirmed{false};  ///< the operator answered "yes, it is so" to the plausibility question
    std::string gauge{};    ///< from a gauge: its identity in the register; empty: not known
};

/// Another value in the place of a stored one.
struct BoreCorrection {
    MeasurementId id{0};
    double diameter_mm{0.0};
    std::string author{};
    std::string reason{};
    bool fromGauge{false};
    bool confirmed{false};  ///< the operator answered "yes, it is so" to the plausibility question
    std::string gauge{};    ///< from a gauge: its identity in the register; empty: not known
};

/// Diameters as a file has them; nothing is decided yet.
struct ReadBore {
    std::uint32_t line{0};
    std::uint32_t part{0};                ///< number in the lot
    std::optional<double> overhang_mm{};  ///< empty: the file names no place
    double diameter_mm{0.0};
};
struct ReadBores {
    std::string file{};                ///< its name, without the folder; kept with each value
    std::vector<ReadBore> rows{};      ///< as they stand
    std::vector<std::string> notes{};  ///< what was found out rather than known, in English
    std::string problem{};             ///< not empty: it cannot be read, and why, in English
};

/// What taking a file over would do. Nothing of it is taken while one row is refused.
struct BoreImportPlan {
    struct Row {
        std::uint32_t line{0};
        std::uint32_t partNumber{0};
        PartId part{0};
        std::uint8_t depth{0};
        double diameter_mm{0.0};
        bool asked{false};  ///< implausible: it needs a person's yes
    };
    struct Finding {
        std::uint32_t line{0};
        Sentence reason{};
    };
    std::vector<Row> rows{};           ///< by part, then depth, in the order in which they would be accepted
    std::uint32_t known{0};            ///< rows whose value is stored already
    std::vector<Finding> questions{};  ///< as the entry gate asks them
    std::optional<Finding> refused{};  ///< the first row that cannot be
};

/// Verdict of the entry gate, before anything is stored.
enum class EntryVerdict : std::uint8_t {
    Accept,
    Ask,     ///< implausible: measure again or confirm (|ln(d/d_predicted)| above the gate)
    Refuse,  ///< impossible: nothing stored, nothing updated
};
struct EntryCheck {
    EntryVerdict verdict{EntryVerdict::Refuse};
    Sentence reason{};  ///< for Ask and Refuse
};

/// A diameter with its 95 % interval.
struct DiameterPrediction {
    double diameter_mm{0.0};
    double half95_mm{0.0};
};

struct BoreMeasurementView {
    MeasurementId id{0};
    std::uint8_t depth{0};
    double diameter_mm{0.0};
    bool voided{false};
    bool corrected{false};  ///< has replaced an older value
};

struct BorePartView {
    PartId id{0};
    std::uint32_t number{0};  ///< 1-based within the lot
    bool cut{false};
    bool complete{false};  ///< every depth measured
    BoringSchedule schedule{};
    FeedTrace feed{};
    std::vector<BoreMeasurementView> measurements{};
    std::vector<std::optional<DiameterPrediction>> predicted{};  ///< per depth, as made before the cut
    bool perturbed{false};  ///< the estimator noticed a process change with this part
    Sentence perturbedReason{};
};

/// Estimate after one part: value and half width of the 95 % interval.
struct EstimateView {
    std::uint32_t part{0};
    std::array<double, 3> value{};  ///< ln C, α, β
    std::array<double, 3> half95{};
};

struct DepthView {
    std::string name{};  ///< "top", "bottom", "middle" or a number; translated by the screen
    double overhang_mm{0.0};
};

/// How well the bores shown lie in their tolerance: the depth that does worst.
struct CapabilityView {
    static constexpr std::uint32_t kFewestParts = 10;  ///< below it the figure says nothing
    double cpk{0.0};                                   ///< min(upper − mean, mean − lower)/(3 s), s with n − 1
    std::uint8_t depth{0};
    std::uint32_t parts{0};
};

/// What an operator can announce between two parts.
enum class BoringChange : std::uint8_t {
    Insert,    ///< new insert or tool
    Reground,  ///< tool reground or set anew
    Material,  ///< other batch of material
};

/// Everything the boring page shows that is not live. Rebuilt after each change; cheap to copy (25 parts).
struct BoringServiceView {
    std::uint64_t revision{0};  ///< rises with each change
    std::string partType{};
    std::string lot{};
    std::uint32_t lotSize{0};         ///< 0: no limit
    bool lotClosed{false};            ///< no part is started for it any more
    std::uint32_t recipeRevision{0};  ///< of the part type, taken when the lot was opened
    double targetDiameter_mm{0.0};
    double settingRing_mm{0.0};     ///< of a comparator gauge; 0: the gauge shows diameters
    double lowerTolerance_mm{0.0};  ///< diameter, absolute
    double upperTolerance_mm{0.0};
    std::vector<DepthView> depths{};
    std::vector<BorePartView> parts{};      ///< the last parts of the lot, oldest first
    std::vector<EstimateView> estimates{};  ///< over the parts of the lot
    BoringSchedule nextSchedule{};
    std::vector<std::optional<DiameterPrediction>> nextPrediction{};  ///< per depth
    Sentence nextReason{};                                            ///< why the schedule changed
    Sentence nextRestsOn{};                      ///< what the expected diameters rest on; empty before there are any
    std::optional<BoringChange> announced{};     ///< for the next part
    bool nextLimited{false};                     ///< α clipped or feed at a limit
    bool scheduleAccepted{true};                 ///< advise mode: the operator has yet to accept nextSchedule
    std::optional<CapabilityView> capability{};  ///< over `parts`; empty while there are too few
    std::optional<PartId> awaiting{};            ///< the oldest part that still wants a diameter
    std::uint8_t awaitingDepth{0};
    std::string estimator{};  ///< "kalman" or "perturbation"
    Sentence storeProblem{};  ///< empty when the database works
};

/// Every part of the lot has been cut.
[[nodiscard]] inline bool lotFull(const BoringServiceView& view) noexcept {
    return view.lotSize > 0 && !view.parts.empty() && view.parts.back().number >= view.lotSize;
}

class BoringService {
 public:
    BoringService() = default;
    BoringService(const BoringService&) = delete;
    BoringService& operator=(const BoringService&) = delete;
    virtual ~BoringService() = default;

    [[nodiscard]] virtual const BoringServiceView& view() const = 0;
    [[nodiscard]] virtual EntryCheck check(const BoreEntry& entry) const = 0;

    /// Called on the caller's thread when the change is safely on disk (or has failed: the sentence says why).
    using Done = std::function<void(const Result<void>&)>;
    virtual void enter(const BoreEntry& entry, Done done) = 0;
    /// What the gate says of a file's values, each as if the ones before it were entered already.
    [[nodiscard]] virtual BoreImportPlan planImport(const ReadBores&) const { return {}; }
    /// All of them or none. `confirmed`: the operator has answered "yes" to every question of the plan.
    virtual void importBores(const ReadBores&, const std::string& /*author*/, bool /*confirmed*/, Done done) {
        done(fail(KERF_TEXT("This console takes no files of diameters.")));
    }
    /// Replace or void a measurement; the old value stays on record. Reason and author must not be empty.
    virtual void correct(MeasurementId id, double diameter_mm, const std::string& author, const std::string& reason,
                         Done done) = 0;
    /// The same question as for a first entry.
    [[nodiscard]] virtual EntryCheck checkCorrection(MeasurementId, double) const { return {EntryVerdict::Accept, {}}; }
    /// Refused while its question is not answered. The source is kept with the value.
    virtual void correctValue(const BoreCorrection& correction, Done done) {
        correct(correction.id, correction.diameter_mm, correction.author, correction.reason, std::move(done));
    }
    virtual void voidMeasurement(MeasurementId id, const std::string& author, const std::string& reason, Done done) = 0;
    /// Void the newest measurement of the lot ("undo last").
    virtual void undoLast(const std::string& author, Done done) = 0;
    /// Advise mode: use the proposed schedule for the next part.
    virtual void acceptSchedule(const std::string& author, Done done) = 0;
    /// The next part is cut with something new: its expectation widens to what such changes have brought before.
    virtual void announceChange(BoringChange change, const std::string& author, Done done) = 0;
    /// Takes back what was announced for the next part.
    virtual void withdrawChange(const std::string& author, Done done) = 0;
    /// A reading of the machine's own gauge for this part and depth; empty when no gauge is fitted.
    [[nodiscard]] virtual std::optional<double> gaugeReading_mm(PartId part, std::uint8_t depth) = 0;
    /// `changed` runs on the GUI thread after every new view; the handle ends the subscription when destroyed.
    [[nodiscard]] virtual std::unique_ptr<Subscription> onChanged(std::function<void()> changed) = 0;
};

}  // namespace kerf
