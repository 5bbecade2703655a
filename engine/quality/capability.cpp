// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/quality/capability.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "engine/quality/distributions.h"

namespace kerf::quality {

void Moments::add(double value) noexcept {
    m_smallest = m_count == 0 ? value : std::min(m_smallest, value);
    m_largest = m_count == 0 ? value : std::max(m_largest, value);
    m_first = m_count == 0 ? value : m_first;
    ++m_count;
    const double distance = value - m_first;
    const double off = distance - m_meanOff;
    m_meanOff += off / static_cast<double>(m_count);
    m_squares += off * (distance - m_meanOff);
}

double Moments::deviation() const noexcept {
    return m_count < 2 ? 0.0 : std::sqrt(std::max(0.0, m_squares) / static_cast<double>(m_count - 1));
}

IndexWithInterval potentialInterval(double index, std::size_t n, double confidence) {
    assert(n >= 2);
    const double degrees = static_cast<double>(n - 1);
    const double tail = (1.0 - confidence) / 2.0;
    return {index, index * std::sqrt(chiSquareQuantile(degrees, tail) / degrees),
            index * std::sqrt(chiSquareQuantile(degrees, 1.0 - tail) / degrees)};
}

IndexWithInterval centredInterval(double index, std::size_t n, double confidence) {
    assert(n >= 2);
    const double count = static_cast<double>(n);
    const double half =
        normalQuantile(0.5 + confidence / 2.0) * std::sqrt(1.0 / (9.0 * count) + index * index / (2.0 * (count - 1.0)));
    return {index, index - half, index + half};
}

Capability capability(const Moments& moments, const Tolerance& tolerance, bool quiet, double confidence) {
    Capability result;
    result.count = moments.count();
    result.mean = moments.mean();
    result.deviation = moments.deviation();
    if (!tolerance.lower && !tolerance.upper) {
        result.reason = Sentence(KERF_TEXT("There is no tolerance, so there are no indices."));
        return result;
    }
    if (result.count < kFewestForIndices) {
        result.reason = Sentence(KERF_TEXT("%1 parts are too few for indices; they begin at %2."),
                                 SentenceArg(static_cast<double>(result.count), 0),
                                 SentenceArg(static_cast<double>(kFewestForIndices), 0));
        return result;
    }
    if (!(result.deviation > 0.0)) {
        result.reason = Sentence(KERF_TEXT("All values are alike, so there are no indices: is the gauge too coarse?"));
        return result;
    }
    result.preliminary = result.count < kPreliminaryBelow;
    double nearest = 0.0;
    if (tolerance.lower && tolerance.upper) {
        nearest = std::min(*tolerance.upper - result.mean, result.mean - *tolerance.lower);
        result.pp = potentialInterval((*tolerance.upper - *tolerance.lower) / (6.0 * result.deviation), result.count,
                                      confidence);
    } else {
        nearest = tolerance.upper ? *tolerance.upper - result.mean : result.mean - *tolerance.lower;
    }
    result.ppk = centredInterval(nearest / (3.0 * result.deviation), result.count, confidence);
    if (quiet) {
        result.cp = result.pp;
        result.cpk = result.ppk;
    } else {
        result.reason = Sentence(
            KERF_TEXT("The residual chart shows a signal: these parts performed so, but it is no capability."));
    }
    return result;
}

Capability capability(std::span<const double> values, const Tolerance& tolerance, bool quiet, double confidence) {
    Moments moments;
    for (const double value : values) {
        moments.add(value);
    }
    return capability(moments, tolerance, quiet, confidence);
}

}  // namespace kerf::quality
