// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>

#include "engine/process/tapping/tap_exchange.h"

namespace kerf {

/// One tap while it is made: both axes from its begin, the contour error E_r, the record and its figures.
///
/// E_r = 1000 (P s − z) in µm, with the pitch P in mm, the spindle's angle s in revolutions and the depth z in mm, both
/// counted from the first tick, z into the hole positive. Figures are over the samples that were seen: SAEC = Σ|E_r| in
/// mm, peak |E_r|, RMS, and the range of E_r from the engagement on. Sample k is always at tick k: cycles that did not
/// happen leave places that count as missing.
class TapRecorder {
 public:
    /// `records` outlives the recorder; the reader gets a record when a tap has ended.
    explicit TapRecorder(LatestValue<TapRecord>& records) noexcept : m_records(records) {}

    /// Pitch and engagement; between taps.
    void setJob(const TappingJob& job) noexcept { m_job = job; }
    void begin(std::uint32_t gainsRevision, TapKind kind, std::int64_t now_ns) noexcept;
    /// Where the machine's axes are now.
    void follow(double spindle_rev, double z_mm) noexcept;
    /// The place followed becomes a sample of the record; not `good`: one that is missing.
    void keep(bool good) noexcept;
    void fillGap(std::int64_t now_ns, std::int64_t tick_ns) noexcept;
    /// Too many ticks in a row without a signal, once in this tap: it stays so.
    void watchSignal() noexcept;
    /// What follows is no tap but the way out of one: followed, not recorded.
    void stopRecording() noexcept { m_recording = false; }
    /// Figures of what was seen; those of a tap that counts as if nothing were missing. Says whether enough was seen.
    [[nodiscard]] bool sumUp(bool whole) noexcept;
    /// Hands the record over, once.
    void publish(std::uint32_t number, TapOutcome outcome) noexcept;

    [[nodiscard]] bool recording() const noexcept { return m_recording; }
    [[nodiscard]] bool signalLost() const noexcept { return m_signalLost; }
    [[nodiscard]] std::uint32_t count() const noexcept { return m_records.writeSlot().count; }
    [[nodiscard]] std::uint32_t gainsRevision() const noexcept { return m_records.writeSlot().gains; }
    [[nodiscard]] std::int64_t begin_ns() const noexcept { return m_begin_ns; }
    [[nodiscard]] double spindle_rev() const noexcept { return m_spindle_rev; }
    [[nodiscard]] double z_mm() const noexcept { return m_z_mm; }
    [[nodiscard]] double error_um() const noexcept { return m_error_um; }
    [[nodiscard]] const TapFigures& figures() const noexcept { return m_figures; }
    /// mm of Z per revolution while moving (lag is in it too); empty before it says anything.
    [[nodiscard]] std::optional<double> pitchMoving_mm() const noexcept;
    /// mm of Z per revolution at the bottom, where both axes stand.
    [[nodiscard]] double pitchAtDepth_mm() const noexcept;
    [[nodiscard]] bool pitchFits() const noexcept;

 private:
    LatestValue<TapRecord>& m_records;
    TappingJob m_job{};
    TapFigures m_figures{};
    bool m_recording{false};
    bool m_signalLost{false};
    bool m_engaged{false};
    std::uint32_t m_lostInARow{0};
    std::int64_t m_begin_ns{0};
    double m_spindle_rev{0.0};
    double m_z_mm{0.0};
    double m_error_um{0.0};
    double m_spindleZero_rev{0.0};
    double m_zZero_mm{0.0};
    double m_squares_um2{0.0};
    double m_low_um{0.0};
    double m_high_um{0.0};
    double m_deepest_rev{0.0};
    double m_deepest_mm{0.0};
};

}  // namespace kerf
