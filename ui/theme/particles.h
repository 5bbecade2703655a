// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace kerf::ui {

/// Korean particles that depend on the word before them: translations write both, "이(가)", "을(를)", "은(는)",
/// "와(과)" and "(으)로", and the one that fits what was filled in stays ("공작물 16이", "공작물 3이", "25 mm를").
///
/// Read aloud: Hangul by its final consonant, digits by their Korean names, Latin words by their last letter as Korean
/// says it, units by their names (mm 밀리미터, µm 마이크로미터, °C 도, % 퍼센트). Text without such particles is
/// unchanged.
[[nodiscard]] QString withParticles(const QString& text);

}  // namespace kerf::ui
