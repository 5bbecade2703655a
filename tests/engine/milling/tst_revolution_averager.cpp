// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>
#include <cmath>
#include <functional>
#include <limits>
#include <vector>

#include "engine/core/random.h"
#include "engine/process/milling/revolution_averager.h"
#include "engine/process/milling/sampled_force.h"

using namespace kerf;
using namespace kerf::milling;

namespace {

constexpr double kRate_Hz = 5000.0;

/// Samples a spindle whose speed is a function of time for `duration_s`; returns the finished revolutions.
std::vector<RevolutionForce> run(const std::function<double(double)>& speed_rpm, double duration_s,
                                 const std::function<double(double, double)>& force_N,
                                 const std::function<void(int, FastSample&)>& spoil = {}, double startAngle_rev = 0.3) {
    RevolutionAverager averager;
    std::vector<RevolutionForce> finished;
    double angle_rev = startAngle_rev;
    const int count = static_cast<int>(duration_s * kRate_Hz);
    for (int i = 0; i < count; ++i) {
        const double t_s = i / kRate_Hz;
        FastSample sample{static_cast<std::int64_t>(t_s * 1e9), angle_rev, force_N(t_s, angle_rev), Quality::Good};
        if (spoil) {
            spoil(i, sample);
        }
        if (const auto revolution = averager.add(sample)) {
            finished.push_back(*revolution);
        }
        angle_rev += speed_rpm(t_s + 0.5 / kRate_Hz) / 60.0 / kRate_Hz;
    }
    return finished;
}

double rippled(double, double angle_rev) {
    return sampledForce_N(ForceShape(), 400.0, angle_rev);
}

}  // namespace

class TestRevolutionAverager : public QObject {
    Q_OBJECT

