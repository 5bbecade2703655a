// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/core/sentence.h"

#include "engine/core/number_text.h"

namespace kerf {

std::string formatArg(const SentenceArg& arg) {
    if (arg.decimals < 0) {
        return arg.name.data();
    }
    return fixedText(arg.value, arg.decimals);
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
