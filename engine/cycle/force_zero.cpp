// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/cycle/force_zero.h"

#include <algorithm>
#include <cmath>

#include "engine/core/units.h"

namespace kerf {
namespace {

constexpr std::int64_t kBlock_ns = 20'000'000;
constexpr std::int64_t kGap_ns = 200'000'000;  // samples stay away: what came before says nothing any more
constexpr std::size_t kHeldBack = 2;           // blocks in which a tooth may bite that has not been noticed
constexpr std::size_t kLeast = 5;              // blocks of a zero
constexpr std::size_t kMost = 60;
constexpr std::size_t kEnds = 3;    // blocks at either end of a zero that are compared
constexpr std::size_t kListen = 3;  // blocks of air before a reset
constexpr std::size_t kBelow = 12;  // blocks in the cut
constexpr std::int64_t kSettle_ns = 100'000'000;
constexpr std::int64_t kPatience_ns = 500'000'000;  // for a zero, beside the reset
constexpr double kMoveShare = 0.5;                  // of what can be borne
constexpr double kBiteDeviations = 5.0;
constexpr int kBiteUp = 2;
constexpr int kBiteCount = 6;
constexpr double kSure = 2.0;
constexpr double kShortestLearnt_s = 1.0;

double seconds(std::int64_t span_ns) noexcept {
    return static_cast<double>(span_ns) / kNanosecondPerSecond;
}

}  // namespace

void ForceZero::begin(const ForceZeroParams& params) noexcept {
    keepBefore(false);
    m_params = params;
    m_moved_N.reset();
    m_anySample = false;
    m_known = m_taken = false;
    m_doubt_N = 0.0;
    if (!params.signal.zeroInAir) {
        m_state = ForceZeroState::Own;
        m_zero_N = 0.0;
        return;
    }
    m_state = ForceZeroState::Taking;
    enter(params.resetLine ? Phase::Listening : Phase::Taking, 0);
}

void ForceZero::leave() noexcept {
    if (m_state == ForceZeroState::Own) {
        return;
    }
    keepBefore(true);
    m_taken = false;
    if (!m_known) {
        m_anySample = false;
        m_state = ForceZeroState::Taking;
    }
    enter(Phase::Taking, 0);
}

void ForceZero::end(bool inAir) noexcept {
    if (m_state == ForceZeroState::Own || m_phase != Phase::Cutting || !m_known || !inAir) {
        return;
    }
    m_moved_N.reset();
    const Mean after = meanOf(kHeldBack, std::min(kLeast, m_quiet > kHeldBack ? m_quiet - kHeldBack : 0));
    if (after.blocks >= kLeast) {
        learn(after, m_zero_N, m_error_N, m_zero_ns);
    }
}

void ForceZero::learn(const Mean& after, double before_N, double beforeError_N, std::int64_t before_ns) noexcept {
    m_moved_N = after.value_N - before_N;
    const double span_s = seconds(after.middle_ns - before_ns);
    if (span_s > kShortestLearnt_s) {
        m_learnt_NPerS = std::max(0.0, std::abs(*m_moved_N) - kSure * (after.error_N + beforeError_N)) / span_s;
    }
}

void ForceZero::keepBefore(bool sameCut) noexcept {
    if (m_known) {
        m_before = Before{m_zero_N, m_error_N, m_zero_ns, sameCut};
    } else if (m_before) {
        m_before->sameCut = m_before->sameCut && sameCut;
    }
}

void ForceZero::enter(Phase phase, std::int64_t now_ns) noexcept {
    m_phase = phase;
    m_since_ns = now_ns;
    m_over = 0;
    forget();
}

void ForceZero::forget() noexcept {
    m_count = 0;
    m_quiet = 0;
    m_samples = 0;
}

ForceZero::Mean ForceZero::meanOf(std::size_t newest, std::size_t most) const noexcept {
    Mean mean;
    const std::size_t there = std::min(m_count, kBlocks);
    mean.blocks = there > newest ? std::min(there - newest, most) : 0;
    if (mean.blocks == 0) {
        return mean;
    }
    const auto count = static_cast<double>(mean.blocks);
    double middle_ns = 0.0;
    const std::int64_t origin_ns = back(newest).middle_ns;
    for (std::size_t i = 0; i < mean.blocks; ++i) {
        const Block& block = back(newest + i);
        mean.value_N += block.mean_N / count;
        mean.deviation_N += block.deviation_N / count;
        middle_ns += static_cast<double>(block.middle_ns - origin_ns) / count;
    }
    mean.middle_ns = origin_ns + static_cast<std::int64_t>(middle_ns);
    double squares_N2 = 0.0;
    for (std::size_t i = 0; i < mean.blocks; ++i) {
        const double off_N = back(newest + i).mean_N - mean.value_N;
        squares_N2 += off_N * off_N;
    }
    mean.error_N = mean.blocks > 1 ? std::sqrt(squares_N2 / (count - 1.0) / count) : mean.deviation_N;
    return mean;
}

double ForceZero::rate_NPerS() const noexcept {
    return std::max(m_params.signal.drift_NPerS, m_learnt_NPerS);
}

void ForceZero::addToBlock(double raw_N, std::int64_t stamp_ns) noexcept {
    if ((m_samples > 0 || m_count > 0) && stamp_ns - m_blockTo_ns > kGap_ns) {
        forget();
    }
    if (m_samples == 0) {
        m_blockFrom_ns = stamp_ns;
        m_origin_N = raw_N;
        m_sum_N = m_sumSquares_N2 = 0.0;
    }
    const double off_N = raw_N - m_origin_N;
    m_sum_N += off_N;
    m_sumSquares_N2 += off_N * off_N;
    m_blockTo_ns = stamp_ns;
    ++m_samples;
    if (stamp_ns - m_blockFrom_ns >= kBlock_ns && m_samples > 1) {
        closeBlock();
    }
}

void ForceZero::closeBlock() noexcept {
    const auto count = static_cast<double>(m_samples);
    const double mean_N = m_sum_N / count;
    Block block;
    block.mean_N = m_origin_N + mean_N;
    block.deviation_N = std::sqrt(std::max(0.0, m_sumSquares_N2 / count - mean_N * mean_N));
    block.middle_ns = m_blockFrom_ns + (m_blockTo_ns - m_blockFrom_ns) / 2;
    m_samples = 0;
    const bool jumps = m_count > 0 && std::abs(block.mean_N - back(0).mean_N) > m_params.bite_N;
    const bool quiet = block.deviation_N < m_params.bite_N && !jumps;
    m_blocks[m_count % kBlocks] = block;
    ++m_count;
    m_quiet = quiet ? std::min(m_quiet + 1, kBlocks) : 0;
    follow();
}

void ForceZero::follow() noexcept {
    switch (m_phase) {
        case Phase::Listening:
            if (m_quiet >= kListen) {
                enter(Phase::Resetting, m_blockTo_ns);
            }
            break;
        case Phase::Taking:
            takeZero();
            break;
        case Phase::Cutting:
            if (m_count >= kBelow && meanOf(0, kBelow).value_N < m_zero_N - m_params.trust_N - m_error_N) {
                m_state = ForceZeroState::Doubtful;
            }
            break;
        case Phase::Resetting:
        case Phase::Settling:
            break;
    }
}

/// The first teeth of a cut that begins in the work are small, and grow.
bool ForceZero::rises() const noexcept {
    const Mean late = meanOf(0, kEnds);
    const Mean early = meanOf(std::min(m_quiet, kMost) - kEnds, kEnds);
    return std::abs(late.value_N - early.value_N) >
           kMoveShare * m_params.trust_N + kSure * std::hypot(late.error_N, early.error_N);
}

/// Of the blocks since the last one that was no air.
void ForceZero::takeZero() noexcept {
    if (m_quiet < kLeast + kHeldBack) {
        return;
    }
    const Mean mean = meanOf(kHeldBack, std::min(m_quiet - kHeldBack, kMost));
    const double bound_N =
        kMoveShare * m_params.trust_N + m_params.signal.drift_NPerS * seconds(mean.middle_ns - m_first_ns);
    if (m_taken && std::abs(mean.value_N - m_first_N) > bound_N) {
        bite(m_blockTo_ns);
        return;
    }
    if (!m_taken && rises()) {
        return;
    }
    if (!m_taken) {
        m_first_N = mean.value_N;
        m_first_ns = mean.middle_ns;
        if (m_before && m_before->sameCut) {
            learn(mean, m_before->zero_N, m_before->error_N, m_before->stamp_ns);
        } else if (m_before) {
            m_moved_N = mean.value_N - m_before->zero_N;
        }
    }
    m_known = m_taken = true;
    m_zero_N = mean.value_N;
    m_error_N = mean.error_N;
    m_air_N = mean.deviation_N;
    m_zero_ns = mean.middle_ns;
    m_state = ForceZeroState::Known;
}

void ForceZero::bite(std::int64_t now_ns) noexcept {
    enter(Phase::Cutting, now_ns);
}

void ForceZero::watchBite(double raw_N) noexcept {
    const double bite_N = std::max(m_params.bite_N, kBiteDeviations * m_air_N);
    m_over = raw_N - m_zero_N > bite_N ? m_over + kBiteUp : std::max(0, m_over - 1);
    if (m_over >= kBiteCount) {
        bite(m_blockTo_ns);
    }
}

void ForceZero::watchDrift(std::int64_t now_ns) noexcept {
    m_doubt_N = kSure * m_error_N + rate_NPerS() * std::max(0.0, seconds(now_ns - m_zero_ns));
    if (m_doubt_N > m_params.trust_N) {
        m_state = ForceZeroState::Doubtful;
    }
}

FastSample ForceZero::take(const FastSample& raw) noexcept {
    if (m_state == ForceZeroState::Own) {
        return raw;
    }
    FastSample out = raw;
    const std::int64_t now_ns = raw.stamp_ns;
    if (!m_anySample) {
        m_anySample = true;
        m_begun_ns = m_since_ns = now_ns;
    }
    const std::int64_t reset_ns = static_cast<std::int64_t>(m_params.signal.reset_s * kNanosecondPerSecond);
    if (m_phase == Phase::Resetting && now_ns - m_since_ns >= reset_ns) {
        enter(Phase::Settling, now_ns);
    } else if (m_phase == Phase::Settling && now_ns - m_since_ns >= kSettle_ns) {
        enter(Phase::Taking, now_ns);
    }
    const bool good = raw.quality == Quality::Good && std::isfinite(raw.force_N);
    if (good && m_phase != Phase::Resetting && m_phase != Phase::Settling) {
        if (m_known && m_phase == Phase::Taking) {
            watchBite(raw.force_N);
        }
        addToBlock(raw.force_N, now_ns);
    }
    if (m_known) {
        watchDrift(now_ns);
    } else if (now_ns - m_begun_ns > kPatience_ns + (m_params.resetLine ? reset_ns + kSettle_ns : 0)) {
        m_state = ForceZeroState::Missed;
    }
    if (m_state == ForceZeroState::Known) {
        out.force_N = raw.force_N - m_zero_N;
    } else {
        out.force_N = 0.0;
        out.quality = std::min(raw.quality, m_state == ForceZeroState::Taking ? Quality::Missing : Quality::Bad);
    }
    return out;
}

}  // namespace kerf
