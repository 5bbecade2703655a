// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>
#include <cmath>
#include <memory>

#include "app/desk/boring_recipe.h"
#include "db/migrator.h"
#include "db/writer_thread.h"
#include "engine/boring/model.h"
#include "tests/support/console_bench.h"
#include "tests/support/linuxcnc_control.h"

using namespace kerf;

/// The real console on LinuxCNC's own simulator, offscreen: it starts before the control, then a lot is made.
class TestConsoleLinuxCnc : public QObject {
    Q_OBJECT

    static constexpr std::uint32_t kParts = 6;

    /// A bore short enough for a test in real time.
    [[nodiscard]] static BoringRecipe shortBore() {
        BoringRecipe recipe;
        recipe.overhangFrom_mm = 40.0;
        recipe.overhangTo_mm = 48.0;
        recipe.spindleSpeed_rpm = 1500.0;
        recipe.firstFeed_mmPerRev = 0.3;
        recipe.depths = {{"top", 40.0}, {"bottom", 48.0}};
        return recipe;
    }
    /// What a gauge finds in a bore that this tool has cut with the schedule the part began with.
    [[nodiscard]] static double diameter_mm(const BorePartView& part, double overhang_mm) {
        const BoringRecipe recipe = shortBore();
        const double feed_mmPerRev = part.schedule.feed_mmPerRev(overhang_mm);
        const double deflection_mm = 0.0871 * std::pow(feed_mmPerRev, 0.5025) * std::pow(overhang_mm, 0.2676);
        return boring::diameterFromDeflection_mm(deflection_mm, recipe.targetDiameter_mm, recipe.targetDeflection_mm,
                                                 recipe.phi_deg);
    }
    void prepareRecipe() {
        const std::string path = (m_bench.folder() + QStringLiteral("/kerf.db")).toStdString();
        QVERIFY(db::prepareDatabase(path).has_value());
        db::WriterThread writer(path, nullptr);
        QVERIFY(writer.start().has_value());
        writer.submit(EnsurePartType{ProcessId::Boring, "Cylinder 50", recipeJson(shortBore()), "test"}, {});
        QCOMPARE(writer.stop(), std::size_t{0});
    }
    [[nodiscard]] const BorePartView* awaited() {
        const BoringDeskView& view = m_bench.desk();
        for (const BorePartView& part : view.parts) {
            if (view.awaiting == part.id) {
                return &part;
            }
        }
        return nullptr;
    }
    [[nodiscard]] bool waits(std::uint32_t number) {
        const BorePartView* part = awaited();
        return part != nullptr && part->number == number;
    }
    [[nodiscard]] std::size_t measured(std::uint32_t number) {
        for (const BorePartView& part : m_bench.desk().parts) {
            if (part.number == number) {
                return part.measurements.size();
            }
        }
        return 0;
    }
    template <class Action>
    bool send(const Action& action) {
        Command command;
        command.action = action;
        return m_bench.console().engine().send(command).has_value();
    }

 private slots:
    void initTestCase() {
        if (const QString why = test::LinuxCncControl::whyNot(); !why.isEmpty()) {
            QSKIP(qPrintable(why));
        }
        prepareRecipe();
    }
    void startsWithoutLinuxCncAndFindsItByItself() {
        console::Options options;
        options.machine = "linuxcnc";
        m_bench.start(options);
        QTRY_VERIFY2_WITH_TIMEOUT(m_bench.up(), qPrintable(m_bench.failure()), 20'000);
        QCOMPARE(m_bench.status().link, LinkState::Down);
        QVERIFY2(m_control.start(), m_control.log());
        QTRY_VERIFY_WITH_TIMEOUT(m_bench.status().link == LinkState::Up && m_bench.status().machineOn, 10'000);
    }
    void loopsTheMachineCannotHostSayWhy() {
        QVERIFY(m_bench.up());
        const auto reason = [this](ProcessId id) {
            return m_bench.status().loops[static_cast<std::size_t>(id)].reason.english();
        };
        QTRY_VERIFY(!m_bench.status().loops[static_cast<std::size_t>(ProcessId::Thermal)].fitted);
        QVERIFY2(reason(ProcessId::Thermal).find("temperatures") != std::string::npos,
                 reason(ProcessId::Thermal).c_str());
        QVERIFY2(reason(ProcessId::Turning).find("0.2 ms") != std::string::npos, reason(ProcessId::Turning).c_str());
    }
    void lotOfSixBoresWithEntries() {
        QVERIFY(m_bench.up());
        m_bench.console().window()->showPage("boring");
        QVERIFY(send(SetLoopMode{ProcessId::Boring, LoopMode::Control}));
        for (std::uint32_t number = 1; number <= kParts; ++number) {
            QVERIFY(send(StartPart{ProcessId::Boring}));
            QTRY_VERIFY2_WITH_TIMEOUT(waits(number), m_bench.status().lastCommand.reason.english().c_str(), 20'000);
            for (const double overhang_mm : {40.0, 48.0}) {
                const BorePartView* part = awaited();
                QVERIFY(part != nullptr);
                const std::size_t before = part->measurements.size();
                QVERIFY(m_bench.keyIn(QString::number(diameter_mm(*part, overhang_mm), 'f', 3)));
                QTRY_VERIFY_WITH_TIMEOUT(measured(number) > before, 10'000);
            }
            QTRY_VERIFY(awaited() == nullptr);
        }
        std::size_t complete = 0;
        for (const BorePartView& part : m_bench.desk().parts) {
            complete += part.complete ? 1 : 0;
        }
        QCOMPARE(complete, std::size_t{kParts});
        // The law has been found: the last bores are on the target.
        QVERIFY(std::abs(m_bench.desk().nextSchedule.feed_mmPerRev(40.0) / trueFeed_mmPerRev(40.0) - 1.0) < 0.1);
    }
    void controlRestartedIsTakenOverAgain() {
        QVERIFY(m_bench.up());
        m_control.stop();
        QTRY_COMPARE_WITH_TIMEOUT(m_bench.status().link, LinkState::Down, 10'000);
        QCOMPARE(m_bench.desk().parts.size(), std::size_t{kParts});  // nothing lost
        QVERIFY2(m_control.start(), m_control.log());
        QTRY_COMPARE_WITH_TIMEOUT(m_bench.status().link, LinkState::Up, 10'000);
    }
    void cleanupTestCase() { m_bench.stop(); }

 private:
    [[nodiscard]] static double trueFeed_mmPerRev(double overhang_mm) {
        return std::pow(shortBore().targetDeflection_mm / (0.0871 * std::pow(overhang_mm, 0.2676)), 1.0 / 0.5025);
    }

    test::LinuxCncControl m_control;
    test::ConsoleBench m_bench;
};
QTEST_MAIN(TestConsoleLinuxCnc)
#include "tst_console_linuxcnc.moc"