 private slots:
    void rippleCancelsAtEverySpeed_data() {
        QTest::addColumn<double>("speed_rpm");
        for (const double speed_rpm : {60.0, 600.0, 2999.0, 6000.0, 11987.0, 12000.0}) {
            QTest::addRow("%g rpm", speed_rpm) << speed_rpm;
        }
    }
    void rippleCancelsAtEverySpeed() {
        QFETCH(double, speed_rpm);
        const double duration_s = 60.0 / speed_rpm * 12.0;
        const auto revolutions = run([&](double) { return speed_rpm; }, duration_s, rippled);
        QVERIFY(revolutions.size() >= 10);
        for (const RevolutionForce& revolution : revolutions) {
            QCOMPARE(revolution.quality, Quality::Good);
            QVERIFY(std::abs(revolution.mean_N - 400.0) < 0.005 * 400.0);
            QVERIFY(std::abs(revolution.duration_s() / (60.0 / speed_rpm) - 1.0) < 1e-3);
            QVERIFY(revolution.peak_N > 500.0);  // the ripple was really there
        }
    }
    void averageHoldsThroughSpeedChanges() {
        // 600 → 6000 rpm within a second, then down to 60: the average is by angle, so the ripple still cancels.
        const auto speed_rpm = [](double t_s) {
            return t_s < 1.0 ? 600.0 + 5400.0 * t_s : std::max(60.0, 6000.0 - 4000.0 * (t_s - 1.0));
        };
        const auto revolutions = run(speed_rpm, 4.0, rippled);
        QVERIFY(revolutions.size() > 100);
        for (const RevolutionForce& revolution : revolutions) {
            QCOMPARE(revolution.quality, Quality::Good);
            QVERIFY(std::abs(revolution.mean_N - 400.0) < 2.0);
        }
        for (std::size_t i = 1; i < revolutions.size(); ++i) {
            QCOMPARE(revolutions[i].revolution, revolutions[i - 1].revolution + 1);
            QCOMPARE(revolutions[i].begin_ns, revolutions[i - 1].end_ns);
        }
    }
    void firstRevolutionBeginsAtAMark() {
        const auto revolutions = run([](double) { return 600.0; }, 0.35, rippled, {}, 7.4);
        QCOMPARE(revolutions.size(), std::size_t{2});  // 7.4…8 is no whole revolution
        QCOMPARE(revolutions.front().revolution, std::int64_t{8});
    }
    void badSamplesSpoilTheRevolution_data() {
        QTest::addColumn<int>("quality");
        for (const Quality quality : {Quality::Missing, Quality::Stale, Quality::Bad, Quality::Saturated}) {
            QTest::addRow("quality %d", static_cast<int>(quality)) << static_cast<int>(quality);
        }
    }
    void badSamplesSpoilTheRevolution() {
        QFETCH(int, quality);
        const auto spoil = [&](int i, FastSample& sample) {
            if (i > 1000 && i < 1100) {
                sample.quality = static_cast<Quality>(quality);
            }
        };
        const auto revolutions = run([](double) { return 600.0; }, 0.6, rippled, spoil);
        int spoiled = 0;
        for (const RevolutionForce& revolution : revolutions) {
            if (revolution.quality != Quality::Good) {
                ++spoiled;
                QCOMPARE(static_cast<int>(revolution.quality), quality);
                QVERIFY(revolution.trustedShare < 0.95);
            }
        }
        QCOMPARE(spoiled, 1);
    }
    void aFewLostSamplesDoNoHarm() {
        const auto spoil = [](int i, FastSample& sample) {
            if (i % 100 == 7) {
                sample.force_N = std::numeric_limits<double>::quiet_NaN();
            }
        };
        for (const RevolutionForce& revolution : run([](double) { return 600.0; }, 0.6, rippled, spoil)) {
            QCOMPARE(revolution.quality, Quality::Good);
            QVERIFY(std::abs(revolution.mean_N - 400.0) < 6.0);
        }
    }
    void notANumberIsNeverTrusted() {
        const auto force_N = [](double, double) { return std::numeric_limits<double>::quiet_NaN(); };
        const auto revolutions = run([](double) { return 600.0; }, 0.6, force_N);
        QVERIFY(revolutions.size() >= 4);
        for (const RevolutionForce& revolution : revolutions) {
            QCOMPARE(revolution.quality, Quality::Bad);
            QCOMPARE(revolution.mean_N, 0.0);
        }
    }
    void aStuckSensorShows() {
        const auto revolutions = run([](double) { return 600.0; }, 0.6, [](double, double) { return 321.0; });
        QVERIFY(revolutions.size() >= 4);
        for (const RevolutionForce& revolution : revolutions) {
            QCOMPARE(revolution.quality, Quality::Bad);
        }
    }
    void airIsNotAStuckSensor() {
        for (const RevolutionForce& revolution :
             run([](double) { return 600.0; }, 0.6, [](double, double) { return 0.0; })) {
            QCOMPARE(revolution.quality, Quality::Good);
        }
    }
    void lostBlockOfSamplesIsNotBridged() {
        RevolutionAverager averager;
        std::optional<RevolutionForce> seen;
        for (int i = 0; i < 3000; ++i) {
            if (i > 1010 && i < 1200) {
                continue;  // 0.38 revolution without a sample
            }
            const double angle_rev = i * 0.002;
            const auto revolution =
                averager.add({std::int64_t{i} * 200'000, angle_rev, rippled(0.0, angle_rev), Quality::Good});
            if (revolution && revolution->quality != Quality::Good) {
                seen = revolution;
            }
        }
        QVERIFY(seen.has_value());
        QCOMPARE(seen->quality, Quality::Stale);
    }
    void swingingBackDoesNotPassAMarkTwice() {
        RevolutionAverager averager;
        Random random(5);
        double angle_rev = 0.1;
        std::int64_t last = -1;
        for (int i = 0; i < 20000; ++i) {
            angle_rev += random.uniform(-0.004, 0.008);
            if (const auto revolution =
                    averager.add({std::int64_t{i} * 200'000, angle_rev, 50.0 + angle_rev, Quality::Good})) {
                QVERIFY(last < 0 || revolution->revolution == last + 1);
                last = revolution->revolution;
            }
        }
        QVERIFY(last > 20);
    }
};

QTEST_APPLESS_MAIN(TestRevolutionAverager)
#include "tst_revolution_averager.moc"
