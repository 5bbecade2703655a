// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "app/files/dfq.h"

/// What other programs write where a Q-DAS file wants a number or a time, and what is meant all the same. Only for a
/// field whose place is known: a batch may look like a compact date.
namespace kerf::dfq {

/// Beside timeOf(): 20261127/101112, 20261127101112, 27112026 10:11, 2026.11.27, 27-11-2026, 27. 11. 2026, 27-Nov-2026,
/// Nov 27, 2026, "2026-11-27 오전 10:11:12", a weekday in front, Uhr behind, a clock with dots, 24:00.
[[nodiscard]] std::optional<Time> looseTimeOf(std::string_view text, SlashDates slashes);

/// Beside numberOf(): 0.011- for −0.011, "- 0.011", 1.234,5 and 1,234.5 and 1'234.5 with their thousands.
[[nodiscard]] std::optional<double> looseNumberOf(std::string_view text);

/// "50.011 mm" without its unit when that is `unit` (empty: not described, then mm, in, °, % and the like); else as it
/// is.
[[nodiscard]] std::string withoutUnit(std::string_view text, std::string_view unit);

/// Ends a file or comments it: "EOF", "// …", "; …".
[[nodiscard]] bool isRemark(std::string_view line);

}  // namespace kerf::dfq
