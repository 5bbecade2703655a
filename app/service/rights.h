// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "engine/core/result.h"
#include "ui/services/permissions.h"

namespace kerf {

/// Why this author's role does not allow it; empty when it does. An empty function asks nobody (a service on its own,
/// in a test).
using Rights = std::function<std::optional<Sentence>(const std::string& author, Deed deed)>;

/// Asked by every service as the first line of a change, whoever calls it: somebody with a name, his role, and where
/// the table wants one (ui/services/permissions.h), a reason.
[[nodiscard]] inline Result<void> permitted(const Rights& rights, const std::string& author, Deed deed,
                                            const std::string& reason = {}) {
    if (author.empty()) {
        return fail(KERF_TEXT("Sign on first: a change needs a name."));
    }
    if (const auto why = rights ? rights(author, deed) : std::nullopt) {
        return tl::unexpected<Sentence>(*why);
    }
    if (permissionOf(deed).reason && reason.find_first_not_of(" \t\n") == std::string::npos) {
        return fail(KERF_TEXT("Give a reason: it is kept with the change."));
    }
    return {};
}

/// The same for a change that raises a limit: `far` by more than half, which wants a second person as well.
[[nodiscard]] inline Result<void> permittedLimit(const Rights& rights, const std::string& author, Deed deed,
                                                 const std::string& reason, bool far) {
    const auto may = permitted(rights, author, deed, reason);
    return may && far ? permitted(rights, author, Deed::LimitFar, reason) : may;
}

}  // namespace kerf
