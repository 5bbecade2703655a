// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/milling/blank_form.h"

#include <QEvent>
#include <QPointer>
#include <algorithm>
#include <array>

#include "ui/link/texts.h"
#include "ui/widgets/label.h"

namespace kerf::ui {
namespace {

constexpr ParamSpec kBegin{"milling.blank_begin_mm", KERF_TEXT("Step begins at"), "mm", -10000.0, 10000.0, 0.0, 2, ""};
constexpr ParamSpec kHeight{"milling.blank_height_mm", KERF_TEXT("Height of the step"), "mm", 0.0, 50.0, 1.0, 2, ""};
constexpr ParamSpec kEnd{"milling.blank_end_mm", KERF_TEXT("Blank ends at"), "mm", -10000.0, 20000.0, 100.0, 2, ""};

}  // namespace

MillingBlankForm* MillingBlankForm::open(SheetHost& host, Look& look, MillingService& service, Author author,
                                         const QString& file) {
    Sheet* sheet = host.open({});
    auto* form = new MillingBlankForm(look, service, std::move(author), file, sheet);
    sheet->body()->addWidget(form);
    form->show();
    form->m_begin->edit()->setFocus();
    return form;
}

MillingBlankForm::MillingBlankForm(Look& look, MillingService& service, Author author, const QString& file,
                                   Sheet* sheet)
    : FaceWidget(look, sheet),
      m_service(service),
      m_author(std::move(author)),
      m_sheet(sheet),
      m_chart(new Chart(look, this)),
      m_outline(m_chart->addCurve({Token::Wanted, Chart::Kind::Line, Chart::Marker::Disc, Stroke::Normal})),
      m_begin(new ValueField(look, kBegin, this)),
      m_height(new ValueField(look, kHeight, this)),
      m_end(new ValueField(look, kEnd, this)),
      m_add(new ActionButton(look, this)),
      m_remove(new ActionButton(look, this)),
      m_file(new QLineEdit(file, this)),
      m_import(new ActionButton(look, this)),
      m_message(makeLabel(TextRole::Body, this, true)),
      m_keypad(new Keypad(look, this)),
      m_cancel(new QPushButton),
      m_use(new ActionButton(look)),
      m_columns(new QHBoxLayout),
      m_fieldRow(new QHBoxLayout),
      m_stepRow(new QHBoxLayout),
      m_fileRow(new QHBoxLayout) {
    setObjectName(QStringLiteral("millingBlankForm"));
    m_chart->setObjectName(QStringLiteral("millingBlankChart"));
    m_begin->setObjectName(QStringLiteral("millingBlankBegin"));
    m_height->setObjectName(QStringLiteral("millingBlankHeight"));
    m_end->setObjectName(QStringLiteral("millingBlankEnd"));
    m_add->setObjectName(QStringLiteral("millingBlankAdd"));
    m_remove->setObjectName(QStringLiteral("millingBlankRemove"));
    m_file->setObjectName(QStringLiteral("millingBlankFile"));
    m_import->setObjectName(QStringLiteral("millingBlankImport"));
    m_message->setObjectName(QStringLiteral("millingBlankMessage"));
    m_cancel->setObjectName(QStringLiteral("millingBlankCancel"));
    m_use->setObjectName(QStringLiteral("millingBlankUse"));
    build();
    m_remove->setPredicate([this] { return m_steps.empty() ? tr("There is no step.") : QString(); });
    m_use->setPredicate([this] { return whyNotUse(); });
    m_use->setPrimary(true);
    sheet->addButton(m_cancel, {});
    sheet->addButton(
        m_use, [this] { use(); }, false);
    m_source = service.view().blankSource;
    m_end->setValue(kEnd.fallback);
    take(service.view().blank);
    refresh();
}

void MillingBlankForm::build() {
    m_chart->setLowTitles(true);
    m_chart->setYIncludes({0.0});
    auto* left = new QVBoxLayout;
    m_fieldRow->addWidget(m_begin, 1);
    m_fieldRow->addWidget(m_height, 1);
    m_stepRow->addWidget(m_end, 1);
    m_stepRow->addWidget(m_add, 0, Qt::AlignBottom);
    m_stepRow->addWidget(m_remove, 0, Qt::AlignBottom);
    for (ValueField* field : {m_begin, m_height, m_end}) {
        field->edit()->installEventFilter(this);
        connect(field, &ValueField::edited, this, [this] {
            m_message->clear();
            m_use->reconsider();
        });
    }
    connect(m_height, &ValueField::committed, this, [this] { addStep(); });
    connect(m_end, &ValueField::edited, this, [this] { showProfile(); });
    m_fileRow->addWidget(m_file, 1);
    m_fileRow->addWidget(m_import);
    left->addWidget(m_chart, 1);
    left->addLayout(m_fieldRow);
    left->addLayout(m_stepRow);
    m_columns->addLayout(left, 1);
    m_columns->addWidget(m_keypad);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->addLayout(m_columns);
    column->addLayout(m_fileRow);
    column->addWidget(m_message);
    connect(m_add, &QPushButton::clicked, this, [this] { addStep(); });
    connect(m_remove, &QPushButton::clicked, this, [this] { removeStep(); });
    connect(m_import, &QPushButton::clicked, this, [this] { importFile(); });
}

bool MillingBlankForm::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::FocusIn) {
        for (ValueField* field : {m_begin, m_height, m_end}) {
            if (field->edit() == watched) {
                m_keypad->setTarget(field->edit());
                field->edit()->selectAll();
            }
        }
    }
    return FaceWidget::eventFilter(watched, event);
}

