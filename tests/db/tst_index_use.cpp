// SPDX-License-Identifier: GPL-3.0-or-later
#include <sqlite3.h>

#include <QTest>
#include <map>

#include "db/data_file.h"
#include "db/stores/audit_log.h"
#include "db_test_support.h"

using namespace kerf;

namespace {

/// What the statements of this program have cost, by their words, on every connection.
struct Cost {
    int rowsScanned{0};  ///< rows gone through because no index leads to them
    int indexesMade{0};  ///< entries of indexes that SQLite made for one query
};
std::map<std::string, Cost> costs;

int note(unsigned /*kind*/, void* /*context*/, void* statement, void* /*time*/) {
    auto* prepared = static_cast<sqlite3_stmt*>(statement);
    Cost& cost = costs[sqlite3_sql(prepared)];
    cost.rowsScanned += sqlite3_stmt_status(prepared, SQLITE_STMTSTATUS_FULLSCAN_STEP, 1);
    cost.indexesMade += sqlite3_stmt_status(prepared, SQLITE_STMTSTATUS_AUTOINDEX, 1);
    return 0;
}

int watch(sqlite3* connection, const char** /*error*/, const sqlite3_api_routines* /*routines*/) {
    return sqlite3_trace_v2(connection, SQLITE_TRACE_PROFILE, &note, nullptr);
}

constexpr int kParts = 60;

/// Three lots of 20 parts of two bores, each with its states; settings, setups, people of an earlier version.
void fill(test::Shop& shop) {
    for (int lot = 0; lot < 3; ++lot) {
        shop.lot = shop.must(EnsureLot{shop.machine, shop.partType, shop.recipe, "L" + std::to_string(lot), 20,
                                       "kalman", "Lee"})
                       .id;
        for (std::uint32_t i = 0; i < kParts / 3; ++i) {
            const PartId part = shop.addPart(1 + i);
            for (const std::uint8_t station : {0, 1}) {
                (void)shop.must(
                    AcceptMeasurement{test::measured(part, station, 50.0), {test::stateOf(0.5)}, std::nullopt});
            }
        }
        (void)shop.must(CloseLot{shop.lot, "Choi", "done"});
        (void)shop.must(ChangeSetting{"key." + std::to_string(lot), "1", "Lee", "as drawn"});
        (void)shop.must(AddRoomRecord{ProcessId::Thermal, "model", "Z", R"({"half_um":2.1})", "Lee", "trained"});
    }
}

/// Statements that went through more rows than `most`, or made an index of their own.
QString dear(int most) {
    QString found;
    for (const auto& [words, cost] : costs) {
        if (cost.rowsScanned > most || cost.indexesMade > 0) {
            found += QStringLiteral("%1 rows, %2 indexed: %3\n")
                         .arg(cost.rowsScanned)
                         .arg(cost.indexesMade)
                         .arg(QString::fromStdString(words));
        }
    }
    return found;
}

}  // namespace

/// Indexes were taken away for the sake of an acceptance (migration 008): what is read all the same must find its rows.
class TestIndexUse : public QObject {
    Q_OBJECT
 private slots:
    void initTestCase() { QCOMPARE(sqlite3_auto_extension(reinterpret_cast<void (*)()>(&watch)), SQLITE_OK); }
    void cleanupTestCase() { sqlite3_reset_auto_extension(); }

    void verifyLooksEntriesUp() {
        test::ScratchDatabase scratch;
        test::Shop shop(scratch.path());
        fill(shop);
        costs.clear();
        const AuditVerdict verdict = *shop.reader()->verifyAudit();
        QVERIFY(verdict.finding.empty());
        bool entriesLookedUp = false;
        for (const auto& [words, cost] : costs) {
            QVERIFY2(cost.indexesMade == 0, words.c_str());
            if (words.find("object <> 'measurement'") != std::string::npos) {
                entriesLookedUp = true;
                QVERIFY2(cost.rowsScanned < 10, words.c_str());  // lots, settings, records; not 130 entries
            } else if (words.find("audit") != std::string::npos) {
                // The chain and the measurements, each once from the first to the last.
                QVERIFY2(cost.rowsScanned <= static_cast<int>(verdict.entries), words.c_str());
            }
        }
        QVERIFY(entriesLookedUp);
    }
    void everyQueryOfTheAuditByObjectSaysSo() {
        test::ScratchDatabase scratch;
        {
            test::Shop shop(scratch.path());
            fill(shop);
        }
        costs.clear();
        {
            const auto file = db::DataFile::open(scratch.path());
            QVERIFY(file);
        }
        QCOMPARE(dear(30), QString());
    }
    void statesOfAPartAreFoundInItsLot() {
        test::ScratchDatabase scratch;
        test::Shop shop(scratch.path());
        fill(shop);
        const auto reader = shop.reader();
        costs.clear();
        const auto part = reader->part(kParts / 2);
        QVERIFY(part && *part);
        QCOMPARE((*part)->states.size(), std::size_t{2});
        QCOMPARE((*part)->states[0].measurement, MeasurementId{kParts - 1});
        QCOMPARE(dear(0), QString());
    }
    void statesOfALotComeInTheirOrder() {
        test::ScratchDatabase scratch;
        test::Shop shop(scratch.path());
        fill(shop);
        const auto reader = shop.reader();
        costs.clear();
        const auto history = reader->history(2);
        QVERIFY(history && *history);
        QCOMPARE((*history)->states.size(), std::size_t{2 * kParts / 3});
        QCOMPARE((*history)->lastState->measurement, (*history)->measurements.back().id);
        QCOMPARE(dear(0), QString());
    }
    void anAcceptanceLooksEverythingUp() {
        test::ScratchDatabase scratch;
        test::Shop shop(scratch.path());
        fill(shop);
        costs.clear();
        ScheduleRow next;
        next.lot = shop.lot;
        next.schedule = test::boringPart(1, 2).schedule;
        (void)shop.must(AcceptMeasurement{test::measured(kParts, 0, 50.0), {test::stateOf(0.5)}, next});
        QCOMPARE(dear(1), QString());
    }
};

QTEST_GUILESS_MAIN(TestIndexUse)
#include "tst_index_use.moc"
