// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>

#include "app/service/milling/milling_service.h"
#include "db/writer_thread.h"
#include "tests/db/db_test_support.h"
#include "tests/support/fake_engine.h"

using namespace kerf;

namespace {

/// The service on a real database, with rights by name: Kim is an operator, Lee a setter, Park an engineer.
struct Bench {
    Bench() : writer(scratch.path(), nullptr, {.queueCapacity = 64, .ringPoll_ms = 1, .retry_ms = 2}) {
        if (!writer.start()) {
            qFatal("no writer");
        }
        open();
    }
    void open() {
        service.reset();
        reader = std::move(*db::DatabaseReader::open(scratch.path()));
        StoredMillingService::Links links{writer, engine, [] { return std::string("Kerf"); }, {}, {}};
        links.rights = [](const std::string& author, Trust least) -> std::optional<Sentence> {
            const Trust has = author == "Park" ? Trust::Engineer : author == "Lee" ? Trust::Setter : Trust::Operator;
            return has >= least ? std::nullopt : std::optional(Sentence("not trusted with it"));
        };
        service = std::make_unique<StoredMillingService>(std::move(links), *reader, *reader);
    }
    template <class Call>
    [[nodiscard]] bool done(const Call& call) {
        std::optional<bool> ok;
        call([&ok](const Result<void>& result) { ok = result.has_value(); });
        return QTest::qWaitFor([&] { return ok.has_value(); }) && *ok;
    }
    [[nodiscard]] bool save(const MillingSetup& setup, const char* author) {
        return done([&](auto answer) { service->saveSetup(setup, author, "drawing", answer); });
    }
    [[nodiscard]] bool choose(const std::string& name, const char* author) {
        return done([&](auto answer) { service->choosePartType(name, author, answer); });
    }

    test::ScratchDatabase scratch;
    test::FakeEngine engine;
    db::WriterThread writer;
    std::unique_ptr<db::DatabaseReader> reader;
    std::unique_ptr<StoredMillingService> service;
};

}  // namespace

/// What the milling service keeps, and from whom it takes it.
class TestMillingService : public QObject {
    Q_OBJECT
 private slots:
    void limitsAreRaisedByAnEngineerAlone() {
        Bench bench;
        MillingSetup setup = bench.service->view().setup;
        setup.overload_N = 1500.0;
        QVERIFY(!bench.save(setup, "Kim"));
        QVERIFY(!bench.save(setup, "Lee"));
        QVERIFY(!bench.save(setup, ""));
        QCOMPARE(bench.service->view().setup.overload_N, 650.0);
        QVERIFY(bench.save(setup, "Park"));
        QCOMPARE(bench.service->view().setup.overload_N, 1500.0);
        setup.overload_N = 500.0;
        QVERIFY(!bench.save(setup, "Kim"));
        QVERIFY(bench.save(setup, "Lee"));  // a setter lowers it
        QVERIFY(!bench.choose("Bracket", "Kim"));
        QVERIFY(bench.done([&](auto answer) { bench.service->newTool("Kim", answer); }));
    }
    void partTypesKeepTheirOwnLimitOverARestart() {
        Bench bench;
        MillingSetup setup = bench.service->view().setup;
        setup.overload_N = 400.0;
        setup.reference_N = 300.0;
        QVERIFY(bench.choose("Soft", "Park") && bench.save(setup, "Park"));
        QVERIFY(bench.choose("Like soft", "Park"));  // takes the setup it finds, and is never saved itself
        setup.overload_N = 1500.0;
        QVERIFY(bench.choose("Hard", "Park") && bench.save(setup, "Park"));
        for (int i = 0; i < 520; ++i) {  // more setups than were read once
            setup.wearWarning = 0.3 + 0.001 * (i % 7);
            QVERIFY(bench.save(setup, "Park"));
        }
        bench.open();
        QCOMPARE(bench.service->view().partType, std::string("Hard"));
        QCOMPARE(bench.service->view().partTypes.size(), std::size_t{4});
        QCOMPARE(bench.service->view().setup.overload_N, 1500.0);
        for (const char* soft : {"Soft", "Like soft"}) {
            QVERIFY(bench.choose(soft, "Park"));
            QCOMPARE(bench.service->view().setup.overload_N, 400.0);
        }
    }
};
QTEST_GUILESS_MAIN(TestMillingService)
#include "tst_milling_service.moc"
