// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>
#include <cmath>
#include <functional>
#include <memory>
#include <thread>

#include "engine/limits/output_limiter.h"
#include "engine/machine/linuxcnc/linuxcnc_machine.h"
#include "tests/support/lateness.h"
#include "tests/support/linuxcnc_control.h"

using namespace kerf;

/// A LinuxCNC without external offsets: the work origin is shifted by G10 L2 between parts and reads back.
class TestLinuxCncOrigin : public QObject {
    Q_OBJECT

    void newConsole() {
        m_machine = std::make_unique<linuxcnc::LinuxCncMachine>(linuxcnc::LinuxCncMachine::Params{});
        QVERIFY(m_machine->connect().has_value());
        m_inputs = MachineInputs{};
    }
    /// Cycles as the engine makes them, with a thermal loop that wants `shift_um` of Z.
    bool until(const std::function<bool()>& condition, std::optional<double> shift_um) {
        Capabilities quick = m_machine->capabilities();
        quick.limits.workOffsetRate_umPerS = 100.0;
        OutputLimiter limiter(quick);
        std::array<LoopOutputs, kProcessPlaces> wishes{};
        wishes[static_cast<std::size_t>(ProcessId::Thermal)].workOffset_um[2] = shift_um;
        LimitReport report;
        m_machine->read(test::monotonic_ns(), m_inputs);
        limiter.adopt(m_inputs, quick);
        for (int i = 0; i < 15'000; ++i) {
            m_machine->read(test::monotonic_ns(), m_inputs);
            if (condition()) {
                return true;
            }
            m_machine->write(limiter.apply(wishes, m_inputs, 0.001, report));
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        }
        return false;
    }
    [[nodiscard]] bool shiftIs(double shift_um) const {
        return m_inputs.workOffset_um[2].good() && std::abs(m_inputs.workOffset_um[2].value - shift_um) < 0.5;
    }

 private slots:
    void initTestCase() {
        if (const QString why = test::LinuxCncControl::whyNot(); !why.isEmpty()) {
            QSKIP(qPrintable(why));
        }
        QVERIFY2(m_control.start({QStringLiteral("--origin")}), m_control.log());
        newConsole();
    }
    void originIsShiftedAndReadsBack() {
        QVERIFY(until([this] { return shiftIs(0.0); }, std::nullopt));
        QVERIFY(m_machine->capabilities().workOffset.fitted);
        QVERIFY(until([this] { return shiftIs(12.0); }, 12.0));
        test::AtTheControl control;  // and the control's own origin says so
        const auto z_mm = [&](const char* which) {
            const QList<QByteArray> cells = control.ask(which).simplified().split(' ');
            return cells.size() > 3 ? cells[3].toDouble() : 1e9;
        };
        QTRY_VERIFY(std::abs(z_mm("get abs_act_pos") - z_mm("get rel_act_pos") - 0.012) < 1e-5);
    }
    void shiftIsRightWhateverUnitsAndModesAreInForce() {
        test::AtTheControl control;
        control.say("set mode mdi");
        control.say("set mdi g20 g91");
        QVERIFY(until([this] { return shiftIs(22.0); }, 22.0));
        const auto z = [&](const char* which) {
            const QList<QByteArray> cells = control.ask(which).simplified().split(' ');
            return cells.size() > 3 ? cells[3].toDouble() : 1e9;
        };
        // Positions are told in the program's units: inches now, and still inches after Kerf's subroutine.
        QTRY_VERIFY(std::abs((z("get abs_act_pos") - z("get rel_act_pos")) * 25.4 - 0.022) < 1e-4 ||
                    std::abs(z("get abs_act_pos") - z("get rel_act_pos") - 0.022) < 1e-5);
        const QByteArray modes = control.ask("get program_codes");
        QVERIFY2(modes.contains("G20") && modes.contains("G91"), modes.constData());
        control.say("set mdi g21 g90");
        QVERIFY(until([this] { return shiftIs(12.0); }, 12.0));
    }
    void restartedConsoleTakesTheShiftOverWithoutAJump() {
        QVERIFY(shiftIs(12.0));
        newConsole();
        QVERIFY(until([this] { return shiftIs(12.0); }, std::nullopt));
        for (int i = 0; i < 50; ++i) {
            QVERIFY(until([this] { return m_inputs.workOffset_um[2].good(); }, std::nullopt));
            QVERIFY(shiftIs(12.0));
        }
    }

 private:
    test::LinuxCncControl m_control;
    std::unique_ptr<linuxcnc::LinuxCncMachine> m_machine;
    MachineInputs m_inputs{};
};
KERF_TEST_IN_TIME(TestLinuxCncOrigin)
#include "tst_linuxcnc_origin.moc"
