// SPDX-License-Identifier: GPL-3.0-or-later
#include <QFile>
#include <QRegularExpression>
#include <QTableWidget>

#include "tests/support/console_bench.h"
#include "ui/shell/services.h"
#include "ui/widgets/action_button.h"

using namespace kerf;

/// README's tour, step by step, with the touches it asks for.
class TestConsoleTour : public QObject {
    Q_OBJECT

    test::ConsoleBench m_bench;

    void speed(double factor) {
        Command command;
        command.action = SetSimulationSpeed{factor};
        QVERIFY(m_bench.console().engine().send(command).has_value());
    }
    void open(const char* page) {
        const QByteArray item = QByteArray("nav_") + page;
        QVERIFY2(m_bench.press(item.constData()), page);
        QCoreApplication::processEvents();
    }
    [[nodiscard]] std::uint32_t measured() {
        std::uint32_t last = 0;
        for (const BorePartView& part : m_bench.service().parts) {
            last = part.complete ? part.number : last;
        }
        return last;
    }
    [[nodiscard]] bool enabled(const char* name) {
        const auto* button = m_bench.find<QAbstractButton>(name);
        return button != nullptr && button->isEnabled();
    }
    void gaugeBothDepths() {
        const std::uint32_t before = measured();
        while (measured() == before) {
            QTRY_VERIFY_WITH_TIMEOUT(enabled("boringGauge"), 60'000);
            const auto at = m_bench.service().awaitingDepth;
            QVERIFY(m_bench.press("boringGauge"));
            QVERIFY(m_bench.press("keyEnter"));
            QTRY_VERIFY_WITH_TIMEOUT(m_bench.service().awaitingDepth != at || measured() != before ||
                                         m_bench.find("boringConfirm") != nullptr,
                                     20'000);
            if (m_bench.find("boringConfirm") != nullptr) {  // another insert: Kerf asks, and it is true
                QVERIFY(m_bench.press("boringConfirm"));
                QTRY_VERIFY_WITH_TIMEOUT(m_bench.service().awaitingDepth != at || measured() != before, 20'000);
            }
            if (QTest::currentTestFailed()) {
                return;
            }
        }
    }

 private slots:
    void theReadmeStillHasThisTour() {
        QFile readme(QStringLiteral(KERF_SOURCE_DIR "/README.md"));
        QVERIFY(readme.open(QIODevice::ReadOnly));
        const QString text = QString::fromUtf8(readme.readAll());
        const qsizetype from = text.indexOf(QStringLiteral("## A tour of five minutes"));
        QVERIFY(from > 0);
        const QString tour = text.mid(from, text.indexOf(QStringLiteral("\n## "), from + 3) - from);
        QCOMPARE(tour.count(QRegularExpression(QStringLiteral("\n\\d+\\. "))), 11);  // one function below for each
    }
    void step01OverviewAndSixMeasuredParts() {
        m_bench.start(console::Options{});
        QTRY_VERIFY2_WITH_TIMEOUT(m_bench.up(), qPrintable(m_bench.failure()), 30'000);
        QTRY_VERIFY_WITH_TIMEOUT(m_bench.console().shift()->prepared(), 240'000);
        QCOMPARE(m_bench.service().parts.size() >= 6 && measured() == 6, true);
        for (const char* card : {"card_boring", "card_milling", "card_thermal", "card_tapping"}) {
            QVERIFY2(m_bench.find(card) != nullptr, card);
        }
        QVERIFY(m_bench.find("card_turning") == nullptr);                                    // not on this machine
        QTRY_COMPARE_WITH_TIMEOUT(m_bench.status().program, ProgramState::Running, 30'000);  // the seventh
        QVERIFY(m_bench.console().window()->session().signOn(QStringLiteral("Kim"), ui::Role::Engineer));
    }
    void step02TheLivePointAndTheNextPart() {
        open("boring");
        QTRY_VERIFY_WITH_TIMEOUT(m_bench.text("boringLiveFeed").contains(QRegularExpression(QStringLiteral("\\d"))),
                                 20'000);
        QVERIFY(m_bench.find("boringNextDiameter0") != nullptr);
        QVERIFY(!m_bench.service().nextPrediction.empty() && m_bench.service().nextPrediction.front()->half95_mm > 0.0);
    }
    void step03ASlippedDecadeIsAskedAbout() {
        QTRY_VERIFY_WITH_TIMEOUT(m_bench.service().awaiting.has_value(), 120'000);
        const auto before = m_bench.service().revision;
        QVERIFY(m_bench.keyIn(QStringLiteral("500.0")));
        QCOMPARE(m_bench.service().revision, before);
        QVERIFY(!m_bench.text("boringEntryMessage").isEmpty());
        if (m_bench.find("boringMeasureAgain") != nullptr) {
            QVERIFY(m_bench.press("boringMeasureAgain"));
        } else {
            QVERIFY(m_bench.press("keyClear"));
        }
        gaugeBothDepths();
        QCOMPARE(measured(), 7U);
    }
    void step04AnotherInsertIsNoticed() {
        speed(0.0);
        while (measured() < 18 && !QTest::currentTestFailed()) {
            gaugeBothDepths();
        }
        const auto& parts = m_bench.service().parts;
        const auto noticed =
            std::find_if(parts.begin(), parts.end(), [](const BorePartView& p) { return p.perturbed; });
        QVERIFY(noticed != parts.end());
        QVERIFY(noticed->number >= 14);
        QVERIFY(!noticed->perturbedReason.empty());
    }
    void step05AMilledWall() {
        QTRY_VERIFY_WITH_TIMEOUT(m_bench.service().awaiting.has_value(), 60'000);  // the machine is free
        speed(20.0);
        open("milling");
        QTRY_VERIFY_WITH_TIMEOUT(enabled("millingStart"), 30'000);
        QVERIFY(m_bench.press("millingStart"));
        QTRY_VERIFY_WITH_TIMEOUT(m_bench.status().milling.cutting, 20'000);
        QVERIFY(m_bench.press("millingLawPi"));
        QTRY_COMPARE_WITH_TIMEOUT(m_bench.status().milling.law, MillingLaw::Pi, 20'000);
        QVERIFY(m_bench.press("millingLawModel"));
        speed(0.0);
        QTRY_VERIFY_WITH_TIMEOUT(!m_bench.status().milling.cutting, 120'000);
        QVERIFY(m_bench.find("millingTeach") != nullptr);
    }
    void step06AThreadThatWasTuned() {
        open("tapping");
        QVERIFY(m_bench.find("tappingContourChart") != nullptr);
        QVERIFY(!m_bench.text("tappingReason").isEmpty() || !m_bench.text("tappingLoopReason").isEmpty());
        for (const char* button : {"tappingTune", "tappingAccept", "tappingOneMore", "tappingRollBack"}) {
            QVERIFY2(m_bench.find(button) != nullptr, button);
        }
    }
    void step07TheOriginAndItsModel() {
        open("thermal");
        for (const char* part : {"thermalOffsets", "thermalDrawing", "thermalChart"}) {
            QVERIFY2(m_bench.find(part) != nullptr, part);
        }
        QVERIFY(m_bench.press("thermalModel"));
        QTRY_VERIFY(m_bench.console().window()->sheets().current() != nullptr);
        m_bench.console().window()->sheets().current()->close();
    }
    // The correction this step of the tour ends with is walked through by tst_console_lot.
    void step08PartsWithVerdicts() {
        open("parts");
        QTRY_VERIFY_WITH_TIMEOUT(m_bench.find("partsTable") != nullptr, 10'000);
        open("quality");
        QTRY_VERIFY_WITH_TIMEOUT(!m_bench.text("qualitySentence").isEmpty(), 20'000);
    }
    void step09HoldAll() {
        QTest::mouseClick(m_bench.find<QPushButton>("holdAll"), Qt::LeftButton);
        QTRY_VERIFY(m_bench.status().held);
        QTRY_VERIFY(m_bench.find("heldBand") != nullptr);
        QVERIFY(m_bench.press("heldRelease"));
        QTRY_VERIFY(!m_bench.status().held);
    }
    void step10LotsAndTheRecipe() {
        QVERIFY(m_bench.press("lots"));
        QTRY_VERIFY(m_bench.find("lotTable") != nullptr);
        QVERIFY(m_bench.press("lotRecipe"));
        QTRY_VERIFY(m_bench.find("recipeRevisions") != nullptr);
        QVERIFY(m_bench.press("recipeCancel"));
        QTRY_VERIFY(m_bench.find("recipeRevisions") == nullptr);
        if (m_bench.find("lotCancel") != nullptr) {
            QVERIFY(m_bench.press("lotCancel"));
        }
    }
    void step11LanguageUnitsAndTheme() {
        QVERIFY(m_bench.press("language"));
        QCOMPARE(m_bench.console().look().preferences().language, ui::Language::Korean);
        QVERIFY(m_bench.press("language"));
        QVERIFY(m_bench.press("settings"));
        QVERIFY(m_bench.press("unitInch"));
        QVERIFY(m_bench.press("themeDark"));
        QCOMPARE(m_bench.console().look().units().length(), ui::LengthUnit::Inch);
        QVERIFY(m_bench.press("sheetSafe"));
        m_bench.stop();
    }
};

QTEST_MAIN(TestConsoleTour)
#include "tst_console_tour.moc"
