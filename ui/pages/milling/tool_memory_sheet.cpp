// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/milling/tool_memory_sheet.h"

#include <QCoreApplication>
#include <QGridLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPointer>
#include <QPushButton>
#include <algorithm>
#include <cmath>

#include "ui/dialogs/sheet.h"
#include "ui/link/reason_text.h"
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
        text += u'\n' +
                ToolMemory::tr("left out by %1: %2").arg(QString::fromStdString(tool.author), reasonText(tool.reason));
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

namespace {

QString aboveTheTools(const PageContext& context, const MillingService& service) {
    const QString rests = toolMemoryText(service.view().memory, context.look.wording());
    return rests.isEmpty()
               ? ToolMemory::tr("A new tool begins from tools of its radius and flutes. There are none yet.")
               : rests;
}

/// A tool's line. What is in the other lines and in the reason stays while the answer is awaited.
struct ToolLine {
    QPointer<Sheet> sheet{};
    QPointer<QLabel> words{};
    QPointer<QPushButton> button{};
    QPointer<QLineEdit> reason{};
    QPointer<QLabel> message{};
};

const MillingToolView* findTool(const MillingService& service, std::int64_t since) {
    const auto& tools = service.view().memory.tools;
    const auto found = std::ranges::find(tools, since, &MillingToolView::since);
    return found != tools.end() ? &*found : nullptr;
}

void showTool(const ToolLine& line, const MillingToolView& tool, Wording wording) {
    line.words->setText(toolText(tool, wording));
    line.button->setText(tool.leftOut ? ToolMemory::tr("Take in again") : ToolMemory::tr("Leave out"));
}

void answered(const PageContext& context, const MillingService& service, const ToolLine& line, std::int64_t since,
              const QString& reason, const Result<void>& done) {
    if (!line.sheet) {
        context.notify(done ? ToolMemory::tr("What tools before count for is kept.")
                            : sentenceText(done.error(), context.look.units()));
        return;
    }
    line.message->setText(done ? QString() : sentenceText(done.error(), context.look.units()));
    const MillingToolView* tool = findTool(service, since);
    if (!done || tool == nullptr) {
        return;
    }
    showTool(line, *tool, context.look.wording());
    line.sheet->setText(aboveTheTools(context, service));
    if (line.reason->text() == reason) {  // else the next one is being typed
        line.reason->clear();
    }
}

void leaveOut(const PageContext& context, MillingService& service, const ToolLine& line, std::int64_t since) {
    const QString reason = line.reason->text();
    context.withRole(Role::Setter, [context, &service, line, since, reason] {
        const MillingToolView* tool = findTool(service, since);
        if (tool == nullptr) {
            return;
        }
        service.leaveOut(since, !tool->leftOut, context.session.author(), reason.simplified().toStdString(),
                         [context, &service, line, since, reason](const Result<void>& done) {
                             answered(context, service, line, since, reason, done);
                         });
    });
}

}  // namespace

void openToolMemory(const PageContext& context, MillingService& service) {
    const MillingMemoryView memory = service.view().memory;
    Sheet* sheet = context.sheets.open(ToolMemory::tr("Tools before"), aboveTheTools(context, service));
    sheet->setWide();
    auto* list = new QWidget(sheet);
    list->setObjectName(QStringLiteral("millingToolsBefore"));
    auto* rows = new QGridLayout(list);
    auto* reason = new QLineEdit(sheet);
    reason->setObjectName(QStringLiteral("millingToolReason"));
    reason->setPlaceholderText(ToolMemory::tr("Reason"));
    auto* message = makeLabel(TextRole::Body, sheet, true);
    message->setObjectName(QStringLiteral("millingToolsMessage"));
    int row = 0;
    for (const MillingToolView& tool : memory.tools) {
        auto* words = makeLabel(TextRole::Body, list, true);
        auto* button = new QPushButton(list);
        button->setObjectName(QStringLiteral("millingLeaveOut_%1").arg(tool.since));
        const ToolLine line{sheet, words, button, reason, message};
        showTool(line, tool, context.look.wording());
        QObject::connect(button, &QPushButton::clicked, sheet,
                         [context, &service, line, since = tool.since] { leaveOut(context, service, line, since); });
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
