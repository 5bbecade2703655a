// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "engine/core/result.h"
#include "engine/core/spsc_ring.h"
#include "engine/process/thermal/thermal_estimator.h"
#include "engine/process/thermal/thermal_types.h"

namespace kerf {

/// A model ready to run: its estimator and the machine's channel of each of its sensors. Made outside the cycle.
struct LiveModel {
    static constexpr std::uint16_t kNoChannel = 0xFFFF;

    LiveModel(const thermal::ThermalModel& model, std::uint32_t number);

    /// Refuses a model with more than two sensors that this machine does not have.
    [[nodiscard]] static Result<std::unique_ptr<LiveModel>> make(const thermal::ThermalModel& model,
                                                                 std::span<const std::string> channelNames,
                                                                 std::uint32_t number);

    thermal::ThermalEstimator estimator;
    std::uint32_t revision{0};
    std::array<std::uint16_t, thermal::kMaxModelSensors> channel{};
    std::array<SentenceArg, thermal::kMaxModelSensors> name{};
};

/// What passes between the loop (engine thread) and the service (one other thread) beside commands and status. A model
/// is made and destroyed by the service; the cycle only takes the pointer and hands the old one back.
class ThermalExchange {
 public:
    ThermalExchange() = default;
    ThermalExchange(const ThermalExchange&) = delete;
    ThermalExchange& operator=(const ThermalExchange&) = delete;
    ~ThermalExchange();

    /// Service: this model goes live as soon as it has caught up; one not yet taken is dropped.
    void offer(std::unique_ptr<LiveModel> model);
    /// Service: destroy what the loop has handed back.
    void collect();

    /// Loop: a new model, or null. Taken only when there is room to hand the old one back.
    [[nodiscard]] LiveModel* take() noexcept;
    /// Loop: hand a model back. @pre take() has just given one, or the loop is being destroyed
    void retire(LiveModel* model) noexcept { m_retired.store(model, std::memory_order_release); }

    SpscRing<thermal::DayMeasurement> learnt{32};  ///< loop → service: what the live model has learnt from
    SpscRing<ThermalMinute> minutes{2048};         ///< loop → service; a full ring drops

 private:
    std::atomic<LiveModel*> m_offered{nullptr};
    std::atomic<LiveModel*> m_retired{nullptr};
};

}  // namespace kerf
