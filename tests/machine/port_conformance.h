// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QTest>
#include <cmath>
#include <functional>

#include "engine/port/machine_port.h"

/// What every machine behind the port must do. A machine's test derives from this class, makes the port and says how
/// machine time passes; Qt Test then runs the inherited slots against it.
namespace kerf::test {

class PortConformance : public QObject {
    Q_OBJECT
 protected:
    /// A fresh, not yet connected machine.
    virtual MachinePort& machine() = 0;
    /// Let machine time pass by one cycle and return the new time (a real machine waits, a simulated one counts).
    virtual std::int64_t nextCycle() = 0;
    /// A short program of this machine for the named process.
    virtual StartProgram shortProgram() const = 0;
    /// How many cycles the short program and its start may take at most.
    virtual int patience() const = 0;
    /// The way between console and control is lost, though both live, or is there again; false: this machine has none.
    virtual bool loseTheWay(bool /*lost*/) { return false; }
    /// Feed really made over the programmed one, whatever the link shows.
    virtual double trueFeedShare() { return feedShare(); }
    /// A program that still runs a second after a loss.
    virtual StartProgram longProgram() const { return shortProgram(); }
    [[nodiscard]] double feedShare() const {
        return m_inputs.actualFeed_mmPerS.value / std::max(m_inputs.programmedFeed_mmPerS.value, 1e-9);
    }

    /// One cycle: read, then write `outputs`.
    void cycle(const MachineOutputs& outputs) {
        m_previousTime_ns = m_inputs.time_ns;
        machine().read(nextCycle(), m_inputs);
        machine().write(outputs);
    }
    MachineOutputs neutral() {
        MachineOutputs outputs;
        outputs.heartbeat = ++m_heartbeat;
        return outputs;
    }
    bool cycleUntil(const std::function<bool()>& condition, MachineOutputs outputs) {
        for (int i = 0; i < patience(); ++i) {
            outputs.heartbeat = ++m_heartbeat;
            cycle(outputs);
            if (condition()) {
                return true;
            }
        }
        return false;
    }
    /// The console is silent: the machine goes on by itself.
    bool silentUntil(const std::function<bool()>& condition) {
        for (int i = 0; i < patience(); ++i) {
            machine().read(nextCycle(), m_inputs);
            if (condition()) {
                return true;
            }
        }
        return false;
    }
    bool startShortProgram() {
        MachineOutputs outputs = neutral();
        outputs.request.number = ++m_request;
        outputs.request.action = shortProgram();
        return cycleUntil([this] { return m_inputs.program == ProgramState::Running; }, outputs);
    }

    MachineInputs m_inputs{};
    std::int64_t m_previousTime_ns{0};
    std::uint32_t m_heartbeat{0};
    std::uint32_t m_request{0};

 private slots:
    void init() {
        m_inputs = MachineInputs{};
        m_request = 0;
        QVERIFY(machine().connect().has_value());
    }
    void cleanup() { machine().disconnect(); }

