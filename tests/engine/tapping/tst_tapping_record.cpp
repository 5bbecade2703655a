// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>
#include <cmath>
#include <string>
#include <vector>

#include "engine/process/tapping/tap_record.h"
#include "engine/process/tapping/trial_machine.h"
#include "tests/support/golden.h"

using namespace kerf;
using namespace kerf::tapping;

class TestTappingRecord : public QObject {
    Q_OBJECT
 private slots:
    void init() {
        const DriveParams drive;
        TrialMachine machine(drive, {}, 0);
        const TapSignals tap = machine.tap(settingsOf(drive));
        m_spindle_rev.assign(tap.spindle_rev.begin(), tap.spindle_rev.end());
        m_z_mm.assign(tap.z_mm.begin(), tap.z_mm.end());
        m_time_s.clear();
        for (std::size_t k = 0; k < m_z_mm.size(); ++k)
            m_time_s.push_back(0.001 * static_cast<double>(k));
        m_clean = cleanFigures(drive, settingsOf(drive));
    }

    void cleanRecordKeepsItsFigures() {
        const auto record = check();
        QVERIFY(record.has_value());
        KERF_CLOSE(figures(*record).saec_mm, m_clean.saec_mm, 1e-9);
        KERF_CLOSE(figures(*record).engagedPp_um, m_clean.engagedPp_um, 1e-9);
        QCOMPARE(record->wrap_rev, 0.0);
    }

    void wrappedCounterIsUnwrapped_data() {
        QTest::addColumn<double>("wrap_rev");
        QTest::newRow("every turn") << 1.0;
        QTest::newRow("every 8 turns") << 8.0;
    }
    void wrappedCounterIsUnwrapped() {
        QFETCH(double, wrap_rev);
        for (double& turn_rev : m_spindle_rev)
            turn_rev -= wrap_rev * std::floor(turn_rev / wrap_rev);
        const auto record = check();
        QVERIFY2(record.has_value(), record ? "" : record.error().english().c_str());
        QCOMPARE(record->wrap_rev, wrap_rev);
        KERF_CLOSE(figures(*record).saec_mm, m_clean.saec_mm, 1e-9);
    }

    void lostCountsAreRefused() {
        for (std::size_t k = 500; k < m_spindle_rev.size(); ++k)
            m_spindle_rev[k] += 2.6;
        QVERIFY(refusal().find("jumps") != std::string::npos);
    }

    void wrongPitchIsRefused_data() {
        QTest::addColumn<double>("pitch_mm");
        for (const double pitch_mm : {1.0, 1.5, 1.27, 25.4 / 20.6, 0.125})
            QTest::addRow("%g", pitch_mm) << pitch_mm;
    }
    void wrongPitchIsRefused() {
        QFETCH(double, pitch_mm);
        const auto record = checkRecord(m_time_s, m_spindle_rev, m_z_mm, pitch_mm);
        QVERIFY(!record.has_value());
        QVERIFY(record.error().english().find("does not fit a pitch") != std::string::npos);
    }

    void lagAloneIsNoWrongPitch() {
        for (const double speed_rpm : {1500.0, 6000.0}) {
            for (const double gain_perS : {20.0, 80.0}) {
                DriveParams drive;
                drive.speed_rpm = speed_rpm;
                drive.zKp_perS = gain_perS;
                drive.depth_rev = 12.0;
                TrialMachine machine(drive, {}, 0);
                const TapSignals tap = machine.tap(settingsOf(drive));
                std::vector<double> time_s;
                for (std::size_t k = 0; k < tap.z_mm.size(); ++k)
                    time_s.push_back(0.001 * static_cast<double>(k));
                const auto record = checkRecord(time_s, tap.spindle_rev, tap.z_mm, drive.pitch_mm);
                QVERIFY2(record.has_value(), record ? "" : record.error().english().c_str());
            }
        }
    }

    void fewMissingSamplesAreScaledManyAreRefused() {
        auto cut = [this](std::size_t begin, std::size_t count) {
            const auto b = static_cast<std::ptrdiff_t>(begin);
            const auto e = static_cast<std::ptrdiff_t>(begin + count);
            m_time_s.erase(m_time_s.begin() + b, m_time_s.begin() + e);
            m_spindle_rev.erase(m_spindle_rev.begin() + b, m_spindle_rev.begin() + e);
            m_z_mm.erase(m_z_mm.begin() + b, m_z_mm.begin() + e);
        };
        for (std::size_t i = 0; i < 40; ++i)
            cut(20 + 25 * i, 1);
        const auto record = check();
        QVERIFY2(record.has_value(), record ? "" : record.error().english().c_str());
        QVERIFY(std::abs(record->missingShare - 40.0 / 1180.0) < 1e-9);
        QVERIFY(std::abs(figures(*record).saec_mm / m_clean.saec_mm - 1.0) < 0.02);
        cut(1000, 40);
        QVERIFY(refusal().find("missing") != std::string::npos);
    }

    void unevenOrCoarseSamplingIsRefused() {
        m_time_s[300] += 0.0004;
        QVERIFY(refusal().find("uneven") != std::string::npos);
        init();
        m_time_s[300] = m_time_s[299];
        QVERIFY(refusal().find("does not rise") != std::string::npos);
        init();
        std::vector<double> time_s, spindle_rev, z_mm;
        for (std::size_t k = 0; k < m_z_mm.size(); k += 7) {
            time_s.push_back(m_time_s[k]);
            spindle_rev.push_back(m_spindle_rev[k]);
            z_mm.push_back(m_z_mm[k]);
        }
        const auto coarse = checkRecord(time_s, spindle_rev, z_mm, 1.25);
        QVERIFY(!coarse.has_value());
        QVERIFY(coarse.error().english().find("sample faster") != std::string::npos);
    }

    void shortAndStandingRecordsAreRefused() {
        m_time_s.resize(30);
        m_spindle_rev.resize(30);
        m_z_mm.resize(30);
        QVERIFY(refusal().find("samples") != std::string::npos);
        init();
        for (double& turn_rev : m_spindle_rev)
            turn_rev = 0.0;
        QVERIFY(refusal().find("at least one") != std::string::npos);
    }

    void downwardAxisAndOffsetsAreTurnedRound() {
        for (double& z : m_z_mm)
            z = 40.0 - z;
        for (double& turn_rev : m_spindle_rev)
            turn_rev += 1234.5;
        const auto record = check();
        QVERIFY2(record.has_value(), record ? "" : record.error().english().c_str());
        QVERIFY(record->mirrored);
        KERF_CLOSE(figures(*record).saec_mm, m_clean.saec_mm, 1e-7);
    }

 private:
    [[nodiscard]] Result<CheckedRecord> check() const { return checkRecord(m_time_s, m_spindle_rev, m_z_mm, 1.25); }
    [[nodiscard]] std::string refusal() const {
        const auto record = check();
        return record ? std::string("accepted") : record.error().english();
    }
    [[nodiscard]] static ContourFigures figures(const CheckedRecord& record) {
        return contourFigures(record.spindle_rev, record.z_mm, record.valid, 1.25, 3.0);
    }

    std::vector<double> m_time_s, m_spindle_rev, m_z_mm;
    ContourFigures m_clean{};
};

QTEST_GUILESS_MAIN(TestTappingRecord)
#include "tst_tapping_record.moc"
