// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/quality/gauge_study.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "engine/quality/capability.h"
#include "engine/quality/distributions.h"

namespace kerf::quality {
namespace {

constexpr double kConfidence = 0.95;
constexpr std::size_t kMostByRange = 25;
constexpr double kCategories = 1.41;

/// d2 and d3: mean and standard deviation of the range of m standard normal values.
struct RangeConstants {
    double d2;
    double d3;
};
constexpr std::array<RangeConstants, kMostByRange - 1> kRange{
    {{1.1284, 0.8525}, {1.6926, 0.8884}, {2.0588, 0.8798}, {2.3259, 0.8641}, {2.5344, 0.8480}, {2.7044, 0.8332},
     {2.8472, 0.8198}, {2.9700, 0.8078}, {3.0775, 0.7971}, {3.1729, 0.7873}, {3.2585, 0.7785}, {3.3360, 0.7704},
     {3.4068, 0.7630}, {3.4718, 0.7562}, {3.5320, 0.7499}, {3.5879, 0.7441}, {3.6401, 0.7386}, {3.6890, 0.7335},
     {3.7350, 0.7287}, {3.7783, 0.7242}, {3.8194, 0.7199}, {3.8583, 0.7159}, {3.8953, 0.7121}, {3.9306, 0.7084}}};

/// K1 by trials, AIAG's rounding where its table has it. @pre 2 ≤ m ≤ 25
double k1(std::size_t m) {
    constexpr std::array<double, 2> kTable{0.8862, 0.5908};
    return m - 2 < kTable.size() ? kTable[m - 2] : 1.0 / kRange[m - 2].d2;
}

/// K2 by persons and K3 by parts: one range, so 1/d2* with d2*² = d2² + d3².
double k2(std::size_t m) {
    constexpr std::array<double, 9> kTable{0.7071, 0.5231, 0.4467, 0.4030, 0.3742, 0.3534, 0.3375, 0.3249, 0.3146};
    return m - 2 < kTable.size() ? kTable[m - 2] : 1.0 / std::hypot(kRange[m - 2].d2, kRange[m - 2].d3);
}

void setDeviationInterval(double deviation, double degrees, double& low, double& high) {
    const double tail = (1.0 - kConfidence) / 2.0;
    low = deviation * std::sqrt(degrees / chiSquareQuantile(degrees, 1.0 - tail));
    high = deviation * std::sqrt(degrees / chiSquareQuantile(degrees, tail));
}

/// The readings as a full block: parts × persons × trials.
class Block {
 public:
    static Result<Block> of(std::span<const StudyReading> readings) {
        Block block;
        for (const StudyReading& reading : readings) {
            block.m_parts = std::max<std::size_t>(block.m_parts, reading.part + std::size_t{1});
            block.m_persons = std::max<std::size_t>(block.m_persons, reading.person + std::size_t{1});
            block.m_trials = std::max<std::size_t>(block.m_trials, reading.trial + std::size_t{1});
        }
        if (block.m_parts < 2 || block.m_persons < 2 || block.m_trials < 2) {
            return fail(KERF_TEXT("A crossed study needs at least 2 parts, 2 persons and 2 trials; it has %1, %2, %3."),
                        SentenceArg(static_cast<double>(block.m_parts), 0),
                        SentenceArg(static_cast<double>(block.m_persons), 0),
                        SentenceArg(static_cast<double>(block.m_trials), 0));
        }
        const auto incomplete = [](const StudyReading& at) {
            return fail(KERF_TEXT("The study is not crossed: part %1, person %2, trial %3 must stand there once."),
                        SentenceArg(at.part + 1.0, 0), SentenceArg(at.person + 1.0, 0), SentenceArg(at.trial + 1.0, 0));
        };
        // Twice is told before missing; either way the block is only made when it can be full.
        if (block.m_parts * block.m_persons * block.m_trials > readings.size() * 4) {
            return incomplete({static_cast<std::uint32_t>(block.m_parts - 1), 0, 0, 0.0});
        }
        std::vector<bool> there(block.m_parts * block.m_persons * block.m_trials);
        block.m_values.resize(there.size());
        for (const StudyReading& reading : readings) {
            const std::size_t i = block.index(reading.part, reading.person, reading.trial);
            if (there[i]) {
                return incomplete(reading);
            }
            there[i] = true;
            block.m_values[i] = reading.value;
        }
        if (const auto gap = std::ranges::find(there, false); gap != there.end()) {
            const auto i = static_cast<std::size_t>(gap - there.begin());
            return incomplete({static_cast<std::uint32_t>(i / (block.m_trials * block.m_persons)),
                               static_cast<std::uint32_t>(i / block.m_trials % block.m_persons),
                               static_cast<std::uint32_t>(i % block.m_trials), 0.0});
        }
        return block;
    }

