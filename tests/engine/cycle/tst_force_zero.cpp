// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>
#include <cmath>
#include <limits>

#include "engine/core/random.h"
#include "engine/cycle/force_zero.h"
#include "tests/support/cycle_guard.h"

using namespace kerf;

namespace {

constexpr double kNoise_N = 5.0;

/// A drifting sensor at 1 kHz: air, then a cut of a four-fluted tool at 600 rpm.
struct Sensor {
    explicit Sensor(double zero, double drift = 0.0) : zero_N(zero), drift_NPerS(drift) {}

    FastSample next(double mean_N) {
        now_ns += 1'000'000;
        zero_N += drift_NPerS * 1e-3;
        const double turn = static_cast<double>(now_ns) * 1e-9 * 10.0;
        const double force_N = mean_N * (1.0 + 0.4 * std::cos(2.0 * M_PI * 4.0 * turn));
        return {now_ns, turn, force_N + zero_N + kNoise_N * noise.gauss(), Quality::Good};
    }

    double zero_N;
    double drift_NPerS;
    std::int64_t now_ns{1'000'000'000};
    Random noise{7};
};

ForceZeroParams params(double statedDrift_NPerS = 0.0, bool resetLine = false) {
    ForceZeroParams out;
    out.signal = {1000.0, 300.0, true, statedDrift_NPerS, 0.2};
    out.resetLine = resetLine;
    out.bite_N = 20.0;
    out.trust_N = 8.0;
    return out;
}

/// Mean of what comes out over `count` samples of a cut of `mean_N`; empty: not every one of them was good.
std::optional<double> meanOut(ForceZero& zero, Sensor& sensor, double mean_N, int count) {
    double sum_N = 0.0;
    for (int i = 0; i < count; ++i) {
        const FastSample sample = zero.take(sensor.next(mean_N));
        if (sample.quality != Quality::Good) {
            return std::nullopt;
        }
        sum_N += sample.force_N / count;
    }
    return sum_N;
}

void air(ForceZero& zero, Sensor& sensor, int count) {
    for (int i = 0; i < count; ++i) {
        (void)zero.take(sensor.next(0.0));
    }
}

}  // namespace

/// The zero of a force sensor that drifts: what is subtracted, how long it is trusted, and that a force without a zero
/// is none.
class TestForceZero : public QObject {
    Q_OBJECT
 private slots:
    void aSensorThatKeepsItsZeroIsLeftAlone() {
        ForceZero zero;
        ForceZeroParams own = params();
        own.signal.zeroInAir = false;
        zero.begin(own);
        Sensor sensor(3.0);
        const FastSample raw = sensor.next(100.0);
        QCOMPARE(zero.take(raw).force_N, raw.force_N);
        QVERIFY(zero.take(raw).quality == Quality::Good);
        QVERIFY(zero.state() == ForceZeroState::Own);
    }
    void whileItIsTakenThereIsNoForce() {
        ForceZero zero;
        zero.begin(params());
        Sensor sensor(180.0);
        const FastSample first = zero.take(sensor.next(0.0));
        QVERIFY(first.quality == Quality::Missing && first.force_N == 0.0);
        air(zero, sensor, 100);
        QVERIFY(zero.state() == ForceZeroState::Taking);
        air(zero, sensor, 100);
        QVERIFY(zero.state() == ForceZeroState::Known);
        QVERIFY(std::abs(zero.zero_N() - 180.0) < 2.0);
    }
    void theForceOfTheCutIsTheForceLessTheZero_data() {
        QTest::addColumn<double>("zero_N");
        for (const double zero_N : {-900.0, 0.0, 40.0, 3000.0}) {
            QTest::addRow("%g N", zero_N) << zero_N;
        }
    }
    void theForceOfTheCutIsTheForceLessTheZero() {
        QFETCH(double, zero_N);
        ForceZero zero;
        zero.begin(params());
        Sensor sensor(zero_N);
        air(zero, sensor, 1500);
        const auto mean_N = meanOut(zero, sensor, 392.0, 5000);
        QVERIFY(mean_N.has_value());
        QVERIFY2(std::abs(*mean_N - 392.0) < 1.0, qPrintable(QString::number(*mean_N)));
    }
    void whatBitesIsNoPartOfTheZero() {
        ForceZero zero;
        zero.begin(params());
        Sensor sensor(50.0);
        air(zero, sensor, 400);
        for (int i = 0; i < 200; ++i) {  // the first teeth: from nothing to the whole force in .2 s
            (void)zero.take(sensor.next(392.0 * i / 200.0));
        }
        QVERIFY2(std::abs(zero.zero_N() - 50.0) < 2.0, qPrintable(QString::number(zero.zero_N())));
    }
    void aCutThatBeginsSlowlyIsNotSwallowed() {
        ForceZero zero;
        zero.begin(params());
        Sensor sensor(50.0);
        air(zero, sensor, 400);
        double sum_N = 0.0;
        for (int i = 0; i < 20'000; ++i) {  // 10 N/s, a blank that grows out of nothing
            const double true_N = 0.01 * i;
            const FastSample sample = zero.take(sensor.next(true_N));
            QVERIFY(sample.quality == Quality::Good);
            sum_N += i >= 19'000 ? (sample.force_N - true_N) / 1000.0 : 0.0;
        }
        QVERIFY2(std::abs(sum_N) < params().trust_N, qPrintable(QString::number(sum_N)));
    }
    void withoutAirThereIsNoForce() {
        ForceZero zero;
        zero.begin(params());
        Sensor sensor(50.0);
        FastSample sample;
        for (int i = 0; i < 3000; ++i) {
            sample = zero.take(sensor.next(392.0));
            QVERIFY(sample.quality != Quality::Good);
        }
        QVERIFY(sample.quality == Quality::Bad);
        QVERIFY(zero.state() == ForceZeroState::Missed);
    }
    void aStatedDriftEndsTheTrust() {
        ForceZero zero;
        zero.begin(params(0.5));
        Sensor sensor(50.0, 0.5);
        air(zero, sensor, 1000);
        int good = 0;
        double worst_N = 0.0;
        double mean_N = 0.0;
        for (int i = 0; i < 30'000; ++i) {
            const FastSample sample = zero.take(sensor.next(392.0));
            if (sample.quality != Quality::Good) {
                break;
            }
            ++good;
            mean_N += 0.002 * (sample.force_N - mean_N);
            worst_N = good > 3000 ? std::max(worst_N, std::abs(mean_N - 392.0)) : 0.0;
        }
        QVERIFY(zero.state() == ForceZeroState::Doubtful);
        QVERIFY2(good > 10'000 && good < 16'000, qPrintable(QString::number(good)));  // 8 N at .5 N/s, less its error
        QVERIFY2(worst_N < 12.0, qPrintable(QString::number(worst_N)));  // 8 N and what the average still swings
        QVERIFY(zero.take(sensor.next(392.0)).quality == Quality::Bad);
    }
    void aForceBelowNothingIsAWrongZero() {
        ForceZero zero;
        zero.begin(params());
        Sensor sensor(50.0);
        air(zero, sensor, 500);
        QVERIFY(meanOut(zero, sensor, 392.0, 2000).has_value());
        sensor.zero_N -= 60.0;  // it has slipped while it was cutting: in the next gap of the blank that shows
        FastSample sample;
        for (int i = 0; i < 400; ++i) {
            sample = zero.take(sensor.next(0.0));
        }
        QVERIFY(zero.state() == ForceZeroState::Doubtful);
        QVERIFY(sample.quality == Quality::Bad);
    }
    void aDriftNobodyStatedIsLearntBehindTheCut() {
        ForceZero zero;
        Sensor sensor(50.0, 0.4);
        zero.begin(params());
        air(zero, sensor, 500);
        QVERIFY(meanOut(zero, sensor, 392.0, 30'000).has_value());  // nobody could know
        air(zero, sensor, 400);
        zero.end(true);
        QVERIFY(zero.moved_N().has_value());
        QVERIFY2(std::abs(*zero.moved_N() - 12.2) < 2.0, qPrintable(QString::number(*zero.moved_N())));
        zero.begin(params());
        air(zero, sensor, 500);
        int good = 0;
        while (good < 60'000 && zero.take(sensor.next(392.0)).quality == Quality::Good) {
            ++good;
        }
        QVERIFY2(good > 12'000 && good < 30'000, qPrintable(QString::number(good)));  // 8 N at about .4 N/s
    }
    void aCutThatEndsInTheWorkTeachesNothing() {
        ForceZero zero;
        Sensor sensor(50.0);
        zero.begin(params());
        air(zero, sensor, 500);
        QVERIFY(meanOut(zero, sensor, 392.0, 3000).has_value());
        zero.end(true);  // says the control, but the teeth still cut
        QVERIFY(!zero.moved_N().has_value());
        zero.begin(params());
        air(zero, sensor, 500);
        QVERIFY(meanOut(zero, sensor, 392.0, 30'000).has_value());
    }
    void theAmplifierIsResetInTheAirBeforeTheZeroIsTaken() {
        ForceZero zero;
        zero.begin(params(0.0, true));
        Sensor sensor(700.0);
        int held = 0;
        for (int i = 0; i < 1000 && zero.state() != ForceZeroState::Known; ++i) {
            if (zero.wantsReset()) {
                ++held;
                sensor.zero_N = 2.0;
            }
            QVERIFY(zero.take(sensor.next(0.0)).quality == Quality::Missing || zero.state() == ForceZeroState::Known);
        }
        QVERIFY2(held >= 195 && held <= 205, qPrintable(QString::number(held)));  // .2 s
        QVERIFY(std::abs(zero.zero_N() - 2.0) < 2.0);
        QVERIFY(!zero.wantsReset());
    }
    void nothingIsResetInTheWork() {
        ForceZero zero;
        zero.begin(params(0.0, true));
        Sensor sensor(0.0);
        for (int i = 0; i < 3000; ++i) {
            (void)zero.take(sensor.next(392.0));
            QVERIFY(!zero.wantsReset());
        }
        QVERIFY(zero.state() == ForceZeroState::Missed);
    }
    void whatIsNoSampleIsNoAir() {
        ForceZero zero;
        zero.begin(params());
        Sensor sensor(50.0);
        for (int i = 0; i < 400; ++i) {
            FastSample sample = sensor.next(0.0);
            sample.quality = i % 2 == 0 ? Quality::Bad : Quality::Saturated;
            sample.force_N = i % 4 == 0 ? std::numeric_limits<double>::quiet_NaN() : 9999.0;
            QVERIFY(zero.take(sample).quality != Quality::Good);
        }
        QVERIFY(zero.state() == ForceZeroState::Taking);
        QCOMPARE(zero.zero_N(), 0.0);
    }
    void itRunsInTheCycle() {
        ForceZero zero;
        Sensor sensor(50.0);
        const test::CycleGuard guard;
        zero.begin(params(0.1, true));
        air(zero, sensor, 1000);
        (void)meanOut(zero, sensor, 392.0, 2000);
        zero.end(true);
        zero.leave();
        QCOMPARE(guard.allocations() + guard.locks() + guard.throws(), std::uint64_t{0});
    }
};
QTEST_APPLESS_MAIN(TestForceZero)
#include "tst_force_zero.moc"
