// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/core/param_spec.h"

#include <cmath>

namespace kerf {

std::optional<Sentence> whyOutOfRange(const ParamSpec& spec, double value) {
    if (std::isfinite(value) && value >= spec.min && value <= spec.max) {
        return std::nullopt;
    }
    return Sentence(KERF_TEXT("%1 must be from %2 to %3."), SentenceArg(spec.label),
                    SentenceArg(spec.min, spec.decimals), SentenceArg(spec.max, spec.decimals));
}

}  // namespace kerf
