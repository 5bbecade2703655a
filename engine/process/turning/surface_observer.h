// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "engine/process/turning/cutting_process.h"
#include "engine/process/turning/revolution_buffer.h"

namespace kerf::turning {

/// Tool motion from the force alone (B2): û = F/P, with w the trim that acts,
///   m̂(k) = ρ·(m̂(k − d) − m̄/10) − (û + w(k − d) − w(k) − ū),  x̂_i = m̂ − w(k)
///
/// m̂ is the motion as it would be without the trim. The leak and ū act on it and not on x̂_i: inside the loop they would
/// be a high pass that lets the true motion drift away while x̂_i stays at zero. The force sees only the difference of
/// two revolutions; the sum over the revolutions gives the motion itself, relative to the surface before the cut, which
/// is taken as flat. Physics says that û has the depth d0 as its mean: so the mean ū of the first revolution (followed
/// slowly afterwards) stands for d0, and a wrong gain, a residual force or a drifting sensor does not pass for motion.
/// A force error stays in the sum, so the sum leaks: by ρ per revolution at the harmonics of the spindle (where force
/// alone is blind), and by a tenth per revolution at standstill (x̄ is the mean of the last revolution, here m̄). ready()
/// says when the first revolution is complete. Units µm and N. Source: Jeong & Kim, eqs. 3-5 with P of eq. 7 for the
/// bracket; mean and leak are ours.
class SurfaceObserver {
 public:
    static constexpr double kLeakPerRevolution = 0.9995;
    static constexpr double kMeanTaken = 0.1;
    static constexpr double kMeanShare = 2e-4;  ///< 1 s at 5 kHz
    SurfaceObserver(const ProcessParams& process, std::size_t revolutionSamples) noexcept
        : m_process(process),
          m_surface(revolutionSamples),
          m_trim(revolutionSamples),
          m_share(1.0 / static_cast<double>(revolutionSamples)) {}

    /// x̂_i of this sample, in which the trim `command_um` acts (0: the leak acts on x̂_i itself).
    double inner_um(double force_N, double command_um = 0.0) noexcept {
        m_chip_um = m_process.invert(force_N);
        const double untreated_um = m_chip_um + m_trim.oldest() - command_um;
        m_trim.push(command_um);
        if (m_seen < m_surface.samples()) {
            ++m_seen;
            m_mean_um += m_chip_um * m_share;
            m_surface.push(-m_chip_um);
            if (m_seen == m_surface.samples()) {
                m_surface.shift(m_mean_um);
            }
            return 0.0;
        }
        const double change_um = untreated_um - m_mean_um;
        m_mean_um += kMeanShare * change_um;
        const double before_um = m_surface.oldest();
        const double motion_um = kLeakPerRevolution * (before_um - kMeanTaken * m_sum_um * m_share) - change_um;
        m_sum_um += motion_um - before_um;
        m_surface.push(motion_um);
        m_motion_um = motion_um;
        m_inner_um = motion_um - command_um;
        return m_inner_um;
    }
    [[nodiscard]] bool ready() const noexcept { return m_seen == m_surface.samples(); }
    /// û of the last sample, and its mean.
    [[nodiscard]] double chip_um() const noexcept { return m_chip_um; }
    [[nodiscard]] double meanChip_um() const noexcept { return m_mean_um; }
    /// Another process explains the force: û and its mean change together, x̂_i goes on without a step.
    void setProcess(const ProcessParams& process) noexcept {
        m_mean_um *= m_process.params().dcGain() / process.dcGain();
        m_process.retune(process);
    }
    /// The last x̂_i is known better: the touch has left a mark in the sum that would come back with every revolution.
    void replaceLast(double inner_um) noexcept {
        const double more_um = inner_um - m_inner_um;
        m_sum_um += more_um;
        m_motion_um += more_um;
        m_surface.replaceNewest(m_motion_um);
        m_inner_um = inner_um;
    }
    /// Out of the cut: keeps the process's memory going, nothing else.
    void idle(double force_N) noexcept { m_chip_um = m_process.invert(force_N); }
    /// A new cut begins with the next sample; the process's memory stays.
    void beginCut() noexcept {
        m_surface.clear();
        m_trim.clear();
        m_sum_um = m_mean_um = 0.0;
        m_seen = 0;
    }

 private:
    CuttingProcess m_process;
    RevolutionBuffer m_surface;
    RevolutionBuffer m_trim;
    double m_share;
    double m_sum_um{0.0};
    double m_mean_um{0.0};
    double m_chip_um{0.0};
    double m_motion_um{0.0};
    double m_inner_um{0.0};
    std::size_t m_seen{0};
};

}  // namespace kerf::turning
