// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <atomic>
#include <cmath>
#include <deque>
#include <map>
#include <vector>

#include "engine/api/engine_api.h"

namespace kerf::test {

/// An engine for GUI tests: a test writes its status, samples and alarms, and reads the commands it got.
class FakeEngine : public EngineApi {
 public:
    FakeEngine() {
        for (std::size_t i = 0; i < kProcessPlaces; ++i) {
            fake.loops[i].reason = Sentence(KERF_TEXT("not fitted yet"));
        }
        LoopStatus& boring = loop(ProcessId::Boring);
        boring.fitted = true;
        boring.reason = Sentence();
        fake.link = LinkState::Up;
        fake.machineOn = true;
        caps.simulated = true;
        constexpr std::string_view name = "Simulator";
        std::copy(name.begin(), name.end(), caps.machineName.begin());
    }

    std::optional<std::uint32_t> send(const Command& command) noexcept override {
        if (ringFull) {
            return std::nullopt;
        }
        commands.push_back(command);
        commands.back().number = ++m_number;
        if (refuseWith.empty()) {
            takeOrder(command);
        }
        if (answer) {
            fake.lastCommand = refuseWith.empty() ? CommandResult::ok() : CommandResult::refused(refuseWith);
            fake.lastCommand.number = m_number;
            std::rotate(fake.recentCommands.rbegin(), fake.recentCommands.rbegin() + 1, fake.recentCommands.rend());
            fake.recentCommands[0] = fake.lastCommand;
        }
        return m_number;
    }
    void holdAll() noexcept override { ++holds; }
    Status status() noexcept override { return fake; }
    const Capabilities& capabilities() const noexcept override { return caps; }
    std::size_t drainSamples(std::span<Sample> out) noexcept override {
        const std::size_t count = std::min(out.size(), samples.size());
        std::copy_n(samples.begin(), count, out.begin());
        samples.erase(samples.begin(), samples.begin() + static_cast<std::ptrdiff_t>(count));
        return count;
    }
    bool nextAlarm(AlarmEvent& event) noexcept override {
        if (alarms.empty()) {
            return false;
        }
        event = alarms.front();
        alarms.pop_front();
        return true;
    }
    const AlarmSpec* alarmSpec(AlarmCode code) const noexcept override {
        const auto found = specs.find(code);
        return found == specs.end() ? nullptr : &found->second;
    }

    LoopStatus& loop(ProcessId id) { return fake.loops[static_cast<std::size_t>(id)]; }

    Status fake{};
    Capabilities caps{};
    std::deque<Sample> samples{};
    std::deque<AlarmEvent> alarms{};
    std::map<AlarmCode, AlarmSpec> specs{};
    std::vector<Command> commands{};
    std::atomic<int> holds{0};
    bool ringFull{false};
    bool answer{true};      ///< echo each command in the status at once
    Sentence refuseWith{};  ///< not empty: refuse with this reason

 private:
    /// As the cycle does it: whose work the next part is.
    void takeOrder(const Command& command) {
        std::visit(
            [this, &command](const auto& action) {
                if constexpr (requires { action.order->lot; }) {
                    if (action.order && !std::holds_alternative<StartPart>(command.action)) {
                        fake.orders[static_cast<std::size_t>(processOf(command))] = *action.order;
                    }
                } else if constexpr (requires { action.order.lot; }) {
                    fake.orders[static_cast<std::size_t>(processOf(command))] = action.order;
                }
            },
            command.action);
    }
    std::uint32_t m_number{0};
};

}  // namespace kerf::test
