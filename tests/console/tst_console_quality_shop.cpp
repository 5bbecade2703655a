// SPDX-License-Identifier: GPL-3.0-or-later
#include <QCheckBox>
#include <QComboBox>
#include <QTableWidget>
#include <QTest>
#include <cmath>

#include "tests/support/console_bench.h"
#include "tests/support/layout_check.h"
#include "ui/charts/chart.h"

using namespace kerf;

/// The Quality page on the real console: two lots that the loop has steered, a gauge whose study becomes the σ of the
/// next lot, the rules of the charts. Every view is looked at in both languages and two sizes of screen
/// (KERF_SCREENSHOTS: a folder that keeps them).
class TestConsoleQualityShop : public QObject {
    Q_OBJECT
    static constexpr std::uint32_t kLotSize = 14;

    void look(const QString& what) {
        ui::MainWindow* window = m_bench.console().window();
        ui::Look& face = m_bench.console().look();
        const ui::Preferences before = face.preferences();
        // A sheet keeps the language in which it was opened.
        const bool sheet = window->sheets().current() != nullptr;
        for (const ui::Language language : {ui::Language::English, ui::Language::Korean}) {
            if (sheet && language != before.language) {
                continue;
            }
            ui::Preferences other = before;
            other.language = language;
            face.apply(other);
            for (const QSize size : {QSize(1920, 1080), QSize(1280, 800)}) {
                window->resize(size);
                for (int i = 0; i < 4; ++i) {
                    QCoreApplication::sendPostedEvents();
                    QCoreApplication::processEvents();
                }
                const QString name =
                    QStringLiteral("%1_%2_%3")
                        .arg(what, language == ui::Language::Korean ? QStringLiteral("ko") : QStringLiteral("en"),
                             QString::number(size.width()));
                if (const QString folder = qEnvironmentVariable("KERF_SCREENSHOTS"); !folder.isEmpty()) {
                    window->grab().save(folder + u'/' + name + QStringLiteral(".png"));
                }
                const QStringList clipped = test::clippedTexts(window);
                QVERIFY2(clipped.isEmpty(), qPrintable(name + u'\n' + clipped.join(u'\n')));
                const QStringList small = test::smallTargets(window, face);
                QVERIFY2(small.isEmpty(), qPrintable(name + u'\n' + small.join(u'\n')));
            }
        }
        face.apply(before);
    }
    void waitForFullLot() {
        QTRY_VERIFY_WITH_TIMEOUT(lotFull(m_bench.service()) && !m_bench.service().awaiting, 90'000);
    }
    void choose(const char* box, int at) {
        auto* combo = m_bench.find<QComboBox>(box);
        QVERIFY(combo != nullptr && at >= 0 && at < combo->count());
        combo->setCurrentIndex(at);
        emit combo->activated(at);
    }
    void fill(const char* name, const QString& text) {
        QTRY_VERIFY2(m_bench.find<QLineEdit>(name) != nullptr, name);
        auto* edit = m_bench.find<QLineEdit>(name);
        edit->clear();
        QTest::keyClicks(edit, text);
    }
    void openQuality() {
        m_bench.console().window()->showPage("overview");
        m_bench.console().window()->showPage("quality");
        QTRY_VERIFY_WITH_TIMEOUT(m_bench.text("qualityIndices").startsWith(QStringLiteral("n ")), 20'000);
    }

 private slots:
    void initTestCase() {
        console::Options options;
        options.lotSize = kLotSize;
        options.preparedParts = 100;
        options.autoOperator = true;
        options.simulationSpeed = 0.0;
        options.changeAtPart = 0;
        m_bench.prepareQuickBores();
        m_bench.start(options);
        QTRY_VERIFY2_WITH_TIMEOUT(m_bench.up(), qPrintable(m_bench.failure()), 20'000);
        QVERIFY(m_bench.console().window()->session().signOn(QStringLiteral("Kim"), ui::Role::Engineer));
        waitForFullLot();
    }
    /// Every diameter that was entered says at once when it lies outside, and on which side.
    void diametersOutsideSaySoWhereTheyWereEntered() {
        m_bench.console().window()->showPage("boring");
        QVERIFY(m_bench.press("boringCorrect"));
        QTRY_VERIFY(m_bench.find<QTableWidget>("boringMeasurementList") != nullptr);
        const auto* list = m_bench.find<QTableWidget>("boringMeasurementList");
        const BoringServiceView& view = m_bench.service();
        QCOMPARE(list->rowCount(), static_cast<int>(view.parts.size()));
        int outside = 0;
        for (int row = 0; row < list->rowCount(); ++row) {
            const BorePartView& part = view.parts[view.parts.size() - 1 - static_cast<std::size_t>(row)];
            for (const BoreMeasurementView& measured : part.measurements) {
                const QString cell = list->item(row, measured.depth + 1)->text();
                const bool small = measured.diameter_mm < view.lowerTolerance_mm;
                const bool large = measured.diameter_mm > view.upperTolerance_mm;
                QCOMPARE(cell.contains(QStringLiteral("rework possible")), small);
                QCOMPARE(cell.contains(QStringLiteral("scrap")), large);
                outside += small || large ? 1 : 0;
            }
        }
        QVERIFY(outside > 0);  // the first bore, before anything is known
        look(QStringLiteral("entered"));
        m_bench.console().window()->sheets().current()->close();
    }
    void aStudyIsShownWithWhatItFound() {
        openQuality();
        QVERIFY(m_bench.text("qualityGaugeNote").contains(QStringLiteral("typed in the recipe")));
        look(QStringLiteral("lot"));
        QVERIFY(m_bench.press("qualityGauges"));
        QVERIFY(m_bench.press("gaugeNew"));
        for (const auto& [name, text] :
             {std::pair("gaugeIdentity", "G-07"), std::pair("gaugeFrom", "40"), std::pair("gaugeTo", "60"),
              std::pair("gaugeRing", "50"), std::pair("gaugeDue", "2099-12-31")}) {
            fill(name, QString::fromLatin1(text));
        }
        QVERIFY(m_bench.press("gaugeSave"));
        QVERIFY(m_bench.press("gauge_G-07"));
        QVERIFY(m_bench.find<QLabel>("gaugeStudy") == nullptr);
        QVERIFY(m_bench.press("studyTypeOne"));
        QTRY_VERIFY(m_bench.find<QLineEdit>("studyReading") != nullptr);
        auto* reading = m_bench.find<QLineEdit>("studyReading");
        for (int i = 0; i < 25; ++i) {
            QTest::keyClicks(reading, QString::number(50.0004 + (i % 5 - 2) * 0.0008, 'f', 4));
            QTest::keyClick(reading, Qt::Key_Return);
        }
        look(QStringLiteral("study"));
        QVERIFY(m_bench.press("studySave"));
        QVERIFY(m_bench.press("gauge_G-07"));
        QTRY_VERIFY(m_bench.find<QLabel>("gaugeStudy") != nullptr);
        const QString found = m_bench.text("gaugeStudy");
        // s = .0008 √(50/24) = .00115470; Cg = .2 · .03/(6 s) = .87, Cgk = (.003 − .0004)/(3 s) = .75
        QVERIFY2(found.contains(QStringLiteral("Cg 0.87, Cgk 0.75")), qPrintable(found));
        QVERIFY2(found.contains(QStringLiteral("not good enough")) && found.contains(QStringLiteral("Kim")),
                 qPrintable(found));
        look(QStringLiteral("gauge"));
    }
    /// The σ that the estimator uses is the study's from the next lot on, and the page says so with its interval.
    void theRepeatabilityBecomesTheEstimatorsSigma() {
        QVERIFY(m_bench.press("gaugeUse"));
        QTRY_VERIFY2(m_bench.text("gaugeWhy").contains(QStringLiteral("holds for the next lot")),
                     qPrintable(m_bench.text("gaugeWhy")));
        QVERIFY(m_bench.press("sheetSafe"));
        openQuality();
        QVERIFY(m_bench.text("qualityGaugeNote").contains(QStringLiteral("typed in the recipe")));  // of this lot
        QVERIFY(m_bench.press("lots"));
        QVERIFY(m_bench.press("lotOpen"));
        QTRY_COMPARE_WITH_TIMEOUT(m_bench.service().lot, std::string("2"), 30'000);
        m_bench.console().window()->showPage("overview");
        QVERIFY(m_bench.press("startPart"));
        waitForFullLot();
        openQuality();
        choose("qualityLot", 0);
        QTRY_VERIFY2_WITH_TIMEOUT(m_bench.text("qualityGaugeNote").contains(QStringLiteral("from the study of G-07")),
                                  qPrintable(m_bench.text("qualityGaugeNote")), 20'000);
        QVERIFY2(m_bench.text("qualityGaugeNote").contains(QStringLiteral("0.0012")),
                 qPrintable(m_bench.text("qualityGaugeNote")));
        look(QStringLiteral("studied"));
    }
    void allLotsStandBesideEachOther() {
        openQuality();
        auto* lots = m_bench.find<QComboBox>("qualityLot");
        const int all = lots->findText(QStringLiteral("all lots"), Qt::MatchContains);
        QVERIFY(all > 0);
        choose("qualityLot", all);
        QTRY_VERIFY2_WITH_TIMEOUT(
            m_bench.text("qualitySentence").startsWith(QStringLiteral("2 lots one after the other")),
            qPrintable(m_bench.text("qualitySentence")), 20'000);
        QCOMPARE(m_bench.find<ui::Chart>("qualityRaw")->drawn(0).size(), qsizetype(2 * kLotSize));
        look(QStringLiteral("all_lots"));
        choose("qualityGroup", 1);
        QCOMPARE(m_bench.find<ui::Chart>("qualityRaw")->drawn(0).size(), qsizetype(kLotSize));
    }
    void rulesAreSwitches() {
        openQuality();
        choose("qualityLot", 0);
        QVERIFY(m_bench.press("qualityRules"));
        const auto box = [this](const char* name) { return m_bench.find<QCheckBox>(name); };
        QTRY_VERIFY(box("rule_nelson1") != nullptr);
        QVERIFY(box("rule_nelson1")->isChecked() && box("rule_ewma")->isChecked() && !box("rule_cusum")->isChecked());
        look(QStringLiteral("rules"));
        QVERIFY(m_bench.press("sheetSafe"));
        QVERIFY(m_bench.press("language"));
        QVERIFY(m_bench.press("qualityRules"));
        QTRY_VERIFY(box("rule_nelson1") != nullptr);
        look(QStringLiteral("rules"));
        QVERIFY(m_bench.press("sheetSafe"));
        QVERIFY(m_bench.press("qualityGauges"));
        QVERIFY(m_bench.press("gauge_G-07"));
        look(QStringLiteral("gauge"));
        QVERIFY(m_bench.press("sheetSafe"));
        QVERIFY(m_bench.press("language"));
        QVERIFY(m_bench.press("qualityRules"));
        QTRY_VERIFY(box("rule_nelson1") != nullptr);
        box("rule_ewma")->setChecked(false);
        box("rule_cusum")->setChecked(true);
        box("rule_nelson7")->setChecked(true);
        QVERIFY(m_bench.press("rulesSave"));
        QTRY_VERIFY(box("rule_nelson1") == nullptr);
        QVERIFY(m_bench.press("qualityRules"));
        QTRY_VERIFY(box("rule_cusum") != nullptr);
        QVERIFY(box("rule_cusum")->isChecked() && box("rule_nelson7")->isChecked() && !box("rule_ewma")->isChecked());
        QVERIFY(m_bench.press("rulesDefault"));
        QVERIFY(!box("rule_cusum")->isChecked() && !box("rule_nelson7")->isChecked() && box("rule_ewma")->isChecked());
        QVERIFY(m_bench.press("sheetSafe"));
    }

 private:
    test::ConsoleBench m_bench;
};

QTEST_MAIN(TestConsoleQualityShop)
#include "tst_console_quality_shop.moc"
