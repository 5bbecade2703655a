// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/quality/charts.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "engine/core/sentence.h"
#include "engine/quality/distributions.h"

namespace kerf::quality {
namespace {

constexpr double kInside3Sigma = 0.9973002039367398;      // 2 Φ(3) − 1
constexpr double kMovingRangeFactor = 1.128379167095513;  // d2 of two: 2/√π

struct RuleName {
    const char* key;
    const char* text;
};
constexpr std::array<RuleName, kRules> kNames{{
    {"nelson1", KERF_TEXT("one beyond 3σ")},
    {"nelson2", KERF_TEXT("9 in a row on one side")},
    {"nelson3", KERF_TEXT("6 rising or falling")},
    {"nelson4", KERF_TEXT("14 alternating")},
    {"nelson5", KERF_TEXT("2 of 3 beyond 2σ")},
    {"nelson6", KERF_TEXT("4 of 5 beyond 1σ")},
    {"nelson7", KERF_TEXT("15 in a row within 1σ")},
    {"nelson8", KERF_TEXT("8 in a row beyond 1σ")},
    {"western1", KERF_TEXT("one beyond 3σ")},
    {"western2", KERF_TEXT("2 of 3 beyond 2σ")},
    {"western3", KERF_TEXT("4 of 5 beyond 1σ")},
    {"western4", KERF_TEXT("8 in a row on one side")},
    {"ewma", KERF_TEXT("lasting error (EWMA)")},
    {"cusum", KERF_TEXT("lasting error (CUSUM)")},
}};

}  // namespace

const char* ruleKey(Rule rule) noexcept {
    return kNames[static_cast<std::size_t>(rule)].key;
}

const char* ruleText(Rule rule) noexcept {
    return kNames[static_cast<std::size_t>(rule)].text;
}

std::optional<Rule> ruleOf(std::string_view key) noexcept {
    for (std::size_t i = 0; i < kRules; ++i) {
        if (key == kNames[i].key) {
            return static_cast<Rule>(i);
        }
    }
    return std::nullopt;
}

template <class Claim>
bool ChartState::lastAll(std::size_t points, Claim claim) const noexcept {
    if (m_count < points) {
        return false;
    }
    for (std::size_t i = 0; i < points; ++i) {
        if (!claim(past(i))) {
            return false;
        }
    }
    return true;
}

bool ChartState::zone(std::size_t least, std::size_t points, double sigmas) const noexcept {
    const double side = past(0) > 0.0 ? 1.0 : -1.0;
    if (side * past(0) <= sigmas) {
        return false;
    }
    std::size_t beyond = 0;
    for (std::size_t i = 0; i < std::min(points, m_count); ++i) {
        beyond += side * past(i) > sigmas ? 1U : 0U;
    }
    return beyond >= least;
}

bool ChartState::oneSide(std::size_t points) const noexcept {
    return lastAll(points, [](double e) { return e > 0.0; }) || lastAll(points, [](double e) { return e < 0.0; });
}

bool ChartState::trend() const noexcept {
    constexpr std::size_t kPoints = 6;
    if (m_count < kPoints) {
        return false;
    }
    bool rising = true;
    bool falling = true;
    for (std::size_t i = 0; i + 1 < kPoints; ++i) {
        rising = rising && past(i) > past(i + 1);
        falling = falling && past(i) < past(i + 1);
    }
    return rising || falling;
}

bool ChartState::alternation() const noexcept {
    constexpr std::size_t kPoints = 14;
    if (m_count < kPoints) {
        return false;
    }
    for (std::size_t i = 0; i + 2 < kPoints; ++i) {
        if ((past(i) - past(i + 1)) * (past(i + 1) - past(i + 2)) >= 0.0) {
            return false;
        }
    }
    return true;
}

ChartPoint ChartState::push(double error, std::optional<bool> beyond) noexcept {
    m_past[m_count % kMemory] = error;
    ++m_count;
    const double keep = 1.0 - m_params.ewmaLambda;
    m_ewma = m_params.ewmaLambda * error + keep * m_ewma;
    m_forgotten *= keep * keep;
    m_high = std::max(0.0, m_high + error - m_params.cusumAllowance);
    m_low = std::max(0.0, m_low - error - m_params.cusumAllowance);

    ChartPoint point{error, m_ewma, 0.0, m_high, m_low, {}};
    point.ewmaLimit = ewmaLimit(1.0, m_params.ewmaLambda, m_params.ewmaWidth) *
                      (m_params.ewmaSteadyState ? 1.0 : std::sqrt(1.0 - m_forgotten));

    const auto within1 = [](double e) { return std::abs(e) < 1.0; };
    const auto beyond1 = [](double e) { return std::abs(e) > 1.0; };
    const auto fires = [&](Rule rule) {
        switch (rule) {
            case Rule::Nelson1:
                return beyond.value_or(std::abs(error) > 3.0);
            case Rule::Western1:
                return std::abs(error) > 3.0;
            case Rule::Nelson2:
                return oneSide(9);
            case Rule::Nelson3:
                return trend();
            case Rule::Nelson4:
                return alternation();
            case Rule::Nelson5:
            case Rule::Western2:
                return zone(2, 3, 2.0);
            case Rule::Nelson6:
            case Rule::Western3:
                return zone(4, 5, 1.0);
            case Rule::Nelson7:
                return lastAll(15, within1);
            case Rule::Nelson8:
                return lastAll(8, beyond1);
            case Rule::Western4:
                return oneSide(8);
            case Rule::Ewma:
                return std::abs(m_ewma) > point.ewmaLimit;
            case Rule::Cusum:
                return std::max(m_high, m_low) > m_params.cusumLimit;
        }
        return false;
    };
    for (std::size_t i = 0; i < kRules; ++i) {
        point.fired[i] = m_params.active[i] && fires(static_cast<Rule>(i));
    }
    return point;
}

double tSquaredLimit(std::size_t depths) {
    return chiSquareQuantile(static_cast<double>(depths), kInside3Sigma);
}

double ewmaLimit(double sigma, double lambda, double width) noexcept {
    assert(lambda > 0.0 && lambda <= 1.0);
    return width * sigma * std::sqrt(lambda / (2.0 - lambda));
}

CentreLine centreLine(std::span<const double> values) noexcept {
    CentreLine line;
    if (values.empty()) {
        return line;
    }
    double sum = values[0];
    double ranges = 0.0;
    for (std::size_t i = 1; i < values.size(); ++i) {
        sum += values[i];
        ranges += std::abs(values[i] - values[i - 1]);
    }
    line.centre = sum / static_cast<double>(values.size());
    line.sigma = values.size() < 2 ? 0.0 : ranges / static_cast<double>(values.size() - 1) / kMovingRangeFactor;
    return line;
}

}  // namespace kerf::quality
