// SPDX-License-Identifier: GPL-3.0-or-later
#include <QCoreApplication>
#include <QTest>

#include "app/service/turning/turning_records.h"
#include "app/service/turning/turning_service.h"
#include "db/readers/database_reader.h"
#include "db/writer_thread.h"
#include "engine/core/random.h"
#include "engine/process/turning/spectrum.h"
#include "engine/process/turning/turning_setup.h"
#include "tests/db/db_test_support.h"
#include "tests/support/fake_engine.h"
#include "tests/support/fake_turning_service.h"

using namespace kerf;
using kerf::test::FakeEngine;
using kerf::test::FakeTurningService;

namespace {

constexpr db::WriterThread::Options kQuick{.queueCapacity = 64, .ringPoll_ms = 1, .retry_ms = 2};

/// Runs the event loop until it has happened; the test's own time limit ends a wait for ever.
template <class Condition>
void waitUntil(const Condition& happened) {
    while (!happened()) {
        QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents);
    }
}

}  // namespace

/// The service on a real database with a fake engine: what is stored, sent, compared, and found again.
class TestTurningService : public QObject {
    Q_OBJECT
 private slots:
    void init() {
        m_folder = std::make_unique<test::ScratchDatabase>();
        m_engine = std::make_unique<FakeEngine>();
        m_engine->loop(ProcessId::Turning).fitted = true;
        m_exchange = std::make_unique<TurningExchange>();
        open();
    }
    void cleanup() { close(); }

