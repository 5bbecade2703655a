// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>
#include <cmath>
#include <memory>

#include "engine/cycle/event_sink.h"
#include "engine/process/thermal/thermal_loop.h"
#include "engine/process/thermal/training.h"
#include "tests/engine/thermal/lathe_days.h"

using namespace kerf;
using kerf::test::Lathe;
using kerf::test::LatheKind;

namespace {

/// The loop alone on a recorded day of an imagined lathe, one cycle a minute; the control takes every shift at once.
class Day {
 public:
    Day() {
        static const std::vector<thermal::ThermalHistory> days = Lathe(LatheKind::Mild, 3).days();
        static const thermal::ThermalModel model =
            std::move(*thermal::trainHierarchical({days.begin(), days.begin() + 10}, {}));
        m_day = &days[12];
        m_names = m_day->sensors;
        m_exchange.offer(std::move(*LiveModel::make(model, m_names, 1)));
        loop.setMode(LoopMode::Control);
        m_capabilities.temperatures.fitted = true;
        for (Reading& offset : m_inputs.workOffset_um)
            offset = {0.0, 1, Quality::Good};
        m_frame.count = 6;
    }
    /// Minutes of the day from where it stands, in fifths.
    void run(double minutes) {
        for (int fifth = 0; fifth < static_cast<int>(std::lround(5.0 * minutes)); ++fifth) {
            m_inputs.time_ns += 12'000'000'000;
            m_row = std::min<Eigen::Index>(m_row + (fifth % 5 == 4 ? 1 : 0), m_day->rows() - 1);
            ++m_frame.revision;
            for (std::size_t k = 0; k < 6; ++k)
                m_frame.temp_degC[k] = {m_day->temp_degC(m_row, static_cast<Eigen::Index>(k)), m_inputs.time_ns,
                                        Quality::Good};
            step();
        }
    }
    void setProgram(ProgramState state, ProcessId process = ProcessId::Turning) {
        m_inputs.program = state;
        m_inputs.programProcess = process;
        step();
    }
    template <class Action>
    CommandResult execute(const Action& action) {
        Command command;
        command.action = action;
        const CommandResult result = loop.handle(command);
        step();
        return result;
    }
    void betweenParts() {
        ThermalSetup setup;
        setup.revision = 1;
        setup.betweenParts = true;
        QVERIFY(execute(LoadThermalSetup{setup}).done);
    }
    [[nodiscard]] const ThermalStatus& thermal() {
        loop.report(m_status);
        return m_status.thermal;
    }
    [[nodiscard]] double shift_um() const { return m_inputs.workOffset_um[0].value; }
    [[nodiscard]] LoopVerdict verdict() const { return m_verdict; }

 private:
    void step() {
        m_inputs.link = LinkState::Up;
        m_inputs.temperatures = &m_frame;
        LoopOutputs outputs;
        m_verdict = loop.step(m_inputs, m_capabilities, outputs, m_events);
        for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
            if (outputs.workOffset_um[axis]) m_inputs.workOffset_um[axis].value = *outputs.workOffset_um[axis];
        }
    }

    ThermalExchange m_exchange{};
    const thermal::ThermalHistory* m_day{nullptr};
    std::vector<std::string> m_names{};
    TemperatureFrame m_frame{};
    MachineInputs m_inputs{};
    Capabilities m_capabilities{};
    SpscRing<AlarmEvent> m_alarms{64};
    SpscRing<PartRecord> m_parts{4};
    EventSink m_events{m_alarms, m_parts};
    Status m_status{};
    LoopVerdict m_verdict{};
    Eigen::Index m_row{0};

 public:
    ThermalLoop loop{m_exchange};
};

MeasureByPart partOff(double x_um) {
    MeasureByPart part;
    part.deviation_um[0] = x_um;
    part.known[0] = true;
    return part;
}

}  // namespace

/// What finished parts are to the thermal loop.
class TestThermalParts : public QObject {
    Q_OBJECT
 private slots:
    void betweenPartsTheShiftMovesAndDuringOneItStands();
    void withoutTheOptionTheShiftFollowsThroughAPart();
    void theWarmUpIsNoPart();
    void aFinishedPartIsAMeasurementMadeWhenItWasFinished();
    void aPartCountsOnce();
    void whatIsNoDriftIsRefused();
    void aNewReferenceForgetsThePart();
    void anAbortedProgramIsNoPart();
};

