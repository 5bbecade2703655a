// SPDX-License-Identifier: GPL-3.0-or-later
#include <fcntl.h>

#include <QDir>
#include <QFile>
#include <QTableWidget>
#include <QTest>
#include <cmath>

#include "tests/support/console_bench.h"
#include "tests/support/layout_check.h"
#include "tests/support/modbus_modules.h"
#include "tests/support/step.h"

using namespace kerf;

/// The Sensors page on the real console, from a machine without a sensor file to a module that is read and a gauge that
/// is heard; module and gauge are others' (pymodbus, socat).
class TestConsoleSensors : public QObject {
    Q_OBJECT

    void start() {
        KERF_STEP(m_bench.startQuietly());
        m_bench.console().window()->showPage("sensors");
    }
    void write(const char* name, const QByteArray& text) {
        QVERIFY(QDir(m_bench.folder()).mkpath(QStringLiteral("sensors")));
        QFile file(m_bench.folder() + QStringLiteral("/sensors/") + QLatin1String(name));
        QVERIFY(file.open(QIODevice::WriteOnly | QIODevice::Truncate));
        file.write(text);
    }
    [[nodiscard]] QString cell(const char* table, int row, int column) {
        const auto* found = m_bench.find<QTableWidget>(table);
        const auto* item = found != nullptr ? found->item(row, column) : nullptr;
        return item != nullptr ? item->text() : QString();
    }
    void look(const char* what) {
        ui::MainWindow* window = m_bench.console().window();
        for (const ui::Language language : {ui::Language::English, ui::Language::Korean}) {
            ui::Preferences face = m_bench.console().look().preferences();
            face.language = language;
            m_bench.console().look().apply(face);
            for (int i = 0; i < 4; ++i) {
                QCoreApplication::sendPostedEvents();
                QCoreApplication::processEvents();
            }
            const QString name =
                QLatin1String(what) + (language == ui::Language::Korean ? QStringLiteral("_ko") : QString());
            window->grab().save(name + QStringLiteral(".png"));
            const QStringList clipped = test::clippedTexts(window);
            QVERIFY2(clipped.isEmpty(), qPrintable(name + u'\n' + clipped.join(u'\n')));
            const QStringList small = test::smallTargets(window, m_bench.console().look());
            QVERIFY2(small.isEmpty(), qPrintable(name + u'\n' + small.join(u'\n')));
        }
        ui::Preferences face = m_bench.console().look().preferences();
        face.language = ui::Language::English;
        m_bench.console().look().apply(face);
    }

