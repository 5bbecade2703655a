// SPDX-License-Identifier: GPL-3.0-or-later
#include <QLabel>
#include <QLineEdit>
#include <QTest>
#include <deque>

#include "tests/support/boring_page_bench.h"
#include "ui/pages/boring/boring_page.h"
#include "ui/services/sensor_service.h"

using namespace kerf;
using namespace kerf::ui;
using kerf::test::FakeBoringService;
using kerf::test::PageBench;

namespace {

class FakeSensors final : public SensorService {
 public:
    FakeSensors() { seen.gauges = {{"G1", "/dev/ttyUSB0", true, false}, {"G2", "/dev/ttyUSB1", false, true}}; }
    [[nodiscard]] const SensorServiceView& view() const override { return seen; }
    void lookForFinger(bool) override {}
    void askGauge(std::size_t gauge, bool test) override {
        if (!test) {
            asked.push_back(gauge);
        }
    }
    [[nodiscard]] Result<void> place(std::size_t, double, double, const std::string&) override { return {}; }
    SensorServiceView seen{};
    std::vector<std::size_t> asked{};
};

}  // namespace

/// Readings of hand gauges on the boring page: where they go, and what is said when they go nowhere.
class TestGaugeEntry : public QObject, test::BoringPageBench {
    Q_OBJECT
 private slots:
    void init() { open(); }
    void cleanup() { close(); }

