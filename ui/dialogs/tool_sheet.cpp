// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/dialogs/tool_sheet.h"

#include <QCoreApplication>
#include <QDateTime>
#include <QGridLayout>
#include <QLineEdit>
#include <QPointer>
#include <algorithm>

#include "ui/link/texts.h"
#include "ui/services/shift_service.h"
#include "ui/widgets/label.h"

namespace kerf::ui {
namespace {

struct Tools {
    Q_DECLARE_TR_FUNCTIONS(Tools)
};

constexpr int kMostDigits = 6;

QString toolText(const ToolLife& tool) {
    QStringList words{tool.life > 0 ? Tools::tr("%1 of %2 parts").arg(tool.parts).arg(tool.life)
                                    : Tools::tr("%1 parts, no life is set").arg(tool.parts)};
    if (tool.sinceUtc_ms > 0) {
        words << Tools::tr("changed %1 by %2")
                     .arg(QDateTime::fromMSecsSinceEpoch(tool.sinceUtc_ms).toString(QStringLiteral("MM-dd HH:mm")),
                          QString::fromStdString(tool.changedBy));
    }
    return words.join(QStringLiteral(" · "));
}

ToolLife toolOf(const PageContext& context, ProcessId process) {
    const auto& tools = context.services.shiftService->tools();
    const auto found = std::ranges::find(tools, process, &ToolLife::process);
    return found != tools.end() ? *found : ToolLife{process};
}

void askLife(const PageContext& context, ProcessId process) {
    const ToolLife tool = toolOf(context, process);
    Sheet* sheet = context.sheets.open(Tools::tr("Life of the tool: %1").arg(processName(tool.process)),
                                       Tools::tr("Parts that a tool is used for. At nine tenths of them Kerf says so. "
                                                 "0: no life is set."));
    auto* row = new QHBoxLayout;
    auto* field = new QLineEdit(sheet);
    field->setObjectName(QStringLiteral("toolLifeField"));
    field->setInputMethodHints(Qt::ImhDigitsOnly);
    field->setMaxLength(kMostDigits);
    field->setText(QString::number(tool.life));
    field->selectAll();
    field->setFocus();
    row->addWidget(field);
    sheet->body()->addLayout(row);
    sheet->addButton(Tools::tr("Cancel"), {})->setObjectName(QStringLiteral("sheetSafe"));
    QPushButton* keep = sheet->addButton(Tools::tr("Keep it"), std::function<void()>(), false);
    QObject::connect(keep, &QPushButton::clicked, sheet, [context, sheet, keep, field, process] {
        bool ok = false;
        const uint parts = field->text().trimmed().toUInt(&ok);
        if (!ok) {
            sheet->setText(Tools::tr("A life is a whole number of parts."));
            return;
        }
        const auto told = [context](const Result<void>& result) {
            context.notify(result ? Tools::tr("The life is kept.")
                                  : sentenceText(result.error(), context.look.units()));
        };
        context.services.shiftService->setToolLife(process, parts, context.session.author(),
                                                   sheet->whenStored(keep, told));
    });
    keep->setObjectName(QStringLiteral("toolLifeSave"));
    QObject::connect(field, &QLineEdit::returnPressed, keep, &QPushButton::click);
}

}  // namespace

void openTools(const PageContext& context) {
    Sheet* sheet = context.sheets.open(
        Tools::tr("Tools"), Tools::tr("Parts are counted from the last change. Say so when a new tool or insert is in: "
                                      "wear and what the loop has learnt of the old one end with it."));
    auto* grid = new QGridLayout;
    grid->setSpacing(context.look.metrics().touchGap());
    int row = 0;
    for (const ToolLife& tool : context.services.shiftService->tools()) {
        if (!context.client.status().loops[static_cast<std::size_t>(tool.process)].fitted) {
            continue;
        }
        const QLatin1String key(processKey(tool.process));
        auto* name = makeLabel(TextRole::Title, sheet);
        name->setText(processName(tool.process));
        auto* text = makeLabel(TextRole::Body, sheet, true);
        text->setObjectName(QStringLiteral("tool_") + key);
        text->setText(toolText(tool));
        auto* life = new QPushButton(Tools::tr("Life"), sheet);
        life->setObjectName(QStringLiteral("toolLife_") + key);
        auto* fresh = new QPushButton(Tools::tr("New tool"), sheet);
        fresh->setObjectName(QStringLiteral("toolNew_") + key);
        QObject::connect(life, &QPushButton::clicked, sheet, [context, process = tool.process] {
            context.withRole(Role::Setter, [context, process] { askLife(context, process); });
        });
        QObject::connect(
            fresh, &QPushButton::clicked, sheet, [context, process = tool.process, label = QPointer(text)] {
                context.withOperator([context, process, label] {
                    context.services.shiftService->newTool(
                        process, context.session.author(), [context, process, label](const Result<void>& result) {
                            context.notify(result ? Tools::tr("A new tool is in: its parts are counted from here.")
                                                  : sentenceText(result.error(), context.look.units()));
                            if (label) {  // else the sheet has gone meanwhile: whatever is open is somebody's
                                label->setText(toolText(toolOf(context, process)));
                            }
                        });
                });
            });
        grid->addWidget(name, row, 0);
        grid->addWidget(text, row, 1);
        grid->addWidget(life, row, 2);
        grid->addWidget(fresh, row, 3);
        ++row;
    }
    grid->setColumnStretch(1, 1);
    sheet->body()->addLayout(grid);
    sheet->addButton(Tools::tr("Close"), {})->setObjectName(QStringLiteral("sheetSafe"));
}

}  // namespace kerf::ui
