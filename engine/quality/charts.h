// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <bitset>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <optional>
#include <span>
#include <string_view>

/// Control charts of a series in standard form, e = (y − centre)/σ.
///
///   one-step error  e_t = (y_t − ŷ_{t|t−1})/√S_t against ±3     white when the law is right, whatever the loop steers
///   T²              νᵀS⁻¹ν against the χ² quantile of .9973     several depths of one part
///   EWMA            z_t = λ e_t + (1 − λ) z_{t−1}, |z| ≤ w·√(λ/(2 − λ)·(1 − (1 − λ)^{2t})), or the limit for t → ∞
///   CUSUM           H_t = max(0, H + e − k), L_t = max(0, L − e − k), signal above h
///
/// Raw deviations of a process that is corrected after every part are neither independent nor centred by chance: rules
/// made for them alarm wrongly (docs/quality.md says how often). Sources: NIST/SEMATECH e-Handbook 6.3.2.3 (CUSUM) and
/// 6.3.2.4 (EWMA); Nelson, J. Quality Technology 16 (1984) 237; Western Electric, Statistical Quality Control Handbook
/// (1956). e is dimensionless; + is "more than predicted".
namespace kerf::quality {

enum class Rule : std::uint8_t {
    Nelson1,   ///< one beyond 3σ (with several depths: T² above its limit)
    Nelson2,   ///< 9 in a row on one side of the centre
    Nelson3,   ///< 6 in a row rising or falling
    Nelson4,   ///< 14 in a row alternating up and down
    Nelson5,   ///< 2 of 3 beyond 2σ on one side
    Nelson6,   ///< 4 of 5 beyond 1σ on one side
    Nelson7,   ///< 15 in a row within 1σ
    Nelson8,   ///< 8 in a row beyond 1σ, on either side
    Western1,  ///< one beyond 3σ
    Western2,  ///< 2 of 3 beyond 2σ on one side
    Western3,  ///< 4 of 5 beyond 1σ on one side
    Western4,  ///< 8 in a row on one side of the centre
    Ewma,
    Cusum,
};
inline constexpr std::size_t kRules = 14;
using RuleSet = std::bitset<kRules>;

/// Keys of the commands: nelson1 … nelson8, western1 … western4, ewma, cusum.
[[nodiscard]] const char* ruleKey(Rule rule) noexcept;
[[nodiscard]] std::optional<Rule> ruleOf(std::string_view key) noexcept;
/// "one beyond 3σ" and the like, English, marked for translation; short enough for an argument of a Sentence.
[[nodiscard]] const char* ruleText(Rule rule) noexcept;

[[nodiscard]] constexpr RuleSet rules(std::initializer_list<Rule> list) noexcept {
    unsigned long long bits = 0;
    for (const Rule rule : list) {
        bits |= 1ULL << static_cast<unsigned>(rule);
    }
    return RuleSet(bits);
}
[[nodiscard]] inline bool has(const RuleSet& set, Rule rule) noexcept {
    return set[static_cast<std::size_t>(rule)];
}

/// Few rules at once: all of them together are a named cause of alarm fatigue.
inline constexpr RuleSet kDefaultRules = rules({Rule::Nelson1, Rule::Ewma});

struct ChartParams {
    RuleSet active{kDefaultRules};
    double ewmaLambda{0.2};  ///< λ, (0, 1]
    double ewmaWidth{3.0};   ///< w, half width of the limits in standard deviations of z, > 0
    bool ewmaSteadyState{
        true};  ///< limits for t → ∞ from the first point; false: the exact, narrower ones at the start
    double cusumAllowance{0.5};  ///< k, ≥ 0
    double cusumLimit{5.0};      ///< h, > 0
};

/// What the charts say after one point.
struct ChartPoint {
    double error{0.0};
    double ewma{0.0};
    double ewmaLimit{0.0};  ///< ±
    double cusumHigh{0.0};
    double cusumLow{0.0};  ///< ≥ 0; how far the sum of negative errors has come
    RuleSet fired{};       ///< of the active rules only
};

/// The charts, point by point: a value type of a few hundred bytes that neither allocates nor throws.
class ChartState {
 public:
    explicit ChartState(const ChartParams& params = {}) noexcept : m_params(params) {}

    /// Takes the next point. `beyond`: T² is above its limit (several depths); otherwise |e| > 3 decides for rule 1.
    ChartPoint push(double error, std::optional<bool> beyond = std::nullopt) noexcept;
    /// Forget everything: a tool was changed, a lot began, or a person has acknowledged and dealt with the signal.
    void reset() noexcept { *this = ChartState(m_params); }
    [[nodiscard]] const ChartParams& params() const noexcept { return m_params; }

 private:
    static constexpr std::size_t kMemory = 15;  ///< the longest rule looks at 15 points
    /// `back` points ago, 0 is the newest. @pre back < min(m_count, kMemory)
    [[nodiscard]] double past(std::size_t back) const noexcept { return m_past[(m_count - 1 - back) % kMemory]; }
    template <class Claim>
    [[nodiscard]] bool lastAll(std::size_t points, Claim claim) const noexcept;
    /// `least` of the last `points` lie beyond `sigmas` on the newest one's side, the newest among them.
    [[nodiscard]] bool zone(std::size_t least, std::size_t points, double sigmas) const noexcept;
    [[nodiscard]] bool oneSide(std::size_t points) const noexcept;
    [[nodiscard]] bool trend() const noexcept;
    [[nodiscard]] bool alternation() const noexcept;

    ChartParams m_params;
    std::array<double, kMemory> m_past{};
    std::size_t m_count{0};
    double m_ewma{0.0};
    double m_forgotten{1.0};  ///< (1 − λ)^{2t}
    double m_high{0.0};
    double m_low{0.0};
};

/// T² limit for `depths` values of one part: the χ² quantile with the false-alarm rate of ±3σ. @pre depths > 0
[[nodiscard]] double tSquaredLimit(std::size_t depths);

/// Half width of the limits of an EWMA of points with standard deviation `sigma`, for t → ∞. @pre 0 < λ ≤ 1
[[nodiscard]] double ewmaLimit(double sigma, double lambda, double width) noexcept;

/// Mean, and σ from the mean moving range of neighbours (MR̄/1.128): for a raw series whose σ nobody has given.
struct CentreLine {
    double centre{0.0};
    double sigma{0.0};  ///< 0: fewer than two points, or all alike
};
[[nodiscard]] CentreLine centreLine(std::span<const double> values) noexcept;

}  // namespace kerf::quality
