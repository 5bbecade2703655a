// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <memory>
#include <string>
#include <thread>

class RCS_CMD_CHANNEL;
class RCS_CMD_MSG;
class RCS_STAT_CHANNEL;
class EMC_STAT;

namespace kerf::linuxcnc {

struct LinkMemory;

/// Commands of the console that owns the machine, from the shared memory to LinuxCNC's own command channel: no port, no
/// password, nobody else's. On a thread of its own; the bridge's rounds never wait for it.
///
/// A command is taken when LinuxCNC has echoed it and stands in no error of it; a mode when it is in force.
class ControlCommands {
 public:
    /// Speaks on `link` alone. Looks for LinuxCNC's channels until they are there.
    explicit ControlCommands(LinkMemory& link);
    ControlCommands(const ControlCommands&) = delete;
    ControlCommands& operator=(const ControlCommands&) = delete;
    ~ControlCommands();

    [[nodiscard]] bool ready() const noexcept { return m_ready.load(std::memory_order_acquire); }

 private:
    void run();
    [[nodiscard]] bool open();
    [[nodiscard]] bool carryOut(const std::string& line);
    [[nodiscard]] bool send(RCS_CMD_MSG& message);
    [[nodiscard]] const EMC_STAT* look();

    LinkMemory& m_link;
    std::unique_ptr<RCS_CMD_CHANNEL> m_commands;
    std::unique_ptr<RCS_STAT_CHANNEL> m_status;
    std::atomic<bool> m_ready{false};
    std::atomic<bool> m_stop{false};
    std::thread m_thread;
};

}  // namespace kerf::linuxcnc
