// SPDX-License-Identifier: GPL-3.0-or-later
#include <QSignalSpy>
#include <QTest>

#include "ui/shell/mode_buttons.h"

using namespace kerf;
using namespace kerf::ui;

/// The switch of a loop, alike on all five pages.
class TestModeButtons : public QObject {
    Q_OBJECT
 private slots:
    void theEngineSaysWhatTheModeIs() {
        Look look;
        ModeButtons buttons(look, ProcessId::Tapping);
        buttons.setLoop({true, LoopMode::Advise, LoopState::Advising, {}});
        auto* control = buttons.findChild<QPushButton*>(QStringLiteral("tappingModeControl"));
        auto* advise = buttons.findChild<QPushButton*>(QStringLiteral("tappingModeAdvise"));
        QSignalSpy asked(&buttons, &ModeButtons::modeRequested);
        control->click();
        QCOMPARE(asked.count(), 1);
        QCOMPARE(asked.front().front().value<LoopMode>(), LoopMode::Control);
        QVERIFY(advise->isChecked() && !control->isChecked());  // until the engine has taken it
        buttons.setLoop({true, LoopMode::Control, LoopState::Controlling, {}});
        QVERIFY(control->isChecked());
    }
    void whoMayNotSeesWhy() {
        Look look;
        OperatorSession session;
        ModeButtons buttons(look, ProcessId::Boring);
        buttons.setLoop({true, LoopMode::Off, LoopState::Off, {}});
        buttons.setSession(session);
        const auto* off = buttons.findChild<QPushButton*>(QStringLiteral("boringModeOff"));
        QVERIFY(off->isEnabled());  // nobody there: the touch asks who it is
        QVERIFY(session.signOn(QStringLiteral("Kim"), Role::Operator));
        QVERIFY(!off->isEnabled());
        QVERIFY(buttons.words().contains(session.whyNot(Deed::SwitchLoop)));
        QVERIFY(session.signOn(QStringLiteral("Lee"), Role::Setter));
        QVERIFY(off->isEnabled());
        QVERIFY(!buttons.words().contains(QStringLiteral("Only")));
    }
    void withoutTheLoopTheyAreOff() {
        Look look;
        ModeButtons buttons(look, ProcessId::Milling);
        buttons.setLoop({});
        for (const auto* button : buttons.findChildren<QPushButton*>())
            QVERIFY(!button->isEnabled());
    }
};
QTEST_MAIN(TestModeButtons)
#include "tst_mode_buttons.moc"
