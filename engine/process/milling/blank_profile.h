// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "engine/core/result.h"

namespace kerf::milling {

/// Allowance of a blank along the path: sharp steps, each with the height of material over the finished wall.
///
/// Fixed memory, so that a law can look ahead in the cycle. Before the first step stands `before_mm` (0: air), after
/// the end the last height, or air if made with `airAfter`.
class BlankProfile {
 public:
    static constexpr std::size_t kMaxSteps = 256;

    BlankProfile() = default;
    /// Steps of equal length. Heights 0…50 mm, length > 0.
    [[nodiscard]] static Result<BlankProfile> ofSegments(std::span<const double> heights_mm, double segment_mm);
    /// Steps that begin at the given positions (strictly rising); the last one ends at `end_mm`.
    [[nodiscard]] static Result<BlankProfile> ofSteps(std::span<const double> begin_mm,
                                                      std::span<const double> heights_mm, double end_mm);
    /// The same blank with air before its first step, after its end, or both.
    [[nodiscard]] BlankProfile inAir(bool before, bool after) const noexcept;
    /// What a person who measured badly believes: shifted along the path, every height scaled.
    [[nodiscard]] BlankProfile distorted(double shift_mm, double heightFactor) const noexcept;

    /// Radial depth engaged with the tool axis at `x_mm`: the share of heights y ∈ [0, r] at which the blank, met
    /// √(2 r y − y²) ahead of the axis, still stands. A step is thus cut into gradually, not at once.
    [[nodiscard]] double engagedDepth_mm(double x_mm, double toolRadius_mm) const noexcept;
    [[nodiscard]] double height_mm(double x_mm) const noexcept;
    [[nodiscard]] double begin_mm() const noexcept { return m_begin_mm[0]; }
    [[nodiscard]] double end_mm() const noexcept { return m_end_mm; }
    [[nodiscard]] std::size_t size() const noexcept { return m_count; }

 private:
    std::size_t m_count{0};
    std::array<double, kMaxSteps> m_begin_mm{};
    std::array<double, kMaxSteps> m_height_mm{};
    double m_end_mm{0.0};
    double m_before_mm{0.0};
    double m_after_mm{0.0};
};

}  // namespace kerf::milling
