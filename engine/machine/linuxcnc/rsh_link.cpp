// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/machine/linuxcnc/rsh_link.h"

#include <arpa/inet.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <variant>

#include "engine/machine/linuxcnc/machine_claim.h"
#include "engine/machine/linuxcnc/programs.h"

namespace kerf::linuxcnc {
namespace {

constexpr int kAnswer_ms = 2000;
constexpr int kSlice_ms = 20;  // an abort does not wait for another command's answer
constexpr auto kRetry = std::chrono::milliseconds(200);
constexpr auto kPoll = std::chrono::milliseconds(2);
constexpr auto kOwnerLook = std::chrono::milliseconds(500);

}  // namespace

RshLink::RshLink(Params params)
    : m_params(std::move(params)),
      m_link(m_params.memory),
      m_line(static_cast<std::uint32_t>(std::chrono::steady_clock::now().time_since_epoch().count())),
      m_thread([this] { run(); }) {}

RshLink::~RshLink() {
    m_stop = true;
    m_thread.join();
    disconnect();
}

/// Null: there is none, or it does not reach LinuxCNC's command channel.
LinkMemory* RshLink::bridge() {
    LinkMemory* memory = m_link.take();
    FromControl seen;
    const bool ready = memory != nullptr && memory->magic.load(std::memory_order_acquire) == LinkMemory::kMagic &&
                       memory->fromControl.latest(seen) && seen.commandsReady;
    return ready ? memory : nullptr;
}

bool RshLink::connectOnce() {
    if (bridge() != nullptr) {
        m_overBridge = true;
        return true;
    }
    m_socket = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_port = htons(m_params.port);
    if (m_socket < 0 || inet_pton(AF_INET, m_params.host.c_str(), &address.sin_addr) != 1 ||
        ::connect(m_socket, reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0) {
        disconnect();
        return false;
    }
    const bool greeted = acknowledged(std::string("hello ") + m_params.password.connect + " kerf 1") &&
                         acknowledged("set echo off") && acknowledged("set verbose on");
    if (!greeted) {
        disconnect();
    }
    return greeted;
}

void RshLink::disconnect() noexcept {
    m_connected = false;
    m_overBridge = false;
    if (m_socket >= 0) {
        ::close(m_socket);
        m_socket = -1;
    }
}

bool RshLink::sayOverBridge(const std::string& line, std::string& answer) {
    LinkMemory* memory = bridge();
    CommandLine asked;
    if (memory == nullptr || line.size() >= asked.text.size()) {
        disconnect();
        return false;
    }
    m_line = m_line == 0xFFFF'FFFF ? 1 : m_line + 1;
    asked.number = asked.numberAgain = m_line;
    std::copy(line.begin(), line.end(), asked.text.begin());
    const auto asked_at = std::chrono::steady_clock::now();
    asked.asked_ns = asked_at.time_since_epoch().count();
    memory->commandLine.publish(asked);
    while (true) {
        if (memory->commandAnswer.refresh() && memory->commandAnswer.value().number == m_line) {
            answer = memory->commandAnswer.value().taken ? "ACK" : "NAK";
            return true;
        }
        const auto waited = std::chrono::steady_clock::now() - asked_at;
        const bool overtaken = !m_aborting && m_abort.load(std::memory_order_acquire) != 0;
        if (waited > std::chrono::milliseconds(kAnswer_ms) ||
            (overtaken && waited > std::chrono::milliseconds(kSlice_ms))) {
            return false;  // a late answer has another number
        }
        std::this_thread::sleep_for(kPoll);
    }
}

bool RshLink::say(const std::string& line, std::string& answer) {
    if (m_overBridge) {
        return sayOverBridge(line, answer);
    }
    std::array<char, 512> block{};
    while (::recv(m_socket, block.data(), block.size(), MSG_DONTWAIT) > 0) {
        // What comes unasked, or late for a command that was given up, is no answer to this one.
    }
    const std::string text = line + "\r\n";
    if (::send(m_socket, text.data(), text.size(), MSG_NOSIGNAL) != static_cast<ssize_t>(text.size())) {
        return false;
    }
    answer.clear();
    int waited_ms = 0;
    while (answer.find('\n') == std::string::npos) {
        pollfd wait{m_socket, POLLIN, 0};
        const int ready = ::poll(&wait, 1, kSlice_ms);
        waited_ms += ready == 0 ? kSlice_ms : 0;
        const bool overtaken = !m_aborting && m_abort.load(std::memory_order_acquire) != 0;
        if (ready < 0 || waited_ms >= kAnswer_ms || (ready == 0 && overtaken)) {
            disconnect();  // its answer, should it still come, must not be taken for the next one's
            return false;
        }
        if (ready == 0) {
            continue;
        }
        const ssize_t got = ::recv(m_socket, block.data(), block.size(), 0);
        if (got <= 0) {
            return false;
        }
        answer.append(block.data(), static_cast<std::size_t>(got));
    }
    return true;
}

bool RshLink::acknowledged(const std::string& line) {
    std::string answer;
    return say(line, answer) && answer.find("NAK") == std::string::npos;
}

// Only one connection may command at a time: the one that was enabled last.
bool RshLink::command(const std::string& line) {
    return acknowledged(std::string("set enable ") + m_params.password.enable) && acknowledged(line);
}

bool RshLink::mdi(const std::string& line) {
    return command("set mode mdi") && command(line);
}

RequestReply RshLink::carryOut(const Errand& errand) {
    if (errand.kind == Errand::Request) {
        return carryOut(errand.request);
    }
    const std::string line = errand.kind == Errand::ShiftOrigin ? originShiftLine(errand.shift_um) : originReportLine();
    return {kOwnRequest, m_connected && mdi(line) ? RequestState::Done : RequestState::Refused, {}};
}

RequestReply RshLink::carryOut(const PortRequest& request) {
    RequestReply reply{request.number, RequestState::Done, {}};
    const auto refuse = [&reply](const Sentence& why) {
        reply.state = RequestState::Refused;
        reply.reason = why;
        return reply;
    };
    if (!m_connected) {
        return refuse(Sentence(KERF_TEXT("The control takes no commands: linuxcncrsh does not answer.")));
    }
    bool done = true;
    if (const auto* start = std::get_if<StartProgram>(&request.action)) {
        const Result<std::string> line = programLine(*start, request.number);
        if (!line) {
            return refuse(line.error());
        }
        done = mdi(*line);
    } else if (std::holds_alternative<AbortProgram>(request.action)) {
        done = command("set abort");
    } else {
        return refuse(Sentence(KERF_TEXT("This control cannot do that.")));
    }
    return done ? reply
                : refuse(Sentence(KERF_TEXT("The control refused the command: is it switched on, homed and idle?")));
}

void RshLink::abortFirst(std::uint32_t number) {
    m_aborting = true;
    (void)m_replies.tryPush(carryOut(PortRequest{number, AbortProgram{}}));
    m_aborting = false;
    std::uint32_t done = number;
    (void)m_abort.compare_exchange_strong(done, 0);
    Errand errand;
    while (m_errands.tryPop(errand)) {
        const std::uint32_t of = errand.kind == Errand::Request ? errand.request.number : kOwnRequest;
        (void)m_replies.tryPush(
            {of, RequestState::Refused, Sentence(KERF_TEXT("An abort came first: this was not sent any more."))});
    }
}

/// A claim is looked after in /proc, so here and not in the cycle.
void RshLink::watchOwner() {
    const auto now = std::chrono::steady_clock::now();
    if (now - m_ownerSeen < kOwnerLook) {
        return;
    }
    m_ownerSeen = now;
    const LinkMemory* memory = m_link.take();
    const std::uint64_t owner = memory != nullptr ? memory->owner.load() : 0;
    m_deadOwner.store(owner != 0 && !alive(owner) ? owner : 0, std::memory_order_release);
}

void RshLink::run() {
    while (!m_stop) {
        watchOwner();
        if (!m_connected) {
            m_connected = connectOnce();
            if (!m_connected) {
                std::this_thread::sleep_for(kRetry);
            }
        }
        if (const std::uint32_t abort = m_abort.load(std::memory_order_acquire); abort != 0 && m_connected) {
            abortFirst(abort);
        }
        Errand errand;
        if (m_errands.tryPop(errand)) {
            (void)m_replies.tryPush(carryOut(errand));
        } else if (m_connected) {
            char probe = 0;
            const bool closed = !m_overBridge && ::recv(m_socket, &probe, 1, MSG_PEEK | MSG_DONTWAIT) == 0;
            if (closed || m_overBridge != (bridge() != nullptr)) {
                disconnect();  // the control has closed the line, or there is a better one
            }
            std::this_thread::sleep_for(kPoll);
        }
    }
}

}  // namespace kerf::linuxcnc
