// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>

#include "engine/machine/linuxcnc/link_memory.h"
#include "engine/port/machine_port.h"

namespace kerf::linuxcnc {

/// One tapping cycle as the servo thread saw it: spindle and Z of every period, both from zero at its start, in.
///
/// G33.1 starts Z with a turning spindle, catches up with it above the work, and only from then on follows it: the
/// thread's phase is made there. So the angle that counts is the measured one while the tap is in the work, joined to
/// what the Z command says before and after, where no thread is cut: θ(n) = z_command(n + 2) / pitch, since motion
/// reads the spindle of the last period and its command is the one of the next. pitch·θ − z is then the true error
/// against the spindle in the work, and what it would be above it.
class TapFollower {
 public:
    static constexpr std::size_t kDelay = 2;  ///< servo periods from the spindle's angle to the Z command

    /// A new cycle: `pitch_mm` > 0, the work begins `runUp_mm` below the start.
    void arm(double pitch_mm, double runUp_mm) noexcept {
        *this = TapFollower{};
        m_pitch_mm = pitch_mm;
        m_runUp_mm = runUp_mm;
    }
    /// The sample two periods ago, when there is one. @pre armed. Z as the port reports it, down is negative; the angle
    /// rises into the hole.
    [[nodiscard]] bool next(const ServoPeriod& period, ServoSample& sample) noexcept {
        if (m_count == 0) {
            m_start_mm = period.zCommand_mm;
        }
        const ServoPeriod then = m_last[m_count % kDelay];
        m_last[m_count % kDelay] = period;
        if (m_count++ < kDelay) {
            return false;
        }
        const double asked_mm = m_start_mm - period.zCommand_mm;
        const bool inWork = asked_mm >= m_runUp_mm;
        if (inWork && !m_inWork) {
            m_joint_rev = asked_mm / m_pitch_mm + m_offset_rev - then.spindle_rev;
        } else if (!inWork && m_inWork) {
            m_offset_rev = m_before_rev + m_joint_rev - m_asked_mm / m_pitch_mm;
        }
        m_inWork = inWork;
        m_before_rev = then.spindle_rev;
        m_asked_mm = asked_mm;
        sample.spindle_rev = inWork ? then.spindle_rev + m_joint_rev : asked_mm / m_pitch_mm + m_offset_rev;
        sample.z_mm = then.z_mm;
        return true;
    }

 private:
    double m_pitch_mm{1.0};
    double m_runUp_mm{0.0};
    double m_start_mm{0.0};
    double m_joint_rev{0.0};   ///< measured angle → angle that counts
    double m_offset_rev{0.0};  ///< command's angle → angle that counts, after the work
    double m_before_rev{0.0};
    double m_asked_mm{0.0};
    std::array<ServoPeriod, kDelay> m_last{};
    std::size_t m_count{0};
    bool m_inWork{false};
};

}  // namespace kerf::linuxcnc
