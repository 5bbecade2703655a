// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "engine/machine/linuxcnc/link_memory.h"
#include "engine/machine/machine_port.h"

namespace kerf::linuxcnc {

/// One tapping cycle as the servo thread saw it: spindle and Z of every period, both from zero at its start, in.
///
/// G33.1 starts Z with a turning spindle, catches up with it above the work, and only from then on follows it: the
/// thread's phase is made there. So the angle that counts is the measured one while the tap is in the work, joined to
/// what the Z command asks before and after (θ = z_command / pitch), where no thread is cut. pitch·θ − z is then Z's
/// following error above the work, and the true error against the spindle in it.
class TapFollower {
 public:
    /// A new cycle: `pitch_mm` > 0, the work begins `runUp_mm` below the start.
    void arm(double pitch_mm, double runUp_mm) noexcept {
        m_pitch_mm = pitch_mm;
        m_runUp_mm = runUp_mm;
        m_started = false;
        m_inWork = false;
    }
    /// @pre armed. Z as the port reports it, down is negative; the angle rises into the hole.
    [[nodiscard]] ServoSample next(const ServoPeriod& period) noexcept {
        if (!m_started) {
            m_started = true;
            m_start_mm = period.zCommand_mm;
            m_offset_rev = 0.0;
        }
        const double asked_mm = m_start_mm - period.zCommand_mm;
        const bool inWork = asked_mm >= m_runUp_mm;
        if (inWork && !m_inWork) {
            m_joint_rev = asked_mm / m_pitch_mm + m_offset_rev - period.spindle_rev;
        } else if (!inWork && m_inWork) {
            m_offset_rev = m_last_rev + m_joint_rev - m_lastAsked_mm / m_pitch_mm;
        }
        m_inWork = inWork;
        m_last_rev = period.spindle_rev;
        m_lastAsked_mm = asked_mm;
        const double angle_rev = inWork ? period.spindle_rev + m_joint_rev : asked_mm / m_pitch_mm + m_offset_rev;
        return {angle_rev, period.z_mm};
    }

 private:
    double m_pitch_mm{1.0};
    double m_runUp_mm{0.0};
    double m_start_mm{0.0};
    double m_joint_rev{0.0};   ///< measured angle → angle that counts
    double m_offset_rev{0.0};  ///< command's angle → angle that counts, after the work
    double m_last_rev{0.0};
    double m_lastAsked_mm{0.0};
    bool m_started{false};
    bool m_inWork{false};
};

}  // namespace kerf::linuxcnc
