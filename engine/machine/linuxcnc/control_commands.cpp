// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/machine/linuxcnc/control_commands.h"

#include <chrono>
#include <cstdlib>
#include <cstring>
#include <functional>
#include <string_view>

// LinuxCNC's own headers are included as system ones (CMakeLists.txt).
#include <rcs.hh>
//
#include <emc.hh>
#include <emc_nml.hh>

#include "engine/machine/linuxcnc/ini_text.h"
#include "engine/machine/linuxcnc/link_memory.h"

namespace kerf::linuxcnc {
namespace {

constexpr const char* kUsualNml = "/usr/share/linuxcnc/linuxcnc.nml";
constexpr auto kPoll = std::chrono::milliseconds(1);
constexpr auto kEcho =
    std::chrono::milliseconds(500);  // less than the console's own patience; an abort waits for no more

std::string nmlFile() {
    const auto named = iniValue(iniText(), "EMC", "NML_FILE");
    return named && !named->empty() ? *named : kUsualNml;
}

bool soon(const std::function<bool()>& condition) {
    const auto end = std::chrono::steady_clock::now() + kEcho;
    while (!condition()) {
        if (std::chrono::steady_clock::now() > end) {
            return false;
        }
        std::this_thread::sleep_for(kPoll);
    }
    return true;
}

}  // namespace

ControlCommands::ControlCommands(LinkMemory& link) : m_link(link), m_thread([this] { run(); }) {}

ControlCommands::~ControlCommands() {
    m_stop = true;
    m_thread.join();
}

bool ControlCommands::open() {
    const std::string file = nmlFile();
    m_commands = std::make_unique<RCS_CMD_CHANNEL>(emcFormat, "emcCommand", "xemc", file.c_str());
    m_status = std::make_unique<RCS_STAT_CHANNEL>(emcFormat, "emcStatus", "xemc", file.c_str());
    if (m_commands->valid() && m_status->valid() && look() != nullptr) {
        return true;
    }
    m_status.reset();
    m_commands.reset();
    return false;
}

const EMC_STAT* ControlCommands::look() {
    const NMLTYPE type = m_status->peek();
    return type == EMC_STAT_TYPE || type == 0 ? static_cast<const EMC_STAT*>(m_status->get_address()) : nullptr;
}

bool ControlCommands::send(RCS_CMD_MSG& message) {
    if (m_commands->write(&message) != 0) {
        return false;
    }
    const int number = message.serial_number;
    return soon([this, number] {
        const EMC_STAT* now = look();
        return now != nullptr && now->echo_serial_number - number >= 0;
    });
}

/// The words are those of linuxcncrsh, so that the console says the same on both ways.
bool ControlCommands::carryOut(const std::string& line) {
    static constexpr std::string_view kMdi = "set mdi ";
    if (line.starts_with("hello") || line.starts_with("set enable") || line == "set echo off" ||
        line == "set verbose on") {
        return true;  // nobody has to be let in here
    }
    if (line == "set abort") {
        EMC_TASK_ABORT abort;
        return send(abort);
    }
    if (line == "set mode mdi") {
        const EMC_STAT* now = look();
        if (now != nullptr && now->task.mode == EMC_TASK_MODE_MDI) {
            return true;
        }
        EMC_TASK_SET_MODE mode;
        mode.mode = EMC_TASK_MODE_MDI;
        return send(mode) && soon([this] {
                   const EMC_STAT* after = look();
                   return after != nullptr && after->task.mode == EMC_TASK_MODE_MDI;
               });
    }
    if (line.starts_with(kMdi) && line.size() - kMdi.size() < LINELEN) {
        EMC_TASK_PLAN_EXECUTE execute;
        std::memset(execute.command, 0, sizeof execute.command);
        std::memcpy(execute.command, line.data() + kMdi.size(), line.size() - kMdi.size());
        if (!send(execute)) {
            return false;
        }
        const EMC_STAT* now = look();
        return now != nullptr && now->status != RCS_ERROR;
    }
    return false;
}

void ControlCommands::run() {
    std::uint32_t answered = 0;
    while (!m_stop) {
        if (!m_ready) {
            m_ready = open();
            if (!m_ready) {
                std::this_thread::sleep_for(std::chrono::milliseconds(500));
                continue;
            }
        }
        if (m_link.commandLine.refresh()) {
            const CommandLine& asked = m_link.commandLine.value();
            const bool whole = asked.number != 0 && asked.number == asked.numberAgain && asked.number != answered;
            if (whole) {
                answered = asked.number;
                const std::string line(asked.text.data(), strnlen(asked.text.data(), asked.text.size()));
                const std::int64_t now_ns = std::chrono::steady_clock::now().time_since_epoch().count();
                // A start that nobody waits for any more must not begin: this process stood still meanwhile.
                const bool inTime = now_ns - asked.asked_ns < CommandLine::kOldest_ns;
                const bool taken = (inTime || line == "set abort") && carryOut(line);
                m_link.commandAnswer.publish({asked.number, taken});
            }
        }
        std::this_thread::sleep_for(kPoll);
    }
}

}  // namespace kerf::linuxcnc
