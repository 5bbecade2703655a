// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <arpa/inet.h>
#include <fcntl.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/mman.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cstdint>
#include <mutex>
#include <new>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "engine/machine/linuxcnc/link_memory.h"

namespace kerf::test {

/// A linuxcncrsh that says what a test has written for it: line protocol on a port of its own, one client at a time.
/// What nothing is written for is acknowledged as the real one does it.
class ScriptedRsh {
 public:
    struct Answer {
        std::string text{};       ///< without the line's end; empty: nothing is said
        bool closes{false};       ///< the line is cut instead
        std::string following{};  ///< said before the next answer: what came late
    };

    ScriptedRsh() {
        m_listener = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
        sockaddr_in address{};
        address.sin_family = AF_INET;
        address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
        socklen_t size = sizeof address;
        (void)::bind(m_listener, reinterpret_cast<const sockaddr*>(&address), size);
        (void)::getsockname(m_listener, reinterpret_cast<sockaddr*>(&address), &size);
        m_port = ntohs(address.sin_port);
        (void)::listen(m_listener, 1);
        m_thread = std::thread([this] { run(); });
    }
    ScriptedRsh(const ScriptedRsh&) = delete;
    ScriptedRsh& operator=(const ScriptedRsh&) = delete;
    ~ScriptedRsh() {
        m_stop = true;
        m_thread.join();
        ::close(m_listener);
    }

    [[nodiscard]] std::uint16_t port() const { return m_port; }
    /// From now on, for every line that begins so.
    void script(const std::string& begin, const Answer& answer) {
        const std::lock_guard lock(m_mutex);
        std::erase_if(m_script, [&](const auto& one) { return one.first == begin; });
        m_script.emplace_back(begin, answer);
    }
    void forget() {
        const std::lock_guard lock(m_mutex);
        m_script.clear();
    }
    [[nodiscard]] std::vector<std::string> heard() const {
        const std::lock_guard lock(m_mutex);
        return m_heard;
    }
    [[nodiscard]] bool hasHeard(const std::string& begin) const {
        const auto lines = heard();
        return std::ranges::any_of(lines, [&](const std::string& line) { return line.starts_with(begin); });
    }
    [[nodiscard]] int connections() const { return m_connections; }

 private:
    void run() {
        while (!m_stop) {
            pollfd wait{m_listener, POLLIN, 0};
            if (::poll(&wait, 1, 5) > 0) {
                serve(::accept4(m_listener, nullptr, nullptr, SOCK_CLOEXEC));
            }
        }
    }
    void serve(int client) {
        ++m_connections;
        std::string pending;
        std::string late;
        std::array<char, 512> block{};
        while (!m_stop) {
            pollfd wait{client, POLLIN, 0};
            if (::poll(&wait, 1, 5) <= 0) {
                continue;
            }
            const ssize_t got = ::recv(client, block.data(), block.size(), 0);
            if (got <= 0) {
                break;
            }
            pending.append(block.data(), static_cast<std::size_t>(got));
            bool cut = false;
            for (auto end = pending.find("\r\n"); end != std::string::npos && !cut; end = pending.find("\r\n")) {
                const Answer answer = take(pending.substr(0, end));
                pending.erase(0, end + 2);
                cut = answer.closes;
                const std::string said = late + (answer.text.empty() || cut ? "" : answer.text + "\r\n");
                late = answer.following.empty() ? "" : answer.following + "\r\n";
                (void)::send(client, said.data(), said.size(), MSG_NOSIGNAL);
            }
            if (cut) {
                break;
            }
        }
        ::close(client);
    }
    Answer take(const std::string& line) {
        const std::lock_guard lock(m_mutex);
        m_heard.push_back(line);
        for (const auto& [begin, answer] : m_script) {
            if (line.starts_with(begin)) {
                return answer;
            }
        }
        return {line.starts_with("hello") ? "HELLO ACK EMCNETSVR 1.1" : "SET ACK", false, {}};
    }

    int m_listener{-1};
    std::uint16_t m_port{0};
    std::atomic<int> m_connections{0};
    mutable std::mutex m_mutex{};
    std::vector<std::pair<std::string, Answer>> m_script{};
    std::vector<std::string> m_heard{};
    std::atomic<bool> m_stop{false};
    std::thread m_thread{};
};

/// A memory of this test's own: whatever LinuxCNC runs on this computer beside it has nothing to do with it.
[[nodiscard]] inline std::string ownMemory() {
    return "/kerf-test-" + std::to_string(::getpid());
}

/// The bridge's side of the shared memory, moved by hand: of the memory ownMemory().
class ScriptedBridge {
 public:
    ScriptedBridge() {
        (void)shm_unlink(ownMemory().c_str());
        const int file = shm_open(ownMemory().c_str(), O_RDWR | O_CREAT | O_EXCL, 0600);
        if (file >= 0 && ftruncate(file, sizeof(linuxcnc::LinkMemory)) == 0) {
            void* block = mmap(nullptr, sizeof(linuxcnc::LinkMemory), PROT_READ | PROT_WRITE, MAP_SHARED, file, 0);
            memory = block == MAP_FAILED ? nullptr : new (block) linuxcnc::LinkMemory();
        }
        if (file >= 0) {
            ::close(file);
        }
        seen.machineOn = true;
        seen.fitted.units = linuxcnc::MachineUnits::Millimetre;
        seen.fitted.externalOffsets = true;
        seen.fitted.lossScale = true;
        seen.fitted.simulator = true;
        seen.fitted.programDeclared = true;
        seen.spindleSpeed_rps = 20.0;
    }
    ScriptedBridge(const ScriptedBridge&) = delete;
    ScriptedBridge& operator=(const ScriptedBridge&) = delete;
    ~ScriptedBridge() {
        munmap(memory, sizeof(linuxcnc::LinkMemory));
        (void)shm_unlink(ownMemory().c_str());
    }
    /// It has been found by whoever looks.
    void ready() { memory->magic.store(linuxcnc::LinkMemory::kMagic, std::memory_order_release); }
    /// One round of the bridge; the servo thread may stand still.
    void beat(bool servo = true) {
        ++seen.beat;
        if (servo) {
            ++seen.servoPeriods;
            linuxcnc::ServoPeriod period;
            period.number = static_cast<std::uint32_t>(seen.servoPeriods);
            period.cutting = seen.cutting;
            period.finished = seen.finished;
            period.z_mm = seen.position_mm[2];
            period.spindle_rev = seen.spindleAngle_rev;
            period.stamp_ns = now_ns;
            period.force = force;
            period.forceFault = forceFault;
            memory->servo.push(period);
        }
        memory->fromControl.push(seen);
    }
    /// The console's newest wish.
    [[nodiscard]] linuxcnc::ToControl wish() {
        (void)memory->toControl.refresh();
        return memory->toControl.value();
    }

    linuxcnc::LinkMemory* memory{nullptr};
    linuxcnc::FromControl seen{};  ///< what the next beat shows
    std::int64_t now_ns{0};        ///< when it is
    double force{0.0};             ///< on its pin, in the pin's unit
    bool forceFault{false};
};

}  // namespace kerf::test
