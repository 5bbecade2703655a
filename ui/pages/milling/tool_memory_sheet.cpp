// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/milling/tool_memory_sheet.h"

#include <QCoreApplication>
#include <QGridLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPointer>
#include <QPushButton>
#include <cmath>

#include "ui/dialogs/sheet.h"
#include "ui/link/texts.h"
#include "ui/link/vocabulary.h"
#include "ui/widgets/label.h"

namespace kerf::ui {
namespace {

struct ToolMemory {
    Q_DECLARE_TR_FUNCTIONS(ToolMemory)
};

constexpr int kStiffness_decimals = 2;

QString toolText(const MillingToolView& tool, Wording wording) {
    QString text =
        ToolMemory::tr("%1, %2 parts: %3 %4 N/mm, %5 %6", "part type, parts, two figures of a tool with their names")
            .arg(QString::fromStdString(tool.partType))
            .arg(tool.parts)
            .arg(termText(Term::ToolStiffness, wording), UnitSystem::fixed(tool.kx_NPerMm, 0),
                 termText(Term::StiffnessAxis, wording), UnitSystem::fixed(tool.firstStiffness, kStiffness_decimals));
    if (tool.leftOut) {
        text += u'\n' + ToolMemory::tr("left out by %1: %2")
                            .arg(QString::fromStdString(tool.author), QString::fromStdString(tool.reason));
    }
    return text;
}

}  // namespace

QString toolMemoryText(const MillingMemoryView& memory, Wording wording) {
    if (!memory.lnKx) {
        return {};
    }
    const auto kx = [&](double ln) { return UnitSystem::fixed(std::exp(ln), 0); };
    QString text =
        ToolMemory::tr("Begins from %1 tools before: %2 %3 N/mm (%4 to %5)", "how many, name, value, interval")
            .arg(memory.lnKx->tools)
            .arg(termText(Term::ToolStiffness, wording), kx(memory.lnKx->mean),
                 kx(memory.lnKx->mean - memory.lnKx->half95), kx(memory.lnKx->mean + memory.lnKx->half95));
    if (memory.stiffness) {
        text += ToolMemory::tr(", %1 %2 ± %3", "name and value expected of the first part")
                    .arg(termText(Term::StiffnessAxis, wording),
                         UnitSystem::fixed(memory.stiffness->mean, kStiffness_decimals),
                         UnitSystem::fixed(memory.stiffness->half95, kStiffness_decimals));
    }
    return text + u'.';
}

void openToolMemory(const PageContext& context, MillingService& service) {
    const MillingMemoryView memory = service.view().memory;
    const QString rests = toolMemoryText(memory, context.look.wording());
    Sheet* sheet = context.sheets.open(
        ToolMemory::tr("Tools before"),
        rests.isEmpty() ? ToolMemory::tr("A new tool begins from tools of its radius and flutes. There are none yet.")
                        : rests);
    sheet->setWide();
    auto* list = new QWidget(sheet);
    list->setObjectName(QStringLiteral("millingToolsBefore"));
    auto* rows = new QGridLayout(list);
    auto* reason = new QLineEdit(sheet);
    reason->setObjectName(QStringLiteral("millingToolReason"));
    reason->setPlaceholderText(ToolMemory::tr("Reason"));
    auto* message = makeLabel(TextRole::Body, sheet, true);
    message->setObjectName(QStringLiteral("millingToolsMessage"));
    const QPointer<Sheet> open = sheet;
    int row = 0;
    for (const MillingToolView& tool : memory.tools) {
        auto* words = makeLabel(TextRole::Body, list, true);
        words->setText(toolText(tool, context.look.wording()));
        auto* button =
            new QPushButton(tool.leftOut ? ToolMemory::tr("Take in again") : ToolMemory::tr("Leave out"), list);
        button->setObjectName(QStringLiteral("millingLeaveOut_%1").arg(tool.since));
        QObject::connect(button, &QPushButton::clicked, sheet, [context, &service, tool, reason, message, open] {
            const std::string why = reason->text().simplified().toStdString();
            context.withRole(Role::Setter, [context, &service, tool, why, message = QPointer<QLabel>(message), open] {
                service.leaveOut(tool.since, !tool.leftOut, context.session.author(), why,
                                 [context, &service, message, open](const Result<void>& done) {
                                     if (!done && message) {
                                         message->setText(sentenceText(done.error(), context.look.units()));
                                     } else if (done && open) {
                                         openToolMemory(context, service);
                                     }
                                 });
            });
        });
        rows->addWidget(words, row, 0);
        rows->addWidget(button, row, 1);
        ++row;
    }
    rows->setColumnStretch(0, 1);
    sheet->body()->addWidget(list);
    sheet->body()->addWidget(reason);
    sheet->body()->addWidget(message);
    sheet->body()->addStretch(1);
    reason->setVisible(!memory.tools.empty());  // nothing to leave out
    sheet->addButton(ToolMemory::tr("Close"), {})->setObjectName(QStringLiteral("sheetSafe"));
}

}  // namespace kerf::ui
