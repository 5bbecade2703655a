// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "engine/port/machine_port.h"

namespace kerf {

/// What the machine says of its force sensor's zero, and what a process can bear.
struct ForceZeroParams {
    ForceSignal signal{};
    bool resetLine{false};  ///< the amplifier can be reset (Capabilities::forceReset)
    double bite_N{20.0};    ///< this far above the zero a tooth is in the work, > 0
    double trust_N{8.0};    ///< error of the zero that can be borne, > 0
};

/// Zero of a force sensor that does not keep it: piezo sensors and their charge amplifiers drift. One for every
/// process.
///
///   z      mean of the raw force in the air before the cut, over .1 s at least and 1.2 s at most, without the newest
///   .04 s:
///          a tooth may be biting there, and has not yet been told from noise
///   air    a block of 20 ms whose standard deviation is below bite_N; teeth in the work scatter more. A mean that runs
///          away from the first one by more than half of trust_N is a cut that begins slowly: the zero stands
///   bite   samples above z + bite_N (or five standard deviations of the air), more of them than below, six counts
///   doubt  e(t) = 2 s_z + r (t − t_z); s_z standard error of z, r the stated drift or the one seen over the last
///          cut, whichever is larger. Doubtful while e > trust_N, or once a quarter of a second in the cut lies below
///          z − trust_N: no force pulls the tool out of the work
///   reset  where there is a line: asked for once .06 s of air have been seen, for the sensor's reset time; .1 s to
///   settle
///
/// Samples pass take(): with the zero subtracted while it is known; Missing while it is taken; Bad when it was missed
/// or is doubtful. N, sign as the samples. All functions run in the cycle: no allocation, lock, throw or I/O.
class ForceZero {
 public:
    /// A cut begins, in the air: the zero is taken anew.
    void begin(const ForceZeroParams& params) noexcept;
    /// Next raw sample in time order.
    [[nodiscard]] FastSample take(const FastSample& raw) noexcept;
    /// The tool has left the work, as the process knows it: the zero is taken anew, until then the old one counts.
    void leave() noexcept;
    /// The cut is over. `inAir`: it ended as programmed, so that the last samples are of a tool in the air.
    void end(bool inAir) noexcept;

    [[nodiscard]] ForceZeroState state() const noexcept { return m_state; }
    /// The reset line is to be held.
    [[nodiscard]] bool wantsReset() const noexcept {
        return m_state != ForceZeroState::Own && m_phase == Phase::Resetting;
    }
    /// The line is held, or the amplifier settles behind it: the signal says nothing.
    [[nodiscard]] bool resetting() const noexcept {
        return m_state != ForceZeroState::Own && (m_phase == Phase::Resetting || m_phase == Phase::Settling);
    }
    /// The last one known; 0 before.
    [[nodiscard]] double zero_N() const noexcept { return m_zero_N; }
    [[nodiscard]] double trust_N() const noexcept { return m_params.trust_N; }
    /// How wrong the zero may be by now; 0 without one.
    [[nodiscard]] double doubt_N() const noexcept { return m_doubt_N; }
    /// How far it has moved from the air before to this one, the last cut between them; empty: not known.
    [[nodiscard]] std::optional<double> moved_N() const noexcept { return m_moved_N; }

 private:
    enum class Phase : std::uint8_t { Listening, Resetting, Settling, Taking, Cutting };
    struct Block {
        double mean_N{0.0};
        double deviation_N{0.0};
        std::int64_t middle_ns{0};
    };
    /// Mean of blocks with its standard error.
    struct Mean {
        std::size_t blocks{0};
        double value_N{0.0};
        double error_N{0.0};
        double deviation_N{0.0};
        std::int64_t middle_ns{0};
    };

    void enter(Phase phase, std::int64_t now_ns) noexcept;
    void forget() noexcept;
    void addToBlock(double raw_N, std::int64_t stamp_ns) noexcept;
    void closeBlock() noexcept;
    void follow() noexcept;
    [[nodiscard]] bool rises() const noexcept;
    void takeZero() noexcept;
    void bite(std::int64_t now_ns) noexcept;
    void learn(const Mean& after, double before_N, double beforeError_N, std::int64_t before_ns) noexcept;
    void watchBite(double raw_N) noexcept;
    void watchDrift(std::int64_t now_ns) noexcept;
    [[nodiscard]] const Block& back(std::size_t ago) const noexcept { return m_blocks[(m_count - 1 - ago) % kBlocks]; }
    [[nodiscard]] Mean meanOf(std::size_t newest, std::size_t most) const noexcept;
    [[nodiscard]] double rate_NPerS() const noexcept;

    static constexpr std::size_t kBlocks = 64;

    ForceZeroParams m_params{};
    ForceZeroState m_state{ForceZeroState::Own};
    Phase m_phase{Phase::Taking};
    std::int64_t m_since_ns{0};  ///< of the phase
    std::int64_t m_begun_ns{0};  ///< of taking, resets and all
    bool m_anySample{false};
    std::array<Block, kBlocks> m_blocks{};
    std::size_t m_count{0};  ///< blocks since the last forget()
    std::size_t m_quiet{0};  ///< the newest of them that are air
    double m_sum_N{0.0};     ///< of the block under way, about m_origin_N
    double m_sumSquares_N2{0.0};
    double m_origin_N{0.0};
    std::size_t m_samples{0};
    std::int64_t m_blockFrom_ns{0};
    std::int64_t m_blockTo_ns{0};
    bool m_known{false};
    bool m_taken{false};  ///< … in this stay in the air
    double m_zero_N{0.0};
    double m_first_N{0.0};  ///< the first of this stay in the air
    std::int64_t m_first_ns{0};
    double m_error_N{0.0};
    double m_air_N{0.0};  ///< standard deviation of a sample in the air
    std::int64_t m_zero_ns{0};
    double m_doubt_N{0.0};
    int m_over{0};
    double m_learnt_NPerS{0.0};
    /// Zero of the air before, and whether only the cut lies between (nobody may have reset the amplifier).
    struct Before {
        double zero_N{0.0};
        double error_N{0.0};
        std::int64_t stamp_ns{0};
        bool sameCut{false};
    };
    void keepBefore(bool sameCut) noexcept;
    std::optional<Before> m_before{};
    std::optional<double> m_moved_N{};
};

}  // namespace kerf
