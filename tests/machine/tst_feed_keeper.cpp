// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <random>

#include "engine/machine/linuxcnc/feed_keeper.h"
#include "engine/machine/linuxcnc/link_memory.h"

using namespace kerf;
using namespace kerf::linuxcnc;

namespace {

constexpr std::int64_t kRound_ns = 1'000'000;
constexpr int kSilence = 61;  ///< rounds until a silent console is lost

/// kerf.hal, one console and the bridge's law between them, a millisecond at a time.
class Way {
 public:
    ToControl wish{};  ///< what the console says
    FeedKeeper::Round round{};
    FeedKeeper::Pins pins{};  ///< HAL's signals: they outlive the bridge

    /// `console`: it says its wish, following on what it has seen last.
    void step(bool console = true, bool bridge = true) {
        m_sinceBeat_ns += kRound_ns;
        m_sinceRound_ns += kRound_ns;
        if (console) {
            wish.feedEpoch = m_seenEpoch;
            wish.beat = wish.beatAgain = ++m_beat;
            m_waiting = wish;
        }
        if (!bridge) {
            return;
        }
        round.passed_ns = m_sinceRound_ns;
        m_sinceBeat_ns = m_sinceRound_ns = 0;
        pins = m_keeper.next(round, m_waiting ? &*m_waiting : nullptr, pins);
        m_waiting.reset();
        if (console) {
            m_seenEpoch = m_keeper.epoch();
        }
    }
    void steps(int count, bool console = true, bool bridge = true) {
        for (int i = 0; i < count; ++i) {
            step(console, bridge);
        }
    }
    /// A new process on the signals of the one before.
    void restartBridge() {
        m_keeper = FeedKeeper(m_keeper.epoch() + 1000);
        m_sinceRound_ns = 0;
        m_waiting.reset();  // a new memory
    }
    /// The console has seen the bridge as it is now, but has not said anything yet.
    void look() { m_seenEpoch = m_keeper.epoch(); }

    /// What motion is given.
    [[nodiscard]] bool bridgeAlive() const { return m_sinceBeat_ns <= FeedKeeper::kAliveWidth_ns; }
    [[nodiscard]] double scale() const { return bridgeAlive() ? pins.scale : pins.lossScale; }
    [[nodiscard]] bool held() const { return pins.hold || (!bridgeAlive() && pins.holdIfGone); }
    [[nodiscard]] double feed() const { return held() ? 0.0 : scale(); }
    [[nodiscard]] const FeedKeeper& keeper() const { return m_keeper; }

    void says(double feedScale, double lossScale, double plannedScale) {
        wish.feedScale = feedScale;
        wish.lossScale = lossScale;
        wish.plannedScale = plannedScale;
    }

 private:
    FeedKeeper m_keeper{7};
    std::optional<ToControl> m_waiting{};
    std::uint32_t m_seenEpoch{0};
    std::uint64_t m_beat{0};
    std::int64_t m_sinceBeat_ns{0};   ///< as HAL sees it
    std::int64_t m_sinceRound_ns{0};  ///< as the bridge that runs sees it
};

/// A program that is cut at .8 of its programmed feed, planned at .5.
Way cutting() {
    Way way;
    way.steps(3);
    way.round.running = true;
    way.says(0.8, 0.5, 0.5);
    way.steps(3);
    return way;
}

}  // namespace

