// SPDX-License-Identifier: GPL-3.0-or-later
#include <QSignalSpy>
#include <QTest>

#include "tests/support/fake_engine.h"
#include "ui/link/engine_client.h"
#include "ui/link/texts.h"

using namespace kerf;
using namespace kerf::ui;

class TestEngineClient : public QObject {
    Q_OBJECT
 private slots:
    void aTickTakesABoundedNumberOfSamples() {
        test::FakeEngine engine;
        engine.samples.assign(3 * EngineClient::kSamplesPerTick / 2, Sample{});
        EngineClient client(engine);
        std::vector<std::size_t> counts;
        connect(&client, &EngineClient::samplesArrived, this,
                [&counts](std::span<const Sample> samples) { counts.push_back(samples.size()); });
        client.tick();
        client.tick();
        client.tick();
        QCOMPARE(counts, (std::vector<std::size_t>{EngineClient::kSamplesPerTick, EngineClient::kSamplesPerTick / 2}));
    }
    void aTickTakesABoundedNumberOfAlarms() {
        test::FakeEngine engine;
        engine.alarms.resize(EngineClient::kAlarmsPerTick + 5);
        EngineClient client(engine);
        int alarms = 0;
        connect(&client, &EngineClient::alarmArrived, this, [&alarms] { ++alarms; });
        client.tick();
        QCOMPARE(alarms, EngineClient::kAlarmsPerTick);
        client.tick();
        QCOMPARE(alarms, EngineClient::kAlarmsPerTick + 5);
    }
    void theTimerTicks() {
        test::FakeEngine engine;
        EngineClient client(engine);
        int ticks = 0;
        connect(&client, &EngineClient::statusChanged, this, [&ticks] { ++ticks; });
        client.start();
        QTRY_VERIFY(ticks > 2);
    }
    void aFullRingIsToldToTheOperator() {
        test::FakeEngine engine;
        engine.ringFull = true;
        EngineClient client(engine);
        QString told;
        connect(&client, &EngineClient::refused, this, [&told](const Sentence& why) { told = sentenceText(why); });
        QVERIFY(!client.sendAction(ReleaseHold{}));
        QVERIFY(!told.isEmpty());
    }
    void aRefusalReachesTheOperatorOnce() {
        test::FakeEngine engine;
        engine.refuseWith = Sentence("The spindle is at %1 mm.", SentenceArg(25.4, 2));
        EngineClient client(engine);
        std::vector<QString> told;
        connect(&client, &EngineClient::refused, this, [&told](const Sentence& why) {
            told.push_back(sentenceText(why, UnitSystem(LengthUnit::Inch, TemperatureUnit::Celsius)));
        });
        QVERIFY(client.sendAction(StartPart{}));
        client.tick();
        client.tick();
        QCOMPARE(told.size(), std::size_t{1});
        QCOMPARE(told.front(), QStringLiteral("The spindle is at 1.0000\u00a0in."));
    }
    void everyRefusalBetweenTwoTicksIsTold() {
        test::FakeEngine engine;
        EngineClient client(engine);
        int refusals = 0;
        connect(&client, &EngineClient::refused, this, [&refusals] { ++refusals; });
        engine.refuseWith = Sentence("no");
        QVERIFY(client.sendAction(StartPart{}));
        QVERIFY(client.sendAction(StartPart{}));
        engine.refuseWith = Sentence();
        QVERIFY(client.sendAction(ReleaseHold{}));
        client.tick();
        QCOMPARE(refusals, 2);
    }
    void anAcceptedCommandIsNotARefusal() {
        test::FakeEngine engine;
        EngineClient client(engine);
        int refusals = 0;
        std::uint32_t done = 0;
        connect(&client, &EngineClient::refused, this, [&refusals] { ++refusals; });
        connect(&client, &EngineClient::accepted, this, [&done](std::uint32_t number) { done = number; });
        QVERIFY(client.sendAction(SetLoopMode{ProcessId::Boring, LoopMode::Control}));
        client.tick();
        QCOMPARE(refusals, 0);
        QCOMPARE(done, 1U);
    }
    void sentencesFillInNamesAndNumbers() {
        QCOMPARE(sentenceText(Sentence("Thermocouple %1 reads %2 degC", SentenceArg("HL7"), SentenceArg(21.04, 1))),
                 QStringLiteral("Thermocouple HL7 reads 21.0\u00a0°C"));
        QCOMPARE(sentenceText(Sentence("100 % of %1", SentenceArg(3.0, 0))), QStringLiteral("100 % of 3"));
        QCOMPARE(sentenceText(Sentence("%1 mmHg", SentenceArg(3.0, 0))), QStringLiteral("3 mmHg"));
        QVERIFY(sentenceText(Sentence()).isEmpty());
    }
    void anUnknownAlarmSaysSo() {
        const AlarmText text = alarmText(nullptr, 777);
        QVERIFY(text.title.contains(QStringLiteral("777")));
        QVERIFY(!text.action.isEmpty());
    }
};

QTEST_GUILESS_MAIN(TestEngineClient)
#include "tst_engine_client.moc"
