// SPDX-License-Identifier: GPL-3.0-or-later
#include <sys/mman.h>

#include <QDir>
#include <QTest>
#include <cstdlib>
#include <new>
#include <optional>

#include "app/files/table.h"
#include "app/rehearsal/rehearsal.h"
#include "engine/cycle/real_time.h"
#include "tests/support/cycle_guard.h"

using namespace kerf;

namespace {

/// Counts over all cycles of a run.
class Sins final : public rehearsal::CycleWatch {
 public:
    void begins() noexcept override { m_guard.emplace(); }
    void ends() noexcept override {
        allocations += m_guard->allocations();
        locks += m_guard->locks();
        throws += m_guard->throws();
        pageFaults += m_guard->pageFaults();
        m_guard.reset();
        ++cycles;
    }
    std::uint64_t allocations{0};
    std::uint64_t locks{0};
    std::uint64_t throws{0};
    std::uint64_t pageFaults{0};
    std::uint64_t cycles{0};

 private:
    std::optional<test::CycleGuard> m_guard{};
};

}  // namespace

/// All five loops, the supervisor, the limiter and both simulated machines, through parts with every fault and command
/// of the rehearsals that are shipped: the cycle neither allocates, locks nor throws.
class TestRehearsalsGuard : public QObject {
    Q_OBJECT
 private slots:
    void initTestCase() {
        if (!test::CycleGuard::available()) {
            QSKIP("a sanitizer owns malloc in this build");
        }
        prefault();
    }
    void theCycleDoesNotWaitForAnybody_data() {
        QTest::addColumn<QString>("file");
        for (const QString& file : shipped().entryList({QStringLiteral("*.json")}, QDir::Files)) {
            if (!file.endsWith(QStringLiteral(".expected.json"))) {
                QTest::addRow("%s", qPrintable(file.chopped(5))) << file;
            }
        }
    }
    void theCycleDoesNotWaitForAnybody() {
        QFETCH(QString, file);
        const auto scenario = rehearsal::readScenario(headless::readFile(shipped().filePath(file).toStdString()),
                                                      file.toStdString(), std::string());
        Sins sins;
        (void)rehearsal::rehearse(scenario, nullptr, 0.0, {}, &sins);
        QVERIFY(sins.cycles > 1000);
        QCOMPARE(sins.allocations, 0U);
        QCOMPARE(sins.locks, 0U);
        QCOMPARE(sins.throws, 0U);
        QCOMPARE(sins.pageFaults, 0U);
    }
    void theGuardSeesAlignedMemoryAndFirstTouches() {
        constexpr std::size_t kPages = 64;
        constexpr std::size_t kPage = 4096;
        const test::CycleGuard guard;
        void* volatile aligned = std::aligned_alloc(kPage, kPage);
        const std::uint64_t afterC = guard.allocations();
        void* line = ::operator new (64, std::align_val_t{64});
        const std::uint64_t afterNew = guard.allocations();
        void* block = mmap(nullptr, kPages * kPage, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
        QVERIFY(block != MAP_FAILED);
        const std::uint64_t before = guard.pageFaults();
        for (std::size_t page = 0; page < kPages; ++page) {
            static_cast<volatile char*>(block)[page * kPage] = 1;
        }
        const std::uint64_t pageFaults = guard.pageFaults() - before;
        ::operator delete (line, std::align_val_t{64});
        std::free(aligned);
        munmap(block, kPages * kPage);
        QVERIFY(afterC == 1);
        QVERIFY(afterNew == 2);
        QVERIFY2(pageFaults >= kPages, qPrintable(QString::number(pageFaults)));
    }

 private:
    static QDir shipped() {
        return QDir(qEnvironmentVariable("KERF_FIXTURES") + QStringLiteral("/../../resources/rehearsals"));
    }
};
QTEST_GUILESS_MAIN(TestRehearsalsGuard)
#include "tst_rehearsals_guard.moc"
