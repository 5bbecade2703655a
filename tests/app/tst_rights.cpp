// SPDX-License-Identifier: GPL-3.0-or-later
#include <QCoreApplication>
#include <QTest>
#include <set>

#include "app/service/boring/boring_lots.h"
#include "app/service/data/data_keeper.h"
#include "app/service/engine_gate.h"
#include "app/service/milling/milling_service.h"
#include "app/service/quality/stored_quality_service.h"
#include "app/service/tapping/tapping_service.h"
#include "app/service/thermal/thermal_service.h"
#include "app/service/turning/turning_service.h"
#include "engine/process/boring/plant.h"
#include "tests/support/service_bench.h"
#include "ui/services/command_deeds.h"

using namespace kerf;

namespace {

constexpr const char* kReason = "drawing B";

Trust trustOf(const std::string& author) {
    return author == "Park" ? Trust::Engineer : author == "Lee" ? Trust::Setter : Trust::Operator;
}

/// All five services and the gate on a real database, with rights by name: Kim is an operator, Lee a setter, Park a
/// process engineer.
struct Shop : test::FiveServicesBench {
    Shop() {
        engine.caps.servoGains.fitted = true;
        engine.caps.temperatureCount = kMaxTemperatures;
        openBoring();
        StoredMillingService::Links millingLinks{writer, engine, [this] { return signedOn; }, {}, {}};
        millingLinks.rights = rights;
        milling = std::make_unique<StoredMillingService>(std::move(millingLinks), *reader, *reader, *reader);
        StoredTurningService::Links turningLinks{writer, engine, *turningExchange, *reader, *reader};
        turningLinks.rights = rights;
        turning = std::make_unique<StoredTurningService>(turningLinks);
        StoredThermalService::Links thermalLinks{engine, writer, *thermalExchange};
        thermalLinks.rights = rights;
        thermalLinks.dayFolder = scratch.path() + "-days";
        thermal = std::make_unique<StoredThermalService>(thermalLinks, *reader, *reader);
        StoredTappingService::Params tappingParams;
        tappingParams.rights = rights;
        tappingParams.note = [this](const std::string& who, const char* key, const std::string& what) {
            note(who, key, what);
        };
        tapping = std::make_unique<StoredTappingService>(engine, *tapExchange, std::move(tappingParams));
        keeper = std::make_unique<DataKeeper>(DataKeeper::Links{
            writer, scratch.path(), [](const auto& work, const auto& done) { done(work()); }, rights});
        StoredQualityService::Links qualityLinks{
            writer, *reader, *reader, *reader, scratch.path(), [](const auto&, const auto&) {}, {}, rights};
        qualityLinks.recipe = [](ProcessId) { return RecipeHeld{"Bracket", "{}"}; };
        quality = std::make_unique<StoredQualityService>(std::move(qualityLinks));
        gate = std::make_unique<EngineGate>(EngineGate::Links{
            engine, [this] { return signedOn; }, rights,
            [this](const std::string& who, const char* key, const std::string& what) { note(who, key, what); },
            [this](const Sentence& why) { refused = why; }});
        settle();
    }
    ~Shop() {
        gate.reset();
        quality.reset();
        tapping.reset();
        thermal.reset();
        turning.reset();
        milling.reset();
        lots.reset();
        reader.reset();
        writer.stop();
    }
    void openBoring() {
        StoredBoringService::Links links{writer, engine, {}, [] { return LoopMode::Advise; }};
        links.rights = rights;
        links.records = reader.get();
        const BoringLotRequest first{
            "VB-1", "simulator", "Sleeve 50", BoringRecipe{}, "1", 30, boring::EstimatorKind::Kalman, "Kerf"};
        lots = std::make_unique<StoredBoringLots>(links, *reader, first);
        (void)wait([&](const Done& done) { lots->start(done); });
        PartRecord record;
        record.partSequence = 1;
        record.begin_ns = 60'000'000'000LL;
        record.end_ns = 100'000'000'000LL;
        record.schedule = lots->service().view().nextSchedule;
        record.order.lot = reader->activeLot(ProcessId::Boring)->value();
        if (!ring.tryPush(record)) qFatal("ring");
        if (!QTest::qWaitFor([&] { return !lots->service().view().parts.empty(); })) qFatal("no part");
    }
    /// Everything handed over is on the disk.
    void settle() {
        (void)wait([this](const Done& done) {
            writer.submit(AddAudit{"Kerf", "settled", "test", 0, {}, {}, {}},
                          [done](const Result<Receipt>&) { done({}); });
        });
    }
    void note(const std::string& who, const char* key, const std::string& what) {
        writer.submit(AddAudit{who, what, key, 0, {}, {}, {}}, {});
    }
    /// Entries of this author, newest first.
    std::vector<AuditRow> entriesOf(const std::string& author) {
        settle();
        auto all = reader->audit({}, 10'000);
        std::vector<AuditRow> mine;
        for (AuditRow& row : *all) {
            if (row.author == author) mine.push_back(std::move(row));
        }
        return mine;
    }
    template <class Action>
    Result<void> send(const std::string& author, const Action& action) {
        signedOn = author;
        refused = {};
        const std::size_t before = engine.commands.size();
        Command command;
        command.action = action;
        const auto number = gate->send(command);
        if (number.has_value() != (engine.commands.size() > before)) return fail("let through and refused");
        return number ? Result<void>() : Result<void>(tl::unexpected(refused));
    }
    BoreEntry entry(const std::string& author) {
        const BoringServiceView& view = lots->service().view();
        BoreEntry entry;
        entry.part = *view.awaiting;
        entry.depth = view.awaitingDepth;
        entry.diameter_mm = view.targetDiameter_mm;
        entry.author = author;
        entry.confirmed = true;
        return entry;
    }

    Rights rights = [](const std::string& author, Deed deed) -> std::optional<Sentence> {
        const Trust least = permissionOf(deed).least;
        return trustOf(author) >= least ? std::nullopt : std::optional(onlyWho(least));
    };
    std::unique_ptr<StoredBoringLots> lots;
    std::unique_ptr<StoredMillingService> milling;
    std::unique_ptr<StoredTurningService> turning;
    std::unique_ptr<StoredThermalService> thermal;
    std::unique_ptr<StoredTappingService> tapping;
    std::unique_ptr<DataKeeper> keeper;
    std::unique_ptr<StoredQualityService> quality;
    std::unique_ptr<EngineGate> gate;
    std::string signedOn;
    Sentence refused;
};

/// One way to do a deed. `act` answers as the service does.
struct Row {
    Deed deed;
    std::function<Result<void>(Shop&, const std::string& author, const std::string& reason)> act;
    bool recorded{true};  ///< by the service itself; false: by whoever follows it in the status
    std::string but{};    ///< what stands in the way of somebody who may
};

Result<void> said(const StoredTappingService& service, std::uint64_t before) {
    const bool refused = service.view().revision > before && !service.view().reason.empty();
    return refused ? Result<void>(tl::unexpected(service.view().reason)) : Result<void>();
}

Gauge gaugeOfRing() {
    Gauge gauge;
    gauge.identity = "G-07";
    gauge.rangeFrom_mm = 40.0;
    gauge.rangeTo_mm = 60.0;
    gauge.ring_mm = 50.0;
    return gauge;
}

GaugeStudyRecord studyOfRing() {
    GaugeStudyRecord study;
    study.gauge = "G-07";
    study.method = "type1";
    study.tolerance_mm = 0.03;
    for (std::uint32_t trial = 0; trial < 25; ++trial) {
        study.readings.push_back({0, 0, trial, 50.0 + 0.001 * (trial % 3)});
    }
    return study;
}

const std::vector<Row>& rows() {
    using Text = const std::string&;
    static const std::vector<Row> table{
        {Deed::SwitchLoop,
         [](Shop& s, Text who, Text) {
             return s.send(who, SetLoopMode{ProcessId::Milling, LoopMode::Control});
         },
         false},
        {Deed::ReleaseStop, [](Shop& s, Text who, Text) { return s.send(who, ReleaseStop{}); }, false},
        {Deed::BoringDiameter,
         [](Shop& s, Text who, Text) {
             return s.wait([&](const auto& done) { s.lots->service().enter(s.entry(who), done); });
         }},
        {Deed::BoringCorrection,
         [](Shop& s, Text who, Text why) {
             const auto& measured = s.lots->service().view().parts.front().measurements;
             return s.wait([&](const auto& done) {
                 s.lots->service().correct(measured.front().id, measured.front().diameter_mm + 0.001, who, why, done);
             });
         }},
        {Deed::BoringSchedule,
         [](Shop& s, Text who, Text) {
             return s.wait([&](const auto& done) { s.lots->service().acceptSchedule(who, done); });
         }},
        {Deed::BoringChange,
         [](Shop& s, Text who, Text) {
             return s.wait(
                 [&](const auto& done) { s.lots->service().announceChange(BoringChange::Insert, who, done); });
         }},
        {Deed::BoringRecipe,
         [](Shop& s, Text who, Text why) {
             return s.wait([&](const auto& done) {
                 s.lots->saveRecipe(s.lots->partTypes()->front().id, s.lots->standardRecipe(), who, why, done);
             });
         }},
        {Deed::BoringPartType,
         [](Shop& s, Text who, Text) {
             return s.wait([&](const auto& done) {
                 s.lots->addPartType("Sleeve 60", s.lots->standardRecipe(), who, [done](const auto& id) {
                     done(id ? Result<void>() : Result<void>(tl::unexpected(id.error())));
                 });
             });
         }},
        {Deed::BoringLotEnd,
         [](Shop& s, Text who, Text why) { return s.wait([&](const auto& done) { s.lots->close(who, why, done); }); }},
        {Deed::BoringLot,
         [](Shop& s, Text who, Text) {
             BoringLotOrder order;
             order.partType = s.lots->partTypes()->front().id;
             order.name = "2";
             order.author = who;
             return s.wait([&](const auto& done) { s.lots->open(order, done); });
         }},
        {Deed::MillingSetup,
         [](Shop& s, Text who, Text why) {
             MillingSetup setup = s.milling->view().setup;
             setup.overload_N -= 10.0;  // lower is no limit raised
             return s.wait([&](const auto& done) { s.milling->saveSetup(setup, who, why, done); });
         }},
        {Deed::MillingLimits,
         [](Shop& s, Text who, Text why) {
             MillingSetup setup = s.milling->view().setup;
             setup.overload_N = 19'000.0;
             return s.wait([&](const auto& done) { s.milling->saveSetup(setup, who, why, done); });
         }},
        {Deed::MillingBlank,
         [](Shop& s, Text who, Text) {
             const std::array steps{MillingBlankStep{0.0, 1.0}, MillingBlankStep{40.0, 2.0}};
             const auto blank = s.milling->blankOf(steps, 100.0);
             return s.wait([&](const auto& done) { s.milling->saveBlank(*blank, "rail.csv", who, done); });
         }},
        {Deed::MillingPartType,
         [](Shop& s, Text who, Text) {
             return s.wait([&](const auto& done) { s.milling->choosePartType("Bracket", who, done); });
         }},
        {Deed::MillingTool,
         [](Shop& s, Text who, Text) { return s.wait([&](const auto& done) { s.milling->newTool(who, done); }); }},
        {Deed::MillingLaw,
         [](Shop& s, Text who, Text) {
             const auto sent = s.send(who, SetMillingLaw{MillingLaw::Constant});
             if (sent) {  // the engine shows it, the service writes it down
                 MillingStatus& now = s.engine.fake.milling;
                 s.engine.fake.cycle = 1;
                 now.setup = s.milling->view().setup.revision;
                 now.blank = now.setup;
                 now.law = MillingLaw::Constant;
                 now.reference_N = s.milling->view().setup.reference_N;
                 s.milling->poll();
             }
             return sent;
         }},
        {Deed::TurningSetup,
         [](Shop& s, Text who, Text why) {
             TurningSetup setup = s.turning->view().setup;
             setup.trimAuthority_um = 0.5;
             return s.wait([&](const auto& done) { s.turning->loadSetup(setup, who, why, done); });
         }},
        {Deed::TurningLimits,
         [](Shop& s, Text who, Text why) {
             TurningSetup setup = s.turning->view().setup;
             setup.trimAuthority_um = 2.0;
             return s.wait([&](const auto& done) { s.turning->loadSetup(setup, who, why, done); });
         }},
        {Deed::TurningLaw,
         [](Shop& s, Text who, Text) {
             return s.wait([&](const auto& done) { s.turning->setController(TurningController::Pi, who, done); });
         }},
        {Deed::TurningMemory,
         [](Shop& s, Text who, Text why) {
             return s.wait([&](const auto& done) { s.turning->leaveOut(12, true, who, why, done); });
         },
         false, "There is no such part."},
        {Deed::ThermalModel,
         [](Shop& s, Text who, Text) {
             if (s.thermal->view().training.state != TrainingState::Ready && !s.signedOn.empty()) {
                 s.thermal->cancelTraining();
                 (void)QTest::qWaitFor([&] {
                     s.thermal->poll();
                     return s.thermal->view().training.state != TrainingState::Running;
                 });
                 (void)s.thermal->train("regression", {"built-in:0"});
                 (void)QTest::qWaitFor(
                     [&] {
                         s.thermal->poll();
                         return s.thermal->view().training.state == TrainingState::Ready;
                     },
                     60'000);
             }
             s.signedOn = "somebody";
             return s.thermal->goLive(who);
         }},
        {Deed::ThermalLimits,
         [](Shop& s, Text who, Text why) {
             ThermalSetup setup = s.thermal->view().setup;
             setup.maxShift_um = 150.0;
             return s.wait([&](const auto& done) { s.thermal->changeSetup(setup, who, why, done); });
         }},
        {Deed::ThermalSession, [](Shop& s, Text who, Text) { return s.thermal->beginSession(who); }, false},
        {Deed::ThermalReference, [](Shop& s, Text who, Text) { return s.send(who, TakeThermalReference{true}); }},
        {Deed::ThermalMemory,
         [](Shop& s, Text who, Text why) {
             return s.wait([&](const auto& done) { s.thermal->leaveOut("file:no.csv", true, who, why, done); });
         },
         false, "One of the days is not there any more."},
        {Deed::TappingJob, [](Shop& s, Text who, Text) { return s.tapping->load({}, who); }},
        {Deed::MillingMemory,
         [](Shop& s, Text who, Text why) {
             return s.wait([&](const auto& done) { s.milling->leaveOut(12, true, who, why, done); });
         },
         false, "There is no such tool."},
        {Deed::TappingMemory, [](Shop& s, Text who, Text why) { return s.tapping->leaveOut(true, who, why); }, false,
         "This job began from no stored tuning."},
        {Deed::TappingTuning, [](Shop& s, Text who, Text) { return s.tapping->begin(who, false); }},
        {Deed::LimitFar,
         [](Shop& s, Text who, Text why) {
             MillingSetup setup = s.milling->view().setup;
             setup.overload_N *= 2.0;
             return s.wait([&](const auto& done) { s.milling->saveSetup(setup, who, why, done); });
         }},
        {Deed::DataRestore,
         [](Shop& s, Text who, Text why) {
             return s.wait([&](const auto& done) { s.keeper->restore("/no/such.db", who, why, done); });
         },
         false, "There is no such file."},
        {Deed::PersonRemove,
         [](Shop& s, Text who, Text) {
             s.writer.submit(SaveAccount{"Choi", "operator", {}, "Kerf", {}}, {});
             return s.wait([&](const auto& done) { s.keeper->removePerson("Choi", who, done); });
         }},
        {Deed::QualityDecision,
         [](Shop& s, Text who, Text) {
             return s.wait([&](const auto& done) { s.quality->dispose(1, "scrapped", who, done); });
         }},
        {Deed::QualityLimits,
         [](Shop& s, Text who, Text why) {
             return s.wait([&](const auto& done) { s.quality->setLimits(ProcessId::Milling, {}, who, why, done); });
         }},
        {Deed::QualityGauge,
         [](Shop& s, Text who, Text) {
             return s.wait([&](const auto& done) { s.quality->saveGauge(gaugeOfRing(), who, done); });
         }},
        {Deed::QualityStudy,
         [](Shop& s, Text who, Text) {
             return s.wait([&](const auto& done) { s.quality->saveStudy(studyOfRing(), who, done); });
         }},
        {Deed::QualityFiles,
         [](Shop& s, Text who, Text) {
             return s.wait([&](const auto& done) { s.quality->setDfqFiles({}, who, done); });
         }},
    };
    return table;
}

}  // namespace

/// Of a process that has no row in the table of deeds.
struct SetBrush {
    static constexpr ProcessId kProcess{5};
};

/// Who may do what, and what is written down: every deed of the table, at the service that does it.
class TestRights : public QObject {
    Q_OBJECT
 private slots:
    void everyDeedHasARow() {
        // Their services live in the console: tst_sensors_page; ShiftDesk::add asks for all of the shift's.
        // ProcessSetup is for processes that have no row: aProcessWithoutARowIsASetters.
        std::set<Deed> tested{Deed::SensorPlace, Deed::ShiftWords, Deed::ToolChange, Deed::ToolLife,
                              Deed::ProcessSetup};
        for (const Row& row : rows())
            tested.insert(row.deed);
        QCOMPARE(tested.size(), kDeedCount);
        std::set<std::string> keys;
        for (const Permission& one : kPermissions) {
            QVERIFY2(keys.insert(one.key).second, one.key);
            QVERIFY(*one.name != '\0');
        }
    }
    void aProcessWithoutARowIsASetters() {
        QVERIFY(DeedOf{}(SetBrush{}) == Deed::ProcessSetup);
        QVERIFY(permissionOf(Deed::ProcessSetup).least == Trust::Setter);
        QVERIFY(DeedOf{}(LoadMillingSetup{}) == Deed::MillingLimits);
        QVERIFY(!DeedOf{}(AbortTap{}).has_value());
    }
    void whoMayAndWhatIsKept() {
        Shop shop;
        for (const Row& row : rows()) {
            const Permission& permission = permissionOf(row.deed);
            const auto refusedWith = [&](const std::string& author, const std::string& reason) {
                const auto result = row.act(shop, author, reason);
                return result ? std::string("done") : result.error().english();
            };
            const std::string nobody = refusedWith("", kReason);
            QVERIFY2(nobody.starts_with("Sign on first"), (std::string(permission.key) + ": " + nobody).c_str());
            for (const std::string less : {"Kim", "Lee"}) {
                if (trustOf(less) < permission.least) {
                    const std::size_t before = shop.entriesOf(less).size();
                    QVERIFY2(refusedWith(less, kReason) == onlyWho(permission.least).english(),
                             (std::string(permission.key) + ": " + less).c_str());
                    QCOMPARE(shop.entriesOf(less).size(), before);
                }
            }
            const std::string who = permission.least == Trust::Engineer ? "Park"
                                    : permission.least == Trust::Setter ? "Lee"
                                                                        : "Kim";
            if (permission.reason) {
                QCOMPARE(refusedWith(who, " "), std::string("Give a reason: it is kept with the change."));
            }
            const std::size_t before = shop.entriesOf(who).size();
            const std::string result = refusedWith(who, kReason);
            QVERIFY2(result == (row.but.empty() ? "done" : row.but),
                     (std::string(permission.key) + ": " + result).c_str());
            const auto after = shop.entriesOf(who);
            if (row.recorded) {
                QVERIFY2(after.size() > before, permission.key);
                if (permission.reason) {
                    QCOMPARE(after.front().reason, std::string(kReason));
                }
            }
        }
    }
    void tuningsAreDecidedBySetters() {
        Shop shop;
        QVERIFY(shop.tapping->load({}, "Lee").has_value());
        QVERIFY(shop.tapping->begin("Lee", false).has_value());
        const auto refused = [&](const auto& act) {
            const std::uint64_t before = shop.tapping->view().revision;
            act();
            return !said(*shop.tapping, before).has_value();
        };
        QVERIFY(refused([&] { shop.tapping->accept("Kim"); }));
        QVERIFY(refused([&] { shop.tapping->rollBack("Kim"); }));
        QVERIFY(refused([&] { shop.tapping->oneMore("Kim"); }));
        QVERIFY(refused([&] { shop.tapping->setAutomatic(true, "Kim"); }));
        QVERIFY(!shop.tapping->view().automatic);
    }
    void safetyNeedsNoName() {
        Shop shop;
        QVERIFY(shop.send("", ReleaseHold{}).has_value());
        QVERIFY(shop.send("", AbortTap{}).has_value());
        QVERIFY(shop.send("", RecoverTap{}).has_value());
        QVERIFY(shop.send("", StopWarmUp{}).has_value());
        shop.gate->holdAll();
        QCOMPARE(shop.engine.holds.load(), 1);
        // What only services send is refused from a page: it has no reason to give.
        QVERIFY(!shop.send("Park", LoadMillingSetup{}).has_value());
        QVERIFY(!shop.send("Park", LoadThermalSetup{}).has_value());
    }
};
QTEST_GUILESS_MAIN(TestRights)
#include "tst_rights.moc"
