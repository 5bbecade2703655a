// SPDX-License-Identifier: GPL-3.0-or-later
#include <rapidcheck.h>

#include <QTest>
#include <cmath>
#include <limits>

#include "engine/limits/output_limiter.h"

namespace {

kerf::Capabilities fullMachine() {
    kerf::Capabilities c;
    c.maxFeedScale = 1.5;
    for (kerf::Capability* capability : {&c.feedScale, &c.workOffset, &c.toolTrim, &c.zTrim, &c.servoGains}) {
        capability->fitted = true;
    }
    return c;
}

/// Any double a broken loop could produce, the ugly ones included.
rc::Gen<double> anyDouble() {
    return rc::gen::oneOf(
        rc::gen::arbitrary<double>(),
        rc::gen::element(std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(),
                         -std::numeric_limits<double>::infinity(), 0.0, -1.0, 1e300, 0.5, 1.0, 3.0));
}

kerf::LoopOutputs anyWish() {
    kerf::LoopOutputs wish;
    wish.feedHold = *rc::gen::arbitrary<bool>();
    if (*rc::gen::arbitrary<bool>()) {
        wish.feedScale = *anyDouble();
    }
    for (auto& axis : wish.workOffset_um) {
        if (*rc::gen::arbitrary<bool>()) {
            axis = *anyDouble();
        }
    }
    if (*rc::gen::arbitrary<bool>()) {
        wish.toolTrim_um = *anyDouble();
    }
    if (*rc::gen::arbitrary<bool>()) {
        wish.zTrim_um = *anyDouble();
    }
    if (*rc::gen::arbitrary<bool>()) {
        wish.request.number = 7;
        kerf::SetServoGains gains;
        gains.gains.zKp_perS = *anyDouble();
        gains.gains.spindleKp_perS = *anyDouble();
        wish.request.action = gains;
    }
    return wish;
}

constexpr double kRounding = 1e-9;
constexpr double kMostTime_s = kerf::OutputLimiter::kMostPeriods * 1e-3;  // that one late cycle counts for

using Wishes = std::array<kerf::LoopOutputs, kerf::kProcessPlaces>;

/// After so many cycles of the same wishes.
kerf::MachineOutputs after(kerf::OutputLimiter& limiter, const Wishes& wishes, const kerf::MachineInputs& inputs,
                           int cycles = 1000) {
    kerf::LimitReport report;
    kerf::MachineOutputs out;
    for (int i = 0; i < cycles; ++i) {
        out = limiter.apply(wishes, inputs, 1e-3, report);
    }
    return out;
}

kerf::MachineInputs readyMachine() {
    kerf::MachineInputs inputs;
    inputs.link = kerf::LinkState::Up;
    inputs.machineOn = true;
    return inputs;
}

kerf::LoopOutputs starting(kerf::ProcessId process, std::uint32_t number, double plannedScale = 1.0) {
    kerf::StartProgram start;
    start.process = process;
    start.plannedFeedScale = plannedScale;
    kerf::LoopOutputs wish;
    wish.request = {number, start};
    return wish;
}

}  // namespace

