// SPDX-License-Identifier: GPL-3.0-or-later
#include <QLabel>
#include <QLineEdit>
#include <QTableWidget>
#include <QTest>

#include "app/sensors/finger.h"
#include "tests/support/page_bench.h"
#include "ui/pages/sensors/sensors_page.h"

using namespace kerf;
using namespace kerf::ui;
using kerf::test::PageBench;

namespace {

class FakeSensorService final : public SensorService {
 public:
    FakeSensorService() {
        fake.reading = true;
        fake.pictureFolder = "/data/sensors";
        fake.modules.push_back({"A", "tcp 192.168.0.11:502, 1", 2, 1});
        SensorChannelView good;
        good.name = "T00";
        good.place = "front bearing";
        good.value = 21.5;
        good.quality = Quality::Good;
        good.age_s = 0.4;
        SensorChannelView broken;
        broken.name = "T01";
        broken.quality = Quality::Bad;
        broken.age_s = 40.0;
        broken.why = "The module says that there is no measurement: the thermocouple is broken or loose.";
        fake.channels = {good, broken};
        fake.gauges.push_back({"BMD-17", "/dev/ttyUSB0", true, true, false, "01A+00050.012"});
    }
    [[nodiscard]] const SensorServiceView& view() const override { return fake; }
    void lookForFinger(bool on) override { fake.finger = {on, {}, 0.0}; }
    void askGauge(std::size_t gauge, bool test) override { (test ? asked : read).push_back(gauge); }
    [[nodiscard]] Result<void> place(std::size_t channel, double x, double y, const std::string& author) override {
        fake.channels[channel].placed = true;
        fake.channels[channel].x = x;
        fake.channels[channel].y = y;
        placedBy = author;
        return {};
    }
    SensorServiceView fake{};
    std::vector<std::size_t> asked{}, read{};
    std::string placedBy{};
};

class FakeSensorSetup final : public SensorSetup {
 public:
    FakeSensorSetup() {
        fake.revision = 1;
        fake.folder = "/data/sensors";
        fake.files = {{"vmc-3.json", 2, 12, 1, {}, false},
                      {"old.json",
                       0,
                       0,
                       0,
                       {"channels[0].adress", KERF_TEXT("unknown key %2; expected one of %1."), {"name, address", "x"}},
                       false}};
    }
    [[nodiscard]] const SensorSetupView& view() const override { return fake; }
    void lookForFiles() override { ++looks; }
    [[nodiscard]] Result<void> choose(const std::string& name, const std::string& author) override {
        chosen.push_back(name + " by " + author);
        for (SensorFileView& file : fake.files) {
            file.chosen = file.name == name;
        }
        ++fake.revision;
        return {};
    }
    [[nodiscard]] Result<void> scan(const std::string& address, const std::string& author) override {
        fake.scanned = address;
        fake.scanning = true;
        scannedBy = author;
        ++fake.revision;
        return {};
    }
    SensorSetupView fake{};
    int looks{0};
    std::vector<std::string> chosen{};
    std::string scannedBy{};
};

}  // namespace

