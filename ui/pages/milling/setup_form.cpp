// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/milling/setup_form.h"

#include <QButtonGroup>
#include <QComboBox>
#include <QEvent>
#include <QGridLayout>
#include <QPointer>
#include <QStackedWidget>

#include "ui/link/texts.h"
#include "ui/widgets/label.h"

namespace kerf::ui {
namespace {

constexpr std::size_t kPerGroup = 6;
constexpr int kGroups = 3;
constexpr int kColumns = 2;

}  // namespace

MillingSetupForm* MillingSetupForm::open(SheetHost& host, Look& look, MillingService& service, Author author) {
    Sheet* sheet = host.open({});
    auto* form = new MillingSetupForm(look, service, std::move(author), sheet);
    sheet->body()->addWidget(form);
    form->show();
    return form;
}

MillingSetupForm::MillingSetupForm(Look& look, MillingService& service, Author author, Sheet* sheet)
    : FaceWidget(look, sheet),
      m_service(service),
      m_author(std::move(author)),
      m_sheet(sheet),
      m_nameLabel(makeLabel(TextRole::Body, this)),
      m_name(new QLineEdit(this)),
      m_types(new QComboBox(this)),
      m_groups(new QButtonGroup(this)),
      m_nameRow(new QHBoxLayout),
      m_groupRow(new QHBoxLayout),
      m_columns(new QHBoxLayout),
      m_pages(new QStackedWidget(this)),
      m_keypad(new Keypad(look, this)),
      m_hint(makeLabel(TextRole::Small, this, true)),
      m_reason(new QLineEdit(this)),
      m_message(makeLabel(TextRole::Body, this, true)),
      m_cancel(new QPushButton),
      m_open(new ActionButton(look)),
      m_save(new ActionButton(look)) {
    setObjectName(QStringLiteral("millingSetupForm"));
    m_name->setObjectName(QStringLiteral("millingPartType"));
    m_types->setObjectName(QStringLiteral("millingPartTypes"));
    m_hint->setObjectName(QStringLiteral("millingSetupHint"));
    m_reason->setObjectName(QStringLiteral("millingSetupReason"));
    m_message->setObjectName(QStringLiteral("millingSetupMessage"));
    m_cancel->setObjectName(QStringLiteral("millingSetupCancel"));
    m_open->setObjectName(QStringLiteral("millingSetupOpen"));
    m_save->setObjectName(QStringLiteral("millingSetupSave"));
    build();
    const MillingServiceView& view = m_service.view();
    m_name->setText(QString::fromStdString(view.partType));
    for (const std::string& type : view.partTypes) {
        m_types->addItem(QString::fromStdString(type));
    }
    m_types->setCurrentIndex(-1);
    connect(m_types, &QComboBox::textActivated, this, [this](const QString& type) {
        m_name->setText(type);
        m_types->setCurrentIndex(-1);
        m_open->reconsider();
    });
    connect(m_name, &QLineEdit::textEdited, this, [this] { m_open->reconsider(); });
    m_open->setPredicate([this]() -> QString {
        const MillingServiceView& now = m_service.view();
        if (name() == now.partType) {
            return tr("This part type is open.");
        }
        const bool known = std::ranges::find(now.partTypes, name()) != now.partTypes.end();
        return known ? QString() : tr("No part type of this name is stored.");
    });
    sheet->addButton(m_cancel, {});
    sheet->addButton(
        m_open, [this] { openType(); }, false);
    sheet->addButton(
        m_save, [this] { save(); }, false);
    m_save->setPrimary(true);
    refresh();
}

void MillingSetupForm::build() {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    m_nameRow->addWidget(m_nameLabel);
    m_nameRow->addWidget(m_name, 1);
    m_nameRow->addWidget(m_types, 1);
    m_nameRow->addWidget(m_reason, 1);
    column->addLayout(m_nameRow);
    for (int i = 0; i < kGroups; ++i) {
        auto* button = new QPushButton(this);
        button->setObjectName(QStringLiteral("millingGroup%1").arg(i));
        button->setCheckable(true);
        button->setChecked(i == 0);
        button->setFocusPolicy(Qt::TabFocus);
        m_groups->addButton(button, i);
        m_groupRow->addWidget(button, 1);
        m_pages->addWidget(new QWidget(m_pages));
        new QGridLayout(m_pages->widget(i));
    }
    column->addLayout(m_groupRow);
    const auto fields = m_service.fields();
    for (std::size_t i = 0; i < fields.size(); ++i) {
        const int group = std::min(kGroups - 1, static_cast<int>(i / kPerGroup));
        const int place = static_cast<int>(i) - group * static_cast<int>(kPerGroup);
        auto* field = new ValueField(look(), fields[i].spec, m_pages->widget(group));
        field->setObjectName(QStringLiteral("millingField%1").arg(i));
        field->setValue(fields[i].get(m_service.view().setup));
        field->edit()->installEventFilter(this);
        connect(field, &ValueField::edited, this, [this] { m_message->clear(); });
        auto* grid = static_cast<QGridLayout*>(m_pages->widget(group)->layout());
        grid->addWidget(field, place / kColumns, place % kColumns, Qt::AlignTop);
        m_fields.push_back(field);
    }
    m_columns->addWidget(m_pages, 1);
    m_columns->addWidget(m_keypad);
    column->addLayout(m_columns);
    column->addWidget(m_hint);
    column->addWidget(m_message);
    connect(m_groups, &QButtonGroup::idClicked, this, [this](int group) {
        m_pages->setCurrentIndex(group);
        m_fields[static_cast<std::size_t>(group) * kPerGroup]->edit()->setFocus();
    });
}

bool MillingSetupForm::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::FocusIn) {
        for (std::size_t i = 0; i < m_fields.size(); ++i) {
            if (m_fields[i]->edit() == watched) {
                m_keypad->setTarget(m_fields[i]->edit());
                m_fields[i]->edit()->selectAll();
                showHint(i);
            }
        }
    }
    return FaceWidget::eventFilter(watched, event);
}