    void theFirstSetupReachesTheEngine() {
        m_service->poll();
        QCOMPARE(sent<LoadTurningSetup>().setup.revision, 1U);
        QCOMPARE(sent<SetTurningController>().controller, TurningController::Tones);
        const std::size_t before = m_engine->commands.size();
        m_service->poll();
        QCOMPARE(m_engine->commands.size(), before);  // once
    }
    void aFullRingIsTriedAgain() {
        m_engine->ringFull = true;
        m_service->poll();
        QVERIFY(m_engine->commands.empty());
        m_engine->ringFull = false;
        m_service->poll();
        QCOMPARE(sent<LoadTurningSetup>().setup.revision, 1U);
    }
    void aSetupIsStoredThenSentAndFoundAgain() {
        TurningSetup setup = m_service->view().setup;
        setup.depth_um = 4.5;
        setup.knownTones_Hz = {60.0, 181.5};
        setup.knownToneCount = 2;
        QVERIFY(load(setup, "Kim"));
        QCOMPARE(m_service->view().setup.depth_um, 4.5);
        QCOMPARE(sent<LoadTurningSetup>().setup.depth_um, 4.5);
        QCOMPARE(m_service->view().blind.tones.size(), std::size_t{2});
        QVERIFY(choose(TurningController::Pi));
        close();
        open();
        QCOMPARE(m_service->view().setup.depth_um, 4.5);
        QCOMPARE(m_service->view().setup.revision, 2U);
        QCOMPARE(static_cast<int>(m_service->view().setup.knownToneCount), 2);
        QCOMPARE(m_service->view().setup.knownTones_Hz[1], 181.5);
        QCOMPARE(m_service->view().controller, TurningController::Pi);
        m_service->poll();
        QCOMPARE(sent<LoadTurningSetup>().setup.depth_um, 4.5);
    }
    void whatCannotBeCutOrHasNoNameChangesNothing() {
        TurningSetup setup = m_service->view().setup;
        setup.depth_um = 900.0;
        QVERIFY(!load(setup, "Kim"));
        setup.depth_um = 5.0;
        QVERIFY(!load(setup, ""));
        QCOMPARE(m_service->view().setup.depth_um, 6.0);
        QCOMPARE(m_service->view().setup.revision, 1U);
    }
    void partsAreArchivedComparedAndFoundAgain() {
        finishPart(1, false);
        QVERIFY(!m_service->view().comparison.has_value());
        finishPart(2, true);
        QVERIFY(m_service->view().comparison.has_value());
        const double rms_percent = m_service->view().comparison->rms_percent();
        QVERIFY(rms_percent > 90.0);
        const TurningPartView before = m_service->view().parts.back();
        QVERIFY(turning::toneAmplitude(before.spectrum.untreated_um, before.spectrum.step_Hz, 120.0) > 0.55);
        QCOMPARE(before.force.size(), std::size_t{1});
        close();
        open();
        QCOMPARE(m_service->view().parts.size(), std::size_t{2});
        const TurningPartView& after = m_service->view().parts.back();
        QCOMPARE(after.id, before.id);
        QCOMPARE(after.record.steadyRms_um, before.record.steadyRms_um);
        QCOMPARE(after.record.setup.spindleSpeed_rpm, before.record.setup.spindleSpeed_rpm);
        QCOMPARE(after.record.tones[2].blind, before.record.tones[2].blind);
        QCOMPARE(after.record.identification.half95, before.record.identification.half95);
        QCOMPARE(after.spectrum.treated_um.size(), before.spectrum.treated_um.size());
        QCOMPARE(after.force.front().mean_N, before.force.front().mean_N);
        QCOMPARE(m_service->view().comparison->rms_percent(), rms_percent);
    }
    void theNextPartBeginsFromTheStoredOnes() {
        QVERIFY(m_exchange->recall.refresh());
        QVERIFY(!m_exchange->recall.value().processKnown);
        const auto sure = [](TurningRecord& r) {
            r.identification.sure = true;
            r.lawProcess = {0.87, 0.65, -0.62};
        };
        finishPart(1, true, sure);
        QVERIFY(m_exchange->recall.refresh());
        QVERIFY(!m_exchange->recall.value().processKnown);  // the loop has it itself
        finishPart(2, true, sure);
        close();
        m_exchange = std::make_unique<TurningExchange>();
        open();  // a restart
        QVERIFY(m_exchange->recall.refresh());
        const TurningRecall recall = m_exchange->recall.value();
        QVERIFY(recall.processKnown);
        QCOMPARE(recall.process.b0, 0.65);
        // Another cut has no past here; the first one has it again.
        TurningSetup setup = m_service->view().setup;
        setup.depth_um = 3.0;
        QVERIFY(load(setup, "Kim"));
        QVERIFY(m_exchange->recall.refresh());
        QVERIFY(!m_exchange->recall.value().processKnown);
        setup.depth_um = 6.0;
        QVERIFY(load(setup, "Kim"));
        QVERIFY(m_exchange->recall.refresh());
        QVERIFY(m_exchange->recall.value().processKnown);
        // A past that contradicts itself is no guide; a part that left the loop does not count.
        finishPart(3, true, [&](TurningRecord& r) {
            sure(r);
            r.lawProcess.b0 *= 2.0;
        });
        finishPart(4, true, [&](TurningRecord& r) {
            sure(r);
            r.leftLoop = true;
        });
        close();
        m_exchange = std::make_unique<TurningExchange>();
        open();
        QVERIFY(m_exchange->recall.refresh());
        QVERIFY(!m_exchange->recall.value().processKnown);
    }
    void aPartIsLeftOutWithAReasonAndWhatFollowsBeginsFromTheOthers() {
        const auto sure = [](double b0) {
            return [b0](TurningRecord& r) {
                r.identification.sure = true;
                r.lawProcess = {0.87, b0, -0.62};
            };
        };
        finishPart(1, true, sure(0.65));
        finishPart(2, true, sure(0.66));
        m_engine->fake.partSequence = 2;
        QCOMPARE(m_service->view().memory.part.value_or(0), m_service->view().parts.back().number);
        QCOMPARE(m_service->view().memory.counted, 2U);
        const std::int64_t newest = m_service->view().parts.back().id;
        const std::int64_t oldest = m_service->view().parts.front().id;
        QVERIFY(leaveOut(newest, true, "Kim", "").contains(QStringLiteral("reason")));
        QVERIFY(!leaveOut(newest + 7, true, "Kim", "bar").isEmpty());
        m_engine->fake.turning.stage = TurningStage::Cutting;
        QVERIFY(!leaveOut(newest, true, "Kim", "chip").isEmpty());
        m_engine->fake.turning.stage = TurningStage::Idle;
        (void)m_exchange->recall.refresh();
        QVERIFY(!m_exchange->recall.value().processKnown);  // the loop has it itself
        // Left out: the loop, which went by part 2, begins the next one from part 1.
        QCOMPARE(leaveOut(newest, true, "Kim", "chip"), QString());
        QVERIFY(m_exchange->recall.refresh());
        QVERIFY(m_exchange->recall.value().processKnown);
        QCOMPARE(m_exchange->recall.value().process.b0, 0.65);
        QCOMPARE(m_service->view().parts.back().leftOutReason, std::string("chip"));
        // Nothing is left: the assumed process.
        QCOMPARE(leaveOut(oldest, true, "Kim", "other bar"), QString());
        QVERIFY(m_exchange->recall.refresh());
        QVERIFY(!m_exchange->recall.value().processKnown && m_exchange->recall.value().assumed);
        // A part of before that is stored late does not undo it; the one that began from it ends it.
        finishPart(2, true, sure(0.9));
        QVERIFY(m_exchange->recall.refresh());
        QVERIFY(m_exchange->recall.value().processKnown && m_exchange->recall.value().process.b0 == 0.9);
        finishPart(3, true, sure(0.68));
        QVERIFY(m_exchange->recall.refresh());
        QVERIFY(!m_exchange->recall.value().processKnown && !m_exchange->recall.value().assumed);
        // After a restart it is as if these parts had not been cut; taken in again, as if nothing had been said.
        QCOMPARE(leaveOut(m_service->view().parts.back().id, true, "Kim", "chip"), QString());
        QCOMPARE(leaveOut(m_service->view().parts[2].id, true, "Kim", "chip"), QString());
        QCOMPARE(leaveOut(newest, false, "Kim", "no chip"), QString());
        close();
        m_exchange = std::make_unique<TurningExchange>();
        open();
        QVERIFY(m_exchange->recall.refresh());
        QVERIFY(m_exchange->recall.value().processKnown);
        QCOMPARE(m_exchange->recall.value().process.b0, 0.66);
        QCOMPARE(m_service->view().memory.counted, 1U);
        QVERIFY(m_service->view().parts.front().leftOut);
        QCOMPARE(m_service->view().parts.front().leftOutAuthor, std::string("Kim"));
        QVERIFY(!m_service->view().parts[1].leftOut);
    }
    void aPartOfAnotherCutOrOneThatLeftTheLoopIsNotCompared() {
        finishPart(1, false, [](TurningRecord& r) { r.setup.depth_um = 3.0; });
        finishPart(2, true);
        QVERIFY(!m_service->view().comparison.has_value());
        finishPart(3, false);
        QCOMPARE(m_service->view().comparison->openPart, m_service->view().parts.back().number);
        finishPart(4, true, [](TurningRecord& r) { r.leftLoop = true; });
        QCOMPARE(m_service->view().comparison->closedPart, m_service->view().parts[1].number);
    }
    void marginsFollowTheLawAndTheProcess() {
        TurningStatus& turning = m_engine->fake.turning;
        turning.stage = TurningStage::Cutting;
        turning.controller = TurningController::Tones;
        m_service->poll();
        waitForMargins();
        QVERIFY(!m_service->view().margins.known);  // no tone: nothing acts
        turning.tones[0] = {120.0, 0.6, 0.15, false, 0.005};
        turning.toneCount = 1;
        m_service->poll();
        waitForMargins();
        QVERIFY(!m_service->view().margins.known);  // a tone is seen, but nothing acts on it yet
        turning.acting = true;
        turning.toneShare = 1.0;
        m_service->poll();
        waitForMargins();
        const TurningMargins assumed = m_service->view().margins;
        QVERIFY(assumed.known && !assumed.identified);
        QVERIFY(std::abs(assumed.delay_samples.value_or(0.0) - 10.4) < 0.6);
        turning.identification.sure = true;
        turning.identification.value = {0.8725, 0.747, -0.7164};
        turning.identification.half95 = {0.005, 0.003, 0.003};
        m_service->poll();
        waitForMargins();
        const TurningMargins found = m_service->view().margins;
        QVERIFY(found.identified);
        QVERIFY(found.phase_deg < assumed.phase_deg);  // the worst of the whole box
        QVERIFY(found.phase_deg > 60.0);
        turning.underToneWeights[0] = 0.8;  // the prediction joins in: these are the margins of the whole law
        m_service->poll();
        waitForMargins();
        QVERIFY(m_service->view().margins.phase_deg < found.phase_deg - 5.0);
        turning.controller = TurningController::Pi;
        m_service->poll();
        waitForMargins();
        QVERIFY(m_service->view().margins.gain.value_or(0.0) < 2.01);
    }
    void blindTonesFollowSpeedAndFoundTones() {
        QVERIFY(!m_service->view().blind.anyBlind);  // no tone is known from the start
        TurningSetup setup = m_service->view().setup;
        setup.knownTones_Hz[0] = 86.0;  // five times a revolution at 1032 rpm
        setup.knownToneCount = 1;
        QVERIFY(load(setup, "Kim"));
        QVERIFY(m_service->view().blind.anyBlind);
        QVERIFY(m_service->view().blind.suggestedSpeed_rpm.has_value());
        setup.spindleSpeed_rpm = *m_service->view().blind.suggestedSpeed_rpm;
        QVERIFY(load(setup, "Kim"));
        QVERIFY(!m_service->view().blind.anyBlind);
        m_engine->fake.turning.tones[0] = {2.0 * setup.spindleSpeed_rpm / 60.0, 0.3, 0.0, true, 0.005};
        m_engine->fake.turning.toneCount = 1;
        m_service->poll();
        QVERIFY(m_service->view().blind.anyBlind);
        QVERIFY(m_service->view().blind.tones.back().found);
    }
    void recordsOfAnotherVersionDoNotExist() {
        QVERIFY(!turningRecipeFrom("{", TurningController::Open).has_value());
        QVERIFY(!turningRecipeFrom("{\"revision\": 3, \"turning.feed_um_per_rev\": \"fast\"}", TurningController::Open)
                     .has_value());
        QVERIFY(!turningRecipeFrom("[3]", TurningController::Open).has_value());
        // A key that was not there yet has its default; the others stay.
        const auto older =
            turningRecipeFrom("{\"revision\": 3, \"turning.feed_um_per_rev\": 4.5}", TurningController::Open);
        QVERIFY(older && older->setup.revision == 3 && older->setup.feed_umPerRev == 4.5);
        QCOMPARE(older->controller, TurningController::Open);  // the law it says nothing of stays
        QCOMPARE(older->setup.trimAuthority_um, turning::setupSpecs().back().fallback);
        QVERIFY(!turningPartFrom("{\"part\": \"x\"}").has_value());
        QVERIFY(!turningControllerFrom("{\"controller\": \"magic\"}").has_value());
        QVERIFY(!turningRecipeFrom("{\"turning.law\": \"magic\"}", {}));
        TurningSetup bad;
        bad.revision = 2;
        bad.trimAuthority_um = 99.0;
        QVERIFY(!turningRecipeFrom(turningRecipeJson({bad, TurningController::Pi}), {}).has_value());
    }

