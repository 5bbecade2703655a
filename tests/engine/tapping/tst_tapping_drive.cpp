// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>
#include <cmath>
#include <string>

#include "engine/process/tapping/tap_drive.h"
#include "engine/process/tapping/thread_table.h"
#include "engine/process/tapping/trial_machine.h"
#include "tests/support/golden.h"

using namespace kerf;
using namespace kerf::tapping;

namespace {

constexpr double kGolden = 1e-9;

/// BASE of the reference file with changes put in, by the keys of DRIVE.json.
DriveParams driveFrom(const nlohmann::json& golden, std::initializer_list<nlohmann::json> changes) {
    DriveParams drive;
    const auto put = [&](const nlohmann::json& values) {
        for (const auto& [key, value] : values.items()) {
            if (const DriveKey* entry = findDriveKey(key)) drive.*(entry->member) = value.get<double>();
        }
    };
    put(golden["BASE"]);
    for (const auto& change : changes)
        put(change);
    return drive;
}

double saecOf(const DriveParams& drive) {
    return cleanFigures(drive, settingsOf(drive)).saec_mm;
}

}  // namespace

class TestTappingDrive : public QObject {
    Q_OBJECT
 private slots:
    void initTestCase() { m_golden = kerf::test::loadGolden("golden_tapping.json"); }

    void everyConstantOfBaseHasAKeyAndIsTheDefault() {
        const DriveParams reference;
        for (const auto& [key, value] : m_golden["BASE"].items()) {
            const DriveKey* entry = findDriveKey(key);
            QVERIFY2(entry != nullptr, key.c_str());
            KERF_CLOSE(reference.*(entry->member), value.get<double>(), kGolden);
        }
    }

    void commandedPathEqualsReference() {
        const DriveParams drive;
        const TapTrajectory path(drive.depth_rev, drive.speed_rpm, drive.ramp_revPerS2);
        const auto& points = m_golden["traj_A"];
        for (std::size_t i = 0; i < points["t"].size(); ++i) {
            const TapTrajectory::Point point = path.at(points["t"][i].get<double>());
            KERF_CLOSE(point.position_rev, points["pos"][i].get<double>(), kGolden);
            KERF_CLOSE(point.velocity_revPerS, points["vel"][i].get<double>(), kGolden);
            KERF_CLOSE(point.accel_revPerS2, points["acc"][i].get<double>(), kGolden);
        }
    }

    void tapEqualsReference_data() {
        QTest::addColumn<QString>("name");
        for (const char* name : {"A", "B", "A6000"})
            QTest::newRow(name) << name;
    }
    void tapEqualsReference() {
        QFETCH(QString, name);
        const auto& expected = m_golden[name.toStdString()];
        const DriveParams drive = driveFrom(m_golden, {m_golden["scen"][name.toStdString()]});
        QCOMPARE(tapTicks(drive), expected["nticks"].get<std::size_t>());
        KERF_CLOSE(TapTrajectory(drive.depth_rev, drive.speed_rpm, drive.ramp_revPerS2).reversal_s(),
                   expected["T1"].get<double>(), kGolden);
        TrialMachine machine(drive, {}, 0);
        const TapSignals tap = machine.tap(settingsOf(drive));
        for (std::size_t i = 0; i < expected["theta_every10"].size(); ++i) {
            KERF_CLOSE(tap.spindle_rev[10 * i], expected["theta_every10"][i].get<double>(), kGolden);
            KERF_CLOSE(tap.z_mm[10 * i], expected["z_every10"][i].get<double>(), kGolden);
            KERF_CLOSE(drive.pitch_mm * tap.spindle_rev[10 * i] - tap.z_mm[10 * i],
                       expected["Er_every10"][i].get<double>(), kGolden);
        }
        const ContourFigures figures = cleanFigures(drive, settingsOf(drive));
        KERF_CLOSE(figures.saec_mm, expected["SAEC"].get<double>(), kGolden);
        KERF_CLOSE(figures.saec_mm, expected["stats"]["SAEC_mm"].get<double>(), kGolden);
        KERF_CLOSE(figures.peak_um, expected["stats"]["peak_um"].get<double>(), kGolden);
        KERF_CLOSE(figures.rms_um, expected["stats"]["rms_um"].get<double>(), kGolden);
        KERF_CLOSE(figures.engagedPp_um, expected["stats"]["eng_pp_um"].get<double>(), kGolden);
        for (const auto& point : expected["SAEC_vs_Kpz"]) {
            KERF_CLOSE(saecOf(driveFrom(m_golden, {m_golden["scen"][name.toStdString()], point})),
                       point["SAEC"].get<double>(), kGolden);
        }
        KERF_CLOSE(saecOf(driveFrom(m_golden, {m_golden["scen"][name.toStdString()], expected["ff_case"]})),
                   expected["ff_case"]["SAEC"].get<double>(), kGolden);
        DriveParams slaved = driveFrom(m_golden, {m_golden["scen"][name.toStdString()], expected["slave_ff09"]});
        slaved.slaved = 1.0;
        KERF_CLOSE(saecOf(slaved), expected["slave_ff09"]["SAEC"].get<double>(), kGolden);
    }

