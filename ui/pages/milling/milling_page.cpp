// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/milling/milling_page.h"

#include <QDir>
#include <QPointer>
#include <algorithm>

#include "ui/dialogs/limits_sheet.h"
#include "ui/dialogs/lot_sheet.h"
#include "ui/dialogs/recipe_sheet.h"
#include "ui/link/release_stop.h"
#include "ui/link/texts.h"
#include "ui/pages/milling/blank_form.h"
#include "ui/pages/milling/cut_log.h"
#include "ui/pages/milling/milling_texts.h"
#include "ui/pages/milling/setup_form.h"
#include "ui/pages/milling/tool_memory_sheet.h"
#include "ui/shell/last_verdict.h"
#include "ui/shell/start_rest.h"
#include "ui/widgets/label.h"

namespace kerf::ui {

MillingPage::MillingPage(const PageContext& page, QWidget* parent)
    : Page(page, parent), m_service(page.services.millingService) {
    m_columns = new QHBoxLayout(this);
    if (m_service == nullptr) {
        m_missing = addNotice(m_columns);
    } else {
        build();
    }
    refresh();
}

MillingPage::~MillingPage() = default;

void MillingPage::build() {
    m_live = new MillingLivePanel(look(), this);
    m_wall = new MillingWallPanel(look(), this);
    m_tool = new MillingToolPanel(look(), this);
    m_control = new MillingControlPanel(look(), this);
    m_note = makeLabel(TextRole::Body, this, true);
    m_note->setObjectName(QStringLiteral("millingNote"));
    addLotLine(context(), m_service->lots(), m_wall->header());
    m_wall->header()->addWidget(new LastVerdict(context(), ProcessId::Milling, m_wall));
    m_left = new QVBoxLayout;
    m_lower = new QHBoxLayout;
    m_buttons = new QHBoxLayout;
    m_lower->addWidget(m_wall, 3);
    m_lower->addWidget(m_tool, 2);
    const auto add = [this](const char* name, auto onClicked) {
        auto* button = new ActionButton(look(), this);
        button->setObjectName(QLatin1String(name));
        button->setFocusPolicy(Qt::TabFocus);
        connect(button, &QPushButton::clicked, this, onClicked);
        m_buttons->addWidget(button, 1);
        return button;
    };
    const auto author = [this] { return context().session.author(); };
    m_setup = add("millingSetup", [this, author] {
        context().withOperator([this, author] {
            MillingSetupForm::open(context().sheets, look(), *m_service, author);
            offerRecipeSheet(
                context(), m_service->recipes(), Deed::MillingSetup,
                [this](const std::string& key) { return millingRecipeSpec(*m_service, key); }, millingRecipeWord);
            offerLimitsSheet(context(), ProcessId::Milling);
            offerLotSheet(context(), m_service->lots());
        });
    });
    m_blank = add("millingBlank", [this, author] {
        context().withOperator([this, author] {
            MillingBlankForm::open(context().sheets, look(), *m_service, author,
                                   QDir::homePath() + QStringLiteral("/blank.csv"));
        });
    });
    m_log = add("millingLog", [this] { openMillingCutLog(context().sheets, look(), *m_service); });
    m_newTool = add("millingNewTool", [this] { context().withOperator([this] { askNewTool(); }); });
    m_tools = add("millingTools", [this] { openToolMemory(context(), *m_service); });
    m_setup->setPredicate([this] { return whyNotChange(); });
    m_blank->setPredicate([this] { return whyNotChange(); });
    m_newTool->setPredicate([this] { return whyNotChange(); });
    m_log->setPredicate([this] { return m_service->view().cuts.empty() ? tr("Nothing cut yet.") : QString(); });
    m_left->addWidget(m_live, 5);
    m_left->addLayout(m_lower, 4);
    m_left->addWidget(m_note);
    m_left->addLayout(m_buttons);
    m_columns->addLayout(m_left, 1);
    m_columns->addWidget(m_control);

    allowOnly(m_setup, context().session, Deed::MillingSetup);
    allowOnly(m_blank, context().session, Deed::MillingBlank);
    m_control->setSession(context().session);
    restUntilShown(m_control->startButton(), context(), ProcessId::Milling);
    EngineClient& client = context().client;
    connect(m_control, &MillingControlPanel::lawRequested, this, [this, &client](MillingLaw law) {
        context().withPermission(Deed::MillingLaw, [&client, law] { client.sendAction(SetMillingLaw{law}); });
    });
    connect(m_control, &MillingControlPanel::teachRequested, this, [this, &client] {
        context().withPermission(Deed::MillingLaw, [&client] { client.sendAction(TeachMillingReference{}); });
    });
    connect(m_control, &MillingControlPanel::startRequested, this, [&client] { client.startPart(ProcessId::Milling); });
    connect(m_control, &MillingControlPanel::releaseRequested, this, [this] {
        // The stop that is shown now: one that comes while somebody signs on is looked at anew.
        const Status status = context().client.status();
        context().withOperator([this, status] {
            context().client.sendAction(releaseOf(status, ProcessId::Milling, context().session.author()));
        });
    });
    connect(m_control, &MillingControlPanel::modeRequested, this, [this, &client](LoopMode mode) {
        context().withPermission(Deed::SwitchLoop, [&client, mode] {
            client.sendAction(SetLoopMode{ProcessId::Milling, mode});
        });
    });
    connect(&client, &EngineClient::statusChanged, this, &MillingPage::onStatus);
    connect(&client, &EngineClient::samplesArrived, this, &MillingPage::onSamples);
    m_subscription = m_service->onChanged([this] { onServiceChanged(); });
}

void MillingPage::refresh() {
    setObjectName(QStringLiteral("millingPage"));
    const int gap = look().space(Space::Medium);
    m_columns->setContentsMargins(gap, gap, gap, gap);
    m_columns->setSpacing(gap);
    if (m_missing != nullptr) {
        m_missing->setText(tr("This machine has no milling loop."));
    } else {
        m_left->setSpacing(gap);
        m_lower->setSpacing(gap);
        m_buttons->setSpacing(look().metrics().touchGap());
        m_control->setFixedWidth(look().metrics().sideWidth());
        m_setup->setText(tr("Setup"));
        m_blank->setText(tr("Blank profile"));
        m_log->setText(tr("Cut log"));
        m_newTool->setText(tr("New tool"));
        m_tools->setText(tr("Tools before"));
        onServiceChanged();
        onStatus(context().client.status());
    }
    Page::refresh();
}

void MillingPage::showEvent(QShowEvent* event) {
    Page::showEvent(event);
    if (m_service != nullptr) {
        onServiceChanged();
    }
}

void MillingPage::onServiceChanged() {
    const MillingServiceView& view = m_service->view();
    m_live->setSetup(view.setup);
    m_wall->setView(view);
    m_tool->setView(view);
    m_control->setView(view);
    const QString problem = view.problem.empty() ? QString() : sentenceText(view.problem, look().units());
    m_note->setText(problem.isEmpty() ? QString() : tr("Milling data: %1").arg(problem));
    m_note->setVisible(!problem.isEmpty());
    for (ActionButton* button : {m_setup, m_blank, m_log, m_newTool}) {
        button->reconsider();
    }
}

void MillingPage::onStatus(const Status& status) {
    m_wall->setStatus(status);  // also while hidden: it remembers the cut before
    if (!isVisible()) {
        return;
    }
    m_live->setStatus(status);
    m_tool->setStatus(status);
    m_control->setStatus(status, context().client.engine().capabilities());
    for (ActionButton* button : {m_setup, m_blank, m_newTool}) {
        button->reconsider();
    }
}

void MillingPage::onSamples(std::span<const Sample> samples) {
    const Status& status = context().client.status();
    if (status.programProcess != ProcessId::Milling) {
        return;
    }
    m_live->addSamples(samples, status.milling.blind);
    m_wall->addSamples(samples, status.milling.blind);
}

QString MillingPage::whyNotChange() const {
    if (context().client.status().milling.cutting) {
        return tr("A part is being cut.");
    }
    return m_service->view().busy ? tr("being stored") : QString();
}

void MillingPage::askNewTool() {
    context().sheets.ask(tr("New tool?"), tr("Wear and stiffness of the tool are learnt anew from the next cut on."),
                         tr("No"), tr("New tool"), [this] {
                             const QPointer<MillingPage> self(this);
                             m_service->newTool(context().session.author(), [self](const Result<void>& result) {
                                 MillingPage* there = self.data();
                                 if (there != nullptr && !result) {
                                     there->context().notify(sentenceText(result.error(), there->look().units()));
                                 }
                             });
                         });
}

}  // namespace kerf::ui
