// SPDX-License-Identifier: GPL-3.0-or-later
#include <QDir>
#include <QTest>
#include <nlohmann/json.hpp>

#include "app/files/table.h"
#include "app/rehearsal/rehearsal.h"

using namespace kerf;
using nlohmann::json;

namespace {

QDir shipped() {
    return QDir(qEnvironmentVariable("KERF_FIXTURES") + QStringLiteral("/../../resources/rehearsals"));
}

std::string read(const QString& name) {
    return headless::readFile(shipped().filePath(name).toStdString());
}

/// What is wrong with one answer; empty: nothing.
QString checked(const json& summary, const json& check) {
    const auto at = json::json_pointer(check.at("value").get<std::string>());
    if (!summary.contains(at)) {
        return QStringLiteral("is not there");
    }
    const json& value = summary.at(at);
    if (check.contains("equals") && value != check["equals"]) {
        return QString::fromStdString("is " + value.dump() + ", expected " + check["equals"].dump());
    }
    if (check.contains("at_most") && !(value.get<double>() <= check["at_most"].get<double>())) {
        return QString::fromStdString("is " + value.dump() + ", expected at most " + check["at_most"].dump());
    }
    if (check.contains("at_least") && !(value.get<double>() >= check["at_least"].get<double>())) {
        return QString::fromStdString("is " + value.dump() + ", expected at least " + check["at_least"].dump());
    }
    return {};
}

}  // namespace

