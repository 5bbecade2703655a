// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <thread>

#include "db/shop/shop_push.h"

namespace kerf::db {

/// What a screen shows of the way to the shop.
struct ShopState {
    ShopTrouble trouble{ShopTrouble::None};
    std::string detail{};    ///< of the trouble, as the server or the system said it
    std::int64_t unsent{0};  ///< entries the shop has not acknowledged; as far as is known while out of reach
    std::int64_t setAside{0};
    std::int64_t lastContact_utc_ms{0};  ///< when the shop last answered; 0: not since start
    bool newEpoch{false};
};

/// Pushes for ever: again a second after the last row, after a failure 1, 2, 4 … 60 s later with jitter. Returns when
/// interrupted. `told` is called on the caller's thread after each attempt.
void runShopSender(const std::string& dataFile, const std::string& conninfo, const Interrupt& interrupt,
                   const std::function<void(const ShopState&)>& told);

/// The same on a thread of its own. Ending takes no longer than a cut of its own connection.
class ShopSender {
 public:
    ShopSender(std::string dataFile, std::string conninfo);
    ~ShopSender();
    ShopSender(const ShopSender&) = delete;
    ShopSender& operator=(const ShopSender&) = delete;
    /// The newest state; any thread.
    [[nodiscard]] ShopState state() const;

 private:
    Interrupt m_interrupt;
    mutable std::mutex m_lock;  ///< held for a copy only
    ShopState m_state{};
    std::thread m_thread;
};

}  // namespace kerf::db
