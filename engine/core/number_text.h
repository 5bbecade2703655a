// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <charconv>
#include <string>
#include <system_error>

namespace kerf {

/// A number with a point and this many decimals, whatever the program's locale: printf's "%f" writes a comma in half of
/// Europe, and a control stops there. Values that are no number give "?". Allocates: never in the cycle.
[[nodiscard]] inline std::string fixedText(double value, int decimals) {
    std::array<char, 400> text{};  // the largest double has 309 digits before its point
    const auto [end, error] =
        std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::fixed, decimals);
    const bool number = error == std::errc{} && value - value == 0.0;
    return number ? std::string(text.data(), end) : std::string("?");
}

}  // namespace kerf
