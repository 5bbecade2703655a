// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "db/api/store_writer.h"
#include "db/shop/shop_sender.h"
#include "ui/link/shop_text.h"

namespace kerf::console {

/// The console's way to the shop: a sender on a thread of its own when the data folder names a server in shop/database,
/// and an alarm of the third priority when nothing has reached it for a quarter of an hour. Nothing waits for it. GUI
/// thread.
class ShopLink {
 public:
    static constexpr std::int64_t kPatience_ms = 15 * 60 * 1000;

    ShopLink(const std::string& dataFolder, const std::string& dataFile, StoreWriter& writer);
    ~ShopLink();
    ShopLink(const ShopLink&) = delete;
    ShopLink& operator=(const ShopLink&) = delete;

    /// Now and then, with milliseconds of a clock that nobody sets.
    void poll(std::int64_t now_ms);
    /// For the live page: {"trouble": …, "unsent": …, "contact_utc_ms": …}; empty without a shop.
    [[nodiscard]] std::string json() const;
    /// For the screens; empty: none is wanted.
    [[nodiscard]] std::optional<ui::ShopView> view() const;
    /// Why there is none; empty: there is one, or none is wanted.
    [[nodiscard]] const std::string& fault() const noexcept { return m_fault; }

 private:
    StoreWriter& m_writer;
    std::unique_ptr<db::ShopSender> m_sender;
    std::string m_fault{};
    std::int64_t m_troubleSince_ms{-1};
    bool m_alarm{false};
};

}  // namespace kerf::console
