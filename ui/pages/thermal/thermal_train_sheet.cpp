// SPDX-License-Identifier: GPL-3.0-or-later
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QTableWidget>
#include <algorithm>

#include "ui/link/reason_text.h"
#include "ui/link/texts.h"
#include "ui/pages/thermal/thermal_sheets.h"
#include "ui/pages/thermal/thermal_texts.h"
#include "ui/widgets/action_button.h"
#include "ui/widgets/label.h"

/// The sheet of the thermal page on which models are trained.
namespace kerf::ui {

void ThermalSheets::showDays(QTableWidget* table) {
    int row = 0;
    for (const ThermalDayView& day : m_service.view().days) {
        const bool chosen = m_chosenDays.contains(day.id);
        const QString from = day.id.starts_with("file:")      ? tr("file")
                             : day.id.starts_with("session:") ? tr("recorded here")
                                                              : tr("built-in simulation");
        const QString out =
            tr("Left out by %1: %2").arg(QString::fromStdString(day.leftOutAuthor), reasonText(day.leftOutReason));
        setTableRow(table, row,
                    {day.leftOut ? tr("out")
                     : chosen    ? QStringLiteral("✓")
                                 : QStringLiteral("–"),
                     QString::fromStdString(day.label), day.leftOut ? out : from});
        table->item(row, 0)->setTextAlignment(Qt::AlignCenter);
        ++row;
    }
    table->setRowCount(row);
}

const ThermalDayView* ThermalSheets::touchedDay() const {
    const auto& days = m_service.view().days;
    const auto found = std::ranges::find(days, m_touchedDay, &ThermalDayView::id);
    return found == days.end() ? nullptr : &*found;
}

void ThermalSheets::addLeaveOut(Sheet* sheet) {
    auto* reason = new QLineEdit(sheet);
    reason->setObjectName(QStringLiteral("thermalDayReason"));
    reason->setPlaceholderText(tr("Reason to leave the touched day out, or to take it in again"));
    reason->setMinimumHeight(m_context.look.metrics().touch());
    auto* leave = new ActionButton(m_context.look, sheet);
    leave->setObjectName(QStringLiteral("thermalDayLeaveOut"));
    leave->setPredicate([this, reason, leave] {
        const ThermalDayView* day = touchedDay();
        leave->setText(day != nullptr && day->leftOut ? tr("Take in again") : tr("Leave out"));
        return day == nullptr                       ? tr("touch a day first")
               : reason->text().trimmed().isEmpty() ? tr("give a reason")
                                                    : QString();
    });
    allowOnly(leave, m_context.session, Deed::ThermalMemory);
    QObject::connect(reason, &QLineEdit::textChanged, leave, [leave] { leave->reconsider(); });
    QObject::connect(leave, &QPushButton::clicked, sheet, [this, field = QPointer(reason)] {
        const ThermalDayView* day = touchedDay();
        if (day == nullptr) {
            return;
        }
        m_context.withPermission(Deed::ThermalMemory,
                                 [this, id = day->id, out = !day->leftOut, reason = field->text().simplified(), field] {
                                     sendLeaveOut(id, out, reason, field);
                                 });
    });
    auto* row = new QHBoxLayout;
    row->addWidget(reason, 1);
    row->addWidget(leave);
    sheet->body()->addLayout(row);
}

void ThermalSheets::sendLeaveOut(const std::string& day, bool out, const QString& reason, QPointer<QLineEdit> field) {
    if (out) {
        m_chosenDays.erase(day);
    }
    m_service.leaveOut(day, out, m_context.session.author(), reason.toStdString(),
                       [context = m_context, field, reason](const Result<void>& done) {
                           if (!done) {
                               context.notify(sentenceText(done.error(), context.look.units()));
                           } else if (field && field->text().simplified() == reason) {
                               field->clear();  // else the next one is being typed
                           }
                       });
}

void ThermalSheets::openTrain() {
    m_service.findDays();
    Sheet* sheet =
        open(tr("Train a model"), tr("Touch the days to train on. Several days of different work make a model "
                                     "that also holds on days it has not seen. History files belong in %1.")
                                      .arg(QString::fromStdString(m_service.view().dayFolder)));
    Look& look = m_context.look;
    QTableWidget* days = makeThermalTable(look, "thermalDays", {tr("use"), tr("day"), tr("from")}, sheet);
    days->setMinimumHeight(3 * look.metrics().touch());
    days->verticalHeader()->setMinimumSectionSize(look.metrics().touch());
    QTableWidget* compared =
        makeThermalTable(look, "thermalCompared",
                         {tr("model"), tr("thermocouples"), tr("rms X / Y / Z, %1").arg(look.units().of("um").symbol),
                          tr("worst X / Y / Z")},
                         sheet);
    compared->setMinimumHeight(3 * look.metrics().touch());
    QLabel* state = makeLabel(TextRole::Body, sheet, true);
    state->setObjectName(QStringLiteral("thermalTrainState"));
    sheet->body()->addWidget(days, 1);
    addLeaveOut(sheet);
    sheet->body()->addWidget(state);
    sheet->body()->addWidget(compared, 1);
    ActionButton* cancel = named("thermalTrainCancel", tr("Cancel training"));
    ActionButton* train = named("thermalTrainAuto", tr("Train and compare"));
    ActionButton* live = named("thermalGoLive", tr("Go live"));
    const auto running = [this] { return m_service.view().training.state == TrainingState::Running; };
    cancel->setPredicate([running] { return running() ? QString() : tr("nothing is being trained"); });
    train->setPredicate([this, running] {
        return running() ? tr("a model is being trained") : m_chosenDays.empty() ? tr("choose days first") : QString();
    });
    live->setPredicate(
        [this] { return m_service.view().training.state == TrainingState::Ready ? QString() : tr("train one first"); });
    sheet->addButton(
        cancel, [this] { m_service.cancelTraining(); }, false);
    sheet->addButton(
        train,
        [this] {
            tell(m_service.train("auto", {m_chosenDays.begin(), m_chosenDays.end()}));
        },
        false);
    allowOnly(live, m_context.session, Deed::ThermalModel);
    sheet->addButton(
        live,
        [this] {
            withAuthor(Deed::ThermalModel, [this](const std::string& author) { return m_service.goLive(author); });
        },
        false);
    auto* leave = sheet->findChild<ActionButton*>(QStringLiteral("thermalDayLeaveOut"));
    const auto update = [this, days, compared, state, cancel, train, live, leave] {
        const ThermalTrainingView& training = m_service.view().training;
        const UnitSystem& units = m_context.look.units();
        showDays(days);
        for (ActionButton* button : {cancel, train, live, leave})
            button->reconsider();
        switch (training.state) {
            case TrainingState::Idle:
                state->setText(tr("The comparison appears below after the training."));
                break;
            case TrainingState::Running:
                state->setText(tr("Training: %1 %").arg(static_cast<int>(100.0 * training.progress)));
                break;
            case TrainingState::Ready:
                state->setText(
                    tr("Errors on days left out of the training. The live model goes on until you go live.") +
                    (training.detail.empty() ? QString() : u'\n' + QString::fromStdString(training.detail)));
                break;
            case TrainingState::Failed:
                state->setText(sentenceText(training.problem, units) + u' ' + QString::fromStdString(training.detail));
                break;
            case TrainingState::Cancelled:
                state->setText(tr("Cancelled; nothing has changed."));
                break;
        }
        int row = 0;
        for (const ThermalJudgementView& one : training.compared) {
            const QString name = modelKindName(one.kind, m_context.look.wording());
            setTableRow(compared, row++,
                        {one.chosen ? tr("%1: best").arg(name) : name, QString::number(one.sensors),
                         threeText(one.rms_um, units, 2), threeText(one.worst_um, units, 1)});
        }
        compared->setRowCount(row);
        compared->setVisible(row > 0);
    };
    QObject::connect(days, &QTableWidget::cellClicked, sheet, [this, update](int row, int) {
        const auto& list = m_service.view().days;
        if (row < 0 || static_cast<std::size_t>(row) >= list.size()) return;
        const ThermalDayView& day = list[static_cast<std::size_t>(row)];
        m_touchedDay = day.id;
        if (!day.leftOut && m_chosenDays.erase(day.id) == 0) m_chosenDays.insert(day.id);
        update();
    });
    follow(update);
}

}  // namespace kerf::ui
