// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/dialogs/pin_sheet.h"

#include <QCoreApplication>
#include <QLineEdit>

#include "ui/dialogs/sheet.h"
#include "ui/shell/operator_session.h"
#include "ui/widgets/keypad.h"
#include "ui/widgets/label.h"

namespace kerf::ui {
namespace {
struct PinSheet {
    Q_DECLARE_TR_FUNCTIONS(PinSheet)
};
}  // namespace

void askPin(Look& look, SheetHost& host, const QString& title, const QString& text, const QString& refusal,
            std::function<bool(const QString&)> take, std::function<void()> then, std::function<QString()> whyNotYet) {
    Sheet* sheet = host.openOver(title, text);
    auto* field = new QLineEdit(sheet);
    field->setObjectName(QStringLiteral("pinField"));
    field->setEchoMode(QLineEdit::Password);
    field->setMaxLength(OperatorSession::kLongestPin);
    field->setInputMethodHints(Qt::ImhDigitsOnly);
    auto* message = makeLabel(TextRole::Body, sheet, true);
    message->setObjectName(QStringLiteral("pinMessage"));
    auto* keypad = new Keypad(look, Keypad::Shape::Wide, sheet);
    keypad->setObjectName(QStringLiteral("pinKeypad"));
    keypad->setTarget(field);
    sheet->body()->addWidget(field);
    sheet->body()->addWidget(message);
    sheet->body()->addWidget(keypad);
    sheet->addButton(PinSheet::tr("Cancel"), {})->setObjectName(QStringLiteral("sheetSafe"));
    QObject::connect(field, &QLineEdit::textEdited, message, [message] { message->clear(); });
    QObject::connect(field, &QLineEdit::returnPressed, sheet, [sheet, field, message, take, then, refusal, whyNotYet] {
        if (take(field->text())) {
            sheet->close();
            if (then) {
                then();
            }
        } else {
            field->clear();
            const QString wait = whyNotYet ? whyNotYet() : QString();
            message->setText(wait.isEmpty() ? refusal : wait);
        }
    });
    field->setFocus();
}

}  // namespace kerf::ui
