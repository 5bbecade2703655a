// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <memory>

#include "engine/machine/simulated/simulated_boring.h"
#include "engine/machine/simulated/simulated_machine.h"
#include "tests/machine/port_conformance.h"

namespace {

constexpr std::int64_t kCycle_ns = 1'000'000;

struct BoringMachine {
    BoringMachine() {
        std::vector<std::unique_ptr<kerf::SimulatedProcess>> processes;
        auto plant = std::make_unique<kerf::SimulatedBoring>(kerf::SimulatedBoring::Params{});
        boring = plant.get();
        processes.push_back(std::move(plant));
        port = std::make_unique<kerf::SimulatedMachine>(kerf::SimulatedMachine::Params{}, std::move(processes));
    }
    kerf::SimulatedBoring* boring{nullptr};
    std::unique_ptr<kerf::SimulatedMachine> port;
};

kerf::StartProgram shortBore() {
    kerf::StartProgram program;
    program.process = kerf::ProcessId::Boring;
    program.programmedFeed_mmPerRev = 0.25;
    program.spindleSpeed_rpm = 400.0;
    program.from_mm = 40.0;
    program.to_mm = 45.0;
    return program;
}

}  // namespace

/// The simulated machine passes the suite of the port, and behaves like a control when the console is gone.
class TestSimulatedMachine : public kerf::test::PortConformance {
    Q_OBJECT
 protected:
    kerf::MachinePort& machine() override { return *m_machine->port; }
    std::int64_t nextCycle() override { return m_now_ns += kCycle_ns; }
    kerf::StartProgram shortProgram() const override { return shortBore(); }
    int patience() const override { return 20'000; }
    bool loseTheWay(bool lost) override {
        kerf::InjectedFaults faults;
        faults.linkDown = lost;
        m_machine->port->inject(faults);
        return true;
    }
    double trueFeedShare() override {
        const kerf::MachineInputs& truth = m_machine->port->truth();
        return truth.actualFeed_mmPerS.value / std::max(truth.programmedFeed_mmPerS.value, 1e-9);
    }

 private slots:
    void init() {
        m_machine = std::make_unique<BoringMachine>();
        m_inputs = kerf::MachineInputs{};
        m_request = 0;
        m_now_ns = 0;
        QVERIFY(machine().connect().has_value());
    }

    void deflectionFollowsTheLawAtTheFeedReallyCut() {
        QVERIFY(startShortProgram());
        kerf::MachineOutputs half = neutral();
        half.feedScale = 0.4;
        QVERIFY(cycleUntil([this] { return m_inputs.program == kerf::ProgramState::Finished; }, half));
        kerf::BoredHole hole;
        QVERIFY(m_machine->boring->holes().tryPop(hole));
        const double expected_mm = 0.0871 * std::pow(0.1, 0.5025) * std::pow(44.0, 0.2676);
        QVERIFY(std::abs(hole.deflectionAt_mm(44.0) - expected_mm) < 1e-6);
    }
    void deadConsoleLeavesFeedAtOrBelowProgrammedAndOffsetHeld() {
        kerf::MachineOutputs outputs = neutral();
        outputs.workOffset_um = {5.0, 0.0, 0.0};
        QVERIFY(startShortProgram());
        QVERIFY(cycleUntil([this] { return m_inputs.workOffset_um[0].value > 4.9; }, outputs));
        for (int i = 0; i < 500; ++i) {
            machine().read(nextCycle(), m_inputs);  // no write: the console is gone
            QVERIFY(m_inputs.actualFeed_mmPerS.value <= m_inputs.programmedFeed_mmPerS.value * (1.0 + 1e-9));
        }
        QVERIFY(std::abs(m_inputs.workOffset_um[0].value - 5.0) < 0.1);
    }
    void everySignalFaultShowsInQualityNotInLies() {
        QVERIFY(startShortProgram());
        using kerf::SignalFault;
        const std::pair<SignalFault, kerf::Quality> cases[] = {{SignalFault::Unplugged, kerf::Quality::Missing},
                                                               {SignalFault::Stale, kerf::Quality::Stale},
                                                               {SignalFault::NotANumber, kerf::Quality::Bad},
                                                               {SignalFault::Saturated, kerf::Quality::Saturated},
                                                               {SignalFault::Stuck, kerf::Quality::Good}};
        for (const auto& [fault, quality] : cases) {
            kerf::InjectedFaults faults;
            faults.overhang = fault;
            m_machine->port->inject(faults);
            cycle(neutral());
            QCOMPARE(m_inputs.overhang_mm.quality, quality);
            QCOMPARE(m_inputs.overhang_mm.good(), quality == kerf::Quality::Good);
        }
    }
    void emergencyStopEndsTheProgram() {
        QVERIFY(startShortProgram());
        kerf::InjectedFaults faults;
        faults.emergencyStop = true;
        m_machine->port->inject(faults);
        cycle(neutral());
        QCOMPARE(m_inputs.program, kerf::ProgramState::Aborted);
        QVERIFY(m_inputs.emergencyStop);
    }

 private:
    std::unique_ptr<BoringMachine> m_machine;
    std::int64_t m_now_ns{0};
};
QTEST_APPLESS_MAIN(TestSimulatedMachine)
#include "tst_simulated_machine.moc"
