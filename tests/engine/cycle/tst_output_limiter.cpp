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

}  // namespace

class TestOutputLimiter : public QObject {
    Q_OBJECT
 private slots:
    void noSequenceOfWishesGetsPast() {
        const bool held = rc::check("every output stays in range, within its rate, and with its owner", [] {
            const kerf::Capabilities machine = fullMachine();
            const kerf::OutputLimits limits;
            kerf::OutputLimiter limiter(limits, machine);
            kerf::MachineOutputs last;
            const int steps = *rc::gen::inRange(1, 40);
            for (int i = 0; i < steps; ++i) {
                std::array<kerf::LoopOutputs, kerf::kProcessCount> wishes;
                for (auto& wish : wishes) {
                    wish = anyWish();
                }
                kerf::MachineInputs inputs;
                inputs.program = *rc::gen::element(kerf::ProgramState::Idle, kerf::ProgramState::Running,
                                                   kerf::ProgramState::Paused);
                inputs.programProcess = *rc::gen::elementOf(
                    std::vector<kerf::ProcessId>(kerf::kAllProcesses.begin(), kerf::kAllProcesses.end()));
                const double dt_s =
                    *rc::gen::element(0.0, 0.001, 0.0002, 1.0, -1.0, std::numeric_limits<double>::quiet_NaN());
                const double step_s = dt_s > 0.0 ? dt_s : 0.0;
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
        kerf::OutputLimiter limiter({}, fullMachine());
        std::array<kerf::LoopOutputs, kerf::kProcessCount> wishes{};
        kerf::MachineInputs inputs;
        inputs.program = kerf::ProgramState::Running;
        kerf::LimitReport report;
        wishes[0].feedScale = 0.3;
        QCOMPARE(limiter.apply(wishes, inputs, 1.0, report).feedScale, 0.3);
        wishes[0].feedScale.reset();
        QCOMPARE(limiter.apply(wishes, inputs, 1.0, report).feedScale, 0.3);  // the loop let go: stays
        inputs.program = kerf::ProgramState::Finished;
        QCOMPARE(limiter.apply(wishes, inputs, 1.0, report).feedScale, 1.0);
    }
    void adoptingTheMachinesOffsetsMeansNoJump() {
        kerf::OutputLimiter limiter({}, fullMachine());
        kerf::MachineInputs inputs;
        inputs.workOffset_um[1] = {-17.0, 0, kerf::Quality::Good};
        limiter.adopt(inputs, fullMachine());
        kerf::LimitReport report;
        QCOMPARE(limiter.apply({}, inputs, 0.001, report).workOffset_um[1], -17.0);
    }
    void offsetsTheControlHasZeroedAreTakenOverAgain() {
        kerf::OutputLimiter limiter({}, fullMachine());
        kerf::MachineInputs inputs;
        inputs.workOffset_um[1] = {-17.0, 0, kerf::Quality::Good};
        limiter.adopt(inputs, fullMachine());
        std::array<kerf::LoopOutputs, kerf::kProcessCount> wishes{};
        wishes[3].workOffset_um[1] = -17.0;
        kerf::LimitReport report;
        inputs.workOffset_um[1].quality = kerf::Quality::Stale;  // switched off …
        QCOMPARE(limiter.apply(wishes, inputs, 0.001, report).workOffset_um[1], -17.0);
        inputs.workOffset_um[1] = {0.0, 0, kerf::Quality::Good};  // … and on again
        const double rate_umPerS = limiter.limits().workOffsetRate_umPerS;
        QVERIFY(std::abs(limiter.apply(wishes, inputs, 0.001, report).workOffset_um[1]) <= rate_umPerS * 0.0011);
    }
    void limitsSayWhenTheyAreAtWork() {
        kerf::OutputLimiter limiter({}, fullMachine());
        std::array<kerf::LoopOutputs, kerf::kProcessCount> wishes{};
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
        kerf::OutputLimiter limiter({}, kerf::Capabilities{});
        std::array<kerf::LoopOutputs, kerf::kProcessCount> wishes{};
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