/// The rehearsals that are shipped come to what is said of them; wrong scenarios are refused with the key.
class TestRehearsals : public QObject {
    Q_OBJECT
 private slots:
    void shippedOnesComeToWhatIsExpected_data() {
        QTest::addColumn<QString>("name");
        int count = 0;
        for (const QString& file : shipped().entryList({QStringLiteral("*.json")}, QDir::Files)) {
            if (!file.endsWith(QStringLiteral(".expected.json"))) {
                QTest::addRow("%s", qPrintable(file)) << file.chopped(5);
                ++count;
            }
        }
        QVERIFY(count >= 10);
    }
    void shippedOnesComeToWhatIsExpected() {
        QFETCH(QString, name);
        const auto scenario =
            rehearsal::readScenario(read(name + QStringLiteral(".json")), name.toStdString(), std::string());
        const json summary = rehearsal::summaryJson(scenario, rehearsal::rehearse(scenario, nullptr, 0.0, {}));
        const json expected = json::parse(read(name + QStringLiteral(".expected.json")));
        QVERIFY(!expected.at("checks").empty());
        for (const json& check : expected["checks"]) {
            const QString wrong = checked(summary, check);
            QVERIFY2(wrong.isEmpty(),
                     qPrintable(QString::fromStdString(check["value"].get<std::string>()) + u' ' + wrong));
        }
    }
    void theSameSeedIsTheSameRun() {
        const auto scenario = rehearsal::readScenario(read(QStringLiteral("turning_chip.json")), "turning_chip", "");
        const json once = rehearsal::summaryJson(scenario, rehearsal::rehearse(scenario, nullptr, 0.0, {}));
        QVERIFY(once == json(rehearsal::summaryJson(scenario, rehearsal::rehearse(scenario, nullptr, 0.0, {}))));
    }
    void rowsShowTheFeedAsItIsWhateverItsSignalSays_data() {
        QTest::addColumn<QString>("process");
        QTest::addColumn<QString>("fault");
        for (const char* process : {"boring", "milling", "turning"}) {
            for (const char* fault : {"feed_missing", "feed_stale", "feed_stuck"}) {
                QTest::addRow("%s %s", process, fault) << process << fault;
            }
        }
    }
    void rowsShowTheFeedAsItIsWhateverItsSignalSays() {
        QFETCH(QString, process);
        QFETCH(QString, fault);
        const QString text =
            QStringLiteral(R"({"process": "%1", "duration_s": 4.5, "events": [{"at_s": 0, "do": "start"},
            {"at_s": 2, "fault": "%2"}, {"at_s": 4, "fault": "operator_hold"}]})")
                .arg(process, fault);
        const auto scenario = rehearsal::readScenario(text.toStdString(), "feed", "");
        double before_mmPerS = 0.0;
        double after_mmPerS = 1.0;
        (void)rehearsal::rehearse(scenario, nullptr, 0.0, [&](const rehearsal::Row& row) {
            before_mmPerS = row.t_s < 4.0 ? row.machine.actualFeed_mmPerS.value : before_mmPerS;
            after_mmPerS = row.machine.actualFeed_mmPerS.value;
        });
        QVERIFY2(before_mmPerS > 0.05, qPrintable(QString::number(before_mmPerS)));
        QVERIFY2(after_mmPerS < 0.01, qPrintable(QString::number(after_mmPerS)));
    }
    void aFaultThatChangesNothingIsSaid() {
        const auto remarks = [](const QString& process, const QString& more) {
            const QString text = QStringLiteral(
                                     "{\"process\": \"%1\", \"duration_s\": 9, \"events\": [{\"at_s\": 1, "
                                     "\"fault\": \"servo_signal_lost\"}, {\"at_s\": 2, \"fault\": "
                                     "\"link_down\"}%2]}")
                                     .arg(process, more);
            return rehearsal::readScenario(text.toStdString(), "idle.json", "").remarks;
        };
        QCOMPARE(remarks("turning", "").size(), std::size_t{1});
        QCOMPARE(remarks("turning", "").front(),
                 std::string("idle.json: events[0].fault: servo_signal_lost changes nothing: turning does not use that "
                             "signal."));
        QVERIFY(remarks("tapping", "").empty());
        QVERIFY(remarks("boring", ", {\"at_s\": 0, \"do\": \"start\", \"process\": \"tapping\"}").empty());
    }
    void wrongScenariosNameTheKey_data() {
        QTest::addColumn<QString>("text");
        QTest::addColumn<QString>("key");
        const auto row = [](const char* text, const char* key) { QTest::newRow(key) << text << key; };
        row("[]", "the scenario");
        row("{\"duration_s\": 1}", "process");
        row("{\"process\": \"drilling\", \"duration_s\": 1}", "process: \"drilling\"");
        row("{\"process\": \"milling\"}", "duration_s");
        row("{\"process\": \"milling\", \"duration_s\": -1}", "duration_s: -1");
        row("{\"process\": \"milling\", \"duration_s\": 1e308}", "duration_s: 1e+308");
        row("{\"process\": \"milling\", \"duration_s\": 1, \"mode\": \"fast\"}", "mode");
        row("{\"process\": \"milling\", \"duration_s\": 1, \"seed\": 1.5}", "seed");
        row("{\"process\": \"milling\", \"duration_s\": 1, \"speed\": 1}", "speed");
        row("{\"process\": \"milling\", \"duration_s\": 1, \"setup\": {\"depth_um\": 1}}", "setup.depth_um");
        row("{\"process\": \"milling\", \"duration_s\": 1, \"setup\": {\"overload_n\": 1}}", "setup.overload_n");
        row("{\"process\": \"milling\", \"duration_s\": 1, \"events\": {}}", "events");
        row("{\"process\": \"milling\", \"duration_s\": 1, \"events\": [{\"at_s\": 2, \"do\": \"start\"}]}",
            "events[0].at_s");
        row("{\"process\": \"milling\", \"duration_s\": 1, \"events\": [{\"at_s\": 0}]}", "events[0].do");
        row("{\"process\": \"milling\", \"duration_s\": 1, \"events\": [{\"at_s\": 0, \"do\": \"jump\"}]}",
            "events[0].do: \"jump\"");
        row("{\"process\": \"milling\", \"duration_s\": 1, \"events\": [{\"at_s\": 0, \"fault\": \"fire\"}]}",
            "events[0].fault");
        row("{\"process\": \"milling\", \"duration_s\": 1, \"events\": [{\"at_s\": 0, \"do\": \"set_mode\"}]}",
            "events[0].mode");
        row("{\"process\": \"milling\", \"duration_s\": 1, \"events\": [{\"at_s\": 0, \"fault\": \"override\"}]}",
            "events[0].value");
        row("{\"process\": \"thermal\", \"duration_s\": 1, \"events\": [{\"at_s\": 0, \"fault\": "
            "\"thermocouple_open\", \"channel\": 64}]}",
            "events[0].channel");
        row("{\"process\": \"milling\", \"duration_s\": 1, \"events\": [{\"at_s\": 0, \"fault\": \"cycle_stall\"}]}",
            "events[0].seconds");
        row("{\"process\": \"milling\", \"duration_s\": 1", "no JSON");
        row(R"({"process": "milling", "duration_s": 1, "duration_s": 2})", "\"duration_s\": the key stands twice");
        row("[[[[[[[[[[[[[[[[[[[[", "nested");
        row("{\"process\": \"milling\", \"duration_s\": 1e999}", ": a number is too large to be stored");
    }
    void wrongScenariosNameTheKey() {
        QFETCH(QString, text);
        QFETCH(QString, key);
        QString complaint;
        try {
            (void)rehearsal::readScenario(text.toStdString(), "wrong.json", "");
        } catch (const headless::BadInput& bad) {
            complaint = QString::fromUtf8(bad.what());
        }
        QVERIFY2(complaint.startsWith(QStringLiteral("wrong.json")) && complaint.contains(key), qPrintable(complaint));
    }
};
QTEST_APPLESS_MAIN(TestRehearsals)
#include "tst_rehearsals.moc"
