// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/dialogs/people_sheet.h"

#include <QButtonGroup>
#include <QCoreApplication>
#include <QGridLayout>
#include <QHeaderView>
#include <QPointer>
#include <QScrollArea>
#include <QScroller>
#include <QTableWidget>
#include <array>
#include <functional>

#include "ui/dialogs/pin_sheet.h"
#include "ui/dialogs/sheet.h"
#include "ui/link/texts.h"
#include "ui/shell/operator_session.h"
#include "ui/widgets/action_button.h"
#include "ui/widgets/label.h"

namespace kerf::ui {
namespace {

struct People {
    Q_DECLARE_TR_FUNCTIONS(People)
};

constexpr std::array kRoleObjects{"personOperator", "personSetter", "personEngineer"};
constexpr std::array kMinutes{SignOnSettings::kNever, 5, 15, 60};

/// `anew`: the list is made again from what is known by then.
void addPerson(Look& look, SheetHost& host, OperatorSession& session, QGridLayout* grid, int row, QWidget* parent,
               const std::function<void()>& anew) {
    const OperatorAccount& person = session.settings().accounts[static_cast<std::size_t>(row)];
    auto* name = makeLabel(TextRole::Body, parent);
    name->setObjectName(QStringLiteral("person%1").arg(row));
    name->setText(person.name);
    grid->addWidget(name, row, 0);
    auto* group = new QButtonGroup(parent);
    for (std::size_t i = 0; i < kRoles.size(); ++i) {
        auto* button = new QPushButton(roleName(kRoles[i]), parent);
        button->setObjectName(QLatin1String(kRoleObjects[i]) + QString::number(row));
        button->setCheckable(true);
        button->setChecked(person.role == kRoles[i]);
        group->addButton(button);
        grid->addWidget(button, row, 1 + static_cast<int>(i));
        QObject::connect(button, &QPushButton::clicked, parent,
                         [&session, who = person.name, role = kRoles[i]] { session.setRole(who, role); });
    }
    auto* pin = new QPushButton(person.pin.isEmpty() ? People::tr("No PIN") : People::tr("Has a PIN"), parent);
    pin->setObjectName(QStringLiteral("personPin%1").arg(row));
    grid->addWidget(pin, row, 4);
    QObject::connect(pin, &QPushButton::clicked, parent, [&look, &host, &session, anew, who = person.name] {
        askPin(
            look, host, People::tr("PIN of %1").arg(who),
            People::tr("%1 to %2 digits; nothing asks for none.")
                .arg(OperatorSession::kShortestPin)
                .arg(OperatorSession::kLongestPin),
            People::tr("A PIN has %1 to %2 digits.")
                .arg(OperatorSession::kShortestPin)
                .arg(OperatorSession::kLongestPin),
            [&session, who](const QString& typed) { return session.setPin(who, typed); }, anew);
    });
    auto* off = new ActionButton(look, parent);
    off->setObjectName(QStringLiteral("personRemove%1").arg(row));
    off->setText(People::tr("Take off"));
    off->setPredicate([&session, who = person.name] { return session.whyNotRemove(who); });
    grid->addWidget(off, row, 5);
    QObject::connect(off, &QPushButton::clicked, parent, [&host, &session, anew, who = person.name] {
        host.ask(People::tr("Take %1 off the list?").arg(who),
                 People::tr("What was done under this name keeps it. Who comes back signs on anew, as an operator."),
                 People::tr("Cancel"), People::tr("Take off"), [&session, anew, who] {
                     session.remove(who);
                     anew();
                 });
    });
}

/// The one table that services and pages ask, as it stands.
void openPermissions(Look& look, SheetHost& host) {
    Sheet* sheet =
        host.openOver(People::tr("Who may do what"),
                      People::tr("Each role may do what the ones before it may. Starting a part, HOLD ALL and "
                                 "its release, and ending a tap ask for no name."));
    auto* table = new QTableWidget(static_cast<int>(kDeedCount), 3, sheet);
    table->setObjectName(QStringLiteral("permissions"));
    table->setHorizontalHeaderLabels({People::tr("what"), People::tr("from this role on"), People::tr("reason")});
    table->verticalHeader()->hide();
    table->setEditTriggers(QAbstractItemView::NoEditTriggers);
    table->setSelectionMode(QAbstractItemView::NoSelection);
    table->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    table->horizontalHeader()->setSectionResizeMode(0, QHeaderView::Stretch);
    for (int row = 0; row < static_cast<int>(kDeedCount); ++row) {
        const Permission& one = kPermissions[static_cast<std::size_t>(row)];
        table->setItem(row, 0, new QTableWidgetItem(engineText(one.name)));
        table->setItem(row, 1, new QTableWidgetItem(roleName(one.least)));
        table->setItem(row, 2, new QTableWidgetItem(one.reason ? People::tr("must be given") : QString()));
    }
    table->setMinimumHeight(qMin(host.height() / 2, 12 * look.metrics().touch()));
    QScroller::grabGesture(table->viewport(), QScroller::TouchGesture);
    sheet->body()->addWidget(table, 1);
    sheet->addButton(People::tr("Close"), {})->setObjectName(QStringLiteral("sheetSafe"));
}

}  // namespace

void openPeople(Look& look, SheetHost& host, OperatorSession& session) {
    Sheet* sheet = host.openOver(
        People::tr("People at this machine"),
        People::tr("Operators enter and correct diameters. Setters also open lots and switch loops. Process engineers "
                   "also change recipes, limits and this list."));
    auto* list = new QWidget;
    list->setProperty("role", QStringLiteral("scrolled"));
    auto* grid = new QGridLayout(list);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setSpacing(look.metrics().touchGap());
    grid->setColumnStretch(0, 1);
    const auto anew = [&look, &host, &session, here = QPointer<Sheet>(sheet)] {
        if (here) {
            here->close();
        }
        openPeople(look, host, session);
    };
    for (int row = 0; row < static_cast<int>(session.settings().accounts.size()); ++row) {
        addPerson(look, host, session, grid, row, list, anew);
    }
    auto* area = new QScrollArea(sheet);
    area->setObjectName(QStringLiteral("people"));
    area->setWidgetResizable(true);
    area->setFrameShape(QFrame::NoFrame);
    area->setWidget(list);
    area->setMinimumHeight(qMin(list->sizeHint().height(), host.height() / 3));
    QScroller::grabGesture(area->viewport(), QScroller::TouchGesture);
    sheet->body()->addWidget(area, 1);

    auto* words = makeLabel(TextRole::Body, sheet, true);
    words->setText(People::tr("Sign off when nobody has touched anything for"));
    sheet->body()->addWidget(words);
    auto* times = new QHBoxLayout;
    times->setSpacing(look.metrics().touchGap());
    auto* group = new QButtonGroup(sheet);
    for (const int minutes : kMinutes) {
        const bool never = minutes == SignOnSettings::kNever;
        auto* button = new QPushButton(never ? People::tr("never") : People::tr("%1 min").arg(minutes), sheet);
        button->setObjectName(never ? QStringLiteral("signOffNever") : QStringLiteral("signOff%1").arg(minutes));
        button->setCheckable(true);
        button->setChecked(session.settings().autoSignOff_min == minutes);
        group->addButton(button);
        times->addWidget(button, 1);
        QObject::connect(button, &QPushButton::clicked, sheet,
                         [&session, minutes] { session.setAutoSignOff_min(minutes); });
    }
    sheet->body()->addLayout(times);
    sheet
        ->addButton(
            People::tr("Who may do what"), [&look, &host] { openPermissions(look, host); }, false)
        ->setObjectName(QStringLiteral("peoplePermissions"));
    sheet->addButton(People::tr("Close"), {})->setObjectName(QStringLiteral("sheetSafe"));
}

}  // namespace kerf::ui
