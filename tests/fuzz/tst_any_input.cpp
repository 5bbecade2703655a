// SPDX-License-Identifier: GPL-3.0-or-later
#include <sys/resource.h>

#include <QTest>
#include <filesystem>

#include "app/files/whole_file.h"
#include "tests/fuzz/any_reader.h"
#include "tests/fuzz/seeds.h"

using namespace kerf::test;

/// The short form of scripts/fuzz: what campaigns have found, every seed, and seeded mutations of them.
class TestAnyInput : public QObject {
    Q_OBJECT
    const std::vector<std::string> m_seeds = seedInputs(KERF_SOURCE_DIR);

    static void read(const std::string& input, const QByteArray& name) {
        try {
            readAnything(input);
        } catch (const std::exception& what) {
            const QByteArray bytes = QByteArray::fromStdString(input).toBase64();  // for tests/fuzz/found
            QFAIL((name + ": " + what.what() + ": " + bytes).constData());
        }
    }

 private slots:
    void whatCampaignsHaveFound() {
        int count = 0;
        for (const auto& entry : std::filesystem::directory_iterator(KERF_SOURCE_DIR "/tests/fuzz/found")) {
            read(kerf::files::readFile(entry.path().string()), entry.path().c_str());
            ++count;
        }
        QVERIFY(count > 0);
    }
    void everySeedToEveryReader() {
        QVERIFY(m_seeds.size() > 100);
        for (std::size_t i = 0; i < m_seeds.size(); ++i) {
            std::string input = m_seeds[i];
            read(input, "seed " + QByteArray::number(qulonglong(i)));
            input[0] = static_cast<char>(i % kReaders);
            read(input, "seed of another reader " + QByteArray::number(qulonglong(i)));
        }
    }
    void seededMutations() {
        const int asked = qEnvironmentVariableIntValue("KERF_FUZZ_RUNS");
        const int runs = asked > 0 ? asked : 6000;
        std::mt19937_64 random(20261127 + qEnvironmentVariableIntValue("KERF_FUZZ_SEED"));
        for (int i = 0; i < runs; ++i) {
            read(mutated(m_seeds, random), "mutation " + QByteArray::number(i));
            if (QTest::currentTestFailed()) return;
        }
        rusage used{};
        getrusage(RUSAGE_SELF, &used);
        const auto second = [](const timeval& t) { return double(t.tv_sec) + double(t.tv_usec) * 1e-6; };
        qInfo("%d inputs, %.1f s of a processor, %ld MB at most", runs, second(used.ru_utime) + second(used.ru_stime),
              used.ru_maxrss / 1024);
        QVERIFY(used.ru_maxrss < 1024L * 1024L);  // 1 GB, in kB
    }
    void theSameSeedGivesTheSameInputs() {
        std::mt19937_64 one(7), other(7), third(8);
        QCOMPARE(mutated(m_seeds, one), mutated(m_seeds, other));
        QVERIFY(mutated(m_seeds, one) != mutated(m_seeds, third));
    }
};

QTEST_GUILESS_MAIN(TestAnyInput)
#include "tst_any_input.moc"
