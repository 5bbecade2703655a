// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractButton>
#include <QLabel>
#include <QLineEdit>
#include <QTemporaryDir>
#include <QTest>
#include <QTimer>
#include <cmath>
#include <memory>

#include "app/console/console_application.h"
#include "app/service/boring/boring_recipe.h"
#include "db/migrator.h"
#include "db/writer_thread.h"
#include "ui/widgets/action_button.h"

namespace kerf::test {

/// The real console on a scratch data folder, driven through its widgets by object name.
///
/// Its engine is stepped here, so many cycles to a turn of the event loop: whatever the computer is busy with, machine
/// and screen keep pace with each other. On a machine that runs by itself, and where a test asks for it, on its own
/// thread.
class ConsoleBench {
 public:
    static constexpr int kTurn_ms = 1;
    static constexpr std::uint64_t kCyclesPerTurn = 4000;     ///< simulation as fast as it can
    static constexpr std::uint64_t kCyclesPerTurnIdle = 400;  ///< … and no program runs: the console has the processor
    static constexpr std::uint64_t kCyclesPerLook = 100;      ///< of these, until speed and program are looked at again
    static constexpr std::uint64_t kCyclesPerTurnTimed = 4;   ///< for every unit of simulation speed

    /// The same folder again: a restart.
    void start(const console::Options& options) {
        m_options = options;
        m_options.dataDir = m_folder.path().toStdString();
        m_options.ownThread = m_ownThread || m_options.machine == "linuxcnc";
        m_console = std::make_unique<console::ConsoleApplication>(m_options, m_rooms());
        m_failure.clear();
        QObject::connect(m_console.get(), &console::ConsoleApplication::ready, m_console.get(), [this] {
            m_console->window()->resize(1280, 800);
            m_console->window()->show();
            if (!m_options.ownThread) {
                QObject::connect(&m_pacer, &QTimer::timeout, m_console.get(), [this] { step(); });
                m_pacer.start(kTurn_ms);
            }
        });
        QObject::connect(m_console.get(), &console::ConsoleApplication::failed, m_console.get(),
                         [this](const QString& sentence) { m_failure = sentence; });
        if (const auto started = m_console->start(); !started) {
            m_failure = QString::fromStdString(started.error().english());
        }
    }
    /// A console at whose machine nothing was made before and nothing changes by itself, as fast as it can, with an
    /// engineer signed on.
    void startQuietly() {
        console::Options options;
        options.preparedParts = 0;
        options.simulationSpeed = 0.0;
        options.changeAtPart = 0;
        start(options);
        QTRY_VERIFY2_WITH_TIMEOUT(up(), qPrintable(m_failure), 30'000);
        QVERIFY(m_console->window()->session().signOn(QStringLiteral("Lee"), ui::Role::Engineer));
    }
    void stop() {
        m_pacer.stop();
        m_console.reset();
    }
    /// Before the first start: what the console bores, instead of its own recipe.
    void prepareBores(const BoringRecipe& recipe) {
        const std::string path = (folder() + QStringLiteral("/kerf.db")).toStdString();
        QVERIFY(db::prepareDatabase(path).has_value());
        db::WriterThread writer(path, nullptr);
        QVERIFY(writer.start().has_value());
        writer.submit(EnsurePartType{ProcessId::Boring, "Cylinder 50", recipeJson(recipe), "test"}, {});
        QCOMPARE(writer.stop(), std::size_t{0});
    }
    /// The console's own bore at four times the spindle speed: the same feeds and diameters in a quarter of the time.
    void prepareQuickBores() {
        BoringRecipe recipe;
        recipe.spindleSpeed_rpm *= 4.0;
        prepareBores(recipe);
    }
    /// The machine stands still, and with it everything that comes from it, until it goes on.
    void pause() { m_pacer.stop(); }
    void goOn() { m_pacer.start(kTurn_ms); }
    /// From the next start on.
    void setOwnThread(bool own) { m_ownThread = own; }

    using Rooms = std::function<std::vector<std::unique_ptr<console::Room>>()>;
    /// From the next start on: other processes than the console's own.
    void setRooms(Rooms rooms) { m_rooms = std::move(rooms); }

    [[nodiscard]] bool up() const { return m_console && m_console->window() != nullptr; }
    [[nodiscard]] const QString& failure() const { return m_failure; }
    [[nodiscard]] console::ConsoleApplication& console() { return *m_console; }
    [[nodiscard]] const BoringServiceView& service() { return m_console->boringService().view(); }
    [[nodiscard]] const Status& status() { return m_console->window()->client().status(); }
    [[nodiscard]] QString folder() const { return m_folder.path(); }

    /// The widget of that name that the operator can see; null when there is none.
    template <class Widget = QWidget>
    [[nodiscard]] Widget* find(const char* name) {
        for (Widget* widget : m_console->window()->findChildren<Widget*>(QLatin1String(name))) {
            if (widget->isVisibleTo(m_console->window())) {
                return widget;
            }
        }
        return nullptr;
    }
    /// Touch a button as soon as it can be pressed, as an operator does, again when it came to rest under the finger;
    /// false when it is not there or stays disabled.
    [[nodiscard]] bool press(const char* name) {
        const auto touched = [&] {
            auto* button = find<QAbstractButton>(name);
            if (button == nullptr || !button->isEnabled()) {
                return false;
            }
            bool pressed = false;
            const auto link = QObject::connect(button, &QAbstractButton::pressed, [&pressed] { pressed = true; });
            QTest::mouseClick(button, Qt::LeftButton);
            QObject::disconnect(link);
            return pressed;
        };
        return QTest::qWaitFor(touched, 10'000);
    }
    /// What a button that could not be touched says of itself.
    [[nodiscard]] QString obstacle(const char* name) {
        const auto* button = find<QAbstractButton>(name);
        const auto* action = qobject_cast<const ui::ActionButton*>(button);
        return QLatin1String(name) + (button == nullptr   ? QStringLiteral(": not there")
                                      : action == nullptr ? QString()
                                                          : QStringLiteral(": ") + action->reason());
    }
    [[nodiscard]] QString text(const char* name) {
        const auto* label = find<QLabel>(name);
        return label != nullptr ? label->text() : QString();
    }
    /// The keys of a number on the gloves keypad, then Enter.
    [[nodiscard]] bool keyIn(const QString& number) {
        for (const QChar c : number) {
            const QByteArray key = c == QLatin1Char('.') ? QByteArray("keyPoint") : QByteArray("key") + c.toLatin1();
            if (!press(key.constData())) {
                return false;
            }
        }
        return press("keyEnter");
    }

 private:
    void step() {
        Engine& engine = m_console->engine();
        for (std::uint64_t done = 0; done < kCyclesPerTurn;) {
            const double speed = engine.cycle().simulationSpeed();
            const std::uint64_t count =
                speed > 0.0 ? static_cast<std::uint64_t>(std::ceil(speed * kCyclesPerTurnTimed)) : kCyclesPerLook;
            engine.runCycles(count);
            const bool idle = engine.cycle().inputs().program != ProgramState::Running;
            done += speed > 0.0 ? kCyclesPerTurn : idle ? kCyclesPerTurn / kCyclesPerTurnIdle * count : count;
        }
    }

    QTemporaryDir m_folder;
    QTimer m_pacer;
    bool m_ownThread{false};
    Rooms m_rooms{console::standardRooms};
    console::Options m_options;
    QString m_failure;
    std::unique_ptr<console::ConsoleApplication> m_console;
};

}  // namespace kerf::test
