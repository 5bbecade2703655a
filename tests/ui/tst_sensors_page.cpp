// SPDX-License-Identifier: GPL-3.0-or-later
#include <QLabel>
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
        fake.gauges.push_back({"BMD-17", "/dev/ttyUSB0", true, true, "01A+00050.012"});
    }
    [[nodiscard]] const SensorServiceView& view() const override { return fake; }
    void lookForFinger(bool on) override { fake.finger = {on, {}, 0.0}; }
    void askGauge(std::size_t gauge) override { asked.push_back(gauge); }
    [[nodiscard]] Result<void> place(std::size_t channel, double x, double y, const std::string& author) override {
        fake.channels[channel].placed = true;
        fake.channels[channel].x = x;
        fake.channels[channel].y = y;
        placedBy = author;
        return {};
    }
    SensorServiceView fake{};
    std::vector<std::size_t> asked{};
    std::string placedBy{};
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
