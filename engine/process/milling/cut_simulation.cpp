// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/process/milling/cut_simulation.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "engine/core/random.h"

namespace kerf::milling {
namespace {

constexpr std::size_t kMostRevolutions = 200'000;

CutSummary summarise(const CutCase& cut, const std::vector<CutRow>& rows) {
    CutSummary summary;
    WallScan scan = cut.scan;
    scan.length_mm = cut.blank.end_mm();
    std::vector<double> x_mm;
    std::vector<double> y_mm;
    std::vector<double> feed_mmPerS;
    for (const CutRow& row : rows) {
        summary.peakForce_N = std::max(summary.peakForce_N, row.force_N);
        x_mm.push_back(row.x_mm);
        y_mm.push_back(row.deflectionY_mm);
        if (row.x_mm >= scan.from_mm) {
            feed_mmPerS.push_back(row.feedCommand_mmPerS);
        }
    }
    summary.time_s = static_cast<double>(rows.size()) * 60.0 / cut.spindle_rpm;
    summary.waviness = wallWaviness(x_mm, y_mm, scan);
    for (std::size_t i = 2; i < feed_mmPerS.size(); ++i) {
        summary.feedUnrest_mmPerS += std::abs(feed_mmPerS[i] - 2.0 * feed_mmPerS[i - 1] + feed_mmPerS[i - 2]) /
                                     static_cast<double>(feed_mmPerS.size() - 2);
    }
    summary.finished = !rows.empty() && rows.back().x_mm >= scan.length_mm;
    return summary;
}

/// The axis over one revolution: mean feed on the way to the one commanded.
class Axis {
 public:
    Axis(double lag_s, double revolution_s) {
        if (lag_s > 0.0) {
            m_decay = std::exp(-revolution_s / lag_s);
            m_share = lag_s / revolution_s * (1.0 - m_decay);
        }
    }
    double feed_mmPerS(double command_mmPerS) {
        const double off_mmPerS = m_feed_mmPerS - command_mmPerS;
        m_feed_mmPerS = command_mmPerS + off_mmPerS * m_decay;
        return command_mmPerS + off_mmPerS * m_share;
    }

 private:
    double m_feed_mmPerS{0.0};  ///< at the end of the revolution
    double m_decay{0.0}, m_share{0.0};
};

}  // namespace

CutResult simulateCut(const CutCase& cut) {
    const double revolution_s = 60.0 / cut.spindle_rpm;
    const BlankProfile blank = cut.fromAir_mm > 0.0 ? cut.blank.inAir(true, false) : cut.blank;
    FeedController controller(cut.controller, cut.law);
    if (cut.believedBlank) {
        controller.setBlank(*cut.believedBlank);
    }
    Random noise(cut.seed);
    CutResult result;
    RevolutionInput measured{0.0, 0.0, -cut.fromAir_mm, revolution_s};  // nothing cut yet
    RevolutionInput late = measured;
    RevolutionState tool;
    std::array<double, 3> forces_N{};  // newest first
    Axis axis(cut.axisLag_s, revolution_s);
    double x_mm = -cut.fromAir_mm;
    double pulseRest = 0.0;
    while (x_mm < blank.end_mm() && result.rows.size() < kMostRevolutions) {
        const FeedDecision decision = controller.update(cut.lag ? late : measured);
        late = measured;
        double feed_mmPerRev = axis.feed_mmPerS(decision.feed_mmPerS) * revolution_s;
        if (cut.wholePulses) {
            const double pulses = feed_mmPerRev / cut.pulse_mm + pulseRest;
            pulseRest = pulses - std::floor(pulses);
            feed_mmPerRev = std::floor(pulses) * cut.pulse_mm;
        }
        const double depth_mm = blank.engagedDepth_mm(x_mm, cut.plant.toolRadius_mm);
        tool = stepRevolution(cut.plant, depth_mm, tool.deflectionX_mm, feed_mmPerRev);
        x_mm += tool.cutFeed_mmPerRev;
        const double zero_N = cut.drift_NPerS * revolution_s * static_cast<double>(result.rows.size());
        std::shift_right(forces_N.begin(), forces_N.end(), 1);
        forces_N[0] = std::max(0.0, tool.forceY_N + zero_N + cut.forceNoise_N * noise.gauss());
        measured.force_N = forces_N[static_cast<std::size_t>(cut.forceLate_rev)];
        measured.feed_mmPerRev = feed_mmPerRev;
        measured.position_mm += feed_mmPerRev;
        result.rows.push_back({static_cast<int>(result.rows.size()), x_mm, depth_mm, decision.feed_mmPerS,
                               tool.cutFeed_mmPerRev, tool.forceY_N, *measured.force_N, tool.deflectionY_mm});
    }
    result.summary = summarise(cut, result.rows);
    return result;
}

}  // namespace kerf::milling
