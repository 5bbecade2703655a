// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/process/thermal/thermal_words.h"

#include <algorithm>

namespace kerf {

LoopVerdict thermalVerdict(const ThermalStatus& status, LoopMode mode, bool commanded) noexcept {
    const bool advises = mode == LoopMode::Advise;
    const bool limited = std::ranges::any_of(status.sizeLimited, [](bool flag) { return flag; }) ||
                         std::ranges::any_of(status.rateLimited, [](bool flag) { return flag; });
    switch (status.stage) {
        case ThermalStage::NoTemperatures:
            return {LoopState::Held, Sentence(KERF_TEXT("The machine sends no temperatures; the last shift stays."))};
        case ThermalStage::NoModel:
            return {LoopState::Held, Sentence(KERF_TEXT("There is no thermal model yet: train one."))};
        case ThermalStage::Baseline:
            return {LoopState::Advising,
                    Sentence(KERF_TEXT("The temperatures to count from are being taken; the shift stays."))};
        case ThermalStage::CatchUp:
            return {LoopState::Advising, Sentence(KERF_TEXT("The new model runs through the day so far."))};
        case ThermalStage::Holding:
            return {LoopState::Held,
                    Sentence(KERF_TEXT("Nothing can be predicted: too many thermocouples are left out."))};
        case ThermalStage::Following:
            break;
    }
    if (!commanded) {
        return {LoopState::Held,
                Sentence(KERF_TEXT("The control does not report its work offset; nothing is shifted."))};
    }
    if (limited) {
        return {LoopState::Limited, Sentence(advises ? KERF_TEXT("The shift would sit at its limit of size or rate.")
                                                     : KERF_TEXT("The shift sits at its limit of size or rate."))};
    }
    if (status.outside > kThermalOutside) {
        return {LoopState::Limited,
                Sentence(
                    advises ? KERF_TEXT("Outside the training range: the shift would fade to hold. Measure the origin.")
                            : KERF_TEXT("Outside the training range: the shift fades to hold. Measure the origin."))};
    }
    if (status.differs) {
        return {LoopState::Limited, Sentence(KERF_TEXT("Today differs from the days trained on: measure."))};
    }
    if (status.waitsForPart) {
        return {LoopState::Controlling, Sentence(KERF_TEXT("A part is being cut: the shift waits for its end."))};
    }
    return {LoopState::Controlling, Sentence(advises ? KERF_TEXT("The work origin would follow the predicted drift.")
                                                     : KERF_TEXT("The work origin follows the predicted drift."))};
}

}  // namespace kerf
