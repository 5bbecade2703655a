// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "engine/core/sentence.h"

/// A recorded day: temperatures, spindle speed and, where it was measured, the drift of the machine origin.
namespace kerf::thermal {

using PresentMask = Eigen::Array<bool, Eigen::Dynamic, Eigen::Dynamic>;

struct ThermalHistory {
    std::string label{};                 ///< for reports: a file name or a date
    std::vector<std::string> sensors{};  ///< names of the temperature columns
    std::vector<double> time_min{};      ///< strictly rising; rows with time < 0 are the baseline
    std::vector<double> speed_rpm{};     ///< empty: spindle speed was not recorded
    Eigen::MatrixXd temp_degC{};         ///< rows × sensors; a missing reading is 0 and not present
    PresentMask present{};               ///< rows × sensors
    Eigen::MatrixXd drift_um{};          ///< rows × 3, measured; empty: not measured. Baseline rows are not used
    std::array<bool, 3> axes{true, true, true};  ///< X, Y, Z: measured at all; the column of one that is not is 0
    Eigen::MatrixXd trueDrift_um{};              ///< rows × 3, of a simulator; may be empty

    [[nodiscard]] Eigen::Index rows() const noexcept { return static_cast<Eigen::Index>(time_min.size()); }
    [[nodiscard]] Eigen::Index baselineRows() const noexcept;
    /// Rows at or after time 0.
    [[nodiscard]] Eigen::Index workRows() const noexcept { return rows() - baselineRows(); }
    [[nodiscard]] std::optional<Eigen::Index> sensorIndex(const std::string& name) const;
};

/// What is wrong with a history, and where.
struct HistoryFault {
    Eigen::Index row{0};
    std::string column{};
    Sentence reason{};
};

/// Training needs every reading, an even time step, temperatures in degC that move, and a measured drift in µm.
[[nodiscard]] std::optional<HistoryFault> whyNotTrainable(const ThermalHistory& history);
/// Prediction needs a baseline and rising time; missing readings are the sensors' health's business.
[[nodiscard]] std::optional<HistoryFault> whyNotUsable(const ThermalHistory& history);

/// FNV-1a over names and numbers of the training days: the same data give the same fingerprint.
[[nodiscard]] std::uint64_t fingerprintOf(const std::vector<ThermalHistory>& histories);

inline constexpr double kLowestTemp_degC = -30.0;  ///< of a shop-floor thermocouple; beyond: open or shorted
inline constexpr double kHighestTemp_degC = 150.0;

}  // namespace kerf::thermal
