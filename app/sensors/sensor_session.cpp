// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/sensors/sensor_session.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <csignal>
#include <filesystem>

#include "app/sensors/monotonic.h"

namespace kerf::sensors {
namespace {

constexpr std::int64_t kOldFrame_ns = 1'000'000'000;

std::string besideUs(const char* name) {
    std::error_code unreadable;
    const auto program = std::filesystem::read_symlink("/proc/self/exe", unreadable);
    return (program.parent_path() / name).string();
}

}  // namespace

SensorSession::SensorSession(std::string file) : m_file(std::move(file)) {
    static std::atomic<int> count{0};
    m_memoryName = fmt::format("/kerf-sensors-{}-{}", getpid(), ++count);
}

SensorSession::~SensorSession() {
    end();
    m_link.reset();
}

Result<void> SensorSession::start() {
    if (!spawn()) {
        return fail(
            KERF_TEXT("The reading process kerf-sensors cannot be started: it is not beside the program, or the "
                      "computer has no room for it."));
    }
    m_link = std::make_unique<MemoryLink<SensorMemory>>(m_memoryName);
    return {};
}

bool SensorSession::spawn() {
    const std::string program = besideUs("kerf-sensors");
    int ends[2] = {-1, -1};
    if (access(program.c_str(), X_OK) != 0 || socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0) {
        return false;
    }
    posix_spawn_file_actions_t actions{};
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, ends[0], STDIN_FILENO);
    posix_spawn_file_actions_adddup2(&actions, STDERR_FILENO, STDOUT_FILENO);  // standard output is ours alone
    std::string file = m_file;
    std::string option = "--memory";
    std::string name = m_memoryName;
    std::string own = program;
    char* arguments[] = {own.data(), file.data(), option.data(), name.data(), nullptr};
    pid_t process = -1;
    const bool started = posix_spawn(&process, program.c_str(), &actions, nullptr, arguments, environ) == 0;
    posix_spawn_file_actions_destroy(&actions);
    close(ends[0]);
    if (!started) {
        close(ends[1]);
        return false;
    }
    m_process = process;
    m_toProcess = ends[1];
    m_lastBeat_ns = monotonic_ns();
    return true;
}

/// It has nothing to save, and may hang: no waiting for its good will.
void SensorSession::end() {
    if (m_toProcess >= 0) {
        close(m_toProcess);
        m_toProcess = -1;
    }
    if (m_process > 0) {
        (void)kill(m_process, SIGKILL);
        (void)waitpid(m_process, nullptr, 0);
        m_process = -1;
        (void)shm_unlink(m_memoryName.c_str());
    }
}

void SensorSession::keep() {
    const std::int64_t now_ns = monotonic_ns();
    if (m_process <= 0) {
        if (m_link && now_ns >= m_startAt_ns) {
            ++m_restarts;
            if (!spawn()) {
                m_startAt_ns = now_ns + kRestart_ns;
            }
        }
        return;
    }
    if (SensorMemory* memory = m_link ? m_link->take() : nullptr) {
        if (const std::uint64_t beat = memory->frames.written(); beat != m_beat) {
            m_beat = beat;
            m_lastBeat_ns = now_ns;
        }
    }
    const bool died = waitpid(m_process, nullptr, WNOHANG) == m_process;
    if (died) {
        m_process = -1;
    }
    if (died || now_ns - m_lastBeat_ns > kHung_ns) {
        end();
        m_startAt_ns = now_ns + kRestart_ns;
    }
}

bool SensorSession::latest(SensorFrame& frame) noexcept {
    SensorMemory* memory = m_link ? m_link->take() : nullptr;
    return memory != nullptr && memory->frames.latest(frame) && monotonic_ns() - frame.written_ns < kOldFrame_ns;
}

bool SensorSession::nextGauge(GaugeEvent& event) noexcept {
    SensorMemory* memory = m_link ? m_link->take() : nullptr;
    if (memory != m_gaugeMemory) {
        m_gaugeMemory = memory;
        m_nextGauge = 0;
    }
    return memory != nullptr && memory->gauges.read(m_nextGauge, event);
}

bool SensorSession::gaugeConnected(std::size_t gauge) noexcept {
    SensorMemory* memory = m_link ? m_link->take() : nullptr;
    return memory != nullptr && gauge < memory->gaugeConnected.size() && memory->gaugeConnected[gauge].load();
}

void SensorSession::askGauge(std::size_t gauge) noexcept {
    const std::string line = fmt::format("ask {}\n", gauge);
    if (m_toProcess >= 0) {
        (void)!send(m_toProcess, line.data(), line.size(), MSG_NOSIGNAL | MSG_DONTWAIT);
    }
}

}  // namespace kerf::sensors
