// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "engine/process/boring/estimator.h"
#include "engine/process/boring/feed_law.h"
#include "engine/process/boring/memory.h"
#include "engine/process/boring/plant.h"
#include "engine/process/boring/sigma_bank.h"

/// Simulated lots, part by part: cut, measure, estimate, next schedule. What `kerf boring simulate`, the tests and the
/// benchmark run; the laws in it are the console's.
namespace kerf::boring {

/// Who chooses the feed.
enum class FeedPolicy : std::uint8_t {
    Estimator,      ///< the estimator's law, part by part
    FixedFeed,      ///< the first feed for ever
    FrozenOptimum,  ///< the true optimum of part 1, then frozen
    ToldChanges,    ///< the Kalman filter, told with which parts the process changed
    ToldTruth,      ///< the true optimum of every part
};

struct CampaignParams {
    EstimatorParams estimator{};
    FeedLawParams feed{};
    FeedPolicy policy{FeedPolicy::Estimator};
    std::uint32_t parts{30};
    std::vector<double> measureAt_mm{40.0, 310.0};          ///< in measuring order, 1…kMaxBoreDepths
    std::vector<double> evaluateAt_mm{40.0, 175.0, 310.0};  ///< where the true bore decides over scrap
    double scrapBand_mm{3.0 * kTableSigma_mm};              ///< scrap when |d − d0| is above this anywhere
    double typoRate{0.0};                                   ///< share of entries that slip by a decade, up or down
    bool gated{true};        ///< implausible entries are measured again, and confirmed when they stay
    bool memory{false};      ///< a lot begins from the lots before it, an announced change from them and from the lot
    bool learnSigma{false};  ///< kalman only: σ is one of several candidates, by the evidence of the parts (SigmaBank)
    HardMachine hard{};      ///< what the shop floor adds; its truth counts when its seed is not 0
    bool temperatureEntered{true};  ///< a warm part's temperature is entered with its bores, ± .5 K, and corrected for
    double boreDiameter_mm{50.0};   ///< for that correction, 20 µm/m·K
    double phi_deg{kTablePhi_deg};
    bool teach{false};  ///< without a past, the feed varies along the first part, which is measured at three depths
    /// Standard normal noise instead of the random one; run, lot and part count from 1, depth by teachDepths_mm() in
    /// the first part that teaches, else by measureAt_mm.
    std::function<double(std::uint32_t run, std::uint32_t lot, std::uint32_t part, std::size_t depth)> noise{};
};

/// Where the first part is measured when it teaches: measureAt_mm, and the middle of the bore when that is fewer than
/// three depths.
[[nodiscard]] std::vector<double> teachDepths_mm(const CampaignParams& params);

/// Which lot of a machine's life is bored, and what is known when it begins.
struct LotPlace {
    std::uint32_t lot{1};
    std::span<const PastLot> past{};
    std::span<const AnnouncedChange> announced{};  ///< used with memory only
};

/// One row: a depth of a part that was measured or evaluated.
struct CampaignRow {
    std::uint32_t run{0};
    std::uint32_t lot{1};
    std::uint32_t part{0};
    double overhang_mm{0.0};
    bool measured{false};
    double feed_mmPerRev{0.0};
    double deflectionTrue_mm{0.0};
    double deflectionMeasured_mm{0.0};  ///< as entered; valid if measured
    RowOutcome outcome{};               ///< evaluated only: as after the part's last measurement
};

struct LotResult {
    std::vector<bool> scrap{};      ///< per part
    std::vector<bool> perturbed{};  ///< per part
    std::vector<double>
        feedError_percent{};             ///< per part: mean |S − S_opt(true)|/S_opt(true) over the evaluated depths
    std::vector<double> squaredError{};  ///< per part: mean of ((d − d0)/σ)² over the evaluated depths
    std::uint32_t asked{0};              ///< plausibility questions
    std::uint32_t askedWrongly{0};       ///< of them: the entry was right
    std::uint32_t entries{0};
    std::uint32_t refused{0};  ///< measured d ≤ 0: not used
    double sigmaFactor{1.0};   ///< with learnSigma: what the gauge's σ is taken to be at the end, of the assumed one
    bool unstable{false};      ///< the last ten parts are scrap although their best feed was within the range
    std::vector<Stretch> stretches{};  ///< with memory: what the lot leaves to the next ones
};

/// One lot. Random streams depend on seed, run and lot only, so two policies see the same noise. `sink` may be empty.
[[nodiscard]] LotResult simulateLot(const CampaignParams& params, const TruthPlan& truth, std::uint64_t seed,
                                    std::uint32_t run, const std::function<void(const CampaignRow&)>& sink = {},
                                    const LotPlace& place = {});

/// Mean over lots and half width of its 95 % interval.
struct Mean {
    double value{0.0};
    double half95{0.0};
};

struct CampaignSummary {
    Mean scrap{};  ///< scrapped parts per lot
    Mean scrapFromPart4{};
    double falseAlarm{0.0};                       ///< share of lots that perturbed between part 4 and the first change
    double detectionsPerLot{0.0};                 ///< all perturbations per lot
    double inBandFromPart4{0.0};                  ///< share of parts from 4 to the first change in band
    double steadyRms{0.0};                        ///< rms of (d − d0)/σ there
    std::vector<double> perturbedAfterChange{};   ///< per change: share of lots that perturbed before the next change
    std::vector<double> badPartsAfterChange{};    ///< per change: scrap before the next change, mean per lot
    std::vector<double> feedErrorMean_percent{};  ///< per part
    double asked{0.0};                            ///< questions per lot
    double askedWrongly{0.0};
    double refused{0.0};
    std::vector<double> scrapPerLot{};  ///< mean over runs, lot by lot
};

/// Adds up lots; each with the truth it had.
class CampaignTally {
 public:
    void add(const LotResult& lot, const TruthPlan& truth, std::uint32_t place = 1);
    [[nodiscard]] CampaignSummary summary() const;

 private:
    std::uint32_t m_lots{0};
    double m_scrap{0.0}, m_scrapSquared{0.0}, m_late{0.0}, m_lateSquared{0.0};
    double m_falseAlarms{0.0}, m_detections{0.0};
    double m_steadyParts{0.0}, m_steadyInBand{0.0}, m_steadySquares{0.0};
    double m_asked{0.0}, m_askedWrongly{0.0}, m_refused{0.0};
    std::vector<double> m_perturbed{}, m_bad{}, m_feedError_percent{}, m_scrapOfLot{};
    std::vector<std::uint32_t> m_runsOfLot{};
};

}  // namespace kerf::boring