void TestThermalParts::betweenPartsTheShiftMovesAndDuringOneItStands() {
    Day day;
    day.betweenParts();
    day.run(20.0);
    day.setProgram(ProgramState::Running);
    const double before_um = day.shift_um();
    day.run(60.0);
    QCOMPARE(day.shift_um(), before_um);
    QVERIFY(day.thermal().waitsForPart);
    QVERIFY(day.verdict().reason.english().find("waits") != std::string::npos);
    QVERIFY2(std::abs(day.thermal().drift_um[0] + before_um) > 2.0, "it must have drifted for this to mean anything");
    day.setProgram(ProgramState::Paused);
    day.run(1.0);
    QCOMPARE(day.shift_um(), before_um);
    day.setProgram(ProgramState::Finished);
    day.setProgram(ProgramState::Idle);
    QVERIFY(std::abs(day.thermal().drift_um[0] + day.shift_um()) < 2.0);  // at once, not a minute later
    QVERIFY(!day.thermal().waitsForPart);
    day.run(3.0);
    QVERIFY(std::abs(day.thermal().drift_um[0] + day.shift_um()) < 1.5);
}

void TestThermalParts::withoutTheOptionTheShiftFollowsThroughAPart() {
    Day day;
    day.run(20.0);
    day.setProgram(ProgramState::Running);
    day.run(60.0);
    QVERIFY(std::abs(day.thermal().drift_um[0] + day.shift_um()) < 1.5);
    QVERIFY(!day.thermal().waitsForPart);
}

void TestThermalParts::theWarmUpIsNoPart() {
    Day day;
    day.betweenParts();
    day.run(20.0);
    day.setProgram(ProgramState::Running, ProcessId::Thermal);
    day.run(40.0);
    QVERIFY(std::abs(day.thermal().drift_um[0] + day.shift_um()) < 1.5);
    day.setProgram(ProgramState::Finished, ProcessId::Thermal);
    QVERIFY(!day.thermal().partToMeasure);
}

void TestThermalParts::aFinishedPartIsAMeasurementMadeWhenItWasFinished() {
    Day day;
    day.run(60.0);
    day.setProgram(ProgramState::Running);
    day.run(10.0);
    const double shift_um = day.shift_um();
    const double predicted_um = day.thermal().drift_um[0];
    const double half_um = day.thermal().half_um[0];
    day.setProgram(ProgramState::Finished);
    QVERIFY(day.thermal().partToMeasure);
    day.run(15.0);  // on its way to the gauge
    const double later_um = day.thermal().drift_um[0];
    QVERIFY(day.execute(partOff(6.0)).done);
    const GapMeasurement gap = day.thermal().gap;
    QVERIFY(gap.byPart && gap.known[0] && !gap.known[1] && gap.phase == GapPhase::Done);
    QCOMPARE(gap.measured_um[0], 6.0 - shift_um);
    QCOMPARE(gap.predicted_um[0], predicted_um);
    day.run(1.0);
    const double learnt_um = day.thermal().drift_um[0] - later_um;
    QVERIFY2(learnt_um > 1.0 && learnt_um < 12.0, qPrintable(QString::number(learnt_um)));
    QVERIFY(day.thermal().half_um[0] < half_um);
}

void TestThermalParts::aPartCountsOnce() {
    Day day;
    day.run(30.0);
    QVERIFY(!day.execute(partOff(3.0)).done);
    day.setProgram(ProgramState::Running);
    QVERIFY(!day.execute(partOff(3.0)).done);
    day.setProgram(ProgramState::Finished);
    QVERIFY(day.execute(partOff(3.0)).done);
    const CommandResult again = day.execute(partOff(3.0));
    QVERIFY(!again.done);
    QVERIFY(!again.reason.empty());
}

void TestThermalParts::whatIsNoDriftIsRefused() {
    Day day;
    day.run(30.0);
    day.setProgram(ProgramState::Running);
    day.setProgram(ProgramState::Finished);
    const std::uint32_t number = day.thermal().gap.number;
    for (const double off_um : {200.1, -3000.0, std::nan(""), HUGE_VAL}) {
        QVERIFY(!day.execute(partOff(off_um)).done);
    }
    QVERIFY(!day.execute(MeasureByPart{}).done);
    QCOMPARE(day.thermal().gap.number, number);
    QVERIFY(day.thermal().partToMeasure);
    QVERIFY(day.execute(partOff(-200.0)).done);
}

void TestThermalParts::aNewReferenceForgetsThePart() {
    Day day;
    day.run(30.0);
    day.setProgram(ProgramState::Running);
    day.setProgram(ProgramState::Finished);
    QVERIFY(day.execute(TakeThermalReference{false}).done);
    day.run(3.0);
    QVERIFY(!day.thermal().partToMeasure);
    QVERIFY(!day.execute(partOff(3.0)).done);
}

void TestThermalParts::anAbortedProgramIsNoPart() {
    Day day;
    day.run(30.0);
    day.setProgram(ProgramState::Running);
    day.setProgram(ProgramState::Aborted);
    QVERIFY(!day.thermal().partToMeasure);
}

QTEST_GUILESS_MAIN(TestThermalParts)
#include "tst_thermal_parts.moc"
