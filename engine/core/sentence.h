// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <type_traits>

/// Marks an engine text for translation (lupdate reads it as QT_TRANSLATE_NOOP in the context "engine").
#define KERF_TEXT(english) english

namespace kerf {

/// One value inside a sentence: a number with fixed decimals, or a short name (a sensor, an axis).
struct SentenceArg {
    double value{0.0};
    std::int8_t decimals{-1};  ///< < 0: `name` is the argument
    std::array<char, 23> name{};

    constexpr SentenceArg() = default;
    constexpr SentenceArg(double v, int d) : value(v), decimals(static_cast<std::int8_t>(d)) {}
    constexpr explicit SentenceArg(std::string_view s) {
        for (std::size_t i = 0; i < s.size() && i + 1 < name.size(); ++i) {
            name[i] = s[i];
        }
    }
};

/// A message for a person: a translatable English text with %1…%3 and its arguments.
///
/// Trivially copyable and free of allocation, so the cycle can make one and a ring can carry it. `text` always
/// points to a string literal marked with KERF_TEXT. The screen translates it; the headless program prints english().
struct Sentence {
    const char* text{""};
    std::array<SentenceArg, 3> args{};
    std::uint8_t argCount{0};

    constexpr Sentence() = default;
    constexpr explicit Sentence(const char* t) : text(t) {}
    constexpr Sentence(const char* t, SentenceArg a) : text(t), args{a}, argCount(1) {}
    constexpr Sentence(const char* t, SentenceArg a, SentenceArg b) : text(t), args{a, b}, argCount(2) {}
    constexpr Sentence(const char* t, SentenceArg a, SentenceArg b, SentenceArg c)
        : text(t), args{a, b, c}, argCount(3) {}

    [[nodiscard]] constexpr bool empty() const noexcept { return text[0] == '\0'; }
    /// The English sentence with its arguments filled in. Allocates: never in the cycle.
    [[nodiscard]] std::string english() const;
};
static_assert(std::is_trivially_copyable_v<Sentence>);

/// One argument as the English text shows it.
[[nodiscard]] std::string formatArg(const SentenceArg& arg);

}  // namespace kerf
