// SPDX-License-Identifier: GPL-3.0-or-later
#include <rapidcheck.h>

#include <QTest>
#include <cfenv>
#include <limits>

#include "engine/process/thermal/compensation.h"
#include "tests/support/golden.h"

using namespace kerf::thermal;
using nlohmann::json;

class TestCompensation : public QObject {
    Q_OBJECT
 private slots:
    void wordsMatchTheReference();
    void everyWordDecodesToWhatWasEncoded();
    void reservedAxisAndTooLargeShiftsAreRefused();
    void requestWordRoundTrips();
    void loopMatchesTheReference();
    void shiftIsAgainstWhatTheControlReports();
    void neverBeyondSizeOrRate();
    void notANumberCommandsNothing();
    void roundsHalvesToEvenInAnyRoundingMode();
    void silenceOrADeadBitHolds();
    void followsInsideAndHoldsFarOutside();
};

void TestCompensation::wordsMatchTheReference() {
    const json golden = kerf::test::loadGolden("golden_comp.json");
    for (const json& one : golden["words"]) {
        const auto axis = one["axis"].get<std::string>();
        const ShiftWord word{static_cast<std::uint8_t>(axis == "X"   ? 0
                                                       : axis == "Y" ? 1
                                                                     : 2),
                             one["um"].get<std::int16_t>(), one["working"].get<bool>()};
        const auto encoded = encodeShiftWord(word);
        QVERIFY(encoded.has_value());
        QCOMPARE(int{*encoded}, one["word"].get<int>());
        QVERIFY(decodeShiftWord(*encoded) == word);
    }
}

void TestCompensation::everyWordDecodesToWhatWasEncoded() {
    for (int raw = 0; raw <= 0xFFFF; ++raw) {
        const auto word = decodeShiftWord(static_cast<std::uint16_t>(raw));
        const bool reserved = ((raw >> 13) & 3) == 3;
        QCOMPARE(word.has_value(), !reserved);
        if (word) {
            const auto back = encodeShiftWord(*word);
            QVERIFY(back.has_value());
            QCOMPARE(int{*back}, raw);
        }
    }
}

void TestCompensation::reservedAxisAndTooLargeShiftsAreRefused() {
    QVERIFY(!encodeShiftWord({3, 0, true}).has_value());
    QVERIFY(!encodeShiftWord({0, 4096, true}).has_value());
    QVERIFY(!encodeShiftWord({0, -4097, true}).has_value());
    QVERIFY(encodeShiftWord({2, -4096, true}).has_value());
}

void TestCompensation::requestWordRoundTrips() {
    for (std::uint8_t axis = 0; axis < 3; ++axis) {
        for (const bool start : {false, true}) {
            const auto raw = encodeRequestWord({axis, start});
            QVERIFY(raw.has_value());
            QCOMPARE(int{*raw}, axis + (start ? 16 : 0));
            QVERIFY(decodeRequestWord(*raw) == (RequestWord{axis, start}));
        }
    }
    QVERIFY(!decodeRequestWord(3).has_value());
}

void TestCompensation::loopMatchesTheReference() {
    const json loop = kerf::test::loadGolden("golden_comp.json")["loop"];
    double shift_um = 0.0;
    double worst_um = 0.0;
    std::size_t next = 0;
    for (std::size_t k = 0; k < loop["pred"].size(); ++k) {
        const double drift_um = loop["pred"][k].get<double>();
        if (k > 0 && k % 5 == 0) {
            const ShiftCommand command = nextShift(drift_um, shift_um, ShiftLimits{});
            QCOMPARE(std::size_t{k}, loop["cmds"][next][0].get<std::size_t>());
            QCOMPARE(command.step_um, loop["cmds"][next][1].get<double>());
            shift_um = command.total_um;
            ++next;
        }
        worst_um = std::max(worst_um, std::abs(drift_um + shift_um));
    }
    QCOMPARE(next, loop["cmds"].size());
    QVERIFY(std::abs(worst_um - loop["residual_max"].get<double>()) <=
            5e-5);  // the predictions are printed to .0001 µm
}

void TestCompensation::shiftIsAgainstWhatTheControlReports() {
    // After a restart in mid-shift the control still has 12 µm: only the difference is commanded.
    const ShiftCommand command = nextShift(-14.2, 12.0, ShiftLimits{});
    QCOMPARE(command.step_um, 2.0);
    QCOMPARE(command.total_um, 14.0);
    QCOMPARE(nextShift(-14.2, 14.0, ShiftLimits{}).step_um, 0.0);
}

void TestCompensation::neverBeyondSizeOrRate() {
    QVERIFY(rc::check([](double drift, double applied) {
        const double drift_um = std::fmod(drift, 1e4);
        const double applied_um = std::round(std::fmod(applied, 100.0));
        const ShiftLimits limits{1.0, 60.0, 5.0};
        RC_PRE(std::isfinite(drift_um) && std::isfinite(applied_um) && std::abs(applied_um) <= 60.0);
        const ShiftCommand command = nextShift(drift_um, applied_um, limits);
        RC_ASSERT(std::abs(command.total_um) <= 60.0);
        RC_ASSERT(std::abs(command.step_um) <= 5.0);
        RC_ASSERT(command.step_um == std::round(command.step_um));
        if (!command.sizeLimited && !command.rateLimited) {
            RC_ASSERT(std::abs(command.total_um + drift_um) <= 0.5);
        }
    }));
}

void TestCompensation::notANumberCommandsNothing() {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    QCOMPARE(nextShift(nan, 7.0, ShiftLimits{}).step_um, 0.0);
    QCOMPARE(nextShift(nan, 7.0, ShiftLimits{}).total_um, 7.0);
    QCOMPARE(nextShift(-3.0, nan, ShiftLimits{}).step_um, 0.0);
    QCOMPARE(nextShift(std::numeric_limits<double>::infinity(), 7.0, ShiftLimits{}).step_um, 0.0);
}

void TestCompensation::roundsHalvesToEvenInAnyRoundingMode() {
    for (const int mode : {FE_TONEAREST, FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO}) {
        std::fesetround(mode);
        const double half = roundHalfEven(0.5);
        const double oneHalf = roundHalfEven(1.5);
        const double minus = roundHalfEven(-2.5);
        std::fesetround(FE_TONEAREST);
        QCOMPARE(half, 0.0);
        QCOMPARE(oneHalf, 2.0);
        QCOMPARE(minus, -2.0);
    }
}

void TestCompensation::silenceOrADeadBitHolds() {
    AliveWatch watch(5.0);
    QVERIFY(!watch.alive(0.0));
    watch.seen({0, 3, true}, 1.0);
    QVERIFY(watch.alive(6.0));
    watch.seen({0, 3, false}, 4.0);
    QVERIFY(!watch.alive(6.1));
}

void TestCompensation::followsInsideAndHoldsFarOutside() {
    QCOMPARE(holdShare(0.0), 1.0);
    QCOMPARE(holdShare(0.25), 0.75);
    QCOMPARE(holdShare(3.0), 0.0);
}

QTEST_APPLESS_MAIN(TestCompensation)
#include "tst_compensation.moc"