    [[nodiscard]] std::size_t parts() const { return m_parts; }
    [[nodiscard]] std::size_t persons() const { return m_persons; }
    [[nodiscard]] std::size_t trials() const { return m_trials; }
    [[nodiscard]] const std::vector<double>& values() const { return m_values; }
    [[nodiscard]] std::span<const double> cell(std::size_t part, std::size_t person) const {
        return std::span(m_values).subspan(index(part, person, 0), m_trials);
    }
    [[nodiscard]] double cellMean(std::size_t part, std::size_t person) const {
        double sum = 0.0;
        for (const double value : cell(part, person)) {
            sum += value;
        }
        return sum / static_cast<double>(m_trials);
    }
    [[nodiscard]] double partMean(std::size_t part) const {
        double sum = 0.0;
        for (std::size_t person = 0; person < m_persons; ++person) {
            sum += cellMean(part, person);
        }
        return sum / static_cast<double>(m_persons);
    }
    [[nodiscard]] double personMean(std::size_t person) const {
        double sum = 0.0;
        for (std::size_t part = 0; part < m_parts; ++part) {
            sum += cellMean(part, person);
        }
        return sum / static_cast<double>(m_parts);
    }

 private:
    [[nodiscard]] std::size_t index(std::size_t part, std::size_t person, std::size_t trial) const {
        return (part * m_persons + person) * m_trials + trial;
    }
    std::size_t m_parts{0}, m_persons{0}, m_trials{0};
    std::vector<double> m_values;
};

template <class Mean>
double rangeOf(std::size_t count, Mean mean) {
    double low = mean(0);
    double high = low;
    for (std::size_t i = 1; i < count; ++i) {
        low = std::min(low, mean(i));
        high = std::max(high, mean(i));
    }
    return high - low;
}

/// √ of a variance component; a negative one is 0 and noted.
double component(double variance, bool& negative) {
    negative = variance < 0.0;
    return negative ? 0.0 : std::sqrt(variance);
}

void byAverageAndRange(const Block& block, CrossedStudy& study) {
    double ranges = 0.0;
    for (std::size_t part = 0; part < block.parts(); ++part) {
        for (std::size_t person = 0; person < block.persons(); ++person) {
            const auto [low, high] = std::ranges::minmax(block.cell(part, person));
            ranges += high - low;
        }
    }
    const double cells = static_cast<double>(block.parts() * block.persons());
    study.meanRange = ranges / cells;
    study.personDiff = rangeOf(block.persons(), [&](std::size_t i) { return block.personMean(i); });
    study.partRange = rangeOf(block.parts(), [&](std::size_t i) { return block.partMean(i); });
    study.ev = study.meanRange * k1(block.trials());
    const double between = study.personDiff * k2(block.persons());
    study.av = component(between * between - study.ev * study.ev / static_cast<double>(block.parts() * block.trials()),
                         study.avNegative);
    study.pv = study.partRange * k2(block.parts());
    // Degrees of freedom of a mean range: Patnaik's approximation, d2² and d3² of the range.
    const RangeConstants range = kRange[block.trials() - 2];
    setDeviationInterval(study.ev, cells * 0.5 * range.d2 * range.d2 / (range.d3 * range.d3), study.evLow,
                         study.evHigh);
}

void byAnova(const Block& block, CrossedStudy& study) {
    const double n = static_cast<double>(block.parts());
    const double k = static_cast<double>(block.persons());
    const double r = static_cast<double>(block.trials());
    double grand = 0.0;
    for (const double value : block.values()) {
        grand += value;
    }
    grand /= n * k * r;
    const auto square = [](double x) { return x * x; };
    for (const double value : block.values()) {
        study.ssTotal += square(value - grand);
    }
    for (std::size_t part = 0; part < block.parts(); ++part) {
        study.ssPart += k * r * square(block.partMean(part) - grand);
        for (std::size_t person = 0; person < block.persons(); ++person) {
            const double mean = block.cellMean(part, person);
            study.ssInteraction += r * square(mean - block.partMean(part) - block.personMean(person) + grand);
            for (const double value : block.cell(part, person)) {
                study.ssRepeatability += square(value - mean);
            }
        }
    }
    for (std::size_t person = 0; person < block.persons(); ++person) {
        study.ssPerson += n * r * square(block.personMean(person) - grand);
    }
    const double freePart = n - 1.0;
    const double freePerson = k - 1.0;
    const double freeInteraction = freePart * freePerson;
    const double freeRepeat = n * k * (r - 1.0);
    const double msInteraction = study.ssInteraction / freeInteraction;
    const double msRepeat = study.ssRepeatability / freeRepeat;
    if (msRepeat > 0.0) {
        study.fInteraction = msInteraction / msRepeat;
        study.pInteraction = fUpperTail(freeInteraction, freeRepeat, *study.fInteraction);
    } else {
        constexpr double kRounding = 1e-18;  // of the total: what sums of squares leave over
        study.pInteraction = study.ssInteraction > kRounding * study.ssTotal ? 0.0 : 1.0;
    }
    study.pooled = study.pInteraction > kPoolingAlpha;
    double error = msRepeat;         // what repetition alone makes
    double against = msInteraction;  // what persons and parts are compared with
    double freeError = freeRepeat;
    if (study.pooled) {
        freeError = freeInteraction + freeRepeat;
        error = (study.ssInteraction + study.ssRepeatability) / freeError;
        against = error;
    } else {
        study.interaction = component((msInteraction - msRepeat) / r, study.interactionNegative);
    }
    study.ev = std::sqrt(error);
    study.av = component((study.ssPerson / freePerson - against) / (n * r), study.avNegative);
    study.pv = component((study.ssPart / freePart - against) / (k * r), study.pvNegative);
    setDeviationInterval(study.ev, freeError, study.evLow, study.evHigh);
}

}  // namespace

Result<TypeOneStudy> typeOneStudy(std::size_t count, double mean, double deviation, double tolerance,
                                  std::optional<double> reference) {
    if (count < kFewestTypeOneReadings) {
        return fail(KERF_TEXT("%1 readings are too few; a type 1 study needs %2."),
                    SentenceArg(static_cast<double>(count), 0),
                    SentenceArg(static_cast<double>(kFewestTypeOneReadings), 0));
    }
    if (!(tolerance > 0.0)) {
        return fail(KERF_TEXT("The tolerance must be above 0; it is %1."), SentenceArg(tolerance, 6));
    }
    if (!(deviation > 0.0)) {
        return fail(KERF_TEXT("All readings are alike: the gauge is stuck, or too coarse for a study."));
    }
    TypeOneStudy study;
    study.count = count;
    study.mean = mean;
    study.deviation = deviation;
    study.cg = 0.2 * tolerance / (6.0 * deviation);
    study.pass = study.cg >= kGaugePass;
    if (reference) {
        study.bias = mean - *reference;
        study.cgk = (0.1 * tolerance - std::abs(*study.bias)) / (3.0 * deviation);
        study.pass = study.pass && *study.cgk >= kGaugePass;
    }
    setDeviationInterval(deviation, static_cast<double>(count - 1), study.deviationLow, study.deviationHigh);
    return study;
}

Result<TypeOneStudy> typeOneStudy(std::span<const double> readings, double tolerance, std::optional<double> reference) {
    Moments moments;
    for (const double reading : readings) {
        moments.add(reading);
    }
    return typeOneStudy(moments.count(), moments.mean(), moments.deviation(), tolerance, reference);
}

Result<CrossedStudy> crossedStudy(std::span<const StudyReading> readings, StudyMethod method,
                                  std::optional<double> tolerance) {
    if (tolerance && !(*tolerance > 0.0)) {
        return fail(KERF_TEXT("The tolerance must be above 0; it is %1."), SentenceArg(*tolerance, 6));
    }
    const Result<Block> block = Block::of(readings);
    if (!block) {
        return tl::unexpected(block.error());
    }
    CrossedStudy study;
    study.parts = block->parts();
    study.persons = block->persons();
    study.trials = block->trials();
    if (method == StudyMethod::AverageRange) {
        const std::size_t most = std::max({study.parts, study.persons, study.trials});
        if (most > kMostByRange) {
            return fail(KERF_TEXT("Average and range takes at most %1 parts, persons or trials; use ANOVA."),
                        SentenceArg(static_cast<double>(kMostByRange), 0));
        }
        byAverageAndRange(*block, study);
    } else {
        byAnova(*block, study);
    }
    study.grr = std::sqrt(study.ev * study.ev + study.av * study.av + study.interaction * study.interaction);
    study.tv = std::hypot(study.grr, study.pv);
    if (!(study.tv > 0.0)) {
        return fail(KERF_TEXT("All readings are alike: the gauge is stuck, or too coarse for a study."));
    }
    study.grrPercent = 100.0 * study.grr / study.tv;
    if (tolerance) {
        study.grrPercentOfTolerance = 100.0 * 6.0 * study.grr / *tolerance;
    }
    constexpr double kMostCategories = 1e6;  // a gauge without any spread of its own
    const double categories = study.grr > 0.0 ? std::floor(kCategories * study.pv / study.grr) : kMostCategories;
    study.ndc = static_cast<std::uint32_t>(std::clamp(categories, 1.0, kMostCategories));
    return study;
}

}  // namespace kerf::quality