    void channelsBelongToDepthsAndARepeatChangesNothing() {
        m_service->cutPart();
        m_service->cutPart();
        m_service->keepAnswers = true;  // a store takes its time
        show();
        QStringList kept;
        m_bench->services.saveSetting = [&](const QString& key, const QString& value) { kept << key + u' ' + value; };
        burst(m_bench->page, "02A+00049.998");  // in the other order
        burst(m_bench->page, "01A+00050.011");
        m_service->answerAll();
        m_service->answerAll();
        QCOMPARE(m_service->entries.size(), std::size_t{2});
        QCOMPARE(m_service->entries[0].depth, std::uint8_t{1});
        QCOMPARE(m_service->entries[0].diameter_mm, 49.998);
        QCOMPARE(m_service->entries[1].depth, std::uint8_t{0});
        QCOMPARE(m_service->entries[1].part, PartId{101});
        QVERIFY(kept.contains(QStringLiteral("gauge.channels 1=0,2=1")));
        burst(m_bench->page, "01A+00050.011");
        burst(m_bench->page, "02A+00049.998");
        burst(m_bench->page, "01A+00050.012");  // one too many: not the next part's
        burst(m_bench->page, "03A+00050.013");  // a channel without a depth
        m_service->answerAll();
        QCOMPARE(m_service->entries.size(), std::size_t{2});
        QVERIFY(text("boringEntryMessage").contains(QStringLiteral("channel 3")));
        QVERIFY(visible("boringChannels"));
        QVERIFY(m_bench->press("boringChannels"));
        QVERIFY(m_bench->press("boringChannel1Depth1"));  // they were mounted the other way
        QVERIFY(kept.contains(QStringLiteral("gauge.channels 1=1,2=0")));
        QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);  // the sheet before it
        QVERIFY(m_bench->press("boringChannelsClose"));
    }
    void aDepthOfTheSensorFileIsWhereItGoes() {
        m_service->cutPart();
        m_service->cutPart();
        std::deque<GaugeLineFrame> line{{QStringLiteral("+49.99800mm"), std::uint8_t{1}},  // the second depth first
                                        {QStringLiteral("+50.01100mm"), std::uint8_t{0}},
                                        {QStringLiteral("+50.01400mm"), std::uint8_t{7}}};
        m_bench->services.nextGaugeFrame = [&line]() -> std::optional<GaugeLineFrame> {
            if (line.empty()) {
                return std::nullopt;
            }
            const GaugeLineFrame next = line.front();
            line.pop_front();
            return next;
        };
        show();
        m_bench->client.tick();
        QTRY_VERIFY((m_bench->client.tick(), line.empty()));
        QCOMPARE(m_service->entries.size(), std::size_t{2});
        QCOMPARE(m_service->entries[0].depth, std::uint8_t{1});
        QCOMPARE(m_service->entries[0].diameter_mm, 49.998);
        QCOMPARE(m_service->entries[1].depth, std::uint8_t{0});
        QCOMPARE(m_service->entries[1].part, m_service->entries[0].part);
        QVERIFY(text("boringEntryMessage").contains(QStringLiteral("depth 8 of the sensor file")));
        QVERIFY(!visible("boringChannels"));  // nothing was learnt
    }
    void theGaugeButtonAsksOneOnALine() {
        FakeSensors sensors;
        m_service->gaugeFitted = false;
        m_bench->services.sensorService = &sensors;
        m_service->cutPart();
        show();
        m_bench->client.tick();
        QVERIFY(!m_bench->press("boringGauge"));  // not plugged in
        sensors.seen.gauges[1].connected = true;
        auto* button = m_bench->find<QPushButton>("boringGauge");
        QTRY_VERIFY((m_bench->client.tick(), button->isEnabled()));
        QVERIFY(m_bench->press("boringGauge"));
        QCOMPARE(sensors.asked, std::vector<std::size_t>{1});  // the other one has no such command
        QVERIFY(m_service->entries.empty());                   // until it answers
        m_bench.reset();                                       // the page goes before what it asks
    }
    /// A reading without a depth is of the bore that waits: two of them would be two diameters of it.
    void ofTwoThatCouldBeMeantAPersonChoosesOne() {
        FakeSensors sensors;
        for (SensorGaugeView& gauge : sensors.seen.gauges) {
            gauge.connected = gauge.canAsk = true;
        }
        m_service->gaugeFitted = false;
        m_bench->services.sensorService = &sensors;
        m_service->cutPart();
        show();
        m_bench->client.tick();
        QVERIFY(m_bench->press("boringGauge"));
        QVERIFY(sensors.asked.empty());
        QVERIFY(m_bench->press("boringAsk1"));
        QCOMPARE(sensors.asked, std::vector<std::size_t>{1});
        QVERIFY(m_bench->sheets->current() == nullptr);
        QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
        QVERIFY(m_bench->press("boringGauge"));
        QVERIFY(m_bench->press("sheetSafe"));
        QCOMPARE(sensors.asked.size(), std::size_t{1});
        // Those that say their depth are all asked, each for its own.
        sensors.seen.gauges[0].saysDepth = true;
        QVERIFY(m_bench->press("boringGauge"));
        QCOMPARE(sensors.asked, (std::vector<std::size_t>{1, 0, 1}));
        sensors.seen.gauges[1].saysDepth = true;
        QVERIFY(m_bench->press("boringGauge"));
        QCOMPARE(sensors.asked, (std::vector<std::size_t>{1, 0, 1, 0, 1}));
        m_bench.reset();
    }
    void aFrameTooManyIsSaid() {
        m_service->cutPart();
        m_service->cutPart();
        show();
        for (const char* frame : {"50.011", "50.012", "50.013"}) {
            burst(m_bench->page, frame);
        }
        QCOMPARE(m_service->entries.size(), std::size_t{2});
        QVERIFY(text("boringEntryMessage").contains(QStringLiteral("50.013")));
    }
    void aReadingWaitsForTheAnswerToAQuestion() {
        m_service->cutPart();
        show();
        burst(m_bench->page, "1.9689");
        burst(m_bench->page, "50.012");
        QVERIFY(m_service->entries.empty());
        QVERIFY(m_bench->press("boringConfirm"));
        QCOMPARE(m_service->entries.size(), std::size_t{2});
        QCOMPARE(m_service->entries[1].depth, std::uint8_t{1});
    }
    void aReadingTakesNobodysFormAway() {
        m_service->cutPart();
        show();
        m_bench->session.signOff();
        Sheet* sheet = m_bench->sheets->open(QStringLiteral("Who is there?"));
        auto* name = new QLineEdit(QStringLiteral("Le"), sheet);
        sheet->body()->addWidget(name);
        burst(m_bench->page, "50.011");
        burst(m_bench->page, "50.012");
        QCOMPARE(m_bench->askedForName, 0);
        QCOMPARE(m_bench->sheets->current(), sheet);
        QCOMPARE(name->text(), QStringLiteral("Le"));
        QVERIFY(m_service->entries.empty());
        QVERIFY(!m_bench->notices.empty() && m_bench->notices.back().contains(QStringLiteral("50.012")));
        m_bench->session.signOn(QStringLiteral("Lee"));
        QCOMPARE(m_service->entries.size(), std::size_t{2});
        QCOMPARE(m_service->entries[1].author, std::string("Lee"));
    }
    void whatIsTypedWhileTheStoreTakesItsTimeIsTheNext() {
        m_service->cutPart();
        m_service->keepAnswers = true;
        show();
        field()->setFocus();
        for (const char* figures : {"11", "12"}) {
            QTest::keyClicks(field(), figures);
            QTest::keyClick(field(), Qt::Key_Return);
            QTest::keyClick(field(), Qt::Key_Return);  // the last key twice
        }
        QVERIFY(m_service->entries.empty());
        m_service->answerAll();
        QCOMPARE(m_service->entries.size(), std::size_t{1});
        m_service->answerAll();
        QCOMPARE(m_service->entries.size(), std::size_t{2});
        QCOMPARE(m_service->entries[1].depth, std::uint8_t{1});
        QCOMPARE(m_service->entries[1].diameter_mm, 50.012);
        m_service->answerAll();
        QCOMPARE(m_service->entries.size(), std::size_t{2});
    }
    void aComparatorNeedsItsRing() {
        m_service->cutPart();
        show();
        burst(m_bench->page, "+0.011");
        QVERIFY(m_service->entries.empty());
        QVERIFY(text("boringEntryMessage").contains(QStringLiteral("setting ring")));
        m_service->edit().settingRing_mm = 50.002;
        m_service->announce();
        burst(m_bench->page, "+0.009");
        QVERIFY(std::abs(m_service->entries.at(0).diameter_mm - 50.011) < 1e-9);
    }
    void theLastKeyTwiceDoesNothingTwice() {
        m_service->cutPart();
        show();
        burst(field(), "50.011");
        QTest::keyClick(field(), Qt::Key_Return);
        QCOMPARE(m_service->entries.size(), std::size_t{1});
        QVERIFY(text("boringEntryMessage").contains(QStringLiteral("stored")));
        QVERIFY(!field()->property("wrong").toBool());
        QVERIFY(m_bench->press("key1"));
        QVERIFY(m_bench->press("key2"));
        QVERIFY(m_bench->press("keyEnter"));
        QVERIFY(m_bench->press("keyEnter"));
        QCOMPARE(m_service->entries.size(), std::size_t{2});
        QVERIFY(text("boringEntryMessage").contains(QStringLiteral("stored")));
    }
    void numLockOffVanishesNoFigureAndEntersNothing() {
        m_service->cutPart();
        show();
        for (const char* key : {"key5", "key0", "keyPoint", "key0", "key1", "key2"}) {
            QVERIFY(m_bench->press(key));
        }
        for (const Qt::Key key :
             {Qt::Key_Clear, Qt::Key_Insert, Qt::Key_Delete, Qt::Key_Insert, Qt::Key_End, Qt::Key_End}) {
            QTest::keyClick(field(), key, Qt::KeypadModifier);
        }
        QTest::keyClick(field(), Qt::Key_Enter, Qt::KeypadModifier);
        QVERIFY(m_service->entries.empty());
        QCOMPARE(field()->text(), QStringLiteral("50.012"));
        QVERIFY(text("boringEntryMessage").contains(QStringLiteral("Num Lock")));
    }
    void whatBecameOfAReadingIsToldOnAnotherPage() {
        m_service->cutPart();
        m_service->keepAnswers = true;
        show();
        m_bench->page->hide();
        QLineEdit elsewhere;
        elsewhere.show();
        burst(&elsewhere, "50.011");
        m_service->answerAll();
        QVERIFY(m_bench->notices.back().contains(QStringLiteral("50.011")) &&
                m_bench->notices.back().contains(QStringLiteral("stored")));
    }
    void aReadingGoesToTheOpenCorrectionAndDecidesNothing() {
        m_service->runParts(2);
        m_service->cutPart();
        show();
        const std::size_t before = m_service->entries.size();
        QVERIFY(m_bench->press("boringUndo"));
        burst(m_bench->page, "50.011");  // "Take it out" stays
        QVERIFY(m_bench->find<QPushButton>("measurementVoid")->isChecked());
        QVERIFY(text("measurementMessage").contains(QStringLiteral("50.011")));
        QVERIFY(m_bench->press("measurementCorrect"));
        QVERIFY(m_bench->press("measurementReason0"));
        auto* value = m_bench->find<QLineEdit>("measurementField");
        burst(value, "50.012");
        QTest::keyClick(value, Qt::Key_Return);
        QKeyEvent later(QEvent::KeyPress, Qt::Key_Return, Qt::NoModifier, QStringLiteral("\r"));
        QCoreApplication::sendEvent(value, &later);  // past the filter, as a late one: nobody has confirmed it
        QVERIFY(m_service->corrections.empty());
        QVERIFY(m_bench->press("measurementApply"));
        QCOMPARE(m_service->corrections.size(), std::size_t{1});
        QCOMPARE(m_service->corrections[0].diameter_mm, 50.012);
        QVERIFY(m_service->corrections[0].fromGauge);
        QCOMPARE(m_service->entries.size(), before);
    }
    void aStudyOfTheGaugeTakesItsReadings() {
        m_service->cutPart();
        show();
        Sheet* sheet = m_bench->sheets->open(QStringLiteral("Study"));
        auto* reading = new QLineEdit(sheet);
        reading->setProperty("takesReadings", true);
        sheet->body()->addWidget(reading);
        QStringList taken;
        connect(reading, &QLineEdit::returnPressed, reading, [&] { taken << reading->text(); });
        reading->show();
        burst(reading, "+0.0125mm");
        QCOMPARE(taken, QStringList{QStringLiteral("0.0125")});
        QVERIFY(m_service->entries.empty());
    }
    void aCorrectionTenTimesTooLargeIsAskedAbout() {
        m_service->runParts(2);
        show();
        QVERIFY(m_bench->press("boringUndo"));
        QVERIFY(m_bench->press("measurementCorrect"));
        QVERIFY(m_bench->press("measurementReason0"));
        auto* value = m_bench->find<QLineEdit>("measurementField");
        for (const QChar c : QStringLiteral("5.0011")) {
            QKeyEvent press(QEvent::KeyPress, c.unicode(), Qt::NoModifier, QString(c));
            QCoreApplication::sendEvent(value, &press);
        }
        QTest::keyClick(value, Qt::Key_Return);
        QVERIFY(m_service->corrections.empty());
        QVERIFY(text("measurementMessage").contains(QStringLiteral("5.001")));
        QTest::keyClick(value, Qt::Key_Return);  // Enter is no answer
        QVERIFY(m_service->corrections.empty());
        QVERIFY(m_bench->press("measurementApply"));
        QCOMPARE(m_service->corrections.size(), std::size_t{1});
        QVERIFY(m_service->corrections[0].confirmed);
    }

 private:
    static void burst(QWidget* target, const char* text) {
        for (const char c : std::string(text)) {
            QTest::keyClick(target, c);
        }
        QTest::keyClick(target, Qt::Key_Return);
    }
};

QTEST_MAIN(TestGaugeEntry)
#include "tst_gauge_entry.moc"