class TestSensorsPage : public QObject {
    Q_OBJECT
 private slots:
    void withoutASensorFileThePageSaysSo() {
        PageBench bench;
        bench.show<SensorsPage>();
        QVERIFY(bench.window.findChild<QLabel*>()->text().contains(QStringLiteral("--sensors")));
    }
    void withoutASensorFileOneIsChosenByTouch() {
        FakeSensorSetup setup;
        PageBench bench;
        bench.session.signOn(QStringLiteral("Lee"), Role::Engineer);
        bench.services.sensorSetup = &setup;
        bench.show<SensorsPage>();
        QVERIFY(setup.looks > 0);
        QVERIFY(bench.find<QLabel>("sensorFileNow")->text().contains(QStringLiteral("None is in use")));
        auto* files = bench.find<QTableWidget>("sensorFiles");
        QCOMPARE(files->rowCount(), 2);
        QVERIFY(files->item(0, 1)->text().contains(QStringLiteral("channels: 12")));
        QVERIFY(files->item(1, 1)->text().contains(
            QStringLiteral("channels[0].adress: unknown key x; expected one of name, address.")));
        QVERIFY(!bench.press("sensorFileUse"));  // nothing touched yet
        files->selectRow(1);
        QVERIFY(!bench.press("sensorFileUse"));  // one that is refused
        files->selectRow(0);
        QVERIFY(bench.press("sensorFileUse"));
        QCOMPARE(setup.chosen, std::vector<std::string>{"vmc-3.json by Lee"});
        bench.client.tick();
        QVERIFY(bench.find<QLabel>("sensorFileNow")->text().contains(QStringLiteral("vmc-3.json")));
        QVERIFY(bench.press("sensorFileNone"));
        QCOMPARE(setup.chosen.back(), std::string(" by Lee"));
    }
    void whatAnswersAtAnAddressIsShown() {
        FakeSensorSetup setup;
        PageBench bench;
        bench.session.signOn(QStringLiteral("Lee"), Role::Engineer);
        bench.services.sensorSetup = &setup;
        bench.show<SensorsPage>();
        QVERIFY(!bench.press("sensorScan"));  // no address yet
        QTest::keyClicks(bench.find<QLineEdit>("sensorScanAddress"), QStringLiteral(" 192.168.0.11:1502 "));
        QVERIFY(bench.press("sensorScan"));
        QCOMPARE(setup.fake.scanned, std::string("192.168.0.11:1502"));
        QCOMPARE(setup.scannedBy, std::string("Lee"));
        QVERIFY(!bench.press("sensorScan"));  // one after the other
        setup.fake.scanning = false;
        setup.fake.found = {{3, "ICP DAS tM-TH8 2.1", "4: 203 247"}};
        ++setup.fake.revision;
        bench.client.tick();
        auto* found = bench.find<QTableWidget>("sensorFound");
        QCOMPARE(found->rowCount(), 1);
        QCOMPARE(found->item(0, 1)->text(), QStringLiteral("ICP DAS tM-TH8 2.1"));
        setup.fake.found.clear();
        setup.fake.refused = Sentence(KERF_TEXT("nothing takes a connection there"));
        ++setup.fake.revision;
        bench.client.tick();
        QVERIFY(bench.find<QLabel>("sensorScanAnswer")->text().contains(QStringLiteral("nothing takes")));
    }
    void whoMayNotIsTold() {
        FakeSensorSetup setup;
        FakeSensorService service;
        PageBench bench;
        QVERIFY(bench.session.signOn(QStringLiteral("Lee"), Role::Engineer));
        QVERIFY(bench.session.signOn(QStringLiteral("Park"), Role::Operator));
        QVERIFY(!bench.session.whyNot(Deed::SensorPlace).isEmpty());
        bench.services.sensorSetup = &setup;
        bench.services.sensorService = &service;
        bench.show<SensorsPage>();
        QVERIFY(bench.press("sensorSetupOpen"));
        QApplication::processEvents();
        bench.find<QTableWidget>("sensorFiles")->selectRow(0);
        QVERIFY(!bench.press("sensorFileUse"));
        QVERIFY(bench.find<ActionButton>("sensorFileUse")->reason().contains(QStringLiteral("engineer")));
        QVERIFY(setup.chosen.empty());
    }
    void aValueThatIsNotGoodIsNoNumber() {
        FakeSensorService service;
        PageBench bench;
        bench.services.sensorService = &service;
        bench.show<SensorsPage>();
        auto* table = bench.find<QTableWidget>("sensorChannels");
        QCOMPARE(table->rowCount(), 2);
        QVERIFY(table->item(0, 2)->text().startsWith(QStringLiteral("21.5")));
        QCOMPARE(table->item(1, 2)->text(), QStringLiteral("–"));
        QVERIFY(table->item(1, 4)->text().contains(QStringLiteral("broken or loose")));
        QCOMPARE(bench.find<QTableWidget>("sensorModules")->item(0, 2)->text(), QStringLiteral("1 of 2"));
    }
    void theFingerChoosesItsChannelAndATouchPlacesIt() {
        FakeSensorService service;
        PageBench bench;
        bench.session.signOn(QStringLiteral("Lee"), Role::Engineer);
        bench.services.sensorService = &service;
        auto* page = bench.show<SensorsPage>();
        QVERIFY(!bench.press("placeSensor"));  // nothing chosen yet
        QVERIFY(bench.press("whichOneRises"));
        QVERIFY(service.fake.finger.looking);
        service.fake.finger.channel = 1;
        service.fake.finger.rise_K = 1.8;
        QTRY_VERIFY((bench.client.tick(), bench.find<QLabel>("sensorHint")->text().contains(QStringLiteral("T01"))));
        QVERIFY(bench.press("placeSensor"));
        auto* picture = bench.find<SensorPicture>("sensorPicture");
        QTest::mouseClick(picture, Qt::LeftButton, {}, QPoint(picture->width() / 4, picture->height() / 2));
        QVERIFY(service.fake.channels[1].placed);
        QVERIFY(std::abs(service.fake.channels[1].x - 0.25) < 0.05);
        QCOMPARE(service.placedBy, std::string("Lee"));
        QVERIFY(bench.press("askGauge"));
        QCOMPARE(service.asked, std::vector<std::size_t>{0});
        QVERIFY(service.read.empty());  // a test read is no diameter
        service.fake.gauges[0].frame = "ERR0";
        service.fake.gauges[0].understood = false;
        QTRY_VERIFY(
            (bench.client.tick(), bench.find<QTableWidget>("sensorModules")->item(1, 2)->text() == "ERR0: no reading"));
        QVERIFY(page->isVisible());
    }
    void oneThatRisesAloneIsFound() {
        sensors::FingerFinder finder;
        finder.begin();
        QVERIFY(!finder.look({20.0, 30.0, std::nullopt}));
        QVERIFY(!finder.look({20.1, 30.6, 25.0}));
        QVERIFY(!finder.look({21.5, 31.2, 25.0}));  // two at once: the machine warms
        finder.begin();
        (void)finder.look({20.0, 30.0, 25.0});
        const auto found = finder.look({20.1, 31.2, std::nullopt});
        QVERIFY(found.has_value());
        QCOMPARE(found->channel, 1U);
    }
};

QTEST_MAIN(TestSensorsPage)
#include "tst_sensors_page.moc"
