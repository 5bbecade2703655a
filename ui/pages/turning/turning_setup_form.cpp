// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/turning/turning_setup_form.h"

#include <QButtonGroup>
#include <QGridLayout>
#include <QLabel>
#include <QLineEdit>
#include <QStackedWidget>

#include "ui/link/texts.h"
#include "ui/widgets/label.h"

namespace kerf::ui {
namespace {
constexpr std::size_t kDepth = 0;
constexpr std::size_t kFeed = 2;
constexpr std::size_t kRadius = 3;
}  // namespace

TurningSetupForm* TurningSetupForm::open(SheetHost& host, Look& look, TurningService& service, Author author,
                                         const TurningSetup& setup, OnDone onDone) {
    Sheet* sheet = host.open({});
    auto* form = new TurningSetupForm(look, service, std::move(author), setup, std::move(onDone), sheet);
    sheet->body()->addWidget(form);
    form->show();
    form->takeFocus();
    return form;
}

TurningSetupForm::TurningSetupForm(Look& look, TurningService& service, Author author, const TurningSetup& setup,
                                   OnDone onDone, Sheet* sheet)
    : FaceWidget(look, sheet),
      m_service(service),
      m_author(std::move(author)),
      m_setup(setup),
      m_onDone(std::move(onDone)),
      m_sheet(sheet),
      m_sides(new QButtonGroup(this)),
      m_cut(new QPushButton(this)),
      m_tones(new QPushButton(this)),
      m_pages(new QStackedWidget(this)),
      m_overlap(makeLabel(TextRole::Body, this, true)),
      m_reason(new QLineEdit(this)),
      m_message(makeLabel(TextRole::Body, this, true)),
      m_keypad(new Keypad(look, this)),
      m_columns(new QHBoxLayout),
      m_sideRow(new QHBoxLayout),
      m_cancel(new QPushButton),
      m_apply(new ActionButton(look)) {
    setObjectName(QStringLiteral("turningSetupForm"));
    m_cut->setObjectName(QStringLiteral("turningSetupCut"));
    m_tones->setObjectName(QStringLiteral("turningSetupTones"));
    m_overlap->setObjectName(QStringLiteral("turningOverlap"));
    m_reason->setObjectName(QStringLiteral("turningSetupReason"));
    m_message->setObjectName(QStringLiteral("turningSetupMessage"));
    m_keypad->setObjectName(QStringLiteral("turningSetupKeypad"));
    m_cancel->setObjectName(QStringLiteral("turningSetupCancel"));
    m_apply->setObjectName(QStringLiteral("turningSetupApply"));
    int side = 0;
    for (QPushButton* button : {m_cut, m_tones}) {
        button->setCheckable(true);
        button->setFocusPolicy(Qt::TabFocus);
        m_sides->addButton(button, side++);
        m_sideRow->addWidget(button);
    }
    m_cut->setChecked(true);

    auto* cut = new QWidget(this);
    m_cutGrid = new QGridLayout(cut);
    const auto specs = m_service.setupSpecs();
    for (std::size_t i = 0; i < specs.size(); ++i) {
        ValueField* field =
            makeField(specs[i], QStringLiteral("turningField%1").arg(i), m_cutGrid, static_cast<int>(i), 2);
        field->setValue(m_service.setupValue(m_setup, i));
        m_fields.push_back(field);
    }
    m_cutGrid->addWidget(m_overlap, 3, 1);
    auto* tones = new QWidget(this);
    m_toneGrid = new QGridLayout(tones);
    for (std::size_t j = 0; j < kTurningTones; ++j) {
        ValueField* field =
            makeField(m_service.toneSpec(), QStringLiteral("turningTone%1").arg(j), m_toneGrid, static_cast<int>(j), 2);
        if (j < m_setup.knownToneCount) {
            field->setValue(m_setup.knownTones_Hz[j]);
        }
        m_toneFields.push_back(field);
    }
    m_pages->addWidget(cut);
    m_pages->addWidget(tones);
    connect(m_sides, &QButtonGroup::idClicked, this, [this](int id) {
        m_pages->setCurrentIndex(id);
        takeFocus();
    });

    auto* left = new QVBoxLayout;
    left->addLayout(m_sideRow);
    left->addWidget(m_pages, 1);
    m_sideRow->addWidget(m_reason, 1);
    left->addWidget(m_message);
    m_columns->addLayout(left, 1);
    m_columns->addWidget(m_keypad, 0, Qt::AlignTop);
    auto* rows = new QVBoxLayout(this);
    rows->setContentsMargins(0, 0, 0, 0);
    rows->addLayout(m_columns);

    sheet->addButton(m_cancel, {});
    sheet->addButton(
        m_apply, [this] { apply(); }, false);
    m_apply->setPredicate([this] { return whyNot(); });
    refresh();
}

ValueField* TurningSetupForm::makeField(const ParamSpec& spec, const QString& name, QGridLayout* grid, int place,
                                        int columns) {
    auto* field = new ValueField(look(), spec, this);
    field->setObjectName(name);
    field->edit()->setObjectName(name + QStringLiteral("Edit"));
    grid->addWidget(field, place / columns, place % columns);
    connect(field, &ValueField::edited, this, [this] {
        m_refusal = {};
        reconsider();
    });
    connect(field, &ValueField::committed, this, [this] { focusNextChild(); });
    return field;
}

void TurningSetupForm::takeFocus() {
    (m_pages->currentIndex() == 0 ? m_fields : m_toneFields).front()->edit()->setFocus();
}

void TurningSetupForm::refresh() {
    if (m_sheet) {
        m_sheet->setTitle(tr("Setup of the next part"));
        m_sheet->setText(tr("A part being cut keeps the setup it began with."));
    }
    m_cut->setText(tr("Cut"));
    m_tones->setText(tr("Tones of the machine"));
    m_cancel->setText(tr("Leave as it is"));
    m_reason->setPlaceholderText(tr("Reason, when a limit is raised"));
    m_reason->setMinimumHeight(look().metrics().touch());
    m_apply->setText(tr("Use for the next part"));
    for (std::size_t j = 0; j < m_toneFields.size(); ++j) {
        m_toneFields[j]->setLabel(tr("Tone %1").arg(j + 1));
    }
    const int gap = look().metrics().touchGap();
    m_columns->setSpacing(look().space(Space::Large));
    m_sideRow->setSpacing(gap);
    for (QGridLayout* grid : {m_cutGrid, m_toneGrid}) {
        grid->setContentsMargins(0, 0, 0, 0);
        grid->setHorizontalSpacing(look().space(Space::Large));
        grid->setVerticalSpacing(look().space(Space::Small));
    }
    reconsider();
    FaceWidget::refresh();
}

TurningSetup TurningSetupForm::typed() const {
    TurningSetup setup = m_setup;
    for (std::size_t i = 0; i < m_fields.size(); ++i) {
        if (const auto value = m_fields[i]->value()) {
            m_service.changeSetup(setup, i, *value);
        }
    }
    setup.knownTones_Hz = {};
    setup.knownToneCount = 0;
    for (const ValueField* field : m_toneFields) {
        if (const auto tone = field->value()) {
            setup.knownTones_Hz[setup.knownToneCount++] = *tone;
        }
    }
    return setup;
}

QString TurningSetupForm::whyNot() const {
    if (m_pending) {
        return tr("being stored");
    }
    for (const ValueField* field : m_fields) {
        if (!field->value()) {
            return tr("a value is missing");
        }
    }
    for (const ValueField* field : m_toneFields) {
        if (!field->edit()->text().trimmed().isEmpty() && !field->value()) {
            return tr("a tone is out of range");
        }
    }
    const auto why = m_service.whyUnusable(typed());
    return why ? sentenceText(*why, look().units()) : QString();
}

void TurningSetupForm::reconsider() {
    const auto radius = m_fields[kRadius]->value();
    const auto depth = m_fields[kDepth]->value();
    const auto feed = m_fields[kFeed]->value();
    QString text;
    if (radius && depth && feed) {
        const auto overlap = m_service.overlap(*radius, *depth, *feed);
        text = overlap ? tr("Overlap factor %1").arg(UnitSystem::fixed(*overlap, 4))
                       : sentenceText(overlap.error(), look().units());
    }
    m_overlap->setText(text);
    m_message->setText(m_refusal.empty() ? QString()
                                         : tr("Not stored: %1").arg(sentenceText(m_refusal, look().units())));
    m_message->setVisible(!m_refusal.empty());
    m_apply->reconsider();
}

void TurningSetupForm::apply() {
    m_pending = true;
    if (m_sheet) {
        m_sheet->sent();
    }
    const QPointer<TurningSetupForm> self(this);
    m_service.loadSetup(typed(), m_author(), m_reason->text().trimmed().toStdString(),
                        [self](const Result<void>& result) {
                            if (TurningSetupForm* form = self.data(); form != nullptr) {
                                form->answered(result);
                            }
                        });
    if (m_pending) {
        reconsider();
    }
}

void TurningSetupForm::answered(const Result<void>& result) {
    m_pending = false;
    if (!result) {
        m_refusal = result.error();
        reconsider();
        return;
    }
    if (m_onDone) {
        m_onDone(tr("The next part is cut with the new setup."));
    }
    if (m_sheet) {
        m_sheet->taken();
    }
}

}  // namespace kerf::ui
