// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/machine/linuxcnc/rsh_link.h"

#include <arpa/inet.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <variant>

namespace kerf::linuxcnc {
namespace {

constexpr int kAnswer_ms = 2000;
constexpr auto kRetry = std::chrono::milliseconds(200);
constexpr auto kPoll = std::chrono::milliseconds(2);

std::string callBore(double depth_mm, double feed_mmPerMin, double speed_rpm) {
    std::array<char, 200> text{};
    std::snprintf(text.data(), text.size(), "set mdi o<kerf_bore> call [%.6f] [%.6f] [%.3f]", depth_mm, feed_mmPerMin,
                  speed_rpm);
    return text.data();
}

/// Starts the shipped subroutine (resources/linuxcnc/kerf_bore.ngc); all numbers are plain decimals.
Result<std::string> programLine(const StartProgram& start) {
    const bool sound =
        start.programmedFeed_mmPerRev > 0.0 && start.spindleSpeed_rpm > 0.0 && start.to_mm > start.from_mm &&
        std::isfinite(start.programmedFeed_mmPerRev * start.spindleSpeed_rpm * (start.to_mm - start.from_mm));
    if (start.process != ProcessId::Boring) {
        return fail(KERF_TEXT("This control has no program for that process."));
    }
    if (!sound) {
        return fail(
            KERF_TEXT("The boring program needs feed, speed and overhangs above zero, the end deeper than the start."));
    }
    const double feed_mmPerMin = start.programmedFeed_mmPerRev * start.spindleSpeed_rpm;
    return callBore(start.to_mm - start.from_mm, feed_mmPerMin, start.spindleSpeed_rpm);
}

}  // namespace

RshLink::RshLink(Params params) : m_params(std::move(params)), m_thread([this] { run(); }) {}

RshLink::~RshLink() {
    m_stop = true;
    m_thread.join();
    disconnect();
}

bool RshLink::connectOnce() {
    m_socket = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_port = htons(m_params.port);
    if (m_socket < 0 || inet_pton(AF_INET, m_params.host.c_str(), &address.sin_addr) != 1 ||
        ::connect(m_socket, reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0) {
        disconnect();
        return false;
    }
    const bool greeted = acknowledged("hello EMC kerf 1") && acknowledged("set enable EMCTOO") &&
                         acknowledged("set echo off") && acknowledged("set verbose on") &&
                         (!m_params.prepareMachine || prepareMachine());
    if (!greeted) {
        disconnect();
    }
    return greeted;
}

void RshLink::disconnect() noexcept {
    m_connected = false;
    if (m_socket >= 0) {
        ::close(m_socket);
        m_socket = -1;
    }
}

bool RshLink::say(const std::string& line, std::string& answer) {
    const std::string text = line + "\r\n";
    if (::send(m_socket, text.data(), text.size(), MSG_NOSIGNAL) != static_cast<ssize_t>(text.size())) {
        return false;
    }
    answer.clear();
    std::array<char, 512> block{};
    while (answer.find('\n') == std::string::npos) {
        pollfd wait{m_socket, POLLIN, 0};
        if (::poll(&wait, 1, kAnswer_ms) <= 0) {
            return false;
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

bool RshLink::prepareMachine() {
    for (const char* line :
         {"set estop off", "set machine on", "set mode manual", "set home 0", "set home 1", "set home 2"}) {
        if (!acknowledged(line)) {
            return false;
        }
    }
    std::string answer;
    for (int i = 0; i < 100 && !m_stop; ++i) {  // homing takes its time; 10 s is more than any simulated machine needs
        if (say("get joint_homed", answer) && answer.find("YES YES YES") != std::string::npos) {
            return acknowledged("set mode mdi");
        }
        std::this_thread::sleep_for(std::chrono::milliseconds(100));
    }
    return false;
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
        const Result<std::string> line = programLine(*start);
        if (!line) {
            return refuse(line.error());
        }
        done = acknowledged("set mode mdi") && acknowledged(*line);
    } else if (std::holds_alternative<AbortProgram>(request.action)) {
        done = acknowledged("set abort");
    } else {
        return refuse(Sentence(KERF_TEXT("This control cannot do that.")));
    }
    return done ? reply
                : refuse(Sentence(KERF_TEXT("The control refused the command: is it switched on, homed and idle?")));
}

void RshLink::run() {
    while (!m_stop) {
        if (!m_connected) {
            m_connected = connectOnce();
            if (!m_connected) {
                std::this_thread::sleep_for(kRetry);
            }
        }
        PortRequest request;
        if (m_requests.tryPop(request)) {
            (void)m_replies.tryPush(carryOut(request));
        } else if (m_connected) {
            char probe = 0;
            if (::recv(m_socket, &probe, 1, MSG_PEEK | MSG_DONTWAIT) == 0) {
                disconnect();  // the control has closed the line
            }
            std::this_thread::sleep_for(kPoll);
        }
    }
}

}  // namespace kerf::linuxcnc
