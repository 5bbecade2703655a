// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include <functional>

#include "ui/charts/chart.h"
#include "ui/link/verdict_text.h"
#include "ui/services/quality_service.h"

namespace kerf::ui {

/// What of a lot the charts show: the newest hundred up to a part, of a group alone when one is chosen.
struct PartWindow {
    PartId last{0};                         ///< 0: the newest
    std::function<bool(PartId)> belongs{};  ///< empty: all do
};

/// One-step errors against ±3 and their EWMA against its limits, newest parts right; a signal stands as a mark.
class ResidualChart final : public Chart {
    Q_OBJECT
 public:
    explicit ResidualChart(Look& look, QWidget* parent = nullptr);
    void setLot(const LotQuality& lot, const PartWindow& window);
    void retranslate();

 private:
    CurveId m_errors;
    CurveId m_ewma;
};

/// Measured values with tolerance, never with control limits: what the customer asks for.
class RawChart final : public Chart {
    Q_OBJECT
 public:
    explicit RawChart(Look& look, QWidget* parent = nullptr);
    void setLot(const LotQuality& lot, std::size_t characteristic, const PartWindow& window);
    void retranslate();

 private:
    CurveId m_values;
};

/// What the controller does: a feed that goes on falling is the wear of the tool.
class ActionChart final : public Chart {
    Q_OBJECT
 public:
    explicit ActionChart(Look& look, QWidget* parent = nullptr);
    void setLot(const LotQuality& lot, const PartWindow& window);
    void retranslate();

 private:
    CurveId m_feed;
};

/// How the values of all parts that were read lie in the tolerance, or those of a group.
class SpreadChart final : public Chart {
    Q_OBJECT
 public:
    explicit SpreadChart(Look& look, QWidget* parent = nullptr);
    void setLot(const LotQuality& lot, std::size_t characteristic, const PartWindow& window);
    void retranslate();

 private:
    CurveId m_counts;
};

/// "Ppk 1.42 (1.10 to 1.74), n 62" and the like, or why there is none.
[[nodiscard]] QString capabilityText(const quality::Capability& capability, const UnitSystem& units);
/// Parts of a chart's width.
inline constexpr std::size_t kChartParts = 100;
/// "Tool from part 11", "Kim", "entered by hand".
[[nodiscard]] QString groupName(const PartGroup& group);
[[nodiscard]] QString characteristicName(const Characteristic& characteristic);

}  // namespace kerf::ui
