// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json_fwd.hpp>

namespace kerf {

/// One rule for the kept setups of every process (boring, milling, turning, thermal): a key that a revision does not
/// have, because it was written before there was one, has the default of its field, and the log names it once. A key
/// that is there and no number refuses the revision. What was found by measuring (a tuning, a tool, a model) has no
/// defaults: there a missing key refuses.
/// `what`: "turning setup", for the log. @throws nlohmann::json::exception when it is no number
[[nodiscard]] double numberOr(const nlohmann::json& setup, const char* key, double fallback, const char* what);

}  // namespace kerf
