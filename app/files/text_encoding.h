// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

/// Text of other programs as UTF-8, whatever they wrote it in. Converted by the C library's iconv.
namespace kerf::files {

enum class Encoding : std::uint8_t { Utf8, Utf16LittleEndian, Utf16BigEndian, Windows1252, Cp949 };
/// As a person knows it: "UTF-8", "CP949", …
[[nodiscard]] const char* nameOf(Encoding encoding) noexcept;
/// "utf-8", "utf-16", "windows-1252", "cp949", "euc-kr"; case does not matter.
[[nodiscard]] std::optional<Encoding> encodingOf(std::string_view name);

struct DecodedText {
    std::string utf8{};  ///< valid UTF-8 without a byte order mark, always
    Encoding encoding{Encoding::Utf8};
    bool ascii{true};     ///< nothing but ASCII: every reading is the same
    bool damaged{false};  ///< some bytes fit no encoding and stand as U+FFFD
};

/// Found out in this order: byte order mark; UTF-16 by its zero bytes; valid UTF-8; CP949 when it decodes and holds
/// more Korean letters and signs than pairs that end in an ASCII letter (as "°C" of Windows-1252 does); else
/// Windows-1252. `as`: what the person says it is.
[[nodiscard]] DecodedText decodeText(std::string_view bytes, std::optional<Encoding> as = std::nullopt);

/// A file name or another short text of unknown origin, fit for JSON and the screen.
[[nodiscard]] std::string utf8Of(std::string_view bytes);

[[nodiscard]] bool isValidUtf8(std::string_view bytes) noexcept;

}  // namespace kerf::files