 private:
    void open() {
        m_writer = std::make_unique<db::WriterThread>(m_folder->path(), &m_parts, kQuick);
        QVERIFY(m_writer->start().has_value());
        m_reader = std::move(*db::DatabaseReader::open(m_folder->path()));
        m_service = std::make_unique<StoredTurningService>(
            StoredTurningService::Links{*m_writer, *m_engine, *m_exchange, *m_reader, *m_reader});
    }
    void close() {
        (void)m_writer->stop();
        m_service.reset();
        m_reader.reset();
        m_writer.reset();
        m_engine->commands.clear();
    }
    template <class Action>
    [[nodiscard]] Action sent() const {
        Action last{};
        for (const Command& command : m_engine->commands) {
            if (const auto* action = std::get_if<Action>(&command.action)) {
                last = *action;
            }
        }
        return last;
    }
    bool load(const TurningSetup& setup, const char* author) {
        std::optional<bool> done;
        m_service->loadSetup(setup, author, "drawing",
                             [&done](const Result<void>& result) { done = result.has_value(); });
        waitUntil([&done] { return done.has_value(); });
        return *done;
    }
    bool choose(TurningController controller) {
        std::optional<bool> done;
        m_service->setController(controller, "Kim", [&done](const Result<void>& result) { done = result.has_value(); });
        waitUntil([&done] { return done.has_value(); });
        return *done;
    }
    /// What it answered; empty: done.
    QString leaveOut(std::int64_t part, bool out, const char* author, const char* reason) {
        std::optional<QString> answer;
        m_service->leaveOut(part, out, author, reason, [&answer](const Result<void>& done) {
            answer = done ? QString() : QString::fromStdString(done.error().english());
        });
        waitUntil([&answer] { return answer.has_value(); });
        return *answer;
    }
    void waitForMargins() {
        const std::uint64_t before = m_service->view().revision;
        QTRY_VERIFY((m_service->poll(), m_service->view().revision > before));
    }
    /// A part as the loop ends it: surfaces and force in the exchange, its record in the ring.
    void finishPart(std::uint32_t sequence, bool controlled, const std::function<void(TurningRecord&)>& change = {}) {
        Random random(sequence);
        for (std::uint32_t number = 1; number <= 2; ++number) {
            TurningSurface& surface = m_exchange->surfaces.writeSlot();
            surface.partSequence = sequence;
            surface.number = number;
            surface.count = TurningSurface::kPoints;
            for (std::size_t k = 0; k < TurningSurface::kPoints; ++k) {
                const double tone = 0.6 * std::sin(2.0 * 3.14159265358979 * 120.0 * static_cast<double>(k) / 1250.0);
                surface.untreated_um[k] = static_cast<float>(tone + 0.02 * random.gauss());
                surface.treated_um[k] = static_cast<float>(controlled ? 0.02 * random.gauss() : tone);
            }
            m_exchange->surfaces.publish();
            m_service->poll();
        }
        TurningForceTrace& trace = m_exchange->traces.writeSlot();
        trace = {};
        trace.partSequence = sequence;
        trace.samples[100] = 10;
        trace.low_N[100] = 1.2F;
        trace.mean_N[100] = 1.44F;
        trace.high_N[100] = 1.7F;
        m_exchange->traces.publish();
        PartRecord part;
        part.process = ProcessId::Turning;
        part.partSequence = sequence;
        part.turning = FakeTurningService().part(sequence, controlled).record;
        if (change) {
            change(part.turning);
        }
        const std::size_t before = m_service->view().parts.size();
        QVERIFY(m_parts.tryPush(part));
        waitUntil([&] { return m_service->view().parts.size() > before; });
        // The archive's row is on its way; the next command is behind it.
        QVERIFY(choose(TurningController::Tones));
    }

    std::unique_ptr<test::ScratchDatabase> m_folder;
    SpscRing<PartRecord> m_parts{64};
    std::unique_ptr<FakeEngine> m_engine;
    std::unique_ptr<TurningExchange> m_exchange;
    std::unique_ptr<db::WriterThread> m_writer;
    std::unique_ptr<db::DatabaseReader> m_reader;
    std::unique_ptr<StoredTurningService> m_service;
};
QTEST_GUILESS_MAIN(TestTurningService)
#include "tst_turning_service.moc"
