// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

namespace kerf {

/// Share of the way that a lag of the first order goes in one step: 1 − e^(−dt/τ).
///
/// Steps mostly have one length: the power is taken anew only when dt or τ is another one.
class LagShare {
 public:
    [[nodiscard]] double of(double dt_s, double lag_s) noexcept {
        if (dt_s != m_dt_s || lag_s != m_lag_s) {
            m_dt_s = dt_s;
            m_lag_s = lag_s;
            m_share = 1.0 - std::exp(-dt_s / lag_s);
        }
        return m_share;
    }

 private:
    double m_dt_s{0.0};
    double m_lag_s{1.0};
    double m_share{0.0};
};

}  // namespace kerf