/// Which feed is left when console, bridge or both are late, dead or new: never a faster one than planned.
class TestFeedKeeper : public QObject {
    Q_OBJECT
 private slots:
    void theConsoleIsObeyedOnceItHasSeenTheBridge() {
        Way way;
        way.says(0.3, 1.0, 0.0);
        way.step();
        QVERIFY(!way.keeper().obeyed());
        way.step();
        QVERIFY(way.keeper().obeyed());
        QCOMPARE(way.feed(), 0.3);
        QVERIFY(!way.keeper().lost());
    }
    void aSilentConsoleLeavesThePlannedFeed() {
        Way way = cutting();
        QCOMPARE(way.feed(), 0.8);
        way.steps(kSilence - 2, false);
        QCOMPARE(way.feed(), 0.8);
        way.steps(3, false);
        QVERIFY(way.keeper().lost());
        QCOMPARE(way.feed(), 0.5);
        way.steps(1000, false);
        QCOMPARE(way.feed(), 0.5);
        way.round.running = false;
        way.step(false);
        QCOMPARE(way.feed(), 1.0);  // an operator's own program
        QCOMPARE(way.keeper().plannedScale(), 0.0);
    }
    void aLateBridgeLeavesThePlannedFeed() {
        Way way = cutting();
        way.steps(50, true, false);
        QCOMPARE(way.feed(), 0.8);
        way.step(true, false);
        QCOMPARE(way.feed(), 0.5);
        way.steps(500, true, false);
        QCOMPARE(way.feed(), 0.5);
    }
    void itObeysAgainOnlyWhatFollowsOnItsReturn() {
        Way way = cutting();
        way.steps(200, true, false);
        way.step();  // the wish that has waited is of the time before
        QVERIFY(!way.keeper().obeyed());
        QCOMPARE(way.feed(), 0.5);
        way.says(0.6, 0.5, 0.5);
        way.step();
        QCOMPARE(way.feed(), 0.6);
    }
    void theLastWishOfADeadConsoleIsNotANewOne() {
        Way way = cutting();
        way.step(true, false);  // said, and dead
        way.steps(70, false, false);
        for (int i = 0; i < 100; ++i) {
            way.step(false);
            QCOMPARE(way.feed(), 0.5);
        }
        QVERIFY(way.keeper().lost());
    }
    void aDeadBridgeLeavesThePlannedFeedForEver() {
        Way way = cutting();
        way.steps(10'000, false, false);
        QCOMPARE(way.feed(), 0.5);
    }
    void aNewBridgeGoesOnFromWhatTheOldOneHasLeft() {
        Way way = cutting();
        way.steps(300, false, false);
        way.restartBridge();
        for (int i = 0; i < 300; ++i) {
            way.step(false);
            QCOMPARE(way.feed(), 0.5);
        }
        way.look();
        way.says(0.7, 0.5, 0.5);
        way.step();
        QCOMPARE(way.feed(), 0.7);
    }
    void aConsoleThatFollowsOnTheOldBridgeIsNotObeyedByTheNewOne() {
        Way way = cutting();
        way.steps(60, false, false);
        way.restartBridge();
        way.step();
        QVERIFY(!way.keeper().obeyed());
        QCOMPARE(way.feed(), 0.5);
    }
    void whatNobodyHasDeclaredIsHeld() {
        Way way = cutting();
        way.says(0.8, 0.0, 0.0);  // the limiter's word for a program that somebody scales and nobody has declared
        way.step();
        QCOMPARE(way.feed(), 0.8);
        Way silent = way;
        silent.steps(kSilence + 1, false);
        QCOMPARE(silent.feed(), 0.0);
        QVERIFY(silent.held());
        way.steps(60, false, false);
        QCOMPARE(way.feed(), 0.0);
    }
    void aPlannedFeedCountsEvenWhereTheConsoleHasNotSaidWhatIsLeft() {
        Way way = cutting();
        way.says(0.8, 1.0, 0.5);
        way.step();
        way.steps(60, false, false);
        QCOMPARE(way.feed(), 0.5);
    }
    void aStartUnderWayBeginsAtItsPlannedFeed_data() {
        QTest::addColumn<bool>("bridge");
        QTest::newRow("the console dies") << true;
        QTest::newRow("both die") << false;
    }
    void aStartUnderWayBeginsAtItsPlannedFeed() {
        QFETCH(bool, bridge);
        Way way;
        way.steps(3);
        way.says(0.5, 0.5, 0.0);  // the limiter before it sends the start: nothing runs yet, so nothing is declared
        way.step();
        way.steps(200, false, bridge);
        QCOMPARE(way.feed(), 0.5);
        way.round.running = true;
        way.steps(200, false, bridge);
        QCOMPARE(way.feed(), 0.5);
        if (bridge) {
            way.round.running = false;
            way.step(false);
            QCOMPARE(way.feed(), 1.0);
        }
    }
    void aHoldStaysWhoeverIsLost() {
        Way way = cutting();
        way.wish.feedHold = true;
        way.step();
        Way late = way;
        late.steps(300, true, false);
        QVERIFY(late.held());
        late.restartBridge();
        late.steps(300, false);
        QVERIFY(late.held());
        way.steps(300, false);
        QVERIFY(way.held());
        way.round.running = false;
        way.step(false);
        QVERIFY(!way.held());
    }
    void aHoldOfTheTimeBeforeCountsAndItsReleaseDoesNot() {
        Way way = cutting();
        way.steps(60, true, false);
        way.wish.feedHold = true;
        way.step();
        QVERIFY(!way.keeper().obeyed());
        QVERIFY(way.held());
    }
    void aStopHoldsWhoeverSpeaks() {
        Way way = cutting();
        way.round.stopHolds = true;
        way.step();
        QVERIFY(way.held());
        way.steps(300, false);
        QVERIFY(way.held());
        way.round.running = false;
        way.steps(3, false);
        QVERIFY(way.held());
    }
    void holdOnLossHoldsAlsoWithoutTheBridge() {
        Way way = cutting();
        way.round.holdOnLoss = true;
        way.step();
        QVERIFY(!way.held());
        Way silent = way;
        silent.steps(kSilence + 1, false);
        QVERIFY(silent.held());
        silent.step();
        silent.step();
        QVERIFY(!silent.held());
        way.steps(60, false, false);
        QVERIFY(way.held());
    }
    void aMachineOfOtherUnitsIsNeverScaled() {
        Way way;
        way.round.mayScale = false;
        way.says(0.2, 0.1, 0.1);
        way.steps(5);
        way.round.running = true;
        way.steps(5);
        QCOMPARE(way.feed(), 1.0);
        way.steps(200, false);
        QCOMPARE(way.feed(), 1.0);
        QVERIFY(!way.held());
    }
    void whatIsNoNumberIsNoFeed() {
        Way way = cutting();
        way.says(std::numeric_limits<double>::quiet_NaN(), 0.5, 0.5);
        way.step();
        QCOMPARE(way.feed(), 0.0);
        way.says(0.8, std::numeric_limits<double>::infinity(), 0.5);
        way.step();
        QVERIFY(way.pins.lossScale <= 0.5);
    }
    /// Any order of deaths, delays and restarts: while anything is unknown the feed is at most the planned one, and
    /// nothing but a console that has seen the loss makes it faster.
    void noOrderOfLossesMakesItFaster() {
        std::mt19937_64 random(20261127);
        const auto upTo = [&](int most) { return std::uniform_int_distribution<int>(0, most)(random); };
        const auto share = [&] { return std::uniform_real_distribution<double>(0.05, 1.0)(random); };
        int lostOnes = 0;
        for (int run = 0; run < 400; ++run) {
            Way way;
            way.steps(3);
            const double planned = share();
            way.says(planned, planned, 0.0);
            way.step();
            way.round.running = true;
            double said = planned;
            int consoleSilent = 0;
            for (int event = 0; event < 30; ++event) {
                const int what = upTo(4);
                const bool console = what <= 1;
                const bool bridge = what == 0 || what == 2;
                if (what == 4) {
                    way.restartBridge();
                }
                const int rounds = 1 + upTo(what == 0 ? 20 : 150);
                for (int i = 0; i < rounds; ++i) {
                    if (console && bridge) {
                        said = share();
                        way.says(said, planned, planned);
                    }
                    const double before = way.feed();
                    way.step(console, bridge);
                    consoleSilent = console ? 0 : consoleSilent + 1;
                    const bool heard = bridge && way.keeper().obeyed();
                    if (!heard && bridge) {
                        QVERIFY(way.feed() <= before + 1e-12);
                    }
                    if (!way.bridgeAlive() || (bridge && consoleSilent > kSilence && way.keeper().lost())) {
                        ++lostOnes;
                        QVERIFY2(way.feed() <= planned + 1e-12, qPrintable(QString::number(run)));
                    }
                }
            }
        }
        QVERIFY(lostOnes > 10'000);
    }
};
QTEST_APPLESS_MAIN(TestFeedKeeper)
#include "tst_feed_keeper.moc"
