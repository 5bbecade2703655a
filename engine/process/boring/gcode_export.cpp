// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/process/boring/gcode_export.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <iterator>
#include <span>

#include "engine/core/number_text.h"

namespace kerf::boring {
namespace {

constexpr double kLeastDeviation = 0.001;
constexpr double kMostDeviation = 0.1;
constexpr int kBisections = 60;
constexpr std::size_t kFirstVariable = 101;
/// Every control with macros has #100…#149; #150…#199 are an option that has to be bought.
constexpr std::size_t kMostMacroVariables = 49;

struct Segment {
    double end_mm{0.0};  ///< overhang
    double feed_mmPerRev{0.0};
};

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

std::string variable(std::size_t index) {
    std::string name(1, '#');
    name += std::to_string(kFirstVariable + index);
    return name;
}

/// The letters between parentheses as upper case: some controls of the macro family refuse others.
std::string remark(const std::string& text, GcodeDialect dialect) {
    std::string shown(1, '(');
    shown += text;
    shown += ')';
    if (dialect == GcodeDialect::Macro) {
        std::ranges::transform(shown, shown.begin(),
                               [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
    }
    return shown;
}

std::vector<std::string> heading(const BoringSchedule& s, const GcodeParams& p) {
    return {
        remark("Kerf boring schedule " + std::to_string(s.revision) + ", overhang " + fixedText(s.overhangFrom_mm, 3) +
                   " to " + fixedText(s.overhangTo_mm, 3) + " mm, " + fixedText(s.spindleSpeed_rpm, 1) + " rpm",
               p.dialect),
        remark("ln C " + fixedText(s.lnC, 6) + ", alpha " + fixedText(s.alpha, 6) + ", beta " + fixedText(s.beta, 6) +
                   ", deflection " + fixedText(s.targetDeflection_mm, 6) + " mm",
               p.dialect),
        // Never a per cent sign: in the macro family it ends the program, in a remark too.
        remark("feed within " + fixedText(100.0 * p.deviation, 1) +
                   " per cent of the schedule, Z0 is where the bore begins",
               p.dialect)};
}

/// Feeds of up to `most` segments from `first` on, as variables from #101.
void addFeeds(std::vector<std::string>& lines, std::span<const Segment> segments, GcodeDialect dialect) {
    for (std::size_t i = 0; i < segments.size(); ++i) {
        lines.push_back(variable(i) + "=" + fixedText(segments[i].feed_mmPerRev, 5) + " " + remark("mm/rev", dialect));
    }
}

void addCuts(std::vector<std::string>& lines, std::span<const Segment> segments, double top_mm) {
    for (std::size_t i = 0; i < segments.size(); ++i) {
        lines.push_back("G1 Z-" + fixedText(segments[i].end_mm - top_mm, 4) + " F" + variable(i));
    }
}

std::string fourDigits(std::uint32_t number) {
    const std::string digits = std::to_string(number);
    return std::string(4 - std::min<std::size_t>(4, digits.size()), '0') + digits;
}

std::vector<std::string> linuxCncLines(const BoringSchedule& s, const GcodeParams& p,
                                       std::span<const Segment> segments) {
    // M73: whatever units, distance mode or feed mode the caller had, he has them again after endsub.
    std::vector<std::string> lines{"o<" + p.name + "> sub", "M73"};
    std::ranges::move(heading(s, p), std::back_inserter(lines));
    addFeeds(lines, segments, p.dialect);
    for (const std::string& one :
         {std::string("G21 G90 G40 G97"), std::string("M3 S") + fixedText(s.spindleSpeed_rpm, 3), std::string("G0 Z0"),
          std::string("G64 P0.002 (no stop between segments)"), std::string("G95 F") + variable(0)}) {
        lines.push_back(one);
    }
    addCuts(lines, segments, s.overhangFrom_mm);
    for (const std::string& one : {std::string("G94 F100"), std::string("G0 Z0"), std::string("M5"),
                                   "o<" + p.name + "> endsub", std::string("M2")}) {
        lines.push_back(one);
    }
    return lines;
}

/// Framed by %, whole spindle speed, capitals; more segments than variables are cut in passes that set them anew.
std::vector<std::string> macroLines(const BoringSchedule& s, const GcodeParams& p, std::span<const Segment> segments) {
    std::vector<std::string> lines{"%", std::string("O").append(fourDigits(p.number))};
    std::ranges::move(heading(s, p), std::back_inserter(lines));
    for (std::size_t from = 0; from < segments.size(); from += kMostMacroVariables) {
        const auto pass = segments.subspan(from, std::min(kMostMacroVariables, segments.size() - from));
        addFeeds(lines, pass, p.dialect);
        if (from == 0) {
            lines.insert(lines.end(), {"G21 G90", std::string("M3 S") + fixedText(std::round(s.spindleSpeed_rpm), 0),
                                       "G0 Z0", "G64 (NO STOP BETWEEN SEGMENTS)", std::string("G95 F") + variable(0)});
        }
        addCuts(lines, pass, s.overhangFrom_mm);
    }
    lines.insert(lines.end(), {"G94 F100", "G0 Z0", "M5", "M99", "%"});
    return lines;
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
    return params.dialect == GcodeDialect::LinuxCnc ? linuxCncLines(schedule, params, segments)
                                                    : macroLines(schedule, params, segments);
}

}  // namespace kerf::boring
