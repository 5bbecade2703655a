// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <atomic>
#include <memory>
#include <optional>
#include <string>

#include "engine/machine/linuxcnc/force_samples.h"
#include "engine/machine/linuxcnc/link_memory.h"
#include "engine/machine/linuxcnc/rsh_link.h"
#include "engine/machine/linuxcnc/shared_link.h"
#include "engine/machine/linuxcnc/shift_word_answer.h"
#include "engine/machine/linuxcnc/simulated_force.h"
#include "engine/machine/linuxcnc/tap_follower.h"
#include "engine/port/machine_description.h"
#include "engine/port/machine_port.h"

namespace kerf::linuxcnc {

/// A machine run by LinuxCNC. Signals come from the HAL bridge through shared memory, read in the cycle without locks;
/// commands go over linuxcncrsh on a thread of their own.
///
/// The link is up while the bridge's beat and the control's servo thread both move; either one still for 100 ms means
/// it is down, and the loops are held. LinuxCNC need not be there when the console starts, and may be restarted: when
/// the two move again the link is up by itself, and the limiter takes over what the control reports, so that nothing
/// jumps.
///
/// The part program tells where it is: M62 P0 while it cuts, M62 P1 when it has reached its end (docs/linuxcnc.md).
/// Tapping and the force are recorded in every servo period; a cycle that came late loses none of them: what does not
/// fit into one cycle comes with the next.
class LinuxCncMachine final : public MachinePort {
 public:
    struct Params {
        MachineDescription described{};
        RshLink::Params rsh{};
        double spindleKp_perS{40.0};  ///< the control has none that can be set: what the gains of a pair are told with
    };
    explicit LinuxCncMachine(const Params& params);
    ~LinuxCncMachine() override;

    /// Succeeds without LinuxCNC: the link is down until it appears.
    [[nodiscard]] Result<void> connect() override;
    void disconnect() noexcept override;
    void onlyRead() noexcept override { m_onlyRead = true; }
    [[nodiscard]] Result<void> endOtherClaim() override;
    /// This program commands the machine. Any thread that does not run beside connect().
    [[nodiscard]] bool commands() const noexcept { return m_mine; }
    [[nodiscard]] const Capabilities& capabilities() const noexcept override {
        return m_capabilities[m_current.load(std::memory_order_acquire)];
    }
    void read(std::int64_t now_ns, MachineInputs& inputs) noexcept override;
    void write(const MachineOutputs& outputs) noexcept override;
    /// linuxcncrsh answers. Any thread.
    [[nodiscard]] bool commandsReady() const noexcept { return m_rsh != nullptr && m_rsh->connected(); }
    /// … or the bridge itself takes commands, without a network. Any thread.
    [[nodiscard]] bool commandsOverBridge() const noexcept { return m_rsh != nullptr && m_rsh->overBridge(); }
    /// A bridge is there. Any thread.
    [[nodiscard]] bool reached() const noexcept { return m_fittedKnown.load(std::memory_order_acquire); }

 private:
    static constexpr std::size_t kMachinesSeen = 32;

    void meet(LinkMemory* memory) noexcept;
    void waitForBeat() const;
    [[nodiscard]] bool watchLink(std::int64_t now_ns) noexcept;
    void adoptFitted(const Fitted& fitted) noexcept;
    void watchOwner() noexcept;
    [[nodiscard]] Sentence whyNotOurs() const noexcept;
    void watchStart(std::int64_t now_ns) noexcept;
    void followDeclaration() noexcept;
    [[nodiscard]] Reading overhang_mm(Quality quality) const noexcept;
    void followProgram(MachineInputs& inputs) noexcept;
    void begin(ProgramState state) noexcept;
    void followTap(MachineInputs& inputs) noexcept;
    void takeReplies(std::int64_t now_ns) noexcept;
    void fillGains(MachineInputs& inputs, Quality quality) const noexcept;
    void answer(std::uint32_t number, RequestState state, const Sentence& reason = {}) noexcept;
    void carryOut(const PortRequest& request) noexcept;
    void setGains(const PortRequest& request, const ServoGains& gains) noexcept;
    void shiftOrigin(const MachineOutputs& outputs) noexcept;
    [[nodiscard]] bool running() const noexcept {
        return m_program == ProgramState::Running || m_program == ProgramState::Paused;
    }

    Params m_params;
    std::array<Capabilities, kMachinesSeen> m_capabilities{};  ///< a new one per change, in turn: whoever reads an old
                                                               ///< one has done so long before its place comes again
    std::atomic<std::size_t> m_current{0};
    std::atomic<bool> m_fittedKnown{false};
    Fitted m_fitted{};
    bool m_onlyRead{false};
    bool m_mine{false};
    std::uint64_t m_own{0};    ///< our claim
    std::uint64_t m_owner{0};  ///< whoever commands; 0: nobody, or a program that has died
    std::uint64_t m_said{0};   ///< … as the capabilities say it
    std::unique_ptr<SharedLink> m_link;
    std::unique_ptr<RshLink> m_rsh;
    LinkMemory* m_memory{nullptr};  ///< of this cycle
    FromControl m_seen{};
    std::int64_t m_now_ns{0};
    std::optional<std::int64_t> m_lastBeat_ns{};  ///< none: this memory has not moved since it was found
    std::optional<std::int64_t> m_lastPeriod_ns{};
    std::uint64_t m_beat{0};
    std::uint64_t m_periods{0};
    std::uint64_t m_outBeat{0};
    RequestReply m_reply{};
    std::uint32_t m_lastRequest{0};
    std::uint32_t m_gainsRequest{0};  ///< waits until the gains read back; 0: none
    std::int64_t m_gainsSince_ns{0};
    std::uint32_t m_gainsRevision{0};
    ZGains m_gains{};
    ProgramState m_program{ProgramState::Idle};
    ProcessId m_process{ProcessId::Boring};
    std::uint32_t m_partSequence{0};
    bool m_outputFell{false};     ///< the program's output was off since the last begin
    std::uint32_t m_declared{0};  ///< as the control shows it (programs.h)
    bool m_declaredFresh{false};  ///< since the last program: it counts for the next one
    double m_startPosition_mm{0.0};
    double m_startFrom_mm{0.0};                  ///< boring: overhang the program asked for begins with
    std::optional<double> m_startOverhang_mm{};  ///< of the program that runs, or ran last
    // tapping
    TapFollower m_tap{};
    std::uint64_t m_nextPeriod{0};
    std::uint32_t m_startRequest{0};   ///< handed on, its program has not begun
    std::int64_t m_startTaken_ns{-1};  ///< the control has acknowledged it; −1: not yet
    std::int64_t m_startIdle_ns{0};    ///< since when nothing runs
    bool m_startRan{false};
    double m_startScale{1.0};          ///< planned over programmed feed of the program asked for
    std::uint32_t m_startDeclared{0};  ///< what it declares
    double m_plannedScale{0.0};        ///< of the running one; 0: not declared
    bool m_tapEnds{false};
    bool m_tapFinished{false};
    // milling: from the pin, or on a simulator without one
    ForceSamples m_forcePin;
    SimulatedForce m_force{};
    // thermal
    std::uint32_t m_offsetEpoch{0};
    std::uint32_t m_wishEpoch{0};  ///< 0: what we want is not meant for this control's offsets yet
    bool m_shiftUnderWay{false};
    std::int64_t m_lastShift_ns{0};
    ShiftWordAnswer m_word{};
};

}  // namespace kerf::linuxcnc
