// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>
#include <bit>

#include "app/sensors/channel_judge.h"
#include "engine/core/random.h"

using namespace kerf;
using namespace kerf::sensors;

namespace {

constexpr std::int64_t kSecond_ns = 1'000'000'000;

Channel channelOf(RegisterType type, double scale = 0.1) {
    Channel channel;
    channel.name = "T00";
    channel.type = type;
    channel.scale = scale;
    return channel;
}

std::array<std::uint16_t, 2> words(float value, bool swapped) {
    const auto bits = std::bit_cast<std::uint32_t>(value);
    const auto high = static_cast<std::uint16_t>(bits >> 16U);
    const auto low = static_cast<std::uint16_t>(bits & 0xFFFFU);
    return swapped ? std::array{low, high} : std::array{high, low};
}

/// A judge and the seconds that pass.
struct Bench {
    explicit Bench(Channel c) : channel(std::move(c)), judge(channel) {}
    const ChannelValue& take(std::int32_t bits, std::optional<std::uint16_t> status = std::nullopt) {
        const std::array<std::uint16_t, 2> registers{static_cast<std::uint16_t>(bits), 0};
        judge.take(std::span(registers).first(1), status, now_ns += kSecond_ns);
        return judge.value();
    }
    const ChannelValue& takeFloat(float value, bool swapped) {
        judge.take(words(value, swapped), std::nullopt, now_ns += kSecond_ns);
        return judge.value();
    }
    Channel channel;
    ChannelJudge judge;
    std::int64_t now_ns{0};
};

}  // namespace

