// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/files/text_encoding.h"

#include <iconv.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cerrno>

namespace kerf::files {
namespace {

constexpr std::string_view kReplacement = "\xEF\xBF\xBD";

const char* iconvName(Encoding encoding) noexcept {
    switch (encoding) {
        case Encoding::Utf16LittleEndian:
            return "UTF-16LE";
        case Encoding::Utf16BigEndian:
            return "UTF-16BE";
        case Encoding::Windows1252:
            return "WINDOWS-1252";
        case Encoding::Cp949:
            return "CP949";
        case Encoding::Utf8:
            break;
    }
    return "UTF-8";
}

class Converter {
 public:
    explicit Converter(Encoding from) : m_handle(iconv_open("UTF-8", iconvName(from))) {}
    ~Converter() {
        if (usable()) {
            iconv_close(m_handle);
        }
    }
    Converter(const Converter&) = delete;
    Converter& operator=(const Converter&) = delete;
    [[nodiscard]] bool usable() const { return m_handle != reinterpret_cast<iconv_t>(-1); }

    /// Bytes that fit nothing become U+FFFD; returns how many did.
    std::size_t run(std::string_view bytes, std::string& out) {
        std::size_t bad = 0;
        std::string copy(bytes);  // iconv wants it writable
        char* in = copy.data();
        std::size_t left = copy.size();
        std::array<char, 4096> buffer{};
        while (left > 0) {
            char* to = buffer.data();
            std::size_t room = buffer.size();
            const std::size_t done = iconv(m_handle, &in, &left, &to, &room);
            const int error = errno;
            out.append(buffer.data(), buffer.size() - room);
            if (done == static_cast<std::size_t>(-1) && error != E2BIG) {
                out += kReplacement;
                ++bad;
                ++in;
                --left;
            }
        }
        return bad;
    }

