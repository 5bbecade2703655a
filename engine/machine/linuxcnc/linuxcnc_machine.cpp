// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/machine/linuxcnc/linuxcnc_machine.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <string_view>
#include <variant>

namespace kerf::linuxcnc {
namespace {

constexpr std::int64_t kSilence_ns = 100'000'000;
constexpr std::size_t kZ = 2;
constexpr double kMicrometrePerMillimetre = 1000.0;

LinkMemory* attach() {
    const int file = shm_open(kLinkName, O_RDWR, 0);
    if (file < 0) {
        return nullptr;
    }
    struct stat size {};
    void* block = MAP_FAILED;
    if (fstat(file, &size) == 0 && size.st_size >= static_cast<off_t>(sizeof(LinkMemory))) {
        block = mmap(nullptr, sizeof(LinkMemory), PROT_READ | PROT_WRITE, MAP_SHARED, file, 0);
    }
    close(file);
    return block == MAP_FAILED ? nullptr : static_cast<LinkMemory*>(block);
}

}  // namespace

LinuxCncMachine::LinuxCncMachine(const Params& params) : m_params(params) {
    constexpr std::string_view name = "LinuxCNC";
    std::ranges::copy(name, m_capabilities.machineName.begin());
    m_capabilities.maxFeedScale = params.maxFeedScale;
    m_capabilities.feedScale.fitted = true;
    m_capabilities.cycleStart.fitted = true;
    m_capabilities.workOffset.fitted = params.externalOffsets;
    if (!params.externalOffsets) {
        m_capabilities.workOffset.why =
            Sentence(KERF_TEXT("This LinuxCNC has no external offsets: set OFFSET_AV_RATIO in its ini."));
    }
    const Sentence noSignal(KERF_TEXT("This LinuxCNC brings no such signal over HAL."));
    for (Capability* capability :
         {&m_capabilities.forceSensor, &m_capabilities.temperatures, &m_capabilities.gapSensors,
          &m_capabilities.servoGains, &m_capabilities.toolTrim, &m_capabilities.gauge}) {
        capability->why = noSignal;
    }
    for (const ProcessId id : kAllProcesses) {
        Capability& host = m_capabilities.process[static_cast<std::size_t>(id)];
        host.fitted = id == ProcessId::Boring;
        if (!host.fitted) {
            host.why = Sentence(KERF_TEXT("This loop does not run on LinuxCNC yet."));
        }
    }
}

LinuxCncMachine::~LinuxCncMachine() {
    disconnect();
}

Result<void> LinuxCncMachine::connect() {
    m_memory = attach();
    if (m_memory == nullptr || m_memory->magic.load(std::memory_order_acquire) != LinkMemory::kMagic) {
        disconnect();
        return fail(KERF_TEXT("LinuxCNC is not reached: it does not run, or its HAL file does not load kerf-hal."));
    }
    m_rsh = std::make_unique<RshLink>(m_params.rsh);
    return {};
}

void LinuxCncMachine::disconnect() noexcept {
    m_rsh.reset();
    if (m_memory != nullptr) {
        munmap(m_memory, sizeof(LinkMemory));
        m_memory = nullptr;
    }
}

bool LinuxCncMachine::watchLink(std::int64_t now_ns) noexcept {
    if (m_memory == nullptr || m_memory->magic.load(std::memory_order_acquire) != LinkMemory::kMagic) {
        return false;
    }
    if (m_memory->fromControl.refresh()) {
        m_seen = m_memory->fromControl.value();
    }
    if (m_seen.beat != m_beat) {
        m_beat = m_seen.beat;
        m_lastBeat_ns = now_ns;
    }
    if (m_seen.servoClock_s != m_clock_s) {
        m_clock_s = m_seen.servoClock_s;
        m_lastClock_ns = now_ns;
    }
    return now_ns - m_lastBeat_ns < kSilence_ns && now_ns - m_lastClock_ns < kSilence_ns && m_beat != 0;
}

void LinuxCncMachine::followProgram() noexcept {
    const bool cutting = m_seen.cutting && m_seen.programRunning;
    if (cutting && !m_wasCutting && m_program != ProgramState::Paused) {
        ++m_partSequence;
        m_startPosition_mm = m_seen.position_mm[kZ];
    }
    if (m_seen.cutting && m_seen.programPaused) {
        m_program = ProgramState::Paused;
    } else if (cutting) {
        m_program = ProgramState::Running;
    } else if (m_program == ProgramState::Running || m_program == ProgramState::Paused) {
        m_program = m_seen.finished ? ProgramState::Finished : ProgramState::Aborted;
    }
    m_wasCutting = cutting;
}

void LinuxCncMachine::read(std::int64_t now_ns, MachineInputs& inputs) noexcept {
    const bool up = watchLink(now_ns);
    const Quality quality = up ? Quality::Good : Quality::Stale;
    if (up) {
        followProgram();
    }
    RequestReply reply;
    while (m_rsh != nullptr && m_rsh->tryReply(reply)) {
        m_reply = reply;
    }
    inputs.time_ns = now_ns;
    inputs.link = up ? LinkState::Up : LinkState::Down;
    inputs.emergencyStop = m_seen.emergencyStop;
    inputs.machineOn = m_seen.machineOn;
    inputs.feedHold =
        m_seen.programPaused || (m_program == ProgramState::Running && m_seen.currentVelocity_mmPerS == 0.0);
    inputs.operatorOverride = m_seen.feedOverride;
    inputs.program = m_program;
    inputs.programProcess = m_process;
    inputs.partSequence = m_partSequence;
    inputs.programmedFeed_mmPerS = {m_seen.requestedVelocity_mmPerS, now_ns, quality};
    inputs.actualFeed_mmPerS = {m_seen.currentVelocity_mmPerS, now_ns, quality};
    inputs.spindleSpeed_rpm = {m_seen.spindleSpeed_rps * 60.0, now_ns, quality};
    inputs.spindleAngle_rev = {m_seen.spindleAngle_rev, now_ns, quality};
    inputs.appliedFeedScale = {m_seen.appliedFeedScale, now_ns, quality};
    for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
        inputs.position_mm[axis] = {m_seen.position_mm[axis], now_ns, quality};
        inputs.workOffset_um[axis] = {m_seen.externalOffset_mm[axis] * kMicrometrePerMillimetre, now_ns, quality};
    }
    const double overhang_mm = m_params.overhangAtZero_mm + (m_startPosition_mm - m_seen.position_mm[kZ]);
    inputs.overhang_mm = {overhang_mm, now_ns, quality};
    inputs.fastCount = 0;
    inputs.temperatures = nullptr;
    inputs.reply = m_reply;
}

void LinuxCncMachine::write(const MachineOutputs& outputs) noexcept {
    if (m_memory == nullptr) {
        return;
    }
    ToControl wish;
    wish.beat = ++m_outBeat;
    wish.beatAgain = wish.beat;
    wish.feedScale = outputs.feedScale;
    wish.feedHold = outputs.feedHold;
    wish.externalOffset_um = outputs.workOffset_um;
    m_memory->toControl.publish(wish);
    if (outputs.request.number != 0 && outputs.request.number != m_lastRequest && m_rsh != nullptr) {
        m_lastRequest = outputs.request.number;
        if (const auto* start = std::get_if<StartProgram>(&outputs.request.action)) {
            m_process = start->process;
        }
        if (!m_rsh->tryAsk(outputs.request)) {
            m_reply = {outputs.request.number, RequestState::Refused,
                       Sentence(KERF_TEXT("The control is still busy with earlier commands."))};
        }
    }
}

}  // namespace kerf::linuxcnc
