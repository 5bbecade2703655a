// SPDX-License-Identifier: GPL-3.0-or-later
#include <memory>

#include "engine/machine/simulated/simulated_machine.h"
#include "engine/machine/simulated/simulated_turning.h"
#include "tests/machine/port_conformance.h"

/// The simulated diamond turning machine passes the suite of the port at its 5 kHz cycle.
class TestSimulatedTurning : public kerf::test::PortConformance {
    Q_OBJECT
 protected:
    kerf::MachinePort& machine() override { return *m_machine; }
    std::int64_t nextCycle() override { return m_now_ns += 200'000; }
    kerf::StartProgram shortProgram() const override {
        kerf::StartProgram program;
        program.process = kerf::ProcessId::Turning;
        program.programmedFeed_mmPerRev = 0.0058;
        program.spindleSpeed_rpm = 1032.0;
        program.to_mm = 0.03;
        program.depth_um = 6.0;
        return program;
    }
    int patience() const override { return 20'000; }

 private slots:
    void init() {
        std::vector<std::unique_ptr<kerf::SimulatedProcess>> processes;
        processes.push_back(std::make_unique<kerf::SimulatedTurning>(kerf::SimulatedTurning::Params{}));
        kerf::SimulatedMachine::Params params;
        params.cycle_ns = 200'000;
        m_machine = std::make_unique<kerf::SimulatedMachine>(params, std::move(processes));
        m_inputs = kerf::MachineInputs{};
        m_request = 0;
        m_now_ns = 0;
        QVERIFY(machine().connect().has_value());
    }
    void oneForceSamplePerCycleAndTheTrimReadsBack() {
        QVERIFY(startShortProgram());
        kerf::MachineOutputs outputs = neutral();
        outputs.toolTrim_um = 0.7;
        cycle(outputs);
        cycle(outputs);
        QCOMPARE(m_inputs.fastCount, std::uint16_t{1});
        QVERIFY(m_inputs.fast[0].quality == kerf::Quality::Good);
        QCOMPARE(m_inputs.toolTrim_um.value, 0.7);
    }

 private:
    std::unique_ptr<kerf::SimulatedMachine> m_machine;
    std::int64_t m_now_ns{0};
};
QTEST_APPLESS_MAIN(TestSimulatedTurning)
#include "tst_simulated_turning.moc"
