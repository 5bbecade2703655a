// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <cstdint>
#include <string>

/// The way to the shop, as a screen shows it.
namespace kerf::ui {

struct ShopView {
    /// None: entries go through, or everything is there.
    enum class Trouble : std::uint8_t {
        None,
        Unreachable,
        NotPrepared,
        NotAllowed,
        NewerConsole,
        DataFile,
        WrongSetting
    };
    Trouble trouble{Trouble::None};
    std::string detail{};               ///< as the server or the system said it; not translated
    std::int64_t unsent{0};             ///< entries that the shop has not acknowledged
    std::int64_t setAside{0};           ///< that the shop could not take and has put aside
    std::int64_t lastContactUtc_ms{0};  ///< 0: none since the console began
};

/// One sentence: what is wrong, how much waits, how old the last contact is.
[[nodiscard]] QString shopText(const ShopView& shop, std::int64_t nowUtc_ms);

}  // namespace kerf::ui