 private slots:
    void initTestCase() {
        if (const QString why = test::ModbusModules::whyNot(true); !why.isEmpty()) {
            QSKIP(qPrintable(why));
        }
        QVERIFY(m_modules.start());
        m_port = m_modules.addTcp(m_module, 16, 3);
        QVERIFY(m_modules.set(m_module, "input", 0, {215, 307}, 3));
        QVERIFY(m_modules.makePair(m_modules.file("far"), m_modules.file("near")));
        const int line = ::open(m_modules.file("far").toUtf8().constData(), O_RDWR | O_NOCTTY | O_NONBLOCK);
        QVERIFY(m_gauge.open(line, QIODevice::ReadWrite | QIODevice::Unbuffered, QFileDevice::AutoCloseHandle));
        const QByteArray module =
            R"({"name": "A", "transport": "tcp", "host": "127.0.0.1", "unit": 3, "period_ms": 200, "port": )" +
            QByteArray::number(m_port) + "}";
        write("vmc-3.json", R"({"modules": [)" + module + R"(], "channels": [
            {"name": "T00", "module": "A", "address": 0, "scale": 0.1, "place": "front bearing"},
            {"name": "T01", "module": "A", "address": 1, "scale": 0.1}],
            "gauges": [{"name": "BMD-17", "device": ")" +
                                m_modules.file("near").toUtf8() + R"(", "protocol": "sylvac", "depths": {"": 1}}]})");
        write("broken.json", R"({"modules": [], "channels": [], "colour": 1})");
    }
    void withoutAFileWhatIsThereIsShown() {
        start();
        QTRY_COMPARE(cell("sensorFiles", 1, 0), QStringLiteral("vmc-3.json"));
        QVERIFY(cell("sensorFiles", 0, 1).contains(QStringLiteral("colour: unknown key")));
        QTest::keyClicks(m_bench.find<QLineEdit>("sensorScanAddress"), QStringLiteral("127.0.0.1:%1").arg(m_port));
        QVERIFY(m_bench.press("sensorScan"));
        QTRY_VERIFY2_WITH_TIMEOUT(m_bench.text("sensorScanAnswer").contains(QStringLiteral("as on the wire")),
                                  qPrintable(m_bench.text("sensorScanAnswer")), 60'000);
        QCOMPARE(cell("sensorFound", 0, 0), QStringLiteral("3"));
        QVERIFY(cell("sensorFound", 0, 1).startsWith(QStringLiteral("Kerf TH8")));
        QVERIFY2(cell("sensorFound", 0, 2).startsWith(QStringLiteral("4: 215 307 0")),
                 qPrintable(cell("sensorFound", 0, 2)));
        m_bench.find<QTableWidget>("sensorFiles")->selectRow(1);
        look("sensors_none");
        QVERIFY(m_bench.press("sensorFileUse"));
        QTRY_VERIFY(m_bench.text("sensorFileNow").contains(QStringLiteral("From the next start: vmc-3.json")));
        m_bench.stop();
    }
    void fromTheNextStartItIsRead() {
        start();
        QTRY_VERIFY2_WITH_TIMEOUT(cell("sensorChannels", 0, 2).startsWith(QStringLiteral("21.5")),
                                  qPrintable(cell("sensorChannels", 0, 4)), 20'000);
        QCOMPARE(cell("sensorChannels", 0, 1), QStringLiteral("front bearing"));
        QVERIFY(cell("sensorChannels", 1, 2).startsWith(QStringLiteral("30.7")));
        QVERIFY(m_bench.press("sensorSetupOpen"));
        QTRY_VERIFY(m_bench.text("sensorFileNow").contains(QStringLiteral("In use: vmc-3.json.")));
        m_bench.console().window()->sheets().current()->close();
        look("sensors_read");
    }
    /// A test read is shown and is no diameter, though a part waits for one; what the gauge's own key sends is.
    void aTestReadIsNoDiameter() {
        QTRY_VERIFY_WITH_TIMEOUT(m_bench.service().awaiting.has_value(), 60'000);
        const std::string diameter =
            QString::number(0.5 * (m_bench.service().lowerTolerance_mm + m_bench.service().upperTolerance_mm), 'f', 3)
                .toStdString();
        QVERIFY(m_bench.press("askGauge"));
        QByteArray asked;
        QTRY_VERIFY_WITH_TIMEOUT((asked += m_gauge.read(16)).contains("?"), 10'000);
        m_gauge.write(("+" + diameter + "\r").c_str());
        QTRY_COMPARE(cell("sensorModules", 1, 2), QStringLiteral("+") + QString::fromStdString(diameter));
        QVERIFY(m_bench.service().parts.back().measurements.empty());
        m_gauge.write("ERR0\r");
        QTRY_COMPARE(cell("sensorModules", 1, 2), QStringLiteral("ERR0: no reading"));
        QVERIFY(m_bench.service().parts.back().measurements.empty());
        m_gauge.write(("+" + diameter + "\r").c_str());
        QTRY_VERIFY_WITH_TIMEOUT(
            m_bench.service().parts.back().measurements.size() == 1 || m_bench.find("boringConfirm") != nullptr,
            10'000);
    }
    void whoMayNotPlacesNothing() {
        const auto placed = m_bench.console().services().sensorService->place(0, 0.5, 0.5, "nobody");
        QVERIFY(!placed);
        m_bench.stop();
    }
    /// A file that was chosen and is gone stops no start.
    void aFileThatIsGoneIsSaid() {
        QVERIFY(QFile::remove(m_bench.folder() + QStringLiteral("/sensors/vmc-3.json")));
        start();
        QTRY_VERIFY(m_bench.find<QTableWidget>("sensorFiles") != nullptr);
        const auto findings = m_bench.console().services().startFindings;
        QVERIFY(std::ranges::any_of(findings, [](const Sentence& said) {
            return QString::fromStdString(said.english()).contains(QStringLiteral("vmc-3.json cannot be used"));
        }));
        m_bench.stop();
    }

 private:
    test::ModbusModules m_modules;
    int m_module{0};
    int m_port{0};
    QFile m_gauge;
    test::ConsoleBench m_bench;
};

QTEST_MAIN(TestConsoleSensors)
#include "tst_console_sensors.moc"
