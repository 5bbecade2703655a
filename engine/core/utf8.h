// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string_view>

namespace kerf {

/// The first bytes of a text in UTF-8, at most so many, cut between letters: half a Hangul syllable in a sentence is no
/// UTF-8, and a program that reads it as JSON stops there.
[[nodiscard]] constexpr std::string_view beginOf(std::string_view text, std::size_t bytes) noexcept {
    constexpr unsigned kContinuation = 0x80, kMask = 0xC0;
    if (text.size() <= bytes) {
        return text;
    }
    while (bytes > 0 && (static_cast<unsigned char>(text[bytes]) & kMask) == kContinuation) {
        --bytes;
    }
    return text.substr(0, bytes);
}

}  // namespace kerf
