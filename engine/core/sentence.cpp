// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/core/sentence.h"

#include <cstdio>

namespace kerf {

std::string formatArg(const SentenceArg& arg) {
    if (arg.decimals < 0) {
        return arg.name.data();
    }
    std::array<char, 64> buffer{};
    const int length = std::snprintf(buffer.data(), buffer.size(), "%.*f", static_cast<int>(arg.decimals), arg.value);
    return {buffer.data(), static_cast<std::size_t>(length < 0 ? 0 : length)};
}

std::string Sentence::english() const {
    std::string out;
    for (const char* c = text; *c != '\0'; ++c) {
        const int index = (*c == '%' && c[1] >= '1' && c[1] <= '3') ? c[1] - '1' : -1;
        if (index >= 0 && index < argCount) {
            out += formatArg(args[static_cast<std::size_t>(index)]);
            ++c;
        } else {
            out += *c;
        }
    }
    return out;
}

}  // namespace kerf
