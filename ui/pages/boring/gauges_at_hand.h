// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <map>
#include <string>
#include <vector>

#include "ui/services/quality_service.h"

namespace kerf::ui {

/// Which gauge of the register sends the readings: a keyboard line names no gauge, so a person says it once. Kept by
/// channel of the gauge's switch; kNoChannel is whatever carries none, and the machine's own gauge.
class GaugesAtHand {
 public:
    static constexpr int kNoChannel = 0;

    /// "0=G-07;2=G-08"; anything else in it is left out.
    static GaugesAtHand fromText(const QString& text);
    [[nodiscard]] QString text() const;

    /// Empty identity: none of the register.
    void set(int channel, const std::string& identity);
    /// What was said; else the only gauge of the register whose range holds the bore; else empty: not known.
    [[nodiscard]] std::string of(int channel, const std::vector<Gauge>& registered, double bore_mm) const;

 private:
    std::map<int, std::string> m_chosen{};
};

}  // namespace kerf::ui
