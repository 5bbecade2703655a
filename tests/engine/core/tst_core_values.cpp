// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>

#include "engine/core/histogram.h"
#include "engine/core/param_spec.h"
#include "engine/core/result.h"
#include "engine/core/units.h"

class TestCoreValues : public QObject {
    Q_OBJECT
 private slots:
    void sentenceFillsItsArgumentsInAnyOrder() {
        const kerf::Sentence sentence("%2 is above %1 N", {40.0, 1}, kerf::SentenceArg("Force"));
        QCOMPARE(sentence.english(), std::string("Force is above 40.0 N"));
    }
    void longNamesAreCutNotOverrun() {
        const kerf::SentenceArg arg("a name that is much longer than its place");
        QCOMPARE(kerf::formatArg(arg).size(), std::size_t{22});
    }
    void resultCarriesValueOrReason() {
        const kerf::Result<int> good = 4;
        const kerf::Result<int> bad = kerf::fail("No %1", kerf::SentenceArg("gauge"));
        QVERIFY(good && *good == 4);
        QVERIFY(!bad);
        QCOMPARE(bad.error().english(), std::string("No gauge"));
    }
    void diameterAndRadiusDoNotMix() {
        static_assert(!std::is_convertible_v<kerf::Diameter_mm, kerf::Radius_mm>);
        QCOMPARE(kerf::radiusOf(kerf::Diameter_mm(50.0)).value, 25.0);
    }
    void outOfRangeNamesTheRange() {
        kerf::ParamSpec spec;
        spec.label = "Feed";
        spec.min = 0.01;
        spec.max = 1.0;
        spec.decimals = 2;
        QVERIFY(!kerf::whyOutOfRange(spec, 0.5));
        QCOMPARE(kerf::whyOutOfRange(spec, 1.5)->english(), std::string("Feed must be from 0.01 to 1.00."));
        QVERIFY(kerf::whyOutOfRange(spec, std::numeric_limits<double>::quiet_NaN()).has_value());
    }
    void histogramBinsCoverEveryTime() {
        for (std::int64_t t = 1; t < 2'000'000'000; t = t * 9 / 8 + 1) {
            kerf::TimeHistogram histogram;
            histogram.add(t);
            QCOMPARE(histogram.percentile_ns(0.5), t);  // one value: clipped to the maximum
            std::size_t bin = 0;
            while (histogram.bin(bin) == 0) {
                ++bin;
            }
            QVERIFY(t <= kerf::TimeHistogram::upperEdge_ns(bin));
            QVERIFY(bin == 0 || t > kerf::TimeHistogram::upperEdge_ns(bin - 1));
        }
    }
    void percentilesRankTimes() {
        kerf::TimeHistogram histogram;
        for (int i = 0; i < 999; ++i) {
            histogram.add(1000);
        }
        histogram.add(50000);
        QVERIFY(histogram.percentile_ns(0.5) < 1300);
        QVERIFY(histogram.percentile_ns(0.9995) >= 50000);
        QCOMPARE(histogram.max_ns(), 50000);
    }
};
QTEST_APPLESS_MAIN(TestCoreValues)
#include "tst_core_values.moc"
