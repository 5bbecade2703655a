// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <atomic>
#include <chrono>
#include <cstdint>
#include <string>
#include <thread>
#include <variant>

#include "engine/core/spsc_ring.h"
#include "engine/machine/linuxcnc/rsh_password.h"
#include "engine/machine/linuxcnc/shared_link.h"
#include "engine/port/machine_port.h"

namespace kerf::linuxcnc {

/// Commands to LinuxCNC on a thread of their own, never in the cycle: through the bridge's memory where the bridge
/// reaches LinuxCNC's command channel, which needs no port and no password; else over linuxcncrsh (the same lines on
/// TCP).
///
/// The cycle hands a request over by ring and finds the reply in another; the thread speaks, waits for each
/// acknowledgement, and connects again by itself when the control comes back.
class RshLink {
 public:
    struct Params {
        std::string host{"127.0.0.1"};
        std::uint16_t port{5007};
        RshPassword password{};
        std::string memory{kLinkName};  ///< name of the memory shared with the bridge
    };
    explicit RshLink(Params params);
    RshLink(const RshLink&) = delete;
    RshLink& operator=(const RshLink&) = delete;
    ~RshLink();

    /// Number of the replies to what the port asks by itself.
    static constexpr std::uint32_t kOwnRequest = 0xFFFF'FFFF;

    /// Cycle: false when the ring is full.
    /// An abort does not wait behind what was asked before: it goes out first, and starts that were not sent yet are
    /// refused.
    [[nodiscard]] bool tryAsk(const PortRequest& request) noexcept {
        if (std::holds_alternative<AbortProgram>(request.action)) {
            m_abort.store(request.number, std::memory_order_release);
            return true;
        }
        return m_errands.tryPush({request});
    }
    /// Cycle: total shift of the work origin by G10 L2, whole µm.
    [[nodiscard]] bool tryShiftOrigin(const std::array<double, 3>& shift_um) noexcept {
        return m_errands.tryPush({{}, Errand::ShiftOrigin, shift_um});
    }
    /// Cycle: let the control tell what it has shifted.
    [[nodiscard]] bool tryReportOrigin() noexcept { return m_errands.tryPush({{}, Errand::ReportOrigin, {}}); }
    /// Cycle: false when there is nothing new.
    [[nodiscard]] bool tryReply(RequestReply& reply) noexcept { return m_replies.tryPop(reply); }
    [[nodiscard]] bool connected() const noexcept { return m_connected.load(std::memory_order_acquire); }
    /// Connected, and without a network. Any thread.
    [[nodiscard]] bool overBridge() const noexcept { return m_overBridge.load(std::memory_order_acquire); }
    /// The claim on the machine whose program has died, as seen within the last half second; 0: it lives, or there is
    /// no claim. Any thread.
    [[nodiscard]] std::uint64_t deadOwner() const noexcept { return m_deadOwner.load(std::memory_order_acquire); }

 private:
    struct Errand {
        enum Kind : std::uint8_t { Request, ShiftOrigin, ReportOrigin };
        PortRequest request{};
        Kind kind{Request};
        std::array<double, 3> shift_um{};
    };
    void run();
    void watchOwner();
    void abortFirst(std::uint32_t number);
    [[nodiscard]] bool connectOnce();
    void disconnect() noexcept;
    [[nodiscard]] bool say(const std::string& line, std::string& answer);
    [[nodiscard]] bool sayOverBridge(const std::string& line, std::string& answer);
    [[nodiscard]] LinkMemory* bridge();
    [[nodiscard]] bool acknowledged(const std::string& line);
    [[nodiscard]] RequestReply carryOut(const Errand& errand);
    [[nodiscard]] RequestReply carryOut(const PortRequest& request);
    [[nodiscard]] bool command(const std::string& line);
    [[nodiscard]] bool mdi(const std::string& line);

    Params m_params;
    SpscRing<Errand> m_errands{16};
    SpscRing<RequestReply> m_replies{16};
    std::atomic<std::uint32_t> m_abort{0};  ///< number of the abort that is wanted; 0: none
    bool m_aborting{false};
    std::atomic<bool> m_connected{false};
    std::atomic<bool> m_stop{false};
    int m_socket{-1};
    SharedLink m_link;  ///< of its own: the cycle's may be replaced while we speak
    std::atomic<bool> m_overBridge{false};
    std::atomic<std::uint64_t> m_deadOwner{0};
    std::chrono::steady_clock::time_point m_ownerSeen{};
    std::uint32_t m_line{0};  ///< number of the last one
    std::thread m_thread;
};

}  // namespace kerf::linuxcnc