void MillingBlankForm::refresh() {
    m_sheet->setTitle(tr("Blank profile of %1").arg(QString::fromStdString(m_service.view().partType)));
    m_sheet->setText(tr("Height of the blank over the finished wall, step by step along the path."));
    m_chart->setXAxis(tr("path"), "mm");
    m_chart->setYAxis(tr("height"), "mm");
    m_chart->setEmptyText(tr("The profile appears here with its first step."));
    m_chart->setAccessibleName(tr("Blank profile along the path"));
    m_add->setText(tr("Add step"));
    m_remove->setText(tr("Remove last"));
    m_import->setText(tr("Import CSV"));
    m_cancel->setText(tr("Cancel"));
    m_use->setText(tr("Save and use"));
    layout()->setSpacing(look().space(Space::Medium));
    m_chart->setMinimumHeight(look().metrics().chart() / 2);
    for (QHBoxLayout* row : {m_columns, m_fieldRow, m_stepRow, m_fileRow}) {
        row->setSpacing(look().metrics().touchGap());
    }
    showProfile();
    FaceWidget::refresh();
}

void MillingBlankForm::take(const MillingBlank& blank) {
    m_steps.clear();
    for (std::size_t i = 0; i < blank.count; ++i) {
        m_steps.push_back({blank.begin_mm[i], blank.height_mm[i]});
    }
    if (blank.count > 0) {
        m_end->setValue(blank.end_mm);
    }
    showProfile();
}

void MillingBlankForm::addStep() {
    for (const ValueField* field : {m_begin, m_height}) {
        if (!field->value()) {
            m_message->setText(field->whyInvalid());
            return;
        }
    }
    const MillingBlankStep step{*m_begin->value(), *m_height->value()};
    const auto place = std::ranges::lower_bound(m_steps, step.begin_mm, {}, &MillingBlankStep::begin_mm);
    if (place != m_steps.end() && place->begin_mm == step.begin_mm) {
        *place = step;  // typed again: the newer height holds
    } else {
        m_steps.insert(place, step);
    }
    m_source.clear();
    m_message->clear();
    m_begin->clear();
    m_height->clear();
    m_begin->edit()->setFocus();
    showProfile();
}

void MillingBlankForm::removeStep() {
    m_steps.pop_back();
    m_source.clear();
    m_message->clear();
    showProfile();
}

void MillingBlankForm::importFile() {
    const Result<MillingBlank> blank = m_service.readBlank(m_file->text().trimmed().toStdString());
    if (!blank) {
        m_message->setText(sentenceText(blank.error(), look().units()));
        return;
    }
    m_source = m_file->text().trimmed().toStdString();
    take(*blank);
    m_message->setText(tr("%n steps imported; look at the profile, then save.", nullptr, blank->count));
}

void MillingBlankForm::showProfile() {
    std::vector<QPointF> outline;
    const double end_mm = m_end->value().value_or(m_steps.empty() ? 0.0 : m_steps.back().begin_mm);
    for (std::size_t i = 0; i < m_steps.size(); ++i) {
        const double to_mm = i + 1 < m_steps.size() ? m_steps[i + 1].begin_mm : end_mm;
        outline.emplace_back(m_steps[i].begin_mm, m_steps[i].height_mm);
        outline.emplace_back(to_mm, m_steps[i].height_mm);
    }
    m_chart->setPoints(m_outline, outline);
    m_remove->reconsider();
    m_use->reconsider();
}

QString MillingBlankForm::whyNotUse() const {
    const bool typed = std::ranges::any_of(std::array{m_begin, m_height},
                                           [](auto* field) { return !field->edit()->text().isEmpty(); });
    if (typed) {
        return tr("The step that is typed is not added yet.");
    }
    const std::optional<double> end_mm = m_end->value();
    if (!end_mm) {
        return m_end->whyInvalid();
    }
    const Result<MillingBlank> blank = m_service.blankOf(m_steps, *end_mm);
    return blank ? QString() : sentenceText(blank.error(), look().units());
}

void MillingBlankForm::use() {
    const Result<MillingBlank> blank = m_service.blankOf(m_steps, m_end->value().value_or(0.0));
    if (!blank) {
        return;
    }
    const QPointer<MillingBlankForm> self(this);
    m_sheet->sent();
    m_service.saveBlank(*blank, m_source, m_author(), [self](const Result<void>& result) {
        MillingBlankForm* form = self.data();
        if (form == nullptr) {
            return;
        }
        if (result) {
            form->m_sheet->taken();
        } else {
            form->m_message->setText(sentenceText(result.error(), form->look().units()));
        }
    });
}

}  // namespace kerf::ui
