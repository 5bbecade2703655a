// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>
#include <cmath>

#include "app/service/tapping/tapping_tuning_json.h"

using namespace kerf;

namespace {
tapping::StoredTuning tuning() {
    tapping::StoredTuning t;
    t.choice = {"M10x1", 4500.0, 18.5, 2, "Bracket", "7"};
    t.settings = {40.0, 40.153456789012345, -0.00201, -1.245, {0.0, 0.0823456, -0.01}};
    t.own = {40.0, 48.0, 0.0, 0.0, {}};
    t.proof.before = {40.0, 48.0, 0.0, 0.0, 0.0};
    t.proof.after = {40.0, 40.15, -0.002, -1.245, 82.3};
    t.proof.first = {219.9, 260.0, 240.0, 519.6, 1180, 3};
    t.proof.last = {2.1, 9.0, 2.2, 14.0, 1180, 0};
    t.proof.taps = 4;
    t.proof.author = "김민지";
    t.hole_s = 0.92;
    t.first = {{0.0F, 1.0F, 0.5F}, {0.0F, -200.0F, 100.0F}, 1};
    t.last = t.first;
    return t;
}
}  // namespace

class TestTappingTuningJson : public QObject {
    Q_OBJECT
 private slots:
    void aTuningComesBackAsItWas() {
        const tapping::StoredTuning before = tuning();
        const auto after = formats::tuningFromJson(formats::tuningToJson(before));
        QVERIFY2(after.has_value(), after ? "" : after.error().english().c_str());
        QCOMPARE(after->choice.thread, before.choice.thread);
        QCOMPARE(after->choice.gear, before.choice.gear);
        QCOMPARE(after->choice.partType, before.choice.partType);
        QCOMPARE(after->settings.zKp_perS, before.settings.zKp_perS);  // all digits
        QCOMPARE(after->settings.zTrim_mm.size(), std::size_t{3});
        QVERIFY(std::abs(after->settings.zTrim_mm[1] - before.settings.zTrim_mm[1]) < 1e-7);
        QCOMPARE(after->own.zKp_perS, 48.0);
        QCOMPARE(after->proof.author, before.proof.author);
        QCOMPARE(after->proof.first.missing, 3U);
        QCOMPARE(after->first.reversal, std::size_t{1});
        QCOMPARE(after->last.error_um[1], -200.0F);
    }
    void damagedOnesAreRefused_data() {
        QTest::addColumn<QByteArray>("from");
        QTest::addColumn<QByteArray>("to");
        QTest::newRow("cut off") << QByteArray("}") << QByteArray("");
        QTest::newRow("version") << QByteArray("\"version\":1") << QByteArray("\"version\":2");
        QTest::newRow("no gain") << QByteArray("z_kp_perS") << QByteArray("z_kp");
        QTest::newRow("gain is text") << QByteArray("\"gear\":2") << QByteArray("\"gear\":\"two\"");
        QTest::newRow("gear") << QByteArray("\"gear\":2") << QByteArray("\"gear\":200");
        QTest::newRow("trim") << QByteArray("82.3456") << QByteArray("8.2e9");
        QTest::newRow("curves") << QByteArray("[0.0,1.0,0.5]") << QByteArray("[0.0,1.0]");
    }
    void damagedOnesAreRefused() {
        QFETCH(QByteArray, from);
        QFETCH(QByteArray, to);
        QByteArray json = QByteArray::fromStdString(formats::tuningToJson(tuning()));
        QVERIFY(json.contains(from));
        json.replace(json.indexOf(from), from.size(), to);
        const auto result = formats::tuningFromJson(json.toStdString());
        QVERIFY(!result.has_value());
        QVERIFY(!result.error().empty());
    }
};
QTEST_GUILESS_MAIN(TestTappingTuningJson)
#include "tst_tapping_tuning_json.moc"