class TestOutputLimiter : public QObject {
    Q_OBJECT
 private slots:
    void noSequenceOfWishesGetsPast() {
        const bool held = rc::check("every output stays in range, within its rate, and with its owner", [] {
            const kerf::Capabilities machine = fullMachine();
            const kerf::OutputLimits limits;
            kerf::OutputLimiter limiter(machine);
            kerf::MachineOutputs last;
            const int steps = *rc::gen::inRange(1, 40);
            for (int i = 0; i < steps; ++i) {
                std::array<kerf::LoopOutputs, kerf::kProcessPlaces> wishes;
                for (auto& wish : wishes) {
                    wish = anyWish();
                }
                kerf::MachineInputs inputs;
                inputs.link = kerf::LinkState::Up;
                inputs.program = *rc::gen::element(kerf::ProgramState::Idle, kerf::ProgramState::Running,
                                                   kerf::ProgramState::Paused);
                inputs.programProcess = *rc::gen::elementOf(
                    std::vector<kerf::ProcessId>(kerf::allProcesses().begin(), kerf::allProcesses().end()));
                const double dt_s =
                    *rc::gen::element(0.0, 0.001, 0.0002, 1.0, -1.0, std::numeric_limits<double>::quiet_NaN());
                const double step_s = dt_s > 0.0 ? std::min(dt_s, kMostTime_s) : 0.0;
                kerf::LimitReport report;
                const kerf::MachineOutputs out = limiter.apply(wishes, inputs, dt_s, report);
                RC_ASSERT(out.feedScale >= limits.feedScaleMin - kRounding);
                RC_ASSERT(out.feedScale <= std::max(1.0, limits.feedScaleMax) + kRounding);
                RC_ASSERT(out.feedScale - last.feedScale <= limits.feedScaleRise_perS * step_s + kRounding);
                RC_ASSERT(last.feedScale - out.feedScale <= limits.feedScaleFall_perS * step_s + kRounding);
                for (std::size_t a = 0; a < kerf::kAxisCount; ++a) {
                    RC_ASSERT(std::abs(out.workOffset_um[a]) <= limits.workOffsetMax_um + kRounding);
                    RC_ASSERT(std::abs(out.workOffset_um[a] - last.workOffset_um[a]) <=
                              limits.workOffsetRate_umPerS * step_s + kRounding);
                    if (!wishes[static_cast<std::size_t>(kerf::ProcessId::Thermal)].workOffset_um[a]) {
                        RC_ASSERT(out.workOffset_um[a] ==
                                  last.workOffset_um[a]);  // nobody but thermal moves the origin
                    }
                }
                RC_ASSERT(std::abs(out.toolTrim_um) <= limits.toolTrimMax_um + kRounding);
                RC_ASSERT(std::abs(out.zTrim_um) <= limits.zTrimMax_um + kRounding);
                RC_ASSERT(std::abs(out.zTrim_um - last.zTrim_um) <= limits.zTrimRate_umPerS * step_s + kRounding);
                const bool tapping =
                    inputs.program != kerf::ProgramState::Idle && inputs.programProcess == kerf::ProcessId::Tapping;
                if (!tapping) {
                    RC_ASSERT(std::abs(out.zTrim_um) <= std::abs(last.zTrim_um));  // only a running tap has a trim
                }
                if (const auto* gains = std::get_if<kerf::SetServoGains>(&out.request.action)) {
                    RC_ASSERT(gains->gains.zKp_perS >= limits.servoGainMin_perS &&
                              gains->gains.zKp_perS <= limits.servoGainMax_perS);
                    RC_ASSERT(gains->gains.spindleKp_perS >= limits.servoGainMin_perS &&
                              gains->gains.spindleKp_perS <= limits.servoGainMax_perS);
                }
                const bool running = inputs.program != kerf::ProgramState::Idle;
                if (running && !wishes[static_cast<std::size_t>(inputs.programProcess)].feedScale) {
                    RC_ASSERT(out.feedScale <= last.feedScale + kRounding);  // unknown never means faster
                }
                last = out;
            }
        });
        QVERIFY(held);
    }
    void programEndBringsTheFeedBackToProgrammed() {
        kerf::OutputLimiter limiter(fullMachine());
        std::array<kerf::LoopOutputs, kerf::kProcessPlaces> wishes{};
        kerf::MachineInputs inputs;
        inputs.program = kerf::ProgramState::Running;
        wishes[0].feedScale = 0.3;
        QCOMPARE(after(limiter, wishes, inputs).feedScale, 0.3);
        wishes[0].feedScale.reset();
        QCOMPARE(after(limiter, wishes, inputs).feedScale, 0.3);  // the loop let go: stays
        inputs.program = kerf::ProgramState::Finished;
        QCOMPARE(after(limiter, wishes, inputs).feedScale, 1.0);
    }
    void adoptingTheMachinesOffsetsMeansNoJump() {
        kerf::OutputLimiter limiter(fullMachine());
        kerf::MachineInputs inputs;
        inputs.workOffset_um[1] = {-17.0, 0, kerf::Quality::Good};
        limiter.adopt(inputs, fullMachine());
        kerf::LimitReport report;
        QCOMPARE(limiter.apply({}, inputs, 0.001, report).workOffset_um[1], -17.0);
    }
    void offsetsTheControlHasZeroedAreTakenOverAgain() {
        kerf::OutputLimiter limiter(fullMachine());
        kerf::MachineInputs inputs;
        inputs.workOffset_um[1] = {-17.0, 0, kerf::Quality::Good};
        limiter.adopt(inputs, fullMachine());
        std::array<kerf::LoopOutputs, kerf::kProcessPlaces> wishes{};
        wishes[3].workOffset_um[1] = -17.0;
        kerf::LimitReport report;
        inputs.workOffset_um[1].quality = kerf::Quality::Stale;  // switched off …
        QCOMPARE(limiter.apply(wishes, inputs, 0.001, report).workOffset_um[1], -17.0);
        inputs.workOffset_um[1] = {0.0, 0, kerf::Quality::Good};  // … and on again
        const double rate_umPerS = limiter.limits().workOffsetRate_umPerS;
        QVERIFY(std::abs(limiter.apply(wishes, inputs, 0.001, report).workOffset_um[1]) <= rate_umPerS * 0.0011);
    }
    void aLateCycleMovesNothingFurtherThanOneInTime() {
        kerf::OutputLimiter limiter(fullMachine());
        Wishes wishes{};
        kerf::MachineInputs inputs = readyMachine();
        inputs.program = kerf::ProgramState::Running;
        wishes[0].feedScale = 0.05;
        QCOMPARE(after(limiter, wishes, inputs).feedScale, 0.05);
        wishes[0].feedScale = 1.0;
        wishes[3].workOffset_um[0] = 50.0;
        wishes[2].toolTrim_um = 1.8;
        kerf::LimitReport report;
        const auto out = limiter.apply(wishes, inputs, 2.0, report);  // after a stall of 2 s
        QVERIFY(out.feedScale <= 0.05 + limiter.limits().feedScaleRise_perS * kMostTime_s + kRounding);
        QVERIFY(out.workOffset_um[0] <= limiter.limits().workOffsetRate_umPerS * kMostTime_s + kRounding);
        inputs.programProcess = kerf::ProcessId::Tapping;
        wishes[4].zTrim_um = 900.0;
        const auto tap = limiter.apply(wishes, inputs, 2.0, report);
        QVERIFY(tap.zTrim_um <= limiter.limits().zTrimRate_umPerS * kMostTime_s + kRounding);
    }
    void anAdoptedOffsetBeyondTheLimitIsKeptAndLedBack() {
        kerf::OutputLimiter limiter(fullMachine());
        kerf::MachineInputs inputs = readyMachine();
        inputs.workOffset_um[0] = {350.0, 0, kerf::Quality::Good};
        limiter.adopt(inputs, fullMachine());
        QCOMPARE(after(limiter, {}, inputs, 10).workOffset_um[0], 350.0);  // nobody asks: it stays
        Wishes wishes{};
        wishes[3].workOffset_um[0] = 350.0;
        const double rate_umPerS = limiter.limits().workOffsetRate_umPerS;
        const double led_um = after(limiter, wishes, inputs, 1000).workOffset_um[0];
        QVERIFY(std::abs(led_um - (350.0 - rate_umPerS)) < 1e-6);  // 1 s at the rate
    }
    void reconnectingTakesTheTrimsOver() {
        kerf::OutputLimiter limiter(fullMachine());
        kerf::MachineInputs inputs = readyMachine();
        inputs.program = kerf::ProgramState::Running;
        inputs.programProcess = kerf::ProcessId::Tapping;
        inputs.zTrim_um = {600.0, 0, kerf::Quality::Good};
        inputs.toolTrim_um = {1.5, 0, kerf::Quality::Good};
        limiter.adopt(inputs, fullMachine());
        kerf::LimitReport report;
        const auto out = limiter.apply({}, inputs, 1e-3, report);
        QVERIFY(out.zTrim_um >= 600.0 - limiter.limits().zTrimReturn_umPerS * 1e-3 - kRounding);
        QVERIFY(out.toolTrim_um >= 1.5 - limiter.limits().toolTrimRate_umPerS * 1e-3 - kRounding);
        limiter.adopt(inputs, fullMachine());
        inputs.zTrim_um.quality = kerf::Quality::Missing;  // no read-back: ours stays
        const double before_um = limiter.apply({}, inputs, 1e-3, report).zTrim_um;
        limiter.adopt(inputs, fullMachine());
        QVERIFY(std::abs(limiter.apply({}, inputs, 1e-3, report).zTrim_um - before_um) <= 3.0);
    }
    void twoRequestsInOneCycleAreBothSent() {
        kerf::OutputLimiter limiter(fullMachine());
        Wishes wishes{};
        wishes[3] = starting(kerf::ProcessId::Thermal, 30);
        wishes[4].request = {40, kerf::SetServoGains{{40.0, 48.0, {}}}};
        kerf::LimitReport report;
        QCOMPARE(limiter.apply(wishes, readyMachine(), 1e-3, report).request.number, 30U);
        QCOMPARE(int(report.refusedCount), 0);
        QCOMPARE(limiter.apply({}, readyMachine(), 1e-3, report).request.number, 40U);
        QCOMPARE(limiter.apply({}, readyMachine(), 1e-3, report).request.number, 0U);
    }
    void everyRequestIsSentOrRefused() {
        kerf::OutputLimiter limiter(fullMachine());
        Wishes wishes{};
        wishes[0].request = {1, kerf::SetServoGains{}};  // not boring's
        wishes[1] = starting(kerf::ProcessId::Boring, 2);
        wishes[3] = starting(kerf::ProcessId::Thermal, 3);
        kerf::MachineInputs off = readyMachine();
        off.machineOn = false;
        kerf::LimitReport report;
        QCOMPARE(limiter.apply(wishes, off, 1e-3, report).request.number, 0U);
        QCOMPARE(int(report.refusedCount), 3);
        for (const auto& reply : report.refused) {
            QVERIFY(reply.number == 0 || !reply.reason.empty());
        }
        QCOMPARE(limiter.apply({}, readyMachine(), 1e-3, report).request.number, 0U);  // nothing begins later by itself
    }
    void aStartWaitsForTheScaleOfItsPlannedFeed() {
        kerf::OutputLimiter limiter(fullMachine());
        Wishes wishes{};
        wishes[1] = starting(kerf::ProcessId::Milling, 9, 0.25);
        kerf::LimitReport report;
        auto out = limiter.apply(wishes, readyMachine(), 1e-3, report);
        for (int i = 0; i < 200 && out.request.number == 0; ++i) {
            QVERIFY(out.lossScale <= 0.25);
            out = limiter.apply({}, readyMachine(), 1e-3, report);
        }
        QCOMPARE(out.request.number, 9U);
        QVERIFY(out.feedScale <= 0.25 + kRounding);
        QCOMPARE(after(limiter, {}, readyMachine(), 500).feedScale, 0.25);  // until it runs
    }
    void anAbortOvertakesAndCallsOffAStart() {
        kerf::OutputLimiter limiter(fullMachine());
        Wishes wishes{};
        wishes[1] = starting(kerf::ProcessId::Milling, 9, 0.25);
        kerf::LimitReport report;
        (void)limiter.apply(wishes, readyMachine(), 1e-3, report);
        wishes[1].request = {10, kerf::AbortProgram{}};
        QCOMPARE(limiter.apply(wishes, readyMachine(), 1e-3, report).request.number, 10U);
        QCOMPARE(report.refused[0].number, 9U);
        QCOMPARE(limiter.apply({}, readyMachine(), 1.0, report).request.number, 0U);
    }
    void withoutAWishTheFeedIsAtMostThePlannedOne() {
        kerf::OutputLimiter limiter(fullMachine());
        Wishes wishes{};
        kerf::MachineInputs inputs = readyMachine();
        inputs.program = kerf::ProgramState::Running;
        inputs.programProcess = kerf::ProcessId::Milling;
        inputs.plannedFeedScale = {0.22, 0, kerf::Quality::Good};
        wishes[1].feedScale = 0.9;
        auto out = after(limiter, wishes, inputs);
        QCOMPARE(out.feedScale, 0.9);
        QCOMPARE(out.lossScale, 0.22);
        QCOMPARE(after(limiter, {}, inputs).feedScale, 0.22);
        inputs.plannedFeedScale = {};  // a program that nobody has declared, but a loop scales: held when we are gone
        kerf::OutputLimiter other(fullMachine());
        QCOMPARE(after(other, wishes, inputs).lossScale, 0.0);
        kerf::OutputLimiter advised(fullMachine());
        QCOMPARE(after(advised, {}, inputs).lossScale, 1.0);  // nobody scales it: it is its own
    }
    void aStopHoldsTheFeedAndForbidsStartsUntilAPersonReleasesIt() {
        kerf::OutputLimiter limiter(fullMachine());
        Wishes wishes{};
        wishes[1].stop = {kerf::StopKind::FeedHold, 201, {}};
        QVERIFY(after(limiter, wishes, readyMachine(), 1).feedHold);
        QVERIFY(after(limiter, {}, readyMachine(), 100).feedHold);
        kerf::LimitReport report;
        wishes[1] = starting(kerf::ProcessId::Milling, 5);
        QCOMPARE(limiter.apply(wishes, readyMachine(), 1e-3, report).request.number, 0U);
        QCOMPARE(int(report.refusedCount), 1);
        const std::uint32_t number = limiter.stops().all()[1].number;
        QVERIFY(!limiter.stops().release(kerf::ProcessId::Milling, number, "").empty());
        QVERIFY(!limiter.stops().release(kerf::ProcessId::Milling, number + 1, "Kim").empty());
        QVERIFY(after(limiter, {}, readyMachine(), 1).feedHold);
        QVERIFY(limiter.stops().release(kerf::ProcessId::Milling, number, "Kim").empty());
        QVERIFY(!after(limiter, {}, readyMachine(), 1).feedHold);
    }
    void aReleaseOfAnOlderStopLeavesTheNewOne() {
        kerf::StopLatch latch;
        latch.set(kerf::ProcessId::Milling, {kerf::StopKind::NoStart, 201, {}}, 0);
        latch.set(kerf::ProcessId::Milling, {kerf::StopKind::FeedHold, 202, {}}, 1);  // stronger: a new number
        QVERIFY(!latch.release(kerf::ProcessId::Milling, 1, "Kim").empty());
        QVERIFY(latch.all()[1].active());
        QVERIFY(latch.release(kerf::ProcessId::Milling, 2, "Kim").empty());
        QVERIFY(!latch.all()[1].active());
    }
    void keepersJoinInAnyOrder() {
        const bool held = rc::check("joining is commutative, idempotent, and never loses a stop or a release", [] {
            const auto any = [] {
                kerf::StopSlot slot;
                slot.number = *rc::gen::inRange(0U, 5U);
                slot.released = *rc::gen::inRange(0U, 5U);
                slot.kind =
                    *rc::gen::element(kerf::StopKind::NoStart, kerf::StopKind::FeedHold, kerf::StopKind::InWork);
                return slot;
            };
            const kerf::StopSlot a = any();
            const kerf::StopSlot b = any();
            const kerf::StopSlot both = kerf::joined(a, b);
            RC_ASSERT(both.number == kerf::joined(b, a).number && both.released == kerf::joined(b, a).released);
            RC_ASSERT(both.kind == kerf::joined(b, a).kind);
            RC_ASSERT(kerf::joined(both, a) == both && kerf::joined(both, b) == both);
            RC_ASSERT(both.number >= a.number && both.released >= a.released);
        });
        QVERIFY(held);
    }
    void whatStandsInTheWorkFreezesOffsetAndTrims() {
        kerf::OutputLimiter limiter(fullMachine());
        Wishes wishes{};
        wishes[3].workOffset_um[2] = 20.0;
        wishes[4].stop = {kerf::StopKind::InWork, 502, {}};
        QCOMPARE(after(limiter, wishes, readyMachine()).workOffset_um[2], 0.0);
        QVERIFY(!after(limiter, wishes, readyMachine()).feedHold);  // the way out must stay open
        wishes[4] = {};
        wishes[4].outOfWork = true;
        QVERIFY(after(limiter, wishes, readyMachine()).workOffset_um[2] > 0.9);
    }
    void limitsSayWhenTheyAreAtWork() {
        kerf::OutputLimiter limiter(fullMachine());
        std::array<kerf::LoopOutputs, kerf::kProcessPlaces> wishes{};
        kerf::MachineInputs inputs;
        inputs.program = kerf::ProgramState::Running;
        wishes[0].feedScale = 9.0;
        wishes[3].workOffset_um[2] = 1e6;
        kerf::LimitReport report;
        (void)limiter.apply(wishes, inputs, 0.001, report);
        QVERIFY(report.feedScale);
        QVERIFY(report.workOffset[2]);
        QVERIFY(!report.workOffset[0]);
    }
    void unfittedOutputsStayNeutral() {
        kerf::OutputLimiter limiter(kerf::Capabilities{});
        std::array<kerf::LoopOutputs, kerf::kProcessPlaces> wishes{};
        wishes[0].feedScale = 0.2;
        wishes[3].workOffset_um[0] = 5.0;
        wishes[2].toolTrim_um = 1.0;
        kerf::MachineInputs inputs;
        inputs.program = kerf::ProgramState::Running;
        kerf::LimitReport report;
        const auto out = limiter.apply(wishes, inputs, 1.0, report);
        QCOMPARE(out.feedScale, 1.0);
        QCOMPARE(out.workOffset_um[0], 0.0);
        QCOMPARE(out.toolTrim_um, 0.0);
    }
};
QTEST_APPLESS_MAIN(TestOutputLimiter)
#include "tst_output_limiter.moc"
