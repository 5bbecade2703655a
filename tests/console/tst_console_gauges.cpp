// SPDX-License-Identifier: GPL-3.0-or-later
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTest>

#include "app/console/sensor_service.h"
#include "tests/support/console_bench.h"
#include "tests/support/modbus_modules.h"

using namespace kerf;

/// A multiplexer of two gauges on a serial line, behind the real console: its sensor file says at which depth each
/// channel measures; it is plugged in and pulled out while the console runs.
class TestConsoleGauges : public QObject {
    Q_OBJECT

    [[nodiscard]] const BorePartView* part(std::uint32_t number) {
        for (const BorePartView& one : m_bench.service().parts) {
            if (one.number == number) {
                return &one;
            }
        }
        return nullptr;
    }
    [[nodiscard]] double stored_mm(std::uint32_t number, std::uint8_t depth) {
        const BorePartView* bore = part(number);
        for (std::size_t i = 0; bore != nullptr && i < bore->measurements.size(); ++i) {
            if (bore->measurements[i].depth == depth && !bore->measurements[i].voided) {
                return bore->measurements[i].diameter_mm;
            }
        }
        return 0.0;
    }
    [[nodiscard]] bool waits(std::uint32_t number) {
        const BoringServiceView& view = m_bench.service();
        const BorePartView* bore = part(number);
        return bore != nullptr && view.awaiting == bore->id && view.awaitingDepth == 0;
    }
    [[nodiscard]] double gauged_mm(std::uint8_t depth) {
        return m_bench.console().boringService().gaugeReading_mm(*m_bench.service().awaiting, depth).value_or(0.0);
    }
    /// A Digimatic box sends a channel.
    bool send(int channel, double value_mm) {
        return m_far.write(QStringLiteral("%1A+%2\r")
                               .arg(channel, 2, 10, QLatin1Char('0'))
                               .arg(value_mm, 9, 'f', 3, QLatin1Char('0'))
                               .toLatin1()) > 0;
    }
    bool plugIn() {
        if (!m_lines.makePair(m_farName, m_nearName)) {
            return false;
        }
        m_far.setFileName(m_farName);
        return m_far.open(QIODevice::WriteOnly | QIODevice::Unbuffered) &&
               QTest::qWaitFor([this] { return there(); }, 10'000);
    }
    [[nodiscard]] bool there() {
        const console::StoredSensorService* service = m_bench.console().sensorService();
        return service != nullptr && service->view().gauges.front().connected;
    }

 private slots:
    void readingsGoToTheDepthTheFileSays() {
        if (const QString why = test::ModbusModules::whyNot(true); !why.isEmpty()) {
            QSKIP(qPrintable(why));
        }
        m_farName = m_lines.file("gauge-far");
        m_nearName = m_lines.file("gauge-near");
        const QJsonObject gauge{
            {QStringLiteral("name"), QStringLiteral("G-07")},
            {QStringLiteral("device"), m_nearName},
            {QStringLiteral("protocol"), QStringLiteral("digimatic")},
            {QStringLiteral("depths"), QJsonObject{{QStringLiteral("03"), 2}, {QStringLiteral("08"), 1}}}};
        QFile file(m_lines.file("sensors.json"));
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(QJsonDocument(QJsonObject{{QStringLiteral("gauges"), QJsonArray{gauge}}}).toJson());
        file.close();
        console::Options options;
        options.preparedParts = 0;
        options.simulationSpeed = 0.0;  // as fast as it can
        options.seed = 5;
        options.sensors = file.fileName().toStdString();
        m_bench.start(options);
        QTRY_VERIFY2_WITH_TIMEOUT(m_bench.up(), qPrintable(m_bench.failure()), 20'000);
        m_bench.console().window()->showPage("boring");
        QTRY_VERIFY_WITH_TIMEOUT(waits(1), 20'000);
        QVERIFY(!there());
        QVERIFY(plugIn());  // while the console runs
        const double top_mm = gauged_mm(0);
        const double bottom_mm = gauged_mm(1);
        QVERIFY(top_mm > 0.0 && bottom_mm > 0.0);
        QVERIFY(send(3, bottom_mm) && send(8, top_mm));  // a foot switch: both at once, the lower one first
        QTRY_VERIFY_WITH_TIMEOUT(stored_mm(1, 0) > 0.0 && stored_mm(1, 1) > 0.0, 10'000);
        QVERIFY(std::abs(stored_mm(1, 0) - top_mm) < 6e-4);
        QVERIFY(std::abs(stored_mm(1, 1) - bottom_mm) < 6e-4);

        m_far.close();
        m_lines.dropPair();  // pulled out …
        QTRY_VERIFY_WITH_TIMEOUT(!there(), 10'000);
        QTRY_VERIFY_WITH_TIMEOUT(waits(2), 20'000);
        QVERIFY(plugIn());  // … and in again
        const double next_mm = gauged_mm(0);
        QVERIFY(send(8, next_mm));
        QTRY_VERIFY_WITH_TIMEOUT(stored_mm(2, 0) > 0.0, 10'000);
        QVERIFY(std::abs(stored_mm(2, 0) - next_mm) < 6e-4);
        m_bench.stop();
    }

 private:
    test::ModbusModules m_lines;
    test::ConsoleBench m_bench;
    QString m_farName;
    QString m_nearName;
    QFile m_far;
};
QTEST_MAIN(TestConsoleGauges)
#include "tst_console_gauges.moc"
