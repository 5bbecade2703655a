// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "engine/core/param_spec.h"
#include "engine/core/result.h"
#include "engine/core/subscription.h"
#include "engine/process/turning/turning_types.h"
#include "ui/services/lot_service.h"
#include "ui/services/recipe_history.h"

/// What happens to turned surfaces outside the cycle: the setup of the cut, spectra, margins, blind tones, the archive
/// of parts and the comparison of a cut without the loop with one under it. The page sees values; the service stores
/// first and then sends to the engine.
namespace kerf {

/// Amplitudes over frequency from 0 in equal steps; empty: no surface yet.
struct TurningSpectrum {
    double step_Hz{0.0};
    std::vector<float> treated_um{};    ///< of the surface as it is cut
    std::vector<float> untreated_um{};  ///< of the same surface without the trim
    [[nodiscard]] bool empty() const noexcept { return treated_um.empty(); }
};

/// A piece of the force along the face.
struct TurningForcePiece {
    double progress{0.0};  ///< its middle, 0…1
    double low_N{0.0};
    double mean_N{0.0};
    double high_N{0.0};
};

/// A finished part as it is archived.
struct TurningPartView {
    std::int64_t id{0};
    std::uint32_t number{0};
    std::int64_t endedUtc_ms{0};
    bool complete{false};
    double forceMean_N{0.0};
    double forcePeak_N{0.0};
    TurningRecord record{};
    TurningSpectrum spectrum{};
    std::vector<TurningForcePiece> force{};
    bool leftOut{false};          ///< of what the next part may begin from
    std::string leftOutReason{};  ///< why it was left out or taken in again …
    std::string leftOutAuthor{};  ///< … and by whom; empty: never
};

/// What the first part after a start begins from.
struct TurningMemoryView {
    std::optional<std::uint32_t> part{};  ///< whose process it is; empty: the assumed process
    std::uint32_t counted{0};             ///< parts of the same cut with a sure process among the last ones
};

/// A part without the loop and one under it, cut with the same setup; improvements in per cent of the open one.
struct TurningComparison {
    std::uint32_t openPart{0};
    std::uint32_t closedPart{0};
    TurningController controller{TurningController::Tones};
    double openRms_um{0.0};
    double closedRms_um{0.0};
    double openPv_um{0.0};
    double closedPv_um{0.0};
    double openForce_N{0.0};
    double closedForce_N{0.0};

    [[nodiscard]] double rms_percent() const noexcept { return 100.0 * (1.0 - closedRms_um / openRms_um); }
    [[nodiscard]] double pv_percent() const noexcept { return 100.0 * (1.0 - closedPv_um / openPv_um); }
    [[nodiscard]] double force_percent() const noexcept { return 100.0 * (closedForce_N / openForce_N - 1.0); }
};

/// What the loop tolerates before it oscillates, over the 95 % box of the identified process.
struct TurningMargins {
    bool known{false};             ///< false while nothing acts
    bool identified{false};        ///< else of the process the law is tuned to, by assumption
    std::optional<double> gain{};  ///< factor; empty: without limit
    double phase_deg{0.0};
    std::optional<double> delay_samples{};
    double modulus{0.0};  ///< smallest |1 + L|
};

struct TurningBlindTone {
    double frequency_Hz{0.0};
    double visibility{0.0};  ///< 0 blind to 2
    bool blind{false};
    bool found{false};  ///< by the loop, not among the machine's known tones
};
/// Which tones the force cannot see at a spindle speed, and a speed near it where it sees them all better.
struct TurningBlindView {
    double spindleSpeed_rpm{0.0};
    std::vector<TurningBlindTone> tones{};
    bool anyBlind{false};
    std::optional<double> suggestedSpeed_rpm{};  ///< empty: none within ±10 % is better
    double suggestedVisibility{0.0};
};

/// Everything the turning page shows that is not live. Rebuilt after each change.
struct TurningServiceView {
    std::uint64_t revision{0};  ///< rises with each change
    TurningSetup setup{};       ///< of the next part; revision 0: none yet
    double overlap{0.0};
    TurningController controller{TurningController::Tones};
    TurningSpectrum live{};     ///< of the part being cut, or of the last one
    std::uint32_t livePart{0};  ///< its place in the machine's own count
    TurningMargins margins{};
    TurningBlindView blind{};
    std::vector<TurningPartView> parts{};  ///< the last 25, oldest first
    std::optional<TurningComparison> comparison{};
    TurningMemoryView memory{};
    Sentence storeProblem{};  ///< empty when the database works
};

class TurningService {
 public:
    TurningService() = default;
    TurningService(const TurningService&) = delete;
    TurningService& operator=(const TurningService&) = delete;
    virtual ~TurningService() = default;

    [[nodiscard]] virtual const TurningServiceView& view() const = 0;
    /// The numbers of the setup sheet: depth, spindle speed, feed, tool radius, face from, face to, trim authority.
    [[nodiscard]] virtual std::span<const ParamSpec> setupSpecs() const = 0;
    [[nodiscard]] virtual const ParamSpec& toneSpec() const = 0;
    [[nodiscard]] virtual double setupValue(const TurningSetup& setup, std::size_t field) const = 0;
    virtual void changeSetup(TurningSetup& setup, std::size_t field, double value) const = 0;
    /// Empty: can be cut.
    [[nodiscard]] virtual std::optional<Sentence> whyUnusable(const TurningSetup& setup) const = 0;
    /// Overlap factor µ of tool radius, depth and feed per revolution, or why there is none.
    [[nodiscard]] virtual Result<double> overlap(double toolRadius_um, double depth_um, double feed_umPerRev) const = 0;

    /// Called on the caller's thread when the change is safely on disk (or has failed: the sentence says why).
    using Done = std::function<void(const Result<void>&)>;
    /// The revisions of the setup. Null: there is no store behind the service.
    [[nodiscard]] virtual RecipeHistory* recipes() { return nullptr; }
    /// The lots of turning. Null: there is no store behind the service.
    [[nodiscard]] virtual LotService* lots() { return nullptr; }
    /// The next part is cut with this setup. A larger trim authority is a limit: it wants a process engineer and a
    /// reason.
    virtual void loadSetup(const TurningSetup& setup, const std::string& author, const std::string& reason,
                           Done done) = 0;
    /// Another law, bumpless, also while cutting.
    virtual void setController(TurningController controller, const std::string& author, Done done) = 0;
    /// A part, by its id, that nothing shall begin from, or that counts again. Wants a reason. What the next part
    /// begins from is then computed again from the others, also where the loop has gone by that part until now. Between
    /// parts.
    virtual void leaveOut(std::int64_t part, bool out, const std::string& author, const std::string& reason,
                          Done done) = 0;

    /// `changed` runs on the GUI thread after every new view; the handle ends the subscription when destroyed.
    [[nodiscard]] virtual std::unique_ptr<Subscription> onChanged(std::function<void()> changed) = 0;
};

}  // namespace kerf
