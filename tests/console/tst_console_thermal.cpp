// SPDX-License-Identifier: GPL-3.0-or-later
#include <QDir>
#include <QFile>
#include <QTableWidget>
#include <algorithm>
#include <cmath>

#include "engine/process/thermal/thermal_alarms.h"
#include "tests/support/console_bench.h"
#include "tests/support/golden.h"
#include "tests/support/patience.h"
#include "ui/widgets/action_button.h"
#include "ui/widgets/number_display.h"

using namespace kerf;

/// Thermal on the real console: simulator, engine, database, window; an operator's touches through the widgets.
class TestConsoleThermal : public QObject {
    Q_OBJECT

    [[nodiscard]] static console::Options options() {
        console::Options o;
        o.preparedParts = 0;
        o.simulationSpeed = 0.0;  // as fast as it can
        o.seed = 3;
        return o;
    }
    [[nodiscard]] const ThermalStatus& thermal() { return m_bench.status().thermal; }
    [[nodiscard]] QTableWidget* table(const char* name) { return m_bench.find<QTableWidget>(name); }
    void bringUp() {
        m_bench.start(options());
        QTRY_VERIFY2_WITH_TIMEOUT(m_bench.up(), qPrintable(m_bench.failure()), test::patience_ms(20'000));
        m_bench.console().window()->showPage("thermal");
    }
    void signOn() {
        QVERIFY(m_bench.press("operator"));
        QTRY_VERIFY(m_bench.find<QLineEdit>("operatorName") != nullptr);
        QTest::keyClicks(m_bench.find<QLineEdit>("operatorName"), QStringLiteral("Kim"));
        QTRY_VERIFY(m_bench.find("signOn") != nullptr);
        QVERIFY(m_bench.press("roleEngineer"));
        QVERIFY(m_bench.press("signOn"));
    }
    /// QTRY_VERIFY looks twice: only looking may stand in it.
    [[nodiscard]] bool ready(const char* name) {
        const auto* button = m_bench.find<QAbstractButton>(name);
        return button != nullptr && button->isEnabled();
    }
    void pressWhenReady(const char* name) {
        QTRY_VERIFY_WITH_TIMEOUT(ready(name), test::patience_ms(20'000));
        QVERIFY(m_bench.press(name));
    }
    void closeSheet() {
        QVERIFY(m_bench.press("thermalSheetClose"));
        QTRY_VERIFY(m_bench.find("thermalSheetClose") == nullptr);
    }

 private slots:
    void aShiftOfThermalWork() {
        bringUp();
        signOn();
        theFirstModelTrainsItself();
        if (QTest::currentTestFailed()) return;
        theMachineWarmsUpAndTheOffsetsFollow();
        if (QTest::currentTestFailed()) return;
        aMeasurementChecksTheModel();
        if (QTest::currentTestFailed()) return;
        aRealDataSetIsTrainedComparedAndRolledBack();
        if (QTest::currentTestFailed()) return;
        theLanguageSwitches();
        aRestartReadsTheShiftBack();
        m_bench.stop();
    }

 private:
    void theFirstModelTrainsItself() {
        QTRY_COMPARE_WITH_TIMEOUT(thermal().stage, ThermalStage::Following, test::patience_ms(60'000));
        QCOMPARE(thermal().model, 1U);
        QVERIFY(m_bench.press("thermalModel"));
        QTRY_VERIFY(table("thermalCard") != nullptr && table("thermalCard")->rowCount() > 5);
        closeSheet();
    }
    void theMachineWarmsUpAndTheOffsetsFollow() {
        pressWhenReady("thermalWarmUp");
        QPushButton* start = nullptr;
        for (auto* button : m_bench.console().window()->findChildren<QPushButton*>()) {
            if (button->isVisible() && button->text() == QStringLiteral("Start the spindle")) start = button;
        }
        QVERIFY(start != nullptr);
        QTest::mouseClick(start, Qt::LeftButton);
        QTRY_VERIFY_WITH_TIMEOUT(thermal().warmUpRunning, test::patience_ms(10'000));
        QTRY_VERIFY_WITH_TIMEOUT(!thermal().warmUpRunning, test::patience_ms(120'000));
        QTRY_VERIFY_WITH_TIMEOUT(std::abs(thermal().shifted_um[1].value) >= 3.0, test::patience_ms(30'000));
        for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
            QVERIFY(std::abs(thermal().shifted_um[axis].value + thermal().drift_um[axis]) < 3.0);
        }
        QVERIFY(m_bench.find<ui::NumberDisplay>("thermalDriftY")->text() != QStringLiteral("–"));
        QVERIFY(m_bench.press("thermalHistory"));
        QTRY_VERIFY(table("thermalShiftTable") != nullptr && table("thermalShiftTable")->rowCount() > 2);
        closeSheet();
    }
    void aMeasurementChecksTheModel() {
        QVERIFY(m_bench.press("thermalMeasure"));
        pressWhenReady("thermalMeasureNow");
        QTRY_COMPARE_WITH_TIMEOUT(thermal().gap.phase, GapPhase::Done, test::patience_ms(20'000));
        for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
            const double difference_um = thermal().gap.measured_um[axis] - thermal().gap.predicted_um[axis];
            QVERIFY2(std::abs(difference_um) < 5.0, qPrintable(QString::number(difference_um)));
        }
        QTRY_VERIFY(table("thermalGapTable")->item(0, 1)->text() != QStringLiteral("–"));
        closeSheet();
    }
    void aRealDataSetIsTrainedComparedAndRolledBack() {
        const QDir folder(m_bench.folder() + QStringLiteral("/thermal"));
        for (const char* file : {"H0_train.csv", "H1_train.csv", "H2_train.csv"}) {
            const QString from = QString::fromStdString(test::fixture(std::string("thermal/") + file));
            QVERIFY2(QFile::copy(from, folder.filePath(QLatin1String(file))), qPrintable(from));
        }
        QVERIFY(m_bench.press("thermalModel"));
        QVERIFY(m_bench.press("thermalTrainOpen"));
        QTRY_VERIFY(table("thermalDays") != nullptr && table("thermalDays")->rowCount() >= 7);
        for (int row = 0; row < 3; ++row)
            emit table("thermalDays")->cellClicked(row, 0);
        pressWhenReady("thermalTrainAuto");
        QTRY_VERIFY_WITH_TIMEOUT(table("thermalCompared") != nullptr && table("thermalCompared")->rowCount() == 4,
                                 120'000);
        QCOMPARE(thermal().model, 1U);
        pressWhenReady("thermalGoLive");
        QTRY_COMPARE_WITH_TIMEOUT(thermal().model, 2U, test::patience_ms(30'000));
        closeSheet();
        QVERIFY(m_bench.press("thermalModel"));
        pressWhenReady("thermalRollBack");
        QTRY_COMPARE_WITH_TIMEOUT(thermal().model, 3U, test::patience_ms(30'000));
        closeSheet();
    }
    void theLanguageSwitches() {
        const QString english = m_bench.text("thermalReady");
        QVERIFY(m_bench.press("language"));
        QTRY_VERIFY(m_bench.text("thermalReady") != english);
        QVERIFY(m_bench.press("language"));
    }
    void aRestartReadsTheShiftBack() {
        // One to read back, and written down: together, for the shift goes on, and may go through zero.
        double before_um[kAxisCount]{};
        const auto remembered = [&] {
            for (std::size_t axis = 0; axis < kAxisCount; ++axis)
                before_um[axis] = thermal().shifted_um[axis].value;
            return std::abs(before_um[1]) > 2.0 && std::abs(rememberedShift_um() - before_um[1]) < 0.01;
        };
        QTRY_VERIFY_WITH_TIMEOUT(remembered(), test::patience_ms(120'000));
        m_bench.stop();
        bringUp();
        double jump_um = 0.0;
        const auto watch = [&] {
            for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
                jump_um = std::max(jump_um, std::abs(thermal().shifted_um[axis].value - before_um[axis]));
            }
            return thermal().stage == ThermalStage::Following && thermal().updates >= 2;
        };
        QTRY_VERIFY_WITH_TIMEOUT(thermal().shifted_um[1].good(), test::patience_ms(20'000));
        QTRY_VERIFY_WITH_TIMEOUT(watch(), test::patience_ms(60'000));
        QVERIFY2(jump_um < 6.0, qPrintable(QString::number(jump_um)));
    }

    /// What the machine would still have after a restart, along Y.
    [[nodiscard]] double rememberedShift_um() {
        QFile file(m_bench.folder() + QStringLiteral("/thermal/simulator.json"));
        if (!file.open(QIODevice::ReadOnly)) return 1e9;
        const auto body = nlohmann::json::parse(file.readAll().toStdString(), nullptr, false);
        return body.is_discarded() ? 1e9 : body.at("work_offset_um").at(1).get<double>();
    }

    test::ConsoleBench m_bench;
};

QTEST_MAIN(TestConsoleThermal)
#include "tst_console_thermal.moc"
