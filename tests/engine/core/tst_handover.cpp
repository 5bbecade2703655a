// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>
#include <array>
#include <thread>

#include "engine/core/latest_value.h"
#include "engine/core/spsc_ring.h"

namespace {
/// Larger than a cache line, so that a torn copy shows.
struct Block {
    std::array<std::uint64_t, 32> words{};
    static Block of(std::uint64_t n) {
        Block b;
        b.words.fill(n);
        return b;
    }
    [[nodiscard]] bool whole() const {
        for (const auto word : words) {
            if (word != words[0]) {
                return false;
            }
        }
        return true;
    }
};
#ifdef KERF_SANITIZED
constexpr std::uint64_t kRounds = 5000;
#else
constexpr std::uint64_t kRounds = 200000;
#endif
}  // namespace

/// The two hand-over parts between threads; run under the thread sanitizer too.
class TestHandover : public QObject {
    Q_OBJECT
 private slots:
    void latestValueIsNeverTornAndNeverOlder() {
        kerf::LatestValue<Block> latest;
        std::jthread writer([&] {
            for (std::uint64_t i = 1; i <= kRounds; ++i) {
                latest.publish(Block::of(i));
            }
        });
        std::uint64_t last = 0;
        bool whole = true;
        bool ordered = true;
        while (last < kRounds) {
            if (latest.refresh()) {
                whole = whole && latest.value().whole();
                ordered = ordered && latest.value().words[0] > last;
                last = latest.value().words[0];
            } else {
                std::this_thread::yield();
            }
        }
        QVERIFY(whole);
        QVERIFY(ordered);
    }
    void latestValueSaysNothingNewTwice() {
        kerf::LatestValue<int> latest;
        QVERIFY(!latest.refresh());
        latest.publish(5);
        QVERIFY(latest.refresh());
        QCOMPARE(latest.value(), 5);
        QVERIFY(!latest.refresh());
        QCOMPARE(latest.value(), 5);
    }
    void ringKeepsOrderAndLosesNothingItTook() {
        kerf::SpscRing<Block> ring(64);
        std::jthread producer([&] {
            for (std::uint64_t i = 1; i <= kRounds;) {
                if (ring.tryPush(Block::of(i))) {
                    ++i;
                } else {
                    std::this_thread::yield();
                }
            }
        });
        bool good = true;
        for (std::uint64_t expected = 1; expected <= kRounds;) {
            Block block;
            if (ring.tryPop(block)) {
                good = good && block.whole() && block.words[0] == expected;
                ++expected;
            } else {
                std::this_thread::yield();
            }
        }
        QVERIFY(good);
    }
    void fullRingRefusesAndCounts() {
        kerf::SpscRing<int> ring(8);
        int taken = 0;
        while (ring.tryPush(taken)) {
            ++taken;
        }
        QCOMPARE(taken, 8);
        QVERIFY(!ring.tryPush(99));
        QCOMPARE(ring.refused(), 2U);
        int value = -1;
        QVERIFY(ring.tryPop(value));
        QCOMPARE(value, 0);
        QVERIFY(ring.tryPush(99));
    }
};
QTEST_APPLESS_MAIN(TestHandover)
#include "tst_handover.moc"
