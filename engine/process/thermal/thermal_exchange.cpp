// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/process/thermal/thermal_exchange.h"

#include <algorithm>

namespace kerf {

LiveModel::LiveModel(const thermal::ThermalModel& model, std::uint32_t number) : estimator(model), revision(number) {
    for (std::size_t i = 0; i < model.sensors.size(); ++i) {
        name[i] = SentenceArg(std::string_view(model.sensors[i].name));
    }
}

Result<std::unique_ptr<LiveModel>> LiveModel::make(const thermal::ThermalModel& model,
                                                   std::span<const std::string> channelNames, std::uint32_t number) {
    auto live = std::make_unique<LiveModel>(model, number);
    int missing = 0;
    const thermal::ModelSensor* first = nullptr;
    for (std::size_t i = 0; i < model.sensors.size(); ++i) {
        const auto found = std::ranges::find(channelNames, model.sensors[i].name);
        if (found == channelNames.end()) {
            live->channel[i] = kNoChannel;
            first = first == nullptr ? &model.sensors[i] : first;
            ++missing;
        } else {
            live->channel[i] = static_cast<std::uint16_t>(found - channelNames.begin());
        }
    }
    if (missing > thermal::ThermalEstimator::kMaxLost) {
        return fail(KERF_TEXT("This machine has no thermocouple %1; %2 of the model's %3 are missing."),
                    SentenceArg(std::string_view(first->name)), SentenceArg(missing, 0),
                    SentenceArg(static_cast<double>(model.sensors.size()), 0));
    }
    return live;
}

ThermalExchange::~ThermalExchange() {
    delete m_offered.load();
    delete m_retired.load();
}

void ThermalExchange::offer(std::unique_ptr<LiveModel> model) {
    delete m_offered.exchange(model.release(), std::memory_order_acq_rel);
}

void ThermalExchange::collect() {
    delete m_retired.exchange(nullptr, std::memory_order_acq_rel);
}

LiveModel* ThermalExchange::take() noexcept {
    if (m_offered.load(std::memory_order_relaxed) == nullptr || m_retired.load(std::memory_order_acquire) != nullptr) {
        return nullptr;
    }
    return m_offered.exchange(nullptr, std::memory_order_acq_rel);
}

}  // namespace kerf
