// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/process/boring/gcode_export.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstdarg>
#include <cstdio>

namespace kerf::boring {
namespace {

constexpr double kLeastDeviation = 0.001;
constexpr double kMostDeviation = 0.1;
constexpr int kBisections = 60;
constexpr std::size_t kFirstVariable = 101;

struct Segment {
    double end_mm{0.0};  ///< overhang
    double feed_mmPerRev{0.0};
};

[[gnu::format(printf, 1, 2)]] std::string line(const char* format, ...) {
    std::array<char, 160> text{};
    std::va_list values;
    va_start(values, format);
    std::vsnprintf(text.data(), text.size(), format, values);
    va_end(values);
    return text.data();
}

bool usable(const BoringSchedule& s) {
    const double sum = s.lnC + s.alpha + s.beta + s.targetDeflection_mm + s.overhangTo_mm + s.spindleSpeed_rpm;
    return std::isfinite(sum) && s.alpha > 0.0 && s.overhangFrom_mm > 0.0 && s.overhangTo_mm > s.overhangFrom_mm &&
           s.spindleSpeed_rpm > 0.0 && s.minFeed_mmPerRev > 0.0 && s.maxFeed_mmPerRev >= s.minFeed_mmPerRev &&
           (s.constantFeed_mmPerRev > 0.0 || s.targetDeflection_mm > 0.0);
}

bool usable(const GcodeParams& p) {
    const bool named = !p.name.empty() && p.name.size() <= 60 &&
                       std::ranges::all_of(p.name, [](unsigned char c) { return std::isalnum(c) != 0 || c == '_'; });
    return named && p.number >= 1 && p.number <= 9999 && p.deviation >= kLeastDeviation &&
           p.deviation <= kMostDeviation;
}

/// One feed for overhangs from…to: S(L) is monotonic, so its ends are the extremes.
double middleFeed_mmPerRev(const BoringSchedule& s, double from_mm, double to_mm) {
    return std::sqrt(s.feed_mmPerRev(from_mm) * s.feed_mmPerRev(to_mm));
}

double segmentEnd_mm(const BoringSchedule& s, double from_mm, double deviation) {
    const auto fits = [&](double to_mm) {
        return std::abs(std::log(s.feed_mmPerRev(from_mm) / s.feed_mmPerRev(to_mm))) <= 2.0 * std::log1p(deviation);
    };
    if (fits(s.overhangTo_mm)) {
        return s.overhangTo_mm;
    }
    double low_mm = from_mm;
    double high_mm = s.overhangTo_mm;
    for (int i = 0; i < kBisections; ++i) {
        const double middle_mm = 0.5 * (low_mm + high_mm);
        (fits(middle_mm) ? low_mm : high_mm) = middle_mm;
    }
    return low_mm;
}

std::vector<Segment> segmentsOf(const BoringSchedule& s, double deviation) {
    std::vector<Segment> segments;
    double from_mm = s.overhangFrom_mm;
    while (from_mm < s.overhangTo_mm && segments.size() <= kMostGcodeSegments) {
        const double to_mm = segmentEnd_mm(s, from_mm, deviation);
        segments.push_back({to_mm, middleFeed_mmPerRev(s, from_mm, to_mm)});
        from_mm = to_mm;
    }
    return segments;
}

}  // namespace

Result<std::vector<std::string>> boringSubroutine(const BoringSchedule& schedule, const GcodeParams& params) {
    if (!usable(schedule)) {
        return fail(
            KERF_TEXT("The schedule has a value outside its range: feeds, overhangs, speed and alpha above zero."));
    }
    if (!usable(params)) {
        return fail(
            KERF_TEXT("A subroutine needs a name of letters, digits and underscores, a number from 1 to 9999 and "
                      "a deviation from 0.001 to 0.1."));
    }
    const std::vector<Segment> segments = segmentsOf(schedule, params.deviation);
    if (segments.size() > kMostGcodeSegments) {
        return fail(KERF_TEXT("The schedule needs more than %1 segments: allow a larger deviation."),
                    SentenceArg(static_cast<double>(kMostGcodeSegments), 0));
    }
    const bool linuxCnc = params.dialect == GcodeDialect::LinuxCnc;
    std::vector<std::string> lines;
    lines.push_back(linuxCnc ? "o<" + params.name + "> sub" : line("O%04u", params.number));
    lines.push_back(line("(Kerf boring schedule %u: overhang %.3f to %.3f mm, %.1f rpm)", schedule.revision,
                         schedule.overhangFrom_mm, schedule.overhangTo_mm, schedule.spindleSpeed_rpm));
    lines.push_back(line("(ln C %.6f, alpha %.6f, beta %.6f, deflection %.6f mm)", schedule.lnC, schedule.alpha,
                         schedule.beta, schedule.targetDeflection_mm));
    lines.push_back(
        line("(feed within %.1f %% of the schedule; Z0 is where the bore begins)", 100.0 * params.deviation));
    for (std::size_t i = 0; i < segments.size(); ++i) {
        lines.push_back(line("#%zu=%.5f (mm/rev)", kFirstVariable + i, segments[i].feed_mmPerRev));
    }
    lines.emplace_back("G21 G90");
    lines.push_back(line("M3 S%.3f", schedule.spindleSpeed_rpm));
    lines.emplace_back("G0 Z0");
    lines.emplace_back(linuxCnc ? "G64 P0.002 (no stop between segments)" : "G64 (no stop between segments)");
    lines.push_back(line("G95 F#%zu", kFirstVariable));
    for (std::size_t i = 0; i < segments.size(); ++i) {
        lines.push_back(line("G1 Z-%.4f F#%zu", segments[i].end_mm - schedule.overhangFrom_mm, kFirstVariable + i));
    }
    lines.emplace_back("G94 F100");
    lines.emplace_back("G0 Z0");
    lines.emplace_back("M5");
    lines.push_back(linuxCnc ? "o<" + params.name + "> endsub" : std::string("M99"));
    if (linuxCnc) {
        lines.emplace_back("M2");
    }
    return lines;
}

}  // namespace kerf::boring
