// SPDX-License-Identifier: GPL-3.0-or-later
// The cutting process that the law works with: identified while cutting, taken over when it has moved, recalled.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/process/turning/turning_loop.h"

namespace kerf {
namespace {

constexpr double kStartVariance = 1.0;  // of a1, b0, b1 at the start of a cut, over the noise
constexpr double kSureExcitation = 3.0;
constexpr double kSureHalf95 = 0.02;   // of b0, in N/µm as of b0 itself, and of a1
constexpr double kRetuneAbove = 0.05;  // mismatch of gain or phase that is worth a new tuning
constexpr int kMovedSamples = 500;     // .1 s in a row
constexpr double kFarthestRetune = 3.0;

/// How far two processes differ where the tones are: largest |P_a/P_b − 1| from 10 to 150 Hz.
double mismatch(const turning::ProcessParams& a, const turning::ProcessParams& b) noexcept {
    double worst = 0.0;
    for (const double frequency_Hz : {10.0, 50.0, 150.0}) {
        const double omega = 2.0 * std::numbers::pi * frequency_Hz / turning::kSampleRate_Hz;
        worst = std::max(worst, std::abs(a.response(omega) / b.response(omega) - 1.0));
    }
    return worst;
}

/// A gain further off is no wear but a fault.
bool tooFar(const turning::ProcessParams& process) noexcept {
    const double far = process.dcGain() / turning::ProcessParams{}.dcGain();
    return far > kFarthestRetune || far < 1.0 / kFarthestRetune;
}

}  // namespace

void TurningLoop::identify(double force_N, const MachineInputs& inputs) noexcept {
    TurningIdentification& shown = m_status.identification;
    shown.available = inputs.toolMotion_um.good();
    if (!shown.available) {
        return;
    }
    const double inner_um = inputs.toolMotion_um.value;
    // The build-up of the depth is no chip the model knows: from the second revolution on.
    const double chip_um = m_setup.depth_um + m_motion.oldest() - inner_um;
    if (m_cutSamples == m_motion.samples()) {
        m_identifier.start(m_process, kStartVariance, force_N, chip_um);
    } else if (m_cutSamples > m_motion.samples()) {
        m_identifier.update(force_N, chip_um);
    }
    m_motion.push(inner_um);
    const auto estimate = m_identifier.estimate();
    shown.value = {estimate.process.a1, estimate.process.b0, estimate.process.b1};
    shown.half95 = {estimate.half95[0], estimate.half95[1], estimate.half95[2]};
    shown.trace = m_identifier.trace();
    shown.excitation = m_identifier.excitation();
    shown.residual_N = m_identifier.residual_N();
    shown.sure = m_cutSamples > kReferenceAfter && shown.excitation > kSureExcitation &&
                 estimate.half95.maxCoeff() < kSureHalf95 && estimate.process.usable();
    const bool moved = shown.sure && mismatch(estimate.process, m_process) > kRetuneAbove;
    m_moved = moved ? m_moved + 1 : 0;
    if (m_moved >= kMovedSamples) {
        m_moved = 0;
        retune(estimate.process);
    }
}

/// The process has moved and the identification is sure of it: the law works with the new one, without a bump.
void TurningLoop::retune(const turning::ProcessParams& found) noexcept {
    if (tooFar(found)) {
        return;
    }
    m_process = found;
    m_control.setProcess(found);
    m_watch.reset(m_process);
    ++m_status.retuned;
    ++m_part.turning.retuned;
    m_status.lawProcess = {found.a1, found.b0, found.b1};
    m_status.forceTarget_N = found.dcGain() * m_setup.depth_um;
}

/// What the service has handed over since the last part.
void TurningLoop::recall() noexcept {
    if (m_exchange == nullptr || !m_exchange->recall.refresh()) {
        return;
    }
    const TurningRecall& kept = m_exchange->recall.value();
    const turning::ProcessParams process{kept.process.a1, kept.process.b0, kept.process.b1};
    if (kept.processKnown && process.usable() && !tooFar(process)) {
        m_process = process;
    } else if (kept.assumed) {
        m_process = {};
    }
}

}  // namespace kerf
