// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tl/expected.hpp>

#include "engine/core/sentence.h"

namespace kerf {

/// A value, or the one sentence that says why there is none. Bad input makes a Result; a program fault asserts.
template <class T>
using Result = tl::expected<T, Sentence>;

/// `return fail(KERF_TEXT("…%1…"), {x, 3});`
template <class... Args>
[[nodiscard]] constexpr tl::unexpected<Sentence> fail(const char* text, Args... args) {
    return tl::unexpected<Sentence>(Sentence(text, args...));
}

}  // namespace kerf
