// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/dialogs/operator_chooser.h"

#include <QCoreApplication>
#include <QGridLayout>
#include <QLineEdit>

#include "ui/dialogs/sheet.h"
#include "ui/shell/operator_session.h"

namespace kerf::ui {
namespace {
struct OperatorChooser {
    Q_DECLARE_TR_FUNCTIONS(OperatorChooser)
};
constexpr int kMostButtons = 8;
constexpr int kColumns = 2;
}  // namespace

void chooseOperator(Look& look, SheetHost& host, OperatorSession& session, std::function<void()> then) {
    Sheet* sheet = host.open(OperatorChooser::tr("Who is at the machine?"),
                             OperatorChooser::tr("The name goes with every entry and correction."));
    const auto choose = [&session, sheet, then](const QString& name) {
        session.signOn(name);
        sheet->close();
        if (then && session.signedOn()) {
            then();
        }
    };
    auto* grid = new QGridLayout;
    grid->setSpacing(look.metrics().touchGap());
    const QStringList known = session.known().mid(qMax(0, session.known().size() - kMostButtons));
    for (int i = 0; i < known.size(); ++i) {
        auto* button = new QPushButton(known[i], sheet);
        button->setObjectName(QStringLiteral("operator%1").arg(i));
        QObject::connect(button, &QPushButton::clicked, sheet, [choose, name = known[i]] { choose(name); });
        grid->addWidget(button, i / kColumns, i % kColumns);
    }
    sheet->body()->addLayout(grid);
    auto* edit = new QLineEdit(sheet);
    edit->setObjectName(QStringLiteral("operatorName"));
    edit->setPlaceholderText(OperatorChooser::tr("New name"));
    QObject::connect(edit, &QLineEdit::returnPressed, sheet, [edit, choose] {
        if (!edit->text().simplified().isEmpty()) {
            choose(edit->text());
        }
    });
    sheet->body()->addWidget(edit);
    sheet->addButton(OperatorChooser::tr("Cancel"), {})->setObjectName(QStringLiteral("sheetSafe"));
    if (session.signedOn()) {
        sheet->addButton(OperatorChooser::tr("Sign off"), [&session] { session.signOff(); })
            ->setObjectName(QStringLiteral("signOff"));
    }
    QPushButton* accept = sheet->addButton(
        OperatorChooser::tr("Sign on"),
        [edit, choose] {
            if (!edit->text().simplified().isEmpty()) {
                choose(edit->text());
            }
        },
        false);
    accept->setObjectName(QStringLiteral("signOn"));
    accept->setEnabled(false);
    QObject::connect(edit, &QLineEdit::textChanged, accept,
                     [accept](const QString& text) { accept->setEnabled(!text.simplified().isEmpty()); });
    edit->setFocus();
}

}  // namespace kerf::ui
