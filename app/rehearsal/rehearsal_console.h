// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "app/rehearsal/rehearsal.h"
#include "engine/cycle/engine.h"
#include "engine/process/tapping/tap_exchange.h"
#include "engine/process/thermal/thermal_exchange.h"

namespace kerf::rehearsal {

/// All that dies with a console: the engine with its loops, on the caller's thread. Made anew it starts as a console
/// does: stops as the data file keeps them first, then setups and modes.
class Console {
 public:
    /// `thermal`: the model that is live, null: none has been trained.
    Console(MachinePort& machine, const Setups& setups, const std::array<LoopMode, kProcessPlaces>& modes,
            const StopSlots& keptStops, const thermal::ThermalModel* thermal = nullptr);

    void step(std::int64_t now_ns);
    /// A deed of a person; its answer comes with takeAnswers(), for the command of that index.
    void ask(const Event& event, const char* person, std::size_t index);
    void takeAnswers(std::vector<CommandSeen>& commands);
    void drainAlarms(std::set<AlarmCode>& standing);
    void countParts(std::uint32_t& finished, std::uint32_t& aborted);

    [[nodiscard]] const MachineInputs& inputs() const { return m_engine->cycle().inputs(); }
    [[nodiscard]] const MachineOutputs& outputs() const { return m_engine->cycle().outputs(); }
    [[nodiscard]] const StopSlots& stops() const { return m_engine->cycle().stops().all(); }
    [[nodiscard]] std::string stopReason(ProcessId process) const;
    [[nodiscard]] LoopState state(ProcessId process) const { return m_engine->cycle().describe(process).state; }
    [[nodiscard]] std::map<AlarmCode, std::string> alarmTitles() const;

 private:
    template <class Action>
    std::uint32_t send(const Action& action) {
        Command command;
        command.action = action;
        return m_engine->send(command).value_or(0);
    }

    std::unique_ptr<TapExchange> m_taps;
    std::unique_ptr<ThermalExchange> m_thermal;
    std::unique_ptr<Engine> m_engine;
    std::map<std::uint32_t, std::size_t> m_asked;  ///< numbers of commands that have not been answered
};

}  // namespace kerf::rehearsal
