// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "engine/core/result.h"

namespace kerf {

/// What somebody is trusted with; each may do what the ones before may.
enum class Trust : std::uint8_t {
    Operator,  ///< enter and correct measurements, a new tool, acknowledge
    Setter,    ///< part types, setups, tunings and models that are cut with, lots
    Engineer,  ///< recipes and limits
};

/// Asked by every service before it changes anything, whoever calls it: why this author may not; empty when he may. An
/// empty function asks nobody (a service on its own, in a test).
using Rights = std::function<std::optional<Sentence>(const std::string& author, Trust least)>;

/// The same as a result, for the first line of a change.
[[nodiscard]] inline Result<void> permitted(const Rights& rights, const std::string& author, Trust least) {
    if (author.empty()) {
        return fail(KERF_TEXT("Sign on first: a change needs a name."));
    }
    const auto why = rights ? rights(author, least) : std::nullopt;
    return why ? Result<void>(tl::unexpected<Sentence>(*why)) : Result<void>();
}

}  // namespace kerf
