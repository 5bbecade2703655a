// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>
#include <set>

#include "db/shop/outbox.h"
#include "db_test_support.h"

using namespace kerf;
using kerf::test::number;

namespace {
/// Tables that stay on the console, and why.
const std::set<std::string> kNotForTheShop{
    "schema_steps",     // of this file
    "outbox",           // the way there itself
    "outbox_traces",    //
    "shop_epochs",      // told at each connect
    "sqlite_sequence",  // SQLite's own
    "accounts",         // sealed PINs
};
}  // namespace

/// What changes in a data file is noted for the shop in the same transaction.
class TestOutbox : public QObject {
    Q_OBJECT
 private slots:
    void everyTableIsFollowedOrNamed() {
        test::ScratchDatabase scratch;
        const db::Connection connection(scratch.path(), db::Access::Read);
        std::set<std::string> followed;
        for (const db::FollowedTable& table : db::followedTables()) {
            followed.insert(table.name);
        }
        db::Statement tables(connection.database(), "SELECT name FROM sqlite_master WHERE type = 'table'");
        tables.run();
        while (tables.next()) {
            const std::string name = tables.text(0);
            QVERIFY2(followed.contains(name) != kNotForTheShop.contains(name),
                     ("A new table must get outbox triggers, a line in followedTables() and a table in "
                      "db/shop/migrations, or be named here: " +
                      name)
                         .c_str());
            if (followed.contains(name)) {
                db::Statement trigger(
                    connection.database(),
                    "SELECT count(*) FROM sqlite_master WHERE type = 'trigger' AND tbl_name = ? AND name "
                    "LIKE '%_outbox_insert'");
                QVERIFY(trigger.bind(name).run().next());
                QVERIFY2(trigger.integer(0) == 1, ("a rebuilt table has lost its outbox trigger: " + name).c_str());
            }
        }
    }
    void everyStoredThingIsNoted() {
        test::ScratchDatabase scratch;
        test::Shop shop(scratch.path());
        const PartId part = shop.addPart(1);
        const std::int64_t before = number(shop.database(), "SELECT max(seq) FROM outbox");
        (void)shop.must(AcceptMeasurement{test::measured(part, 0, 50.1), {test::stateOf(0.5)}, std::nullopt});
        QCOMPARE(number(shop.database(), "SELECT count(*) FROM outbox WHERE table_name = 'measurements'"),
                 std::int64_t{1});
        QVERIFY(number(shop.database(), "SELECT max(seq) FROM outbox") >
                before + 1);  // its state and its audit entry too
        (void)shop.must(SetPartSerial{part, "A1", "Kim", {}});
        QCOMPARE(number(shop.database(), "SELECT count(*) FROM outbox WHERE table_name = 'parts'"), std::int64_t{2});
        QCOMPARE(number(shop.database(), "SELECT count(*) FROM outbox_traces"), std::int64_t{1});
    }
    void whatIsRefusedIsNotNoted() {
        test::ScratchDatabase scratch;
        test::Shop shop(scratch.path());
        const PartId part = shop.addPart(1);
        const std::int64_t before = number(shop.database(), "SELECT max(seq) FROM outbox");
        MeasurementRow nameless = test::measured(part, 0, 50.1);
        nameless.author.clear();
        QVERIFY(!shop.tried(AcceptMeasurement{nameless, {test::stateOf(0.5)}, std::nullopt}));
        QCOMPARE(number(shop.database(), "SELECT max(seq) FROM outbox"), before);
    }
    void sealedPinsStayHere() {
        test::ScratchDatabase scratch;
        test::Shop shop(scratch.path());
        const std::int64_t before = number(shop.database(), "SELECT max(seq) FROM outbox");
        (void)shop.must(ChangeSetting{"operators", "Kim\toperator\tsealed", "Lee", {}});
        (void)shop.must(ChangeSetting{"operators", "Kim\toperator\tsealed again", "Lee", {}});
        QCOMPARE(number(shop.database(), "SELECT max(seq) FROM outbox"), before);
    }
    void batchesAreWholeAndBounded() {
        test::ScratchDatabase scratch;
        test::Shop shop(scratch.path());
        for (std::uint32_t i = 0; i < 20; ++i) {
            (void)shop.addPart(i);
        }
        const db::Connection reading(scratch.path(), db::Access::Read);
        db::OutboxReader outbox(reading.database());
        const std::int64_t newest = outbox.newestSeq(db::ShopStream::Rows);
        std::int64_t next = 1;
        while (next <= newest) {
            const db::OutboxBatch batch = outbox.batch(db::ShopStream::Rows, next, 7, 1'000'000);
            QVERIFY(!batch.marks.empty() && batch.marks.size() <= 7);
            QCOMPARE(batch.marks.front(), *outbox.markAt(db::ShopStream::Rows, next));
            next += static_cast<std::int64_t>(batch.marks.size());
        }
        QCOMPARE(next, newest + 1);
        QVERIFY(outbox.batch(db::ShopStream::Rows, next, 7, 1'000'000).marks.empty());
        // Far over the size: still one entry, so that it goes on.
        QCOMPARE(outbox.batch(db::ShopStream::Traces, 1, 500, 1).marks.size(), std::size_t{1});
        QVERIFY(outbox.batch(db::ShopStream::Traces, 1, 500, 2000).marks.size() < 20);
    }
    void aRowThatChangedTwiceTravelsOnce() {
        test::ScratchDatabase scratch;
        test::Shop shop(scratch.path());
        const PartId part = shop.addPart(1);
        (void)shop.must(SetPartSerial{part, "A1", "Kim", {}});
        (void)shop.must(SetPartSerial{part, "A2", "Kim", {}});
        const db::Connection reading(scratch.path(), db::Access::Read);
        db::OutboxReader outbox(reading.database());
        int parts = 0;
        for (const db::OutboxRow& row : outbox.batch(db::ShopStream::Rows, 1, 500, 1'000'000).rows) {
            if (row.table == "parts") {
                ++parts;
                QVERIFY(row.json.find("\"A2\"") != std::string::npos);
            }
        }
        QCOMPARE(parts, 1);
    }
    void numbersTravelWithEveryBit() {
        QCOMPARE(db::jsonNumber(0.1 + 0.2), std::string("0.30000000000000004"));
        QCOMPARE(db::jsonNumber(-0.0), std::string("-0"));
        QCOMPARE(QByteArray::fromStdString(db::jsonText("a\"\n")).toHex(), QByteArray("22615c225c6e22"));
    }
    void newEpochIsNotedAndAudited() {
        test::ScratchDatabase scratch;
        test::Shop shop(scratch.path());
        const db::Connection reading(scratch.path(), db::Access::Read);
        const db::OutboxReader outbox(reading.database());
        const db::ShopIdentity before = outbox.identity();
        db::beginShopEpoch(scratch.path(), "an older copy");
        const db::ShopIdentity now = outbox.identity();
        QCOMPARE(now.store, before.store);
        QVERIFY(now.epoch != before.epoch);
        QCOMPARE(now.reason, std::string("an older copy"));
        const auto verdict = shop.reader()->verifyAudit();
        QVERIFY(verdict && verdict->finding.empty());
        test::ScratchDatabase other;
        const db::Connection there(other.path(), db::Access::Read);
        QVERIFY(db::OutboxReader(there.database()).identity().store != now.store);
    }
};

QTEST_GUILESS_MAIN(TestOutbox)
#include "tst_outbox.moc"