    void capabilitiesExplainWhatIsMissing() {
        const Capabilities& c = machine().capabilities();
        for (const Capability* capability :
             {&c.feedScale, &c.forceSensor, &c.forceReset, &c.temperatures, &c.workOffset, &c.gapSensors, &c.toolMotion,
              &c.servoGains, &c.toolTrim, &c.gauge, &c.cycleStart}) {
            QVERIFY(capability->fitted || !capability->why.empty());
        }
        for (const Capability& process : c.process) {
            QVERIFY(process.fitted || !process.why.empty());
        }
        QVERIFY(c.cycle_ns > 0);
        QVERIFY(c.maxFeedScale >= 1.0);
        QVERIFY(c.machineName[0] != '\0');
    }
    void everyReadIsStampedAndTimeRises() {
        cycle(neutral());
        for (int i = 0; i < 50; ++i) {
            cycle(neutral());
            QVERIFY(m_inputs.time_ns > m_previousTime_ns);
            QCOMPARE(m_inputs.link, LinkState::Up);
            for (const Reading& reading :
                 {m_inputs.spindleSpeed_rpm, m_inputs.spindleAngle_rev, m_inputs.actualFeed_mmPerS}) {
                QVERIFY(reading.quality != Quality::Good || std::isfinite(reading.value));
                QVERIFY(reading.stamp_ns <= m_inputs.time_ns);
            }
        }
    }
    void programRunsAndFinishesAndCounts() {
        cycle(neutral());
        const std::uint32_t before = m_inputs.partSequence;
        QVERIFY(startShortProgram());
        QCOMPARE(m_inputs.partSequence, before + 1);
        QVERIFY(cycleUntil([this] { return m_inputs.program != ProgramState::Running; }, neutral()));
        QCOMPARE(m_inputs.program, ProgramState::Finished);
    }
    void requestIsAnsweredOnceWithItsNumber() {
        QVERIFY(startShortProgram());
        QCOMPARE(m_inputs.reply.number, m_request);
        QCOMPARE(m_inputs.reply.state, RequestState::Done);
    }
    void impossibleRequestIsRefusedWithReason() {
        MachineOutputs outputs = neutral();
        outputs.request.number = ++m_request;
        StartProgram impossible = shortProgram();
        impossible.to_mm = impossible.from_mm - 1.0;
        outputs.request.action = impossible;
        QVERIFY(cycleUntil(
            [this] { return m_inputs.reply.number == m_request && m_inputs.reply.state != RequestState::Accepted; },
            outputs));
        QCOMPARE(m_inputs.reply.state, RequestState::Refused);
        QVERIFY(!m_inputs.reply.reason.empty());
        QVERIFY(m_inputs.program != ProgramState::Running);
    }
    void feedScaleScalesTheRealFeed() {
        if (!machine().capabilities().feedScale.fitted) {
            QSKIP("this machine has no live feed scale");
        }
        QVERIFY(startShortProgram());
        MachineOutputs half = neutral();
        half.feedScale = 0.5;
        QVERIFY(cycleUntil(
            [this] {
                const double programmed_mmPerS = m_inputs.programmedFeed_mmPerS.value;
                return m_inputs.program == ProgramState::Running && programmed_mmPerS > 0.0 &&
                       std::abs(m_inputs.actualFeed_mmPerS.value - 0.5 * programmed_mmPerS) < 0.02 * programmed_mmPerS;
            },
            half));
    }
    void feedHoldStopsTheFeed() {
        QVERIFY(startShortProgram());
        MachineOutputs hold = neutral();
        hold.feedHold = true;
        QVERIFY(cycleUntil([this] { return m_inputs.feedHold && m_inputs.actualFeed_mmPerS.value < 1e-3; }, hold));
        QVERIFY(cycleUntil([this] { return m_inputs.program == ProgramState::Finished; }, neutral()));
    }
    void aLostConsoleLeavesAtMostThePlannedFeed() {
        if (!machine().capabilities().feedScale.fitted) {
            QSKIP("this machine has no live feed scale");
        }
        StartProgram program = shortProgram();
        program.plannedFeedScale = 0.5;
        MachineOutputs outputs = neutral();
        outputs.request = {++m_request, program};
        QVERIFY(cycleUntil([&] { return m_inputs.program == ProgramState::Running && feedShare() > 0.9; }, outputs));
        QVERIFY(m_inputs.plannedFeedScale.good());
        QCOMPARE(m_inputs.plannedFeedScale.value, 0.5);
        QVERIFY(silentUntil(
            [&] { return m_inputs.program != ProgramState::Running || std::abs(feedShare() - 0.5) < 0.02; }));
        QCOMPARE(m_inputs.program, ProgramState::Running);  // it goes on
        double highest = 0.0;
        QVERIFY(silentUntil([&] {
            const bool runs = m_inputs.program == ProgramState::Running;
            highest = std::max(highest, runs ? feedShare() : 0.0);
            return !runs;
        }));
        QVERIFY2(highest < 0.53, qPrintable(QString::number(highest)));  // and never faster again
    }
    void aLostWayLeavesAtMostThePlannedFeed() {
        if (!machine().capabilities().feedScale.fitted || !loseTheWay(false)) {
            QSKIP("this machine has no live feed scale, or no way that could be lost");
        }
        StartProgram program = longProgram();
        program.plannedFeedScale = 0.5;
        MachineOutputs outputs = neutral();
        outputs.request = {++m_request, program};
        QVERIFY(cycleUntil([&] { return m_inputs.program == ProgramState::Running && feedShare() > 0.9; }, outputs));
        QVERIFY(loseTheWay(true));
        // The console goes on speaking, but nobody hears it.
        QVERIFY(cycleUntil([this] { return std::abs(trueFeedShare() - 0.5) < 0.02; }, outputs));
        const std::int64_t from_ns = m_inputs.time_ns;
        double highest = 0.0;
        QVERIFY(cycleUntil(
            [&] {
                highest = std::max(highest, trueFeedShare());
                return m_inputs.link == LinkState::Down && m_inputs.time_ns - from_ns > 900'000'000;
            },
            outputs));
        QVERIFY2(highest < 0.53, qPrintable(QString::number(highest)));
        QVERIFY(loseTheWay(false));
        outputs.feedScale = 0.3;
        QVERIFY(cycleUntil(
            [&] {
                return m_inputs.link == LinkState::Up && m_inputs.program == ProgramState::Running &&
                       std::abs(feedShare() - 0.3) < 0.02;
            },
            outputs));
    }
    void aStopStaysWhateverTheConsoleDoes() {
        QVERIFY(startShortProgram());
        MachineOutputs outputs = neutral();
        StopSlot& stop = outputs.stops[0];
        stop = m_inputs.stops[0];
        stop.number = std::max(stop.number, stop.released) + 1;
        stop.kind = StopKind::FeedHold;
        const auto stands = [this] { return m_inputs.actualFeed_mmPerS.value < 1e-3; };
        QVERIFY(cycleUntil(stands, outputs));
        for (int i = 0; i < 300; ++i) {
            machine().read(nextCycle(), m_inputs);  // silent …
        }
        QVERIFY(stands());
        for (int i = 0; i < 100; ++i) {
            cycle(neutral());  // … and back, as one that has forgotten everything
        }
        QVERIFY(stands());
        QVERIFY(m_inputs.stops[0].active());
        QCOMPARE(m_inputs.stops[0].number, stop.number);
        stop.released = stop.number;  // a person has looked
        QVERIFY(cycleUntil([this] { return m_inputs.program == ProgramState::Finished; }, outputs));
        QVERIFY(!m_inputs.stops[0].active());
    }
    void workOffsetReadsBack() {
        if (!machine().capabilities().workOffset.fitted) {
            QSKIP("this machine has no work offset");
        }
        MachineOutputs shifted = neutral();
        shifted.workOffset_um = {12.0, -7.0, 3.0};
        QVERIFY(cycleUntil(
            [this] {
                return std::abs(m_inputs.workOffset_um[0].value - 12.0) < 0.5 &&
                       std::abs(m_inputs.workOffset_um[1].value + 7.0) < 0.5 &&
                       std::abs(m_inputs.workOffset_um[2].value - 3.0) < 0.5;
            },
            shifted));
    }
    void abortEndsTheProgram() {
        QVERIFY(startShortProgram());
        MachineOutputs abort = neutral();
        abort.request.number = ++m_request;
        abort.request.action = AbortProgram{};
        QVERIFY(cycleUntil([this] { return m_inputs.program == ProgramState::Aborted; }, abort));
    }
};

}  // namespace kerf::test
