// SPDX-License-Identifier: GPL-3.0-or-later
#include <memory>
#include <utility>

#include "engine/machine/simulated/simulated_boring.h"
#include "engine/machine/simulated/simulated_machine.h"
#include "engine/port/machine_module.h"

namespace kerf::test {
namespace {

/// A machine as docs/architecture.md says how to add one: a port, and the one function at the end of this file.
/// A boring machine whose spindle is a computation; to Kerf it is as real as any.
class Testbed final : public MachinePort {
 public:
    Testbed() : m_machine({.name = "Testbed"}, plants()), m_capabilities(m_machine.capabilities()) {
        m_capabilities.simulated = false;
    }
    [[nodiscard]] Result<void> connect() override { return m_machine.connect(); }
    void disconnect() noexcept override { m_machine.disconnect(); }
    [[nodiscard]] const Capabilities& capabilities() const noexcept override { return m_capabilities; }
    void read(std::int64_t now_ns, MachineInputs& inputs) noexcept override { m_machine.read(now_ns, inputs); }
    void write(const MachineOutputs& outputs) noexcept override { m_machine.write(outputs); }

 private:
    static std::vector<std::unique_ptr<SimulatedProcess>> plants() {
        std::vector<std::unique_ptr<SimulatedProcess>> plants;
        plants.push_back(std::make_unique<SimulatedBoring>(SimulatedBoring::Params{}));
        return plants;
    }

    SimulatedMachine m_machine;
    Capabilities m_capabilities;
};

}  // namespace
}  // namespace kerf::test

extern "C" __attribute__((visibility("default"))) kerf::MachinePort* kerfMakeMachine(const kerf::MachineDescription&) {
    return new kerf::test::Testbed();
}