void MillingSetupForm::showHint(std::size_t index) {
    m_hinted = index;
    const ParamSpec& spec = m_service.fields()[index].spec;
    const UnitSystem& units = look().units();
    m_hint->setText(tr("%1: %2 to %3; default %4, %5.", "label, lowest, highest, default, source")
                        .arg(engineText(spec.label), units.number(spec.min, spec.unit, spec.decimals),
                             units.withUnit(spec.max, spec.unit, spec.decimals),
                             units.number(spec.fallback, spec.unit, spec.decimals), engineText(spec.source)));
}

void MillingSetupForm::refresh() {
    m_sheet->setTitle(tr("Setup of a milled part type"));
    m_nameLabel->setText(tr("Part type"));
    const std::array titles{tr("Force and feed"), tr("Path and tool"), tr("Model and gains")};
    for (int i = 0; i < kGroups; ++i) {
        m_groups->button(i)->setText(titles[static_cast<std::size_t>(i)]);
    }
    m_cancel->setText(tr("Cancel"));
    m_reason->setPlaceholderText(tr("Reason, when a limit is raised"));
    m_reason->setMinimumHeight(look().metrics().touch());
    m_open->setText(tr("Open"));
    m_save->setText(tr("Save and use"));
    m_types->setPlaceholderText(tr("Stored part types ▾"));
    m_types->setMinimumHeight(look().metrics().touch());
    layout()->setSpacing(look().space(Space::Medium));
    for (QHBoxLayout* row : {m_nameRow, m_groupRow, m_columns}) {
        row->setSpacing(look().metrics().touchGap());
    }
    for (int i = 0; i < kGroups; ++i) {
        auto* grid = static_cast<QGridLayout*>(m_pages->widget(i)->layout());
        grid->setContentsMargins(0, 0, 0, 0);
        grid->setHorizontalSpacing(look().metrics().touchGap());
        grid->setVerticalSpacing(look().space(Space::Medium));
        grid->setRowStretch(kGroups, 1);
    }
    showHint(m_hinted);
    m_open->reconsider();
    FaceWidget::refresh();
}

std::string MillingSetupForm::name() const {
    return m_name->text().trimmed().toStdString();
}

std::string MillingSetupForm::reason() const {
    return m_reason->text().trimmed().toStdString();
}

std::optional<MillingSetup> MillingSetupForm::typed() {
    MillingSetup setup = m_service.view().setup;
    const auto fields = m_service.fields();
    for (std::size_t i = 0; i < m_fields.size(); ++i) {
        const std::optional<double> value = m_fields[i]->value();
        if (!value) {
            const int group = std::min(kGroups - 1, static_cast<int>(i / kPerGroup));
            m_groups->button(group)->setChecked(true);
            m_pages->setCurrentIndex(group);
            m_fields[i]->edit()->setFocus();
            m_message->setText(engineText(fields[i].spec.label) + QStringLiteral(": ") + m_fields[i]->whyInvalid());
            return std::nullopt;
        }
        fields[i].set(setup, *value);
    }
    if (const auto why = m_service.whyUnusable(setup)) {
        m_message->setText(sentenceText(*why, look().units()));
        return std::nullopt;
    }
    return setup;
}

void MillingSetupForm::save() {
    const std::optional<MillingSetup> setup = typed();
    if (!setup) {
        return;
    }
    m_sheet->sent();
    if (name() == m_service.view().partType) {
        m_service.saveSetup(*setup, m_author(), reason(), whenDone(&MillingSetupForm::finish));
        return;
    }
    m_setup = *setup;
    m_service.choosePartType(name(), m_author(), whenDone(&MillingSetupForm::chosen));
}

void MillingSetupForm::chosen(const Result<void>& result) {
    if (result) {
        m_service.saveSetup(m_setup, m_author(), reason(), whenDone(&MillingSetupForm::finish));
    } else {
        finish(result);
    }
}

void MillingSetupForm::openType() {
    m_sheet->sent();
    m_service.choosePartType(name(), m_author(), whenDone(&MillingSetupForm::finish));
}

MillingService::Done MillingSetupForm::whenDone(void (MillingSetupForm::*then)(const Result<void>&)) {
    return [self = QPointer<MillingSetupForm>(this), then](const Result<void>& result) {
        MillingSetupForm* form = self.data();
        if (form != nullptr) {
            (form->*then)(result);
        }
    };
}

void MillingSetupForm::finish(const Result<void>& result) {
    if (result) {
        m_sheet->taken();
    } else {
        m_message->setText(sentenceText(result.error(), look().units()));
    }
}

}  // namespace kerf::ui