    /// Every gain that any reference tuner tried gives the reference sum of errors.
    void referenceSequencesReplay() {
        for (const auto& [name, sequence] : m_golden["sequences_A_noise_free"].items()) {
            for (const auto& point : sequence) {
                if (point.contains("c")) continue;  // another feed-forward form
                KERF_CLOSE(saecOf(driveFrom(m_golden, {point})), point["SAEC"].get<double>(), kGolden);
            }
        }
    }

    void shortHoleNeverReachesSpeed() {
        const TapTrajectory path(4.0, 6000.0, 500.0);
        QVERIFY(path.peakSpeed_revPerS() < 100.0);
        KERF_CLOSE(path.at(path.reversal_s()).position_rev, 4.0, kGolden);
        KERF_CLOSE(path.at(path.end_s()).position_rev, 0.0, kGolden);
    }

    void toleranceTableKeepsTheStandardsLaw() {
        // ISO 965-1: T_D2 grade 6 is 1.32 · 90 P^.4 d^.1, d the geometric mean of its range, then rounded to R 40.
        for (const ThreadPreset& thread : threadPresets()) {
            if (!thread.metric()) {
                continue;
            }
            const double mean_mm = thread.diameter_mm <= 5.6    ? std::sqrt(2.8 * 5.6)
                                   : thread.diameter_mm <= 11.2 ? std::sqrt(5.6 * 11.2)
                                                                : std::sqrt(11.2 * 22.4);
            const double law_um = 1.32 * 90.0 * std::pow(thread.pitch_mm, 0.4) * std::pow(mean_mm, 0.1);
            QVERIFY2(std::abs(thread.grade6_um / law_um - 1.0) < 0.06, thread.name);
            QVERIFY2(std::abs(thread.grade5_um / thread.grade6_um - 0.8) < 0.03, thread.name);
            QVERIFY(findThread(thread.name) == &thread);
        }
    }

    void unifiedThreadsHaveTheirTable() {
        // ASME B1.1, class 2B: largest less smallest pitch diameter in inches, as tables print it to four places.
        const std::vector<std::pair<const char*, double>> table{
            {"#10-32", 0.0039}, {"1/4-20", 0.0049}, {"3/8-16", 0.0057}, {"1/2-13", 0.0065}, {"1/2-20", 0.0056}};
        for (const auto& [name, tolerance_in] : table) {
            const ThreadPreset* thread = findThread(name);
            QVERIFY2(thread != nullptr, name);
            QVERIFY2(std::abs(thread->grade6_um / 25400.0 - tolerance_in) < 0.00006, name);
            QVERIFY(thread->allowedPpWornTap_um() > 0.0 && thread->allowedPpWornTap_um() < thread->allowedPp_um());
        }
        QVERIFY(std::abs(findThread("1/4-20")->pitch_mm - 1.27) < 1e-12);
        QVERIFY(findThread("1/4-20")->coarse && !findThread("1/4-28")->coarse);
    }

    void m8TolerancesAreThePagesFigures() {
        const ThreadPreset* m8 = findThread("M8");
        QVERIFY(m8 != nullptr);
        QCOMPARE(m8->grade6_um, 160.0);
        QVERIFY(std::abs(m8->allowedPp_um() - 92.0) < 0.6);
        QVERIFY(std::abs(m8->allowedPpWornTap_um() - 56.0) < 0.6);
        QVERIFY(findThread("M7") == nullptr);
    }

 private:
    nlohmann::json m_golden;
};

QTEST_GUILESS_MAIN(TestTappingDrive)
#include "tst_tapping_drive.moc"
