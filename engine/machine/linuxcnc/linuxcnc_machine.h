// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>

#include "engine/machine/linuxcnc/link_memory.h"
#include "engine/machine/linuxcnc/rsh_link.h"
#include "engine/machine/machine_port.h"

namespace kerf::linuxcnc {

/// A machine run by LinuxCNC. Signals come from the HAL bridge through shared memory, read in the cycle without locks;
/// commands go over linuxcncrsh on a thread of their own.
///
/// The link is up while the bridge's beat and the control's servo clock both move; either one still for 100 ms means it
/// is down, and the loops are held. When they move again the link is up by itself, and the limiter takes over what the
/// control reports, so that nothing jumps.
///
/// The part program tells where it is: M64 P0 while it cuts, M64 P1 when it has reached its end (docs/linuxcnc.md).
class LinuxCncMachine final : public MachinePort {
 public:
    struct Params {
        RshLink::Params rsh{};
        double maxFeedScale{1.0};    ///< 2.9 clips motion.adaptive-feed to 1; later versions allow MAX_FEED_OVERRIDE
        bool externalOffsets{true};  ///< OFFSET_AV_RATIO set in the ini
        double overhangAtZero_mm{40.0};  ///< boring: spindle overhang L where Z is at the program's start
    };
    explicit LinuxCncMachine(const Params& params);
    ~LinuxCncMachine() override;

    [[nodiscard]] Result<void> connect() override;
    void disconnect() noexcept override;
    [[nodiscard]] const Capabilities& capabilities() const noexcept override { return m_capabilities; }
    void read(std::int64_t now_ns, MachineInputs& inputs) noexcept override;
    void write(const MachineOutputs& outputs) noexcept override;
    /// linuxcncrsh answers (and, where asked, the machine has been prepared). Any thread.
    [[nodiscard]] bool commandsReady() const noexcept { return m_rsh != nullptr && m_rsh->connected(); }

 private:
    [[nodiscard]] bool watchLink(std::int64_t now_ns) noexcept;
    void followProgram() noexcept;

    Params m_params;
    Capabilities m_capabilities{};
    LinkMemory* m_memory{nullptr};
    std::unique_ptr<RshLink> m_rsh;
    FromControl m_seen{};
    std::int64_t m_lastBeat_ns{0};
    std::int64_t m_lastClock_ns{0};
    std::uint64_t m_beat{0};
    std::uint64_t m_outBeat{0};
    double m_clock_s{0.0};
    RequestReply m_reply{};
    std::uint32_t m_lastRequest{0};
    ProgramState m_program{ProgramState::Idle};
    ProcessId m_process{ProcessId::Boring};
    std::uint32_t m_partSequence{0};
    bool m_wasCutting{false};
    double m_startPosition_mm{0.0};
};

}  // namespace kerf::linuxcnc