class TestChannelJudge : public QObject {
    Q_OBJECT
 private slots:
    void typesAreReadAsTheFileSays() {
        const std::array<std::uint16_t, 2> registers{0xFFFE, 0x0001};
        const auto raw = [&](RegisterType type, WordOrder order) {
            Channel channel = channelOf(type);
            channel.words = order;
            return rawValue(channel, std::span(registers).first(static_cast<std::size_t>(registersOf(type)))).raw;
        };
        QCOMPARE(raw(RegisterType::Int16, WordOrder::Big), -2.0);
        QCOMPARE(raw(RegisterType::Uint16, WordOrder::Big), 65534.0);
        QCOMPARE(raw(RegisterType::Int32, WordOrder::Big), -131071.0);
        QCOMPARE(raw(RegisterType::Uint32, WordOrder::Big), 4294836225.0);
        QCOMPARE(raw(RegisterType::Uint32, WordOrder::Little), 131070.0);
        Channel channel = channelOf(RegisterType::Float32);
        QCOMPARE(rawValue(channel, words(21.5F, false)).raw, 21.5);
        channel.words = WordOrder::Little;
        QCOMPARE(rawValue(channel, words(21.5F, true)).raw, 21.5);
    }
    void scaleAndOffsetBringItToDegrees() {
        Channel channel = channelOf(RegisterType::Uint16, 0.02);
        channel.offset = -273.15;
        Bench bench(channel);
        QVERIFY(std::abs(bench.take(14733).value - 21.51) < 1e-9);
        QVERIFY(bench.judge.value().quality == Quality::Good);
    }
    void codesOfABrokenThermocoupleAreNoNumbers_data() {
        QTest::addColumn<int>("code");
        for (const int code : {32767, -32768, 9999}) {
            QTest::addRow("%d", code) << code;
        }
    }
    void codesOfABrokenThermocoupleAreNoNumbers() {
        QFETCH(int, code);
        Channel channel = channelOf(RegisterType::Int16);
        channel.invalid = {9999.0};  // the ends of the type need not be named
        Bench bench(channel);
        QVERIFY(bench.take(215).quality == Quality::Good);
        QVERIFY(bench.take(code).quality == Quality::Bad);
        QVERIFY(bench.judge.value().cause == Cause::InvalidCode);
        QCOMPARE(bench.judge.value().value, 21.5);  // the last good one, with its own time
        QCOMPARE(bench.judge.value().stamp_ns, kSecond_ns);
        QVERIFY(bench.take(216).quality == Quality::Good);  // back at once
    }
    void aBadStatusIsHeeded() {
        Channel channel = channelOf(RegisterType::Int16);
        channel.status = StatusRegister{4, 100, {1, -2}};
        Bench bench(channel);
        QVERIFY(bench.take(215, 0).quality == Quality::Good);
        QVERIFY(bench.take(215, 1).cause == Cause::BadStatus);
        QVERIFY(bench.take(215, 0xFFFE).cause == Cause::BadStatus);
        QVERIFY(bench.take(215, 3).quality == Quality::Good);
    }
    void swappedWordsNeverPassForATemperature() {
        // A module's firmware changes its word order in mid-shift: 1000 noisy readings around 24 °C.
        Random random(3);
        Bench bench(channelOf(RegisterType::Float32, 1.0));
        const auto reading = [&random] { return static_cast<float>(24.0 + 0.05 * random.gauss()); };
        for (int i = 0; i < 10; ++i) {
            QVERIFY(bench.takeFloat(reading(), false).quality == Quality::Good);
        }
        int passed = 0;
        for (int i = 0; i < 1000; ++i) {
            passed += bench.takeFloat(reading(), true).quality == Quality::Good ? 1 : 0;
        }
        QCOMPARE(passed, 0);
        int until = 0;
        while (bench.takeFloat(reading(), false).quality != Quality::Good) {
            ++until;
        }
        QVERIFY2(until < kAfterNonsense, qPrintable(QString::number(until)));
    }
    void notANumberIsNone() {
        Bench bench(channelOf(RegisterType::Float32, 1.0));
        QVERIFY(bench.takeFloat(std::numeric_limits<float>::quiet_NaN(), false).cause == Cause::NoNumber);
        QVERIFY(bench.takeFloat(std::numeric_limits<float>::infinity(), false).cause == Cause::NoNumber);
        QVERIFY(bench.takeFloat(5000.0F, false).cause == Cause::OutOfRange);
        QVERIFY(bench.judge.value().stamp_ns == 0);
    }
    void aJumpIsBelievedWhenThreeReadingsAgree() {
        Bench bench(channelOf(RegisterType::Int16));
        (void)bench.take(215);
        QVERIFY(bench.take(1200).cause == Cause::Jump);
        QVERIFY(bench.take(215).cause == Cause::Jump);  // back again: the other was a slip, and this is doubted too
        QVERIFY(bench.take(215).cause == Cause::Jump);
        QVERIFY(bench.take(215).quality == Quality::Good);
        QVERIFY(bench.take(1200).quality == Quality::Bad);
        QVERIFY(bench.take(1201).quality == Quality::Bad);
        QVERIFY(bench.take(1199).quality == Quality::Good);
        QVERIFY(bench.take(600).quality == Quality::Good);  // 59.9 K
    }
    void silenceMakesStaleAndNeverReadIsMissing() {
        Bench bench(channelOf(RegisterType::Int16));
        bench.judge.age(kSecond_ns, 3 * kSecond_ns);
        QVERIFY(bench.judge.value().cause == Cause::NotYetRead);
        bench.judge.age(5 * kSecond_ns, 3 * kSecond_ns);
        QVERIFY(bench.judge.value().quality == Quality::Missing && bench.judge.value().cause == Cause::NoAnswer);
        bench.now_ns = 5 * kSecond_ns;
        (void)bench.take(215);
        bench.judge.age(bench.now_ns + 3 * kSecond_ns, 3 * kSecond_ns);
        QVERIFY(bench.judge.value().quality == Quality::Good);
        bench.judge.age(bench.now_ns + 3 * kSecond_ns + 1, 3 * kSecond_ns);
        QVERIFY(bench.judge.value().quality == Quality::Stale);
        QVERIFY(bench.take(216).quality == Quality::Good);
    }
};

QTEST_APPLESS_MAIN(TestChannelJudge)
#include "tst_channel_judge.moc"
