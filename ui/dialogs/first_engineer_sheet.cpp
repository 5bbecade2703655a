// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/dialogs/first_engineer_sheet.h"

#include <QCoreApplication>
#include <QLineEdit>

#include "ui/dialogs/sheet.h"
#include "ui/shell/operator_session.h"
#include "ui/widgets/label.h"

namespace kerf::ui {
namespace {
struct FirstEngineer {
    Q_DECLARE_TR_FUNCTIONS(FirstEngineer)
};
}  // namespace

void askFirstEngineer(Look& look, SheetHost& host, OperatorSession& session) {
    Sheet* sheet =
        host.open(FirstEngineer::tr("The first process engineer"),
                  FirstEngineer::tr(
                      "This machine knows nobody yet who may change recipes, limits and roles. Until then everybody "
                      "who signs on is an operator."));
    auto* name = new QLineEdit(sheet);
    name->setObjectName(QStringLiteral("firstEngineerName"));
    name->setPlaceholderText(FirstEngineer::tr("Name"));
    auto* pin = new QLineEdit(sheet);
    pin->setObjectName(QStringLiteral("firstEngineerPin"));
    pin->setPlaceholderText(
        FirstEngineer::tr("PIN, %1 to %2 digits").arg(OperatorSession::kShortestPin).arg(OperatorSession::kLongestPin));
    pin->setEchoMode(QLineEdit::Password);
    pin->setMaxLength(OperatorSession::kLongestPin);
    pin->setInputMethodHints(Qt::ImhDigitsOnly);
    auto* message = makeLabel(TextRole::Body, sheet, true);
    message->setObjectName(QStringLiteral("firstEngineerMessage"));
    sheet->body()->addWidget(name);
    sheet->body()->addWidget(pin);
    sheet->body()->addWidget(message);
    sheet->addButton(FirstEngineer::tr("Later"), {})->setObjectName(QStringLiteral("sheetSafe"));
    const auto make = [sheet, name, pin, message, &session] {
        if (session.makeFirstEngineer(name->text(), pin->text())) {
            sheet->close();
        } else {
            message->setText(FirstEngineer::tr("A name and a PIN of %1 to %2 digits are needed.")
                                 .arg(OperatorSession::kShortestPin)
                                 .arg(OperatorSession::kLongestPin));
        }
    };
    QObject::connect(pin, &QLineEdit::returnPressed, sheet, make);
    sheet->addButton(FirstEngineer::tr("Make and sign on"), make, false)
        ->setObjectName(QStringLiteral("firstEngineerMake"));
    name->setFocus();
    // It comes by itself at the first start, maybe in a language its reader does not know.
    sheet->followLanguage([&look, &host, &session, name] {
        const QString typed = name->text();
        askFirstEngineer(look, host, session);
        host.current()->findChild<QLineEdit*>(QStringLiteral("firstEngineerName"))->setText(typed);
    });
}

}  // namespace kerf::ui