 private:
    iconv_t m_handle;
};

/// Length of the UTF-8 sequence at the front; 0 when it is none.
std::size_t sequenceLength(std::string_view text) noexcept {
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    const unsigned char lead = byte(0);
    if (lead < 0x80) {
        return 1;
    }
    const std::size_t length = lead >= 0xC2 && lead <= 0xDF   ? 2
                               : lead >= 0xE0 && lead <= 0xEF ? 3
                               : lead >= 0xF0 && lead <= 0xF4 ? 4
                                                              : 0;
    if (length == 0 || text.size() < length) {
        return 0;
    }
    for (std::size_t i = 1; i < length; ++i) {
        if ((byte(i) & 0xC0U) != 0x80U) {
            return 0;
        }
    }
    const unsigned char second = byte(1);
    const bool overlong = (lead == 0xE0 && second < 0xA0) || (lead == 0xF0 && second < 0x90);
    const bool surrogate = lead == 0xED && second > 0x9F;
    const bool beyond = lead == 0xF4 && second > 0x8F;
    return overlong || surrogate || beyond ? 0 : length;
}

/// Nearly every second byte of western text in UTF-16 is zero.
std::optional<Encoding> utf16WithoutMark(std::string_view bytes) {
    const std::size_t looked = std::min<std::size_t>(bytes.size(), 4096) / 2 * 2;
    if (looked < 4) {
        return std::nullopt;
    }
    std::array<std::size_t, 2> zeros{};
    for (std::size_t i = 0; i < looked; ++i) {
        zeros[i % 2] += bytes[i] == '\0' ? 1U : 0U;
    }
    if (zeros[1] * 2 > looked / 2 && zeros[0] * 10 < zeros[1]) {
        return Encoding::Utf16LittleEndian;
    }
    if (zeros[0] * 2 > looked / 2 && zeros[1] * 10 < zeros[0]) {
        return Encoding::Utf16BigEndian;
    }
    return std::nullopt;
}

/// Korean by its pairs: letters and signs of KS X 1001 have both bytes high; an accent of Windows-1252 stands before an
/// ASCII letter.
bool looksKorean(std::string_view bytes) {
    std::size_t korean = 0;
    std::size_t western = 0;
    for (std::size_t i = 0; i < bytes.size(); ++i) {
        const auto lead = static_cast<unsigned char>(bytes[i]);
        if (lead < 0x80) {
            continue;
        }
        const auto trail = i + 1 < bytes.size() ? static_cast<unsigned char>(bytes[i + 1]) : 0U;
        if (trail < 0x80U) {
            ++western;
            continue;
        }
        korean += trail >= 0xA1U && ((lead >= 0xA1 && lead <= 0xAC) || (lead >= 0xB0 && lead <= 0xC8)) ? 1U : 0U;
        ++i;
    }
    return korean > 0 && korean >= western;
}

DecodedText converted(std::string_view bytes, Encoding encoding) {
    DecodedText out;
    out.encoding = encoding;
    Converter converter(encoding);
    if (!converter.usable()) {
        out.utf8.assign(bytes.size(), '?');
        out.damaged = true;
        return out;
    }
    out.damaged = converter.run(bytes, out.utf8) > 0;
    if (out.utf8.starts_with("\xEF\xBB\xBF")) {
        out.utf8.erase(0, 3);
    }
    out.ascii = std::ranges::all_of(out.utf8, [](char c) { return static_cast<unsigned char>(c) < 0x80; });
    return out;
}

}  // namespace

const char* nameOf(Encoding encoding) noexcept {
    switch (encoding) {
        case Encoding::Utf16LittleEndian:
        case Encoding::Utf16BigEndian:
            return "UTF-16";
        case Encoding::Windows1252:
            return "Windows-1252";
        case Encoding::Cp949:
            return "CP949";
        case Encoding::Utf8:
            break;
    }
    return "UTF-8";
}

std::optional<Encoding> encodingOf(std::string_view name) {
    std::string key;
    for (const char c : name) {
        if (c != '-' && c != '_' && c != ' ') {
            key += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
        }
    }
    if (key == "utf8") return Encoding::Utf8;
    if (key == "utf16" || key == "utf16le") return Encoding::Utf16LittleEndian;
    if (key == "utf16be") return Encoding::Utf16BigEndian;
    if (key == "windows1252" || key == "cp1252" || key == "latin1" || key == "iso88591") return Encoding::Windows1252;
    if (key == "cp949" || key == "euckr" || key == "uhc" || key == "ms949") return Encoding::Cp949;
    return std::nullopt;
}

bool isValidUtf8(std::string_view bytes) noexcept {
    while (!bytes.empty()) {
        const std::size_t length = sequenceLength(bytes);
        if (length == 0) {
            return false;
        }
        bytes.remove_prefix(length);
    }
    return true;
}

DecodedText decodeText(std::string_view bytes, std::optional<Encoding> as) {
    if (bytes.starts_with("\xFF\xFE")) {
        return converted(bytes.substr(2), Encoding::Utf16LittleEndian);
    }
    if (bytes.starts_with("\xFE\xFF")) {
        return converted(bytes.substr(2), Encoding::Utf16BigEndian);
    }
    if (as) {
        return converted(bytes, *as);
    }
    if (const auto utf16 = utf16WithoutMark(bytes)) {
        return converted(bytes, *utf16);
    }
    if (isValidUtf8(bytes)) {
        DecodedText out;
        out.utf8 = bytes.starts_with("\xEF\xBB\xBF") ? bytes.substr(3) : bytes;
        out.ascii = std::ranges::all_of(out.utf8, [](char c) { return static_cast<unsigned char>(c) < 0x80; });
        return out;
    }
    if (bytes.starts_with("\xEF\xBB\xBF")) {
        return converted(bytes, Encoding::Utf8);  // says what it is, and is damaged
    }
    if (looksKorean(bytes)) {
        DecodedText korean = converted(bytes, Encoding::Cp949);
        if (!korean.damaged) {
            return korean;
        }
    }
    return converted(bytes, Encoding::Windows1252);
}

std::string utf8Of(std::string_view bytes) {
    return decodeText(bytes).utf8;
}

}  // namespace kerf::files
