// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "engine/process/boring/stretch.h"

/// What the next lot begins from: an estimate over the lots that were bored before.
///
///   tree      shop → machine → part type → insert grade → material → lot → tool → stretch
///             θ(child) = θ(parent) + e,  e ~ N(0, τ²), its own τ (level, α, β) for every kind of step
///   shop      N(prior, prior spread) of KalmanParams: the wide prior, which is all there is without a past
///   evidence  Λ, h of each stretch; messages go up the tree in closed form, the next lot's θ comes down it
///   spreads   every τ² is its posterior mean on a grid, given the others, under a log-normal prior; three passes.
///             A kind of step with one branch only keeps its prior; between several machines that all share a part
///             type, grade or material, that step has no spread. Few lots: the prior's wide right tail stays in the
///             mean, so the interval is wide
///
/// Level is ln d at the past's mean ln S and ln L, where level, α and β hardly mix. All is a pure function of the lots
/// handed in: nothing is carried from one lot's start to the next, so leaving a lot out or correcting one of its bores
/// is the same computation again.
/// Source of the tree: normal hierarchical model, e.g. Gelman et al., Bayesian Data Analysis, 3rd ed., chapters 5 and
/// 15. Cost: some milliseconds for a hundred lots; allocates, not for the cycle.
namespace kerf::boring {

/// What a lot has in common with others, from the widest to the narrowest.
struct MemoryContext {
    static constexpr std::size_t kLevels = 4;
    std::array<std::string, kLevels> names{};  ///< machine, part type, insert grade, material; empty: not told
    friend bool operator==(const MemoryContext&, const MemoryContext&) = default;
};

struct PastLot {
    std::int64_t id{0};  ///< any but −1, which is the lot in work
    MemoryContext context{};
    std::vector<Stretch> stretches{};
};

/// Spreads τ by kind of step, in the order of the tree.
enum class MemoryStep : std::uint8_t { Machine, PartType, Grade, Material, Lot, Insert, Regrind, Batch };
inline constexpr std::size_t kMemorySteps = 8;
[[nodiscard]] const char* memoryStepKey(MemoryStep step) noexcept;

struct MemorySpread {
    MemoryStep step{MemoryStep::Lot};
    std::array<double, 3> tau{};  ///< level, α, β: root of the posterior mean of τ²
    std::uint32_t branches{0};    ///< that it was estimated from; below 2 the prior holds
};

/// How much one lot counts for what the next one begins from.
struct MemoryWeight {
    std::int64_t lot{0};
    double share{0.0};  ///< of the expected level; with the prior's share these add up to 1
};

/// A law to begin with. Level is ln d at (lnFeed, lnOverhang).
struct MemoryStart {
    LawConstants law{};
    Covariance covariance{};
    double lnFeed{0.0}, lnOverhang{0.0};
    double level{0.0};
    std::array<double, 3> spread{};  ///< standard deviations of level, α, β
};

class Memory {
 public:
    /// Lots without a stretch are of no use and are ignored. `lotSoFar`: what the lot in work has shown already; empty
    /// before its first part.
    Memory(std::span<const PastLot> past, MemoryContext now, const KalmanParams& params,
           std::span<const Stretch> lotSoFar = {});

    /// The past, or the lot itself, says more than the wide prior does.
    [[nodiscard]] bool usable() const noexcept { return m_usable; }
    /// For the next part: the first one of the lot, or the first one after a change within it.
    [[nodiscard]] MemoryStart start(StretchKind kind = StretchKind::Insert) const;

    [[nodiscard]] const std::vector<MemorySpread>& spreads() const noexcept { return m_spreads; }
    /// In the order of the past.
    [[nodiscard]] const std::vector<MemoryWeight>& weights() const noexcept { return m_weights; }
    [[nodiscard]] double priorShare() const noexcept { return m_priorShare; }

 private:
    [[nodiscard]] MemoryStart startOf(const Eigen::Vector3d& mean, const Eigen::Matrix3d& covariance) const;

    KalmanParams m_params;
    std::vector<Stretch> m_lotSoFar;
    double m_lnFeed{0.0}, m_lnOverhang{0.0};
    std::array<Eigen::Vector3d, kMemorySteps> m_variance{};  ///< τ² by step
    Eigen::Vector3d m_mean{Eigen::Vector3d::Zero()};         ///< of the narrowest context, centred, about the prior
    Eigen::Matrix3d m_covariance{Eigen::Matrix3d::Zero()};
    bool m_usable{false};
    std::vector<MemorySpread> m_spreads{};
    std::vector<MemoryWeight> m_weights{};
    double m_priorShare{1.0};
};

/// An estimator that begins from memory instead of from its wide prior.
[[nodiscard]] KalmanState stateFrom(const MemoryStart& start, const KalmanParams& params) noexcept;

}  // namespace kerf::boring
