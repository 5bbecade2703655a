// SPDX-License-Identifier: GPL-3.0-or-later
#include <unistd.h>
#include <QFile>

#include "tests/support/console_bench.h"

using namespace kerf;

/// Many parts in one run: everything stored, memory level, nothing left behind. KERF_SOAK_PARTS makes it longer.
class TestConsoleSoak : public QObject {
    Q_OBJECT

    /// Resident memory of this process, MB.
    static double resident_MB() {
        QFile file(QStringLiteral("/proc/self/statm"));
        if (!file.open(QIODevice::ReadOnly)) {
            return 0.0;
        }
        const QList<QByteArray> words = file.readAll().split(' ');
        return words.value(1).toDouble() * static_cast<double>(sysconf(_SC_PAGESIZE)) / 1e6;
    }

 private slots:
    void manyPartsLeaveNothingBehind() {
        const int parts = std::max(qEnvironmentVariableIntValue("KERF_SOAK_PARTS"), 12);
        test::ConsoleBench bench;
        console::Options options;
        options.preparedParts = 0;
        options.simulationSpeed = 0.0;
        options.autoOperator = true;
        options.lotSize = static_cast<std::uint32_t>(parts);
        bench.prepareQuickBores();
        bench.start(options);
        QTRY_VERIFY2_WITH_TIMEOUT(bench.up(), qPrintable(bench.failure()), 20'000);
        const auto done = [&bench](int number) {
            const auto& list = bench.service().parts;
            return !list.empty() && list.back().number >= static_cast<std::uint32_t>(number) && list.back().complete;
        };
        QTRY_VERIFY_WITH_TIMEOUT(done(parts / 2), 3'000'000);
        const double half_MB = resident_MB();
        QTRY_VERIFY_WITH_TIMEOUT(done(parts), 3'000'000);
        const double end_MB = resident_MB();
        qInfo("%d parts, %.0f MB at half, %.0f MB at the end, %llu cycles, %llu chart samples dropped", parts, half_MB,
              end_MB, static_cast<unsigned long long>(bench.status().cycle),
              static_cast<unsigned long long>(bench.status().stats.droppedSamples));
#ifndef __SANITIZE_ADDRESS__  // which keeps what is freed for a while
        QVERIFY(end_MB < half_MB + 40.0);
#endif
        const auto reader = db::DatabaseReader::open(bench.console().databasePath());
        QVERIFY(reader.has_value());
        const auto count = (*reader)->count({}, 1'000'000);
        QVERIFY(count.has_value());
        QCOMPARE(*count, static_cast<std::uint64_t>(parts));
        const auto verdict = (*reader)->verifyAudit();
        QVERIFY(verdict.has_value());
        QVERIFY2(verdict->finding.empty(), verdict->finding.english().c_str());
        QCOMPARE(verdict->measurements, static_cast<std::uint64_t>(2 * parts));
        bench.stop();
    }
};
QTEST_MAIN(TestConsoleSoak)
#include "tst_console_soak.moc"
