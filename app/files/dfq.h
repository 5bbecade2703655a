// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <utility>
#include <vector>

/// Q-DAS ASCII transfer (AQDEF): a description and values, in one DFQ or in a DFD and a DFX.
///
///   K line      `Knnnn/i text`, i a part (K1…), a characteristic (K2…, K8…, and K0… of its newest value) or a place in
///               a catalogue; `/0` means all, no index means the first, `K0…/i/j` the j-th value of characteristic i
///   value line  one part: characteristics apart by 0x0F, the fields of one by 0x14, in the order
///               K0001 K0002 K0004 K0005 #K0006 K0007 K0008 K0010 K0011 K0012; attribute characteristics (K2004 1, 5,
///               6) K0020 K0021 (unnamed) K0002 K0004 … K0012
/// Text is Windows-1252 unless a byte order mark or its own bytes say otherwise (Korean in CP949 too); in here UTF-8.
/// Files in the wild are often slightly off: they are read, and what was odd is listed. What cannot be understood (a
/// value, time, attribute or index that is none) is a Problem with line and field; nothing is guessed.
namespace kerf::dfq {

/// A calendar time without a zone, as the file has it.
struct Time {
    int year{0}, month{0}, day{0}, hour{0}, minute{0};
    double second{0.0};
    friend bool operator==(const Time&, const Time&) = default;
};
/// What comes first where slashes stand between day, month and year: the file as a whole tells.
enum class SlashDates : std::uint8_t { MonthFirst, DayFirst };
/// dd.MM.yyyy/HH:mm:ss and the other orders in circulation; empty when it is no time.
[[nodiscard]] std::optional<Time> timeOf(std::string_view text, SlashDates slashes = SlashDates::MonthFirst);
[[nodiscard]] std::string timeText(const Time& time);
/// A number with point or comma and optional exponent; all of the text.
[[nodiscard]] std::optional<double> numberOf(std::string_view text);

/// A K field. Unnamed places of a value line have negative keys (−3: the third).
struct Field {
    int key{0};
    std::string text{};
    friend bool operator==(const Field&, const Field&) = default;
};

/// A line of the description, in the order of the file.
struct Entry {
    int key{0};
    std::optional<std::uint32_t> index{};
    std::string subIndex{};  ///< what stood behind a second slash
    std::string text{};
    friend bool operator==(const Entry&, const Entry&) = default;
};

/// Attributes of a value (K0002).
inline constexpr int kValid = 0;
inline constexpr int kVoid = 255;
inline constexpr int kNoValue = 256;  ///< common in the wild

struct Value {
    std::uint32_t characteristic{0};  ///< from 1
    std::uint32_t row{0};             ///< from 1: the part within the file
    std::vector<Field> fields{};      ///< every K0… field; numbers with a point, times as dd.MM.yyyy/HH:mm:ss
    // the same, understood
    std::optional<double> value{};  ///< K0001
    int attribute{kValid};          ///< K0002
    std::optional<Time> time{};     ///< K0004
    std::vector<std::uint32_t> events{};

    [[nodiscard]] const std::string* find(int key) const;
};

struct Oddity {
    std::size_t line{0};  ///< 0: the file as a whole
    std::string text{};
};

enum class Encoding : std::uint8_t { Windows1252, Utf8, Utf16, Cp949 };
[[nodiscard]] const char* encodingName(Encoding encoding);

struct File {
    Encoding encoding{Encoding::Windows1252};
    std::uint32_t characteristics{0};  ///< as described, or as many as the values need
    std::vector<Entry> entries{};      ///< without K0100
    std::vector<Value> values{};       ///< by part, then characteristic
    std::vector<Oddity> oddities{};

    /// K field of a part or characteristic; `/0` counts for all, a line of its own beats it.
    [[nodiscard]] const std::string* find(int key, std::uint32_t index) const;
};

struct Problem {
    std::size_t line{0};
    std::string field{};
    std::string text{};
};

/// A DFQ, or a DFD alone (no values).
/// `said`: what comes first in dates with slashes, where somebody knows. Without it the file must tell: a date that may
/// be two days, and no other date that tells, is refused.
[[nodiscard]] tl::expected<File, Problem> read(std::string_view bytes, std::optional<SlashDates> said = {});
/// Adds the values of a DFX to the description that `file` holds.
[[nodiscard]] tl::expected<void, Problem> readValues(std::string_view bytes, File& file,
                                                     std::optional<SlashDates> said = {});

/// A whole DFQ. Values of one row share a line; what has no place in it follows as K lines.
[[nodiscard]] std::string write(const File& file);

/// Text in and out of the encodings. Decoding never fails: bytes that Windows-1252 leaves open keep their number.
[[nodiscard]] std::string decoded(std::string_view bytes, Encoding& encoding);
[[nodiscard]] std::string windows1252(std::string_view utf8, bool& lossless);

}  // namespace kerf::dfq
