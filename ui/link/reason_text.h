// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <string>

namespace kerf::ui {

/// A stored reason for a screen: those that Kerf gave itself are in the operator's language, a person's own words stay.
[[nodiscard]] QString reasonText(const std::string& stored);

}  // namespace kerf::ui
