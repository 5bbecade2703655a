// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>

#include "engine/process/turning/turning_exchange.h"

namespace kerf::turning {

/// Fills the exchange's slots in place while a part is cut; without an exchange it does nothing. In the cycle: no
/// allocation, lock, throw or I/O.
class TurningTrace {
 public:
    explicit TurningTrace(TurningExchange* exchange) noexcept : m_exchange(exchange) {}

    void beginPart(std::uint32_t partSequence, double spindle_rps) noexcept {
        m_sequence = partSequence;
        m_spindle_rps = spindle_rps;
        m_number = 0;
        beginSurface();
        if (m_exchange != nullptr) {
            m_exchange->traces.writeSlot() = TurningForceTrace{};
            m_exchange->traces.writeSlot().partSequence = partSequence;
        }
    }
    void force(double progress, double force_N) noexcept {
        if (m_exchange == nullptr) {
            return;
        }
        TurningForceTrace& trace = m_exchange->traces.writeSlot();
        const auto piece =
            std::min(TurningForceTrace::kPieces - 1, static_cast<std::size_t>(progress * TurningForceTrace::kPieces));
        const auto value_N = static_cast<float>(force_N);
        const std::uint32_t n = ++trace.samples[piece];
        trace.low_N[piece] = n == 1 ? value_N : std::min(trace.low_N[piece], value_N);
        trace.high_N[piece] = n == 1 ? value_N : std::max(trace.high_N[piece], value_N);
        trace.mean_N[piece] += (value_N - trace.mean_N[piece]) / static_cast<float>(n);
    }
    void surface(double treated_um, double untreated_um, bool trimmed) noexcept {
        if (m_exchange == nullptr) {
            return;
        }
        TurningSurface& surface = m_exchange->surfaces.writeSlot();
        m_treated_um += treated_um;
        m_untreated_um += untreated_um;
        surface.trimmed = surface.trimmed && trimmed;
        if (++m_samples < TurningSurface::kDecimation) {
            return;
        }
        surface.treated_um[surface.count] = static_cast<float>(m_treated_um / TurningSurface::kDecimation);
        surface.untreated_um[surface.count] = static_cast<float>(m_untreated_um / TurningSurface::kDecimation);
        m_treated_um = m_untreated_um = 0.0;
        m_samples = 0;
        if (++surface.count == TurningSurface::kPoints) {
            m_exchange->surfaces.publish();
            beginSurface();
        }
    }
    void endPart() noexcept {
        if (m_exchange != nullptr) {
            m_exchange->traces.publish();
        }
    }

 private:
    void beginSurface() noexcept {
        if (m_exchange == nullptr) {
            return;
        }
        TurningSurface& surface = m_exchange->surfaces.writeSlot();
        surface.partSequence = m_sequence;
        surface.number = ++m_number;
        surface.count = 0;
        surface.trimmed = true;
        surface.spindle_rps = m_spindle_rps;
        m_treated_um = m_untreated_um = 0.0;
        m_samples = 0;
    }

    TurningExchange* m_exchange;
    std::uint32_t m_sequence{0};
    std::uint32_t m_number{0};
    double m_spindle_rps{0.0};
    double m_treated_um{0.0};
    double m_untreated_um{0.0};
    std::size_t m_samples{0};
};

}  // namespace kerf::turning
