// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <optional>

/// Work-origin shift against the predicted drift, and the digital word that carries it to a control.
namespace kerf::thermal {

inline constexpr std::size_t kAxes = 3;  ///< X, Y, Z

/// Halfway cases to the even neighbour, whatever rounding mode the processor is in.
[[nodiscard]] double roundHalfEven(double value) noexcept;

/// How far and how fast one update may move the origin.
struct ShiftLimits {
    double quantum_um{1.0};     ///< > 0; the control moves in whole steps of this
    double maxShift_um{100.0};  ///< |total shift| ≤ this, ≥ quantum
    double maxStep_um{15.0};    ///< |change in one update| ≤ this, ≥ quantum
};

struct ShiftCommand {
    double step_um{0.0};   ///< change to command now, whole quanta
    double total_um{0.0};  ///< shift after it
    bool sizeLimited{false};
    bool rateLimited{false};
};

/// shift = round(−drift) − already shifted, in whole quanta, then limited in size and in step.
///
/// drift > 0: the cutting point has moved along +axis (µm); the origin is shifted by −drift. `applied_um` is what the
/// control reports as shifted, never what we believe to have sent: a restart in mid-shift is bumpless.
/// A drift that is not finite, or an applied shift that is not, commands nothing. Source: Ahn & Chung, compensatory
/// control, eq. of the shift per period; the limits are ours.
[[nodiscard]] ShiftCommand nextShift(double drift_um, double applied_um, const ShiftLimits& limits) noexcept;

/// How much of a new prediction to follow: 1 inside the training range, falling to 0 one span outside it (hold).
[[nodiscard]] double holdShare(double outsideSpans) noexcept;

/// The paper's digital word between PC and CNC. PC → CNC: bit 15 PC alive, bits 14-13 axis (X 0, Y 1, Z 2), bits 12-0
/// shift in two's complement, 1 µm per step (−4096…4095). CNC → PC: bit 4 start, bits 1-0 axis. The paper names the
/// fields; sign, scale and axis order are our reading of it.
struct ShiftWord {
    std::uint8_t axis{0};
    std::int16_t shift_um{0};
    bool alive{false};
    friend bool operator==(const ShiftWord&, const ShiftWord&) = default;
};
inline constexpr int kMinWordShift_um = -4096;
inline constexpr int kMaxWordShift_um = 4095;

/// Empty when the axis is not 0…2 or the shift does not fit 13 bits.
[[nodiscard]] std::optional<std::uint16_t> encodeShiftWord(const ShiftWord& word) noexcept;
/// Empty for the reserved axis 3.
[[nodiscard]] std::optional<ShiftWord> decodeShiftWord(std::uint16_t word) noexcept;

struct RequestWord {
    std::uint8_t axis{0};
    bool start{false};
    friend bool operator==(const RequestWord&, const RequestWord&) = default;
};
[[nodiscard]] std::optional<std::uint8_t> encodeRequestWord(const RequestWord& word) noexcept;
/// Bits other than 4, 1 and 0 are ignored; empty for the reserved axis 3.
[[nodiscard]] std::optional<RequestWord> decodeRequestWord(std::uint8_t word) noexcept;

/// What the CNC does with the alive bit: no living word within `timeout_s` means the console is gone, hold the last
/// shift.
class AliveWatch {
 public:
    explicit constexpr AliveWatch(double timeout_s) noexcept : m_timeout_s(timeout_s) {}
    /// A word arrived at `now_s`.
    void seen(const ShiftWord& word, double now_s) noexcept {
        if (word.alive) {
            m_last_s = now_s;
        }
    }
    [[nodiscard]] bool alive(double now_s) const noexcept { return m_last_s && now_s - *m_last_s <= m_timeout_s; }

 private:
    double m_timeout_s;
    std::optional<double> m_last_s{};
};

}  // namespace kerf::thermal
