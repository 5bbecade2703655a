// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/process/turning/cut_watch.h"

#include <algorithm>

namespace kerf::turning {
namespace {

constexpr double kShareOfMean = 0.2;
constexpr double kFastShare = 1.0 / 3.0;
constexpr double kMeanShare = 1.0 / 5000.0;
constexpr double kUsualShare = 1.0 / 1000.0;
constexpr double kSigmas = 4.0;
constexpr double kNotFalling = 0.9;
constexpr int kInARow = 4;
constexpr int kLearning = 1000;  // .2 s before it may speak
constexpr int kEnough = 5000;

}  // namespace

bool CutWatch::update(double force_N, double chip_um, double innovation_um) noexcept {
    if (m_samples == 0) {
        m_process.settle(chip_um);
    }
    m_samples = std::min(m_samples + 1, kEnough);
    const double first = 1.0 / static_cast<double>(m_samples);
    const double beyond_N = force_N - m_process.step(chip_um + innovation_um);
    m_beyond_N += kFastShare * (beyond_N - m_beyond_N);
    const bool above = m_samples > kLearning && m_beyond_N > kShareOfMean * m_mean_N &&
                       m_beyond_N * m_beyond_N > kSigmas * kSigmas * m_usual_N2;
    m_above = above ? m_above + 1 : 0;
    m_most_N = above ? std::max(m_most_N, m_beyond_N) : 0.0;
    if (!above) {
        m_mean_N += std::max(kMeanShare, first) * (force_N - m_mean_N);
        m_usual_N2 += std::max(kUsualShare, first) * (m_beyond_N * m_beyond_N - m_usual_N2);
    }
    return m_above >= kInARow && m_beyond_N > kNotFalling * m_most_N;
}

}  // namespace kerf::turning
