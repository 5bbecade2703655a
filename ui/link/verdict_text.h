// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include "engine/quality/verdict.h"

namespace kerf::ui {

/// "good", "not judged", "rework possible", "scrap".
[[nodiscard]] QString verdictText(quality::Verdict verdict);
[[nodiscard]] constexpr bool isBad(quality::Verdict verdict) {
    return verdict == quality::Verdict::Rework || verdict == quality::Verdict::Scrap;
}

}  // namespace kerf::ui
