// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>
#include <set>

#include "db_test_support.h"
#include "kill_story.h"
#include "tests/support/kill_campaign.h"

using namespace kerf;

namespace {

/// What must be true of a file whose program was killed, given everything the program had acknowledged so far.
QString findingIn(const std::string& path, const std::vector<std::string>& acknowledged) {
    if (const auto ready = db::prepareDatabase(path); !ready) {
        return QString::fromStdString(ready.error().english());
    }
    if (const auto whole = db::checkDatabase(path); !whole) {
        return QString::fromStdString(whole.error().english());
    }
    const auto reader = db::DatabaseReader::open(path);
    if (!reader) {
        return QString::fromStdString(reader.error().english());
    }
    const auto lots = (*reader)->lots(std::nullopt, 2);
    const auto history = (*reader)->history(lots->front().id);
    if (!history || !*history) {
        return QStringLiteral("the lot cannot be read");
    }
    const LotHistory& lot = **history;
    // What is stored, told as the program would have told it; the state of a row is the fold over all rows up to it.
    std::set<std::string> stored;
    std::vector<MeasurementRow> soFar;
    for (const MeasurementRow& row : lot.measurements) {
        soFar.push_back(row);
        stored.insert(test::storyLine(row, test::foldOf(soFar)));
    }
    for (const std::string& line : acknowledged) {
        if (!stored.contains(line)) {
            return QStringLiteral("accepted but lost or changed: %1").arg(QString::fromStdString(line));
        }
    }
    if (stored.size() > acknowledged.size() + 1) {
        return QStringLiteral("%1 rows stored, only %2 acknowledged").arg(stored.size()).arg(acknowledged.size());
    }
    if (lot.measurements.empty() != !lot.lastState) {
        return QStringLiteral("measurements without a state");
    }
    if (lot.lastState && (lot.lastState->cause != lot.measurements.back().id ||
                          lot.lastState->theta[0] != test::foldOf(lot.measurements))) {
        return QStringLiteral("the last state does not belong to the last accepted measurement");
    }
    const auto verdict = (*reader)->verifyAudit();
    if (!verdict || !verdict->finding.empty()) {
        return QStringLiteral("audit: ") +
               QString::fromStdString(verdict ? verdict->finding.english() : std::string("?"));
    }
    for (const PartDetail& detail : lot.parts) {
        if (!detail.schedule || detail.feed.count != kFeedTracePoints) {
            return QStringLiteral("part %1 is half-stored").arg(detail.part.number);
        }
    }
    return {};
}

}  // namespace

/// kill -9 at a random moment. 10 times here; KERF_KILL_RUNS=200 for the long campaign (scripts/test --long).
class TestKill : public QObject {
    Q_OBJECT
 private slots:
    void noAcceptedMeasurementIsLost() {
        test::ScratchDatabase scratch;
        bool given = false;
        const int kills = qEnvironmentVariableIntValue("KERF_KILL_RUNS", &given);
        std::vector<std::string> all;
        test::KillCampaign::Options options;
        options.program = qEnvironmentVariable("KERF_BIN") + QStringLiteral("/db_kill_victim");
        options.arguments = {QString::fromStdString(scratch.path()), QStringLiteral("7")};
        options.rounds = given ? kills : 10;
        options.seed = 20261122;
        // One file over all rounds: what an earlier kill left behind is part of the later ones.
        const QString finding = test::KillCampaign::run(options, [&](int, const std::vector<std::string>& acks) {
            all.insert(all.end(), acks.begin(), acks.end());
            QString found = findingIn(scratch.path(), all);
            // A row may be committed and its line not yet written: from now on it counts like the others.
            if (found.isEmpty()) {
                const auto reader = db::DatabaseReader::open(scratch.path());
                const auto lots = (*reader)->lots(std::nullopt, 1);
                const auto history = (*reader)->history(lots->front().id);
                if ((*history)->measurements.size() > all.size()) {
                    all.push_back(
                        test::storyLine((*history)->measurements.back(), test::foldOf((*history)->measurements)));
                }
            }
            return found;
        });
        QVERIFY2(finding.isEmpty(), qPrintable(finding));
        qInfo("%d kills, %zu accepted measurements, none lost", options.rounds, all.size());
    }
    void theCheckItselfFindsALostMeasurement() {
        test::ScratchDatabase scratch;
        test::Shop shop(scratch.path());
        const PartId part = shop.addPart(1);
        EstimatorStateRow state = test::stateOf(0.5);
        state.theta[0] = 50.0;
        const MeasurementId id = shop.must(AcceptMeasurement{test::measured(part, 0, 50.0), {state}, std::nullopt}).id;
        MeasurementRow row = test::measured(part, 0, 50.0);
        row.id = id;
        const std::string line = test::storyLine(row, 50.0);
        QCOMPARE(findingIn(scratch.path(), {line}), QString());
        MeasurementRow missing = row;
        missing.id = id + 1;
        QVERIFY(findingIn(scratch.path(), {line, test::storyLine(missing, 50.0)}).contains("lost"));
        QVERIFY(findingIn(scratch.path(), {test::storyLine(row, 51.0)}).contains("lost"));
        state.theta[0] = 1.0;
        (void)shop.must(AcceptMeasurement{test::measured(part, 1, 50.0), {state}, std::nullopt});
        QVERIFY(findingIn(scratch.path(), {line}).contains("does not belong"));
    }
};

QTEST_GUILESS_MAIN(TestKill)
#include "tst_kill.moc"
