// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/process/turning/turning_setup.h"

#include <array>

#include "engine/process/turning/overlap.h"

namespace kerf::turning {
namespace {

constexpr const char* kPaper = KERF_TEXT("Jeong & Kim: the cut in copper");
constexpr const char* kOwn = KERF_TEXT("this machine");

constexpr std::array<ParamSpec, kSetupFields> kSpecs{{
    {"turning.depth_um", KERF_TEXT("Depth of cut"), "um", 0.1, 50.0, 6.0, 2, kPaper},
    {"turning.spindle_speed_rpm", KERF_TEXT("Spindle speed"), "rpm", 150.0, 30000.0, 1032.0, 0, kPaper},
    {"turning.feed_um_per_rev", KERF_TEXT("Feed per revolution"), "um", 0.01, 1000.0, 5.8, 2, kPaper},
    {"turning.tool_radius_um", KERF_TEXT("Tool radius"), "um", 10.0, 100000.0, 800.0, 0, kPaper},
    {"turning.face_from_mm", KERF_TEXT("Face from"), "mm", -1000.0, 1000.0, 0.0, 2, kOwn},
    {"turning.face_to_mm", KERF_TEXT("Face to"), "mm", -1000.0, 1000.0, 1.0, 2, kOwn},
    {"turning.trim_authority_um", KERF_TEXT("Trim authority"), "um", 0.0, 2.0, 2.0, 2, kOwn},
}};
constexpr ParamSpec kTone{"turning.tone_hz", KERF_TEXT("Known tone"), "Hz", 9.0, 400.0, 120.0, 1, kOwn};

}  // namespace

std::span<const ParamSpec> setupSpecs() noexcept {
    return kSpecs;
}
const ParamSpec& toneSpec() noexcept {
    return kTone;
}

double valueOf(const TurningSetup& s, SetupField field) noexcept {
    const std::array values{s.depth_um,    s.spindleSpeed_rpm, s.feed_umPerRev,   s.toolRadius_um,
                            s.faceFrom_mm, s.faceTo_mm,        s.trimAuthority_um};
    return values[static_cast<std::size_t>(field)];
}

void setValue(TurningSetup& s, SetupField field, double value) noexcept {
    const std::array values{&s.depth_um,    &s.spindleSpeed_rpm, &s.feed_umPerRev,   &s.toolRadius_um,
                            &s.faceFrom_mm, &s.faceTo_mm,        &s.trimAuthority_um};
    *values[static_cast<std::size_t>(field)] = value;
}

std::optional<Sentence> whyUnusable(const TurningSetup& setup) noexcept {
    for (std::size_t i = 0; i < kSetupFields; ++i) {
        if (auto why = whyOutOfRange(kSpecs[i], valueOf(setup, static_cast<SetupField>(i)))) {
            return why;
        }
    }
    if (!(setup.faceTo_mm > setup.faceFrom_mm)) {
        return Sentence(KERF_TEXT("The face must end beyond its start."));
    }
    if (setup.knownToneCount > kTurningTones) {
        return Sentence(KERF_TEXT("At most 8 known tones."));
    }
    for (std::size_t j = 0; j < setup.knownToneCount; ++j) {
        if (auto why = whyOutOfRange(kTone, setup.knownTones_Hz[j])) {
            return why;
        }
    }
    const auto overlap = overlapFactor(setup.toolRadius_um, setup.depth_um, setup.feed_umPerRev);
    return overlap ? std::nullopt : std::optional<Sentence>(overlap.error());
}

}  // namespace kerf::turning
