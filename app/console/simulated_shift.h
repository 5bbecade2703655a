// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QTimer>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>

#include "engine/api/engine_api.h"
#include "ui/services/boring_service.h"

namespace kerf::console {

/// The hands beside the simulated machine: loads the next blank when every bore so far has been measured, and, where
/// asked, gauges and enters the bores. The console itself cannot tell them from a person's.
class SimulatedShift : public QObject {
    Q_OBJECT
 public:
    /// Who enters the simulated bores; no person has this name's rights by signing on with it.
    static constexpr const char* kAuthor = "Simulator";
    struct Params {
        std::uint32_t preparedParts{0};  ///< measured by itself and as fast as it can, before the operator comes
        bool autoOperator{false};        ///< measured by itself for the rest of the lot too
        double simulationSpeed{20.0};    ///< after the prepared parts
        /// What the other processes do beforehand, after the bores; called until it is true. Empty: nothing.
        std::function<bool()> others{};
    };
    /// `service` is null on a machine that does not bore.
    SimulatedShift(const Params& params, EngineApi& engine, BoringService* service, QObject* parent = nullptr);

    /// True once the prepared parts are done.
    [[nodiscard]] bool prepared() const noexcept { return m_prepared; }

 signals:
    void preparationDone();

 private:
    void tick();
    void enterWhatTheGaugeShows();
    void loadNextBlank();
    void setSpeed(double factor);
    [[nodiscard]] std::uint32_t partsDone() const;
    [[nodiscard]] bool boresDone() const { return m_service == nullptr || partsDone() >= m_params.preparedParts; }

    static constexpr int kTick_ms = 20;
    static constexpr int kStartPatience_ticks = 50;

    Params m_params;
    EngineApi& m_engine;
    BoringService* m_service;
    QTimer m_timer;
    bool m_prepared{false};
    bool m_entering{false};
    int m_startWait{0};
    std::uint32_t m_startedAfter{0};
    std::string m_lot{};   ///< part type and name of the lot on the page
    bool m_opened{false};  ///< by a person, in this run: its first part is started by hand
};

}  // namespace kerf::console
