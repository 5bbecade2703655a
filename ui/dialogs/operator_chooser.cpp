// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/dialogs/operator_chooser.h"

#include <QButtonGroup>
#include <QCoreApplication>
#include <QGridLayout>
#include <QLineEdit>
#include <array>

#include "ui/dialogs/people_sheet.h"
#include "ui/dialogs/pin_sheet.h"
#include "ui/dialogs/sheet.h"
#include "ui/shell/operator_session.h"
#include "ui/widgets/action_button.h"
#include "ui/widgets/label.h"

namespace kerf::ui {
namespace {
struct OperatorChooser {
    Q_DECLARE_TR_FUNCTIONS(OperatorChooser)
};
constexpr int kMostButtons = 8;
constexpr int kColumns = 2;

QString demonstrationNote(const OperatorSession& session) {
    const bool open = session.settings().demonstration && session.whyNoRoles().isEmpty() && !session.signedOn();
    return open ? QStringLiteral("\n") +
                      OperatorChooser::tr(
                          "Demonstration on a simulated machine: a new name may take any role until there is a "
                          "process engineer.")
                : QString();
}

/// Who says yes beside the one who is signed on, by PIN.
void askSecond(Look& look, SheetHost& host, OperatorSession& session) {
    Sheet* sheet = host.openOver(
        OperatorChooser::tr("Who says yes as well?"),
        OperatorChooser::tr("For two minutes %1 may raise a limit by more than half.").arg(session.name()));
    const QStringList others = session.possibleSeconds();
    for (int i = 0; i < others.size(); ++i) {
        auto* button = new QPushButton(others[i], sheet);
        button->setObjectName(QStringLiteral("second%1").arg(i));
        sheet->body()->addWidget(button);
        QObject::connect(button, &QPushButton::clicked, sheet, [&look, &host, &session, sheet, name = others[i]] {
            sheet->close();
            askPin(
                look, host, name, OperatorChooser::tr("Type your PIN."), OperatorChooser::tr("This PIN does not fit."),
                [&session, name](const QString& pin) { return session.confirmAsSecond(name, pin); },
                [&host, &session, name] {
                    host.tell(OperatorChooser::tr("%1 has said yes").arg(name),
                              OperatorChooser::tr("For two minutes %1 may raise a limit by more than half.")
                                  .arg(session.name()));
                },
                [&session, name] { return session.whyNotYet(name); });
        });
    }
    sheet->addButton(OperatorChooser::tr("Cancel"), {})->setObjectName(QStringLiteral("sheetSafe"));
}

}  // namespace

void chooseOperator(Look& look, SheetHost& host, OperatorSession& session, std::function<void()> then) {
    // Over the form that asked: it comes back as it was.
    Sheet* sheet = host.openOver(
        OperatorChooser::tr("Who is at the machine?"),
        OperatorChooser::tr("The name goes with every entry and correction.") + demonstrationNote(session));
    auto* grid = new QGridLayout;
    grid->setSpacing(look.metrics().touchGap());
    const QStringList all = session.known();
    const QStringList known = all.mid(qMax(0, all.size() - kMostButtons));
    auto* edit = new QLineEdit(sheet);
    auto* roles = new QButtonGroup(sheet);
    const auto choose = [&look, &host, &session, sheet, roles, then](const QString& typed) {
        const QString name = typed.simplified();
        if (name.isEmpty()) {
            return;
        }
        const OperatorAccount* account = session.account(name);
        if (account != nullptr && !account->pin.isEmpty() && name != session.name()) {
            sheet->close();
            askPin(
                look, host, name, OperatorChooser::tr("Type your PIN."), OperatorChooser::tr("This PIN does not fit."),
                [&session, name](const QString& pin) { return session.signOn(name, Role::Operator, pin); }, then,
                [&session, name] { return session.whyNotYet(name); });
            return;
        }
        session.signOn(name, kRoles[static_cast<std::size_t>(qMax(0, roles->checkedId()))]);
        sheet->close();
        if (then && session.signedOn()) {
            then();
        }
    };
    for (int i = 0; i < known.size(); ++i) {
        const OperatorAccount* account = session.account(known[i]);
        auto* button = new QPushButton(known[i] + QStringLiteral(" · ") + roleName(account->role), sheet);
        button->setObjectName(QStringLiteral("operator%1").arg(i));
        QObject::connect(button, &QPushButton::clicked, sheet, [choose, name = known[i]] { choose(name); });
        grid->addWidget(button, i / kColumns, i % kColumns);
    }
    sheet->body()->addLayout(grid);
    edit->setObjectName(QStringLiteral("operatorName"));
    edit->setPlaceholderText(OperatorChooser::tr("New name"));
    QObject::connect(edit, &QLineEdit::returnPressed, sheet, [edit, choose] { choose(edit->text()); });
    sheet->body()->addWidget(edit);
    auto* roleRow = new QHBoxLayout;
    roleRow->setSpacing(look.metrics().touchGap());
    constexpr std::array kNames{"roleOperator", "roleSetter", "roleEngineer"};
    for (std::size_t i = 0; i < kRoles.size(); ++i) {
        auto* button = new ActionButton(look, sheet);
        button->setObjectName(QLatin1String(kNames[i]));
        button->setText(roleName(kRoles[i]));
        button->setCheckable(true);
        button->setFocusPolicy(Qt::TabFocus);
        if (kRoles[i] != Role::Operator) {
            button->setPredicate([&session] { return session.whyNoRoles(); });
        }
        roles->addButton(button, static_cast<int>(i));
        roleRow->addWidget(button, 1);
    }
    roles->button(0)->setChecked(true);
    sheet->body()->addLayout(roleRow);
    sheet->addButton(OperatorChooser::tr("Cancel"), {})->setObjectName(QStringLiteral("sheetSafe"));
    auto* people = new ActionButton(look, sheet);
    people->setObjectName(QStringLiteral("people"));
    people->setText(OperatorChooser::tr("People"));
    people->setPredicate([&session] {
        return session.known().isEmpty() ? OperatorChooser::tr("nobody is known yet") : session.whyNoRoles();
    });
    sheet->addButton(people, [&look, &host, &session] { openPeople(look, host, session); });
    if (session.signedOn()) {
        auto* second = new ActionButton(look, sheet);
        second->setObjectName(QStringLiteral("secondPerson"));
        second->setText(OperatorChooser::tr("Second person"));
        second->setPredicate([&session] {
            return session.possibleSeconds().isEmpty() ? OperatorChooser::tr("no other setter or engineer has a PIN")
                                                       : QString();
        });
        sheet->addButton(second, [&look, &host, &session] { askSecond(look, host, session); });
        sheet->addButton(OperatorChooser::tr("Sign off"), [&session] { session.signOff(); })
            ->setObjectName(QStringLiteral("signOff"));
    }
    QPushButton* accept = sheet->addButton(
        OperatorChooser::tr("Sign on"), [edit, choose] { choose(edit->text()); }, false);
    accept->setObjectName(QStringLiteral("signOn"));
    accept->setEnabled(false);
    QObject::connect(edit, &QLineEdit::textChanged, accept,
                     [accept](const QString& text) { accept->setEnabled(!text.simplified().isEmpty()); });
    edit->setFocus();
    // Whoever takes over may read the other language.
    sheet->followLanguage([&look, &host, &session, then, edit] {
        const QString typed = edit->text();
        chooseOperator(look, host, session, then);
        host.current()->findChild<QLineEdit*>(QStringLiteral("operatorName"))->setText(typed);
    });
}

}  // namespace kerf::ui
