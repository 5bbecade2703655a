// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/core/random.h"
#include "engine/process/milling/chatter_watch.h"
#include "engine/process/milling/sampled_force.h"

using namespace kerf;
using milling::ChatterWatch;

/// Chatter told from all that repeats itself with the spindle, and from noise.
class TestChatterWatch : public QObject {
    Q_OBJECT

    struct Cut {
        double speed_rpm{600.0};
        milling::ForceShape shape{};
        double chatter_Hz{637.0};
        double grows_perS{0.0};  ///< from .5 N at 1 s, to 80 N at most; 0: none
        double noise_N{5.0};     ///< of a sample
        double stepPerRev{0.0};  ///< rise of the mean force from 1 s to 2 s, as a share per revolution
        double seconds{4.0};
    };
    struct Seen {
        double at_s{-1.0};  ///< negative: never
        double frequency_Hz{0.0};
    };
    [[nodiscard]] static Seen watch(const Cut& cut) {
        constexpr double kRate_Hz = 5000.0;
        ChatterWatch watch;
        watch.begin(cut.shape.flutes);
        Random noise(3);
        double mean_N = 300.0;
        for (int i = 0; i < static_cast<int>(cut.seconds * kRate_Hz); ++i) {
            const double time_s = i / kRate_Hz;
            const double perSample_rev = cut.speed_rpm / 60.0 / kRate_Hz;
            mean_N *= time_s > 1.0 && time_s < 2.0 ? std::pow(1.0 + cut.stepPerRev, perSample_rev) : 1.0;
            const double swing_N = cut.grows_perS > 0.0 && time_s > 1.0
                                       ? std::min(0.5 * std::exp(cut.grows_perS * (time_s - 1.0)), 80.0)
                                       : 0.0;
            FastSample sample;
            sample.stamp_ns = i * 200'000LL;
            sample.spindleAngle_rev = i * perSample_rev;
            sample.force_N = milling::sampledForce_N(cut.shape, mean_N, sample.spindleAngle_rev) +
                             swing_N * std::sin(2.0 * std::numbers::pi * cut.chatter_Hz * time_s) +
                             cut.noise_N * noise.gauss();
            sample.quality = Quality::Good;
            watch.add(sample);
            if (watch.chatters()) {
                return {time_s, watch.frequency_Hz()};
            }
        }
        return {};
    }

 private slots:
    void itsOnsetIsSeenAtEverySpeed() {
        for (const double speed_rpm : {180.0, 600.0, 3000.0, 12000.0}) {
            for (const double chatter_Hz : {211.0, 437.0, 637.0, 913.0}) {
                Cut cut;
                cut.speed_rpm = speed_rpm;
                cut.chatter_Hz = chatter_Hz;
                cut.grows_perS = 3.0;
                cut.seconds = 6.0;
                const double turns = chatter_Hz / speed_rpm * 60.0;
                if (std::abs(turns - std::round(turns)) < 0.1) {
                    continue;  // as good as a multiple of the spindle's
                }
                const Seen seen = watch(cut);
                const QString where = QStringLiteral("%1 rpm, %2 Hz: %3 s, %4 Hz")
                                          .arg(speed_rpm)
                                          .arg(chatter_Hz)
                                          .arg(seen.at_s)
                                          .arg(seen.frequency_Hz);
                const double plain_s = 1.0 + std::log(30.0 / 0.5) / cut.grows_perS;  // a tenth of the mean force
                const double windows_s = 4.0 * std::max(60.0 / speed_rpm, 256.0 / 5000.0 + 60.0 / speed_rpm);
                QVERIFY2(seen.at_s > 1.0 && seen.at_s < plain_s + windows_s, qPrintable(where));
                QVERIFY2(seen.frequency_Hz > 0.75 * chatter_Hz && seen.frequency_Hz < 1.35 * chatter_Hz,
                         qPrintable(where));
            }
        }
    }
    void whatRepeatsItselfIsNone() {
        for (const double speed_rpm : {180.0, 600.0, 3000.0, 12000.0}) {
            for (const int flutes : {1, 2, 4}) {
                for (const bool missing : {false, true}) {
                    for (const double stepPerRev : {0.0, 0.05, -0.05}) {
                        Cut cut;
                        cut.speed_rpm = speed_rpm;
                        cut.shape.flutes = flutes;
                        cut.shape.runOut = 0.2;
                        cut.shape.missing = missing && flutes > 1;
                        cut.stepPerRev = speed_rpm > 600.0 ? 0.0 : stepPerRev;
                        const Seen seen = watch(cut);
                        QVERIFY2(seen.at_s < 0.0, qPrintable(QStringLiteral("%1 rpm, %2 flutes, step %3: %4 s, %5 Hz")
                                                                 .arg(speed_rpm)
                                                                 .arg(flutes)
                                                                 .arg(stepPerRev)
                                                                 .arg(seen.at_s)
                                                                 .arg(seen.frequency_Hz)));
                    }
                }
            }
        }
    }
    void noiseOfTheSensorIsNone() {
        for (const double noise_N : {0.0, 20.0, 100.0}) {
            Cut cut;
            cut.noise_N = noise_N;
            cut.seconds = 20.0;
            QVERIFY2(watch(cut).at_s < 0.0, qPrintable(QString::number(noise_N)));
        }
    }
};
QTEST_APPLESS_MAIN(TestChatterWatch)
#include "tst_chatter_watch.moc"
