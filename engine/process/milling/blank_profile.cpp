// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/process/milling/blank_profile.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace kerf::milling {
namespace {
constexpr double kMaxHeight_mm = 50.0;
constexpr double kMaxPosition_mm = 1e5;
}  // namespace

Result<BlankProfile> BlankProfile::ofSegments(std::span<const double> heights_mm, double segment_mm) {
    if (!(std::isfinite(segment_mm) && segment_mm > 0.0 && segment_mm <= kMaxPosition_mm)) {
        return fail(KERF_TEXT("The length of a blank segment must be above 0 and at most %1 mm."),
                    SentenceArg(kMaxPosition_mm, 0));
    }
    std::array<double, kMaxSteps> begin_mm{};
    for (std::size_t i = 0; i < std::min(heights_mm.size(), kMaxSteps); ++i) {
        begin_mm[i] = static_cast<double>(i) * segment_mm;
    }
    return ofSteps(std::span(begin_mm).first(std::min(heights_mm.size(), kMaxSteps)), heights_mm,
                   static_cast<double>(heights_mm.size()) * segment_mm);
}

Result<BlankProfile> BlankProfile::ofSteps(std::span<const double> begin_mm, std::span<const double> heights_mm,
                                           double end_mm) {
    if (heights_mm.empty() || heights_mm.size() > kMaxSteps || begin_mm.size() != heights_mm.size()) {
        return fail(KERF_TEXT("A blank profile needs from 1 to %1 steps."),
                    SentenceArg(static_cast<double>(kMaxSteps), 0));
    }
    BlankProfile profile;
    for (std::size_t i = 0; i < begin_mm.size(); ++i) {
        if (!(std::isfinite(heights_mm[i]) && heights_mm[i] >= 0.0 && heights_mm[i] <= kMaxHeight_mm)) {
            return fail(KERF_TEXT("Height of blank step %1 must be from 0 to %2 mm."),
                        SentenceArg(static_cast<double>(i + 1), 0), SentenceArg(kMaxHeight_mm, 0));
        }
        const double next_mm = i + 1 < begin_mm.size() ? begin_mm[i + 1] : end_mm;
        if (!(std::isfinite(begin_mm[i]) && std::isfinite(next_mm) && std::abs(next_mm) <= kMaxPosition_mm &&
              next_mm > begin_mm[i])) {
            return fail(KERF_TEXT("Blank step %1 must end after it begins."),
                        SentenceArg(static_cast<double>(i + 1), 0));
        }
        profile.m_begin_mm[i] = begin_mm[i];
        profile.m_height_mm[i] = heights_mm[i];
    }
    profile.m_count = begin_mm.size();
    profile.m_end_mm = end_mm;
    profile.m_before_mm = heights_mm.front();
    profile.m_after_mm = heights_mm.back();
    return profile;
}

BlankProfile BlankProfile::inAir(bool before, bool after) const noexcept {
    BlankProfile copy = *this;
    copy.m_before_mm = before ? 0.0 : copy.m_before_mm;
    copy.m_after_mm = after ? 0.0 : copy.m_after_mm;
    return copy;
}

BlankProfile BlankProfile::distorted(double shift_mm, double heightFactor) const noexcept {
    BlankProfile copy = *this;
    for (std::size_t i = 0; i < m_count; ++i) {
        copy.m_begin_mm[i] += shift_mm;
        copy.m_height_mm[i] *= heightFactor;
    }
    copy.m_end_mm += shift_mm;
    copy.m_before_mm *= heightFactor;
    copy.m_after_mm *= heightFactor;
    return copy;
}

double BlankProfile::height_mm(double x_mm) const noexcept {
    if (m_count == 0 || x_mm < m_begin_mm[0]) {
        return m_before_mm;
    }
    if (x_mm >= m_end_mm) {
        return m_after_mm;
    }
    const auto last = m_begin_mm.begin() + static_cast<std::ptrdiff_t>(m_count);
    const auto next = std::upper_bound(m_begin_mm.begin(), last, x_mm);
    return m_height_mm[static_cast<std::size_t>(next - m_begin_mm.begin()) - 1];
}

double BlankProfile::engagedDepth_mm(double x_mm, double toolRadius_mm) const noexcept {
    // Height of the tool's circle above the wall at a distance ahead of its axis.
    const auto circle_mm = [r = toolRadius_mm](double ahead_mm) {
        return ahead_mm <= 0.0 ? 0.0 : ahead_mm >= r ? r : r - std::sqrt((r - ahead_mm) * (r + ahead_mm));
    };
    double depth_mm = 0.0;
    const auto add = [&](double from_mm, double to_mm, double height_mm) {
        if (to_mm > x_mm && from_mm < x_mm + toolRadius_mm) {
            const double low_mm = circle_mm(from_mm - x_mm);
            depth_mm += std::max(0.0, std::min(circle_mm(to_mm - x_mm), height_mm) - low_mm);
        }
    };
    constexpr double kFar_mm = std::numeric_limits<double>::max();
    if (m_count == 0) {
        return 0.0;
    }
    add(-kFar_mm, m_begin_mm[0], m_before_mm);
    for (std::size_t i = 0; i < m_count; ++i) {
        add(m_begin_mm[i], i + 1 < m_count ? m_begin_mm[i + 1] : m_end_mm, m_height_mm[i]);
    }
    add(m_end_mm, kFar_mm, m_after_mm);
    return depth_mm;
}

}  // namespace kerf::milling
