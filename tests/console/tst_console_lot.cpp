// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTableWidget>
#include <cmath>

#include "tests/support/console_bench.h"
#include "tests/support/patience.h"

using namespace kerf;

/// A whole lot on the real console: simulator, engine, database, window; an operator's touches through the widgets.
class TestConsoleLot : public QObject {
    Q_OBJECT

    static constexpr std::uint32_t kParts = 12;
    static constexpr std::uint32_t kTypoPart = 5;
    static constexpr std::uint32_t kRestartPart = 6;
    static constexpr std::uint32_t kSwitchPart = 7;
    static constexpr std::uint32_t kCorrectPart = 8;
    static constexpr std::uint32_t kChangePart = 10;

    [[nodiscard]] static console::Options options() {
        console::Options o;
        o.preparedParts = 0;
        o.simulationSpeed = 0.0;  // as fast as it can
        o.seed = 5;
        o.changeAtPart = kChangePart;
        return o;
    }
    /// The part of that number; an empty one (number 0) while the service does not know it.
    [[nodiscard]] const BorePartView& part(std::uint32_t number) {
        static const BorePartView kNone{};
        for (const BorePartView& p : m_bench.service().parts) {
            if (p.number == number) {
                return p;
            }
        }
        return kNone;
    }
    [[nodiscard]] bool waits(std::uint32_t number, std::uint8_t depth) {
        const BoringServiceView& view = m_bench.service();
        const BorePartView& p = part(number);
        return p.number == number && view.awaiting == p.id && view.awaitingDepth == depth;
    }
    [[nodiscard]] double gauged_mm() {
        const BoringServiceView& view = m_bench.service();
        return m_bench.console().boringService().gaugeReading_mm(*view.awaiting, view.awaitingDepth).value_or(0.0);
    }
    [[nodiscard]] double stored_mm(std::uint32_t number, std::uint8_t depth) {
        for (const BoreMeasurementView& m : part(number).measurements) {
            if (m.depth == depth && !m.voided) {
                return m.diameter_mm;
            }
        }
        return 0.0;
    }
    bool enterGauged() { return m_bench.keyIn(QString::number(gauged_mm(), 'f', 3)); }
    void bringUp() {
        m_bench.start(options());
        QTRY_VERIFY2_WITH_TIMEOUT(m_bench.up(), qPrintable(m_bench.failure()), test::patience_ms(20'000));
        m_bench.console().window()->showPage("boring");
    }
    void signOn() {
        QVERIFY(m_bench.press("operator"));
        QTRY_VERIFY(m_bench.find<QLineEdit>("operatorName") != nullptr);
        QTest::keyClicks(m_bench.find<QLineEdit>("operatorName"), QStringLiteral("Kim"));
        QTRY_VERIFY(m_bench.find("signOn") != nullptr);
        QVERIFY(m_bench.press("signOn"));
        QCOMPARE(m_bench.console().window()->session().name(), QStringLiteral("Kim"));
    }

 private slots:
    void wholeLotThroughTheScreen() {
        m_bench.prepareQuickBores();
        bringUp();
        signOn();
        for (std::uint32_t number = 1; number <= kParts; ++number) {
            if (QTest::currentTestFailed()) {
                return;
            }
            QTRY_VERIFY_WITH_TIMEOUT(waits(number, 0), test::patience_ms(20'000));
            if (number == kTypoPart) {
                slipsADecade(number);
            }
            const double top_mm = gauged_mm();
            QVERIFY2(enterGauged(), qPrintable(QStringLiteral("part %1 top").arg(number)));
            QTRY_VERIFY_WITH_TIMEOUT(waits(number, 1), test::patience_ms(10'000));
            QCOMPARE(stored_mm(number, 0), top_mm);
            if (number == kRestartPart) {
                const QString bottom =
                    QString::number(gauged_mm(), 'f', 3);  // read before the console ends, typed after
                restartInTheMiddle(number);
                QVERIFY(m_bench.keyIn(bottom));
            } else if (number == kSwitchPart) {
                entersInInchAndKorean(number);
            } else {
                QVERIFY(enterGauged());
            }
            QTRY_VERIFY_WITH_TIMEOUT(part(number).complete, test::patience_ms(10'000));
            if (number == kCorrectPart) {
                correctsAValue(number);
            }
        }
        processChangeWasNoticed();
        everythingIsOnDisk();
        m_bench.stop();
    }

 private:
    void slipsADecade(std::uint32_t number) {
        const std::uint64_t before = m_bench.service().revision;
        const QString wrong = QString::number(gauged_mm() / 10.0, 'f', 3);
        QVERIFY(m_bench.keyIn(wrong));
        QVERIFY(m_bench.find("boringConfirm") != nullptr || m_bench.find("boringEntryMessage") != nullptr);
        QVERIFY(!m_bench.text("boringEntryMessage").isEmpty());
        QVERIFY(part(number).measurements.empty());
        QCOMPARE(m_bench.service().revision, before);
        if (m_bench.find("boringMeasureAgain") != nullptr) {
            QVERIFY(m_bench.press("boringMeasureAgain"));
        } else {
            QVERIFY(m_bench.press("keyClear"));
        }
    }
    void restartInTheMiddle(std::uint32_t number) {
        const BoringServiceView before = m_bench.service();
        m_bench.stop();
        bringUp();
        signOn();
        const BoringServiceView& after = m_bench.service();
        QCOMPARE(after.parts.size(), before.parts.size());
        QCOMPARE(after.nextSchedule.revision, before.nextSchedule.revision);
        QCOMPARE(after.nextSchedule.lnC, before.nextSchedule.lnC);
        QCOMPARE(after.nextSchedule.alpha, before.nextSchedule.alpha);
        QCOMPARE(after.nextSchedule.beta, before.nextSchedule.beta);
        QCOMPARE(after.estimates.size(), before.estimates.size());
        for (std::size_t i = 0; i < after.estimates.size(); ++i) {
            QCOMPARE(after.estimates[i].value, before.estimates[i].value);
        }
        QVERIFY(m_bench.console().boringService().restartFinding().empty());
        QTRY_VERIFY(waits(number, 1));
    }
    void entersInInchAndKorean(std::uint32_t number) {
        const double top_mm = stored_mm(number, 0);
        const QString english = m_bench.text("boringEntryPrompt");
        QVERIFY(m_bench.press("language"));
        QVERIFY(m_bench.text("boringEntryPrompt") != english);
        QVERIFY(m_bench.press("settings"));
        QTRY_VERIFY(m_bench.find("unitInch") != nullptr);
        QVERIFY(m_bench.press("unitInch"));
        QTRY_VERIFY(m_bench.find("sheetSafe") != nullptr);
        QVERIFY(m_bench.press("sheetSafe"));
        QCOMPARE(stored_mm(number, 0), top_mm);  // switching changes what is shown, never what is stored
        const double bottom_mm = gauged_mm();
        auto* field = m_bench.find<QLineEdit>("boringDiameterField");
        QVERIFY(field != nullptr);
        const QString inches = QString::number(bottom_mm / 25.4, 'f', 5);
        QVERIFY(m_bench.keyIn(inches));
        QTRY_VERIFY_WITH_TIMEOUT(part(number).complete, test::patience_ms(10'000));
        QVERIFY(std::abs(stored_mm(number, 1) - bottom_mm) <= 0.000005 * 25.4 + 1e-9);
        QVERIFY(m_bench.press("settings"));
        QTRY_VERIFY(m_bench.find("unitMillimetre") != nullptr);
        QVERIFY(m_bench.press("unitMillimetre"));
        QTRY_VERIFY(m_bench.find("sheetSafe") != nullptr);
        QVERIFY(m_bench.press("sheetSafe"));
        QVERIFY(m_bench.press("language"));
        QCOMPARE(stored_mm(number, 0), top_mm);
    }
    void correctsAValue(std::uint32_t number) {
        const auto estimateBefore = m_bench.service().estimates.back().value;
        const double old_mm = stored_mm(number, 0);
        const double corrected_mm = old_mm + 0.004;
        QVERIFY(m_bench.press("boringCorrect"));
        QTRY_VERIFY(m_bench.find<QTableWidget>("boringMeasurementList") != nullptr);
        auto* list = m_bench.find<QTableWidget>("boringMeasurementList");
        QTest::mouseClick(list->viewport(), Qt::LeftButton, {},
                          list->visualItemRect(list->item(0, 1)).center());  // newest first
        QTRY_VERIFY(m_bench.find<QLineEdit>("measurementField") != nullptr);
        auto* field = m_bench.find<QLineEdit>("measurementField");
        field->clear();
        QTest::keyClicks(field, QString::number(corrected_mm, 'f', 3));
        QVERIFY(m_bench.press("measurementReason0"));
        QVERIFY(m_bench.press("measurementApply"));
        QTRY_COMPARE_WITH_TIMEOUT(stored_mm(number, 0), std::round(corrected_mm * 1000.0) / 1000.0,
                                  test::patience_ms(10'000));
        QVERIFY(m_bench.service().estimates.back().value != estimateBefore);
        if (m_bench.find("measurementListClose") != nullptr) {
            QVERIFY(m_bench.press("measurementListClose"));
        }
    }
    void processChangeWasNoticed() {
        bool noticed = false;
        for (const BorePartView& p : m_bench.service().parts) {
            if (p.perturbed) {
                QVERIFY(p.number >= kChangePart);
                QVERIFY(!p.perturbedReason.empty());
                noticed = true;
            }
        }
        QVERIFY(noticed);
    }
    void everythingIsOnDisk() {
        const auto reader = db::DatabaseReader::open(m_bench.console().databasePath());
        QVERIFY(reader.has_value());
        const auto parts = (*reader)->parts({});
        QVERIFY(parts.has_value());
        std::size_t rows = 0;
        std::size_t corrections = 0;
        for (const PartRow& row : *parts) {
            for (const MeasurementRow& m : row.measurements) {
                ++rows;
                QCOMPARE(m.author, std::string("Kim"));
                if (m.kind == MeasurementKind::Correction) {
                    ++corrections;
                    QVERIFY(m.replaces.has_value());
                    QVERIFY(!m.reason.empty());
                }
            }
        }
        QCOMPARE(rows, std::size_t{2 * kParts + 1});
        QCOMPARE(corrections, std::size_t{1});
        const auto verdict = (*reader)->verifyAudit();
        QVERIFY(verdict.has_value());
        QVERIFY2(verdict->finding.empty(), verdict->finding.english().c_str());
    }

    test::ConsoleBench m_bench;
};
QTEST_MAIN(TestConsoleLot)
#include "tst_console_lot.moc"
