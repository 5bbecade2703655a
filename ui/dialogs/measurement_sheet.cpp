// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/dialogs/measurement_sheet.h"

#include <QButtonGroup>
#include <QLabel>
#include <QLineEdit>

#include "ui/link/texts.h"
#include "ui/theme/particles.h"
#include "ui/widgets/label.h"

namespace kerf::ui {
namespace {

constexpr int kReasons = 4;
constexpr int kDecimals = 3;

}  // namespace

MeasurementForm* MeasurementForm::open(SheetHost& host, Look& look, BoringService& service, Author author,
                                       const MeasurementSubject& subject, Start start, OnDone onDone) {
    Sheet* sheet = host.open({});
    auto* form = new MeasurementForm(look, service, std::move(author), subject, start, std::move(onDone), sheet);
    sheet->body()->addWidget(form);
    form->show();
    form->m_field->setFocus();
    return form;
}

MeasurementForm::MeasurementForm(Look& look, BoringService& service, Author author, MeasurementSubject subject,
                                 Start start, OnDone onDone, Sheet* sheet)
    : FaceWidget(look, sheet),
      m_service(service),
      m_author(std::move(author)),
      m_subject(std::move(subject)),
      m_onDone(std::move(onDone)),
      m_sheet(sheet),
      m_kind(new QButtonGroup(this)),
      m_correct(new QPushButton(this)),
      m_void(new QPushButton(this)),
      m_field(new DiameterField(look, this)),
      m_unit(makeLabel(TextRole::Dim, this)),
      m_keypad(new Keypad(look, Keypad::Shape::Wide, this)),
      m_why(makeLabel(TextRole::Small, this)),
      m_reasons(new QButtonGroup(this)),
      m_words(new QLineEdit(this)),
      m_message(makeLabel(TextRole::Body, this, true)),
      m_signed(makeLabel(TextRole::Small, this)),
      m_cancel(new QPushButton),
      m_apply(new ActionButton(look)),
      m_columns(new QHBoxLayout),
      m_kindRow(new QHBoxLayout),
      m_reasonRow(new QHBoxLayout) {
    setObjectName(QStringLiteral("measurementForm"));
    m_correct->setObjectName(QStringLiteral("measurementCorrect"));
    m_void->setObjectName(QStringLiteral("measurementVoid"));
    m_field->setObjectName(QStringLiteral("measurementField"));
    m_keypad->setObjectName(QStringLiteral("measurementKeypad"));
    m_words->setObjectName(QStringLiteral("measurementReason"));
    m_message->setObjectName(QStringLiteral("measurementMessage"));
    m_cancel->setObjectName(QStringLiteral("measurementCancel"));
    m_apply->setObjectName(QStringLiteral("measurementApply"));
    for (QPushButton* button : {m_correct, m_void}) {
        button->setCheckable(true);
        button->setFocusPolicy(Qt::TabFocus);
        m_kind->addButton(button);
        m_kindRow->addWidget(button, 1);
    }
    (start == Start::Void ? m_void : m_correct)->setChecked(true);
    for (int i = 0; i < kReasons; ++i) {
        auto* chip = new QPushButton(this);
        chip->setObjectName(QStringLiteral("measurementReason%1").arg(i));
        chip->setCheckable(true);
        chip->setFocusPolicy(Qt::TabFocus);
        m_reasons->addButton(chip, i);
        m_reasonRow->addWidget(chip, 1);
    }
    m_keypad->setTarget(m_field);
    m_field->input().expect(m_subject.expected_mm, look.units());

    auto* fieldRow = new QHBoxLayout;
    fieldRow->addWidget(m_field, 1);
    fieldRow->addWidget(m_unit);
    auto* left = new QVBoxLayout;
    left->addLayout(m_kindRow);
    left->addLayout(fieldRow);
    left->addWidget(m_message, 1);
    m_columns->addLayout(left, 1);
    m_columns->addWidget(m_keypad);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->addLayout(m_columns);
    column->addWidget(m_why);
    column->addLayout(m_reasonRow);
    column->addWidget(m_words);
    column->addWidget(m_signed);

    sheet->addButton(m_cancel, {});
    sheet->addButton(
        m_apply, [this] { apply(); }, false);
    m_apply->setPredicate([this] { return whyNot(); });
    connect(m_kind, &QButtonGroup::buttonClicked, this, [this] { onTyped(); });
    connect(m_reasons, &QButtonGroup::idClicked, this, [this] { reconsider(); });
    connect(m_words, &QLineEdit::textChanged, this, [this] { reconsider(); });
    connect(m_field, &DiameterField::typed, this, [this] {
        m_fromGauge = false;
        onTyped();
    });
    connect(m_field, &DiameterField::cleared, this, [this] { onTyped(); });
    connect(m_field, &DiameterField::numLockOff, this, [this] {
        m_said = tr("Num Lock is off: the keypad sends no figures. Switch it on and type again.");
        reconsider();
    });
    connect(m_field, &DiameterField::entered, this, [this] {
        // Enter may be the gauge's own last key, and it is no answer to a question.
        if (m_apply->isEnabled() && !m_fromGauge && m_question.empty()) {
            apply();
        }
    });
    refresh();
}

void MeasurementForm::refresh() {
    const QString value = look().units().withUnit(m_subject.diameter_mm, "mm", kDecimals);
    if (m_sheet) {
        m_sheet->setTitle(tr("%1: %2", "part and depth, diameter").arg(m_subject.place, value));
        m_sheet->setText(
            tr("The old value stays on record. The law and all later parts are computed again without it."));
    }
    m_correct->setText(tr("Correct the value"));
    m_void->setText(tr("Take it out"));
    const std::array<QString, kReasons> reasons{tr("typed wrong"), tr("measured wrong"), tr("wrong part or depth"),
                                                tr("gauge not set")};
    for (int i = 0; i < kReasons; ++i) {
        m_reasons->button(i)->setText(reasons[static_cast<std::size_t>(i)]);
    }
    m_why->setText(tr("Why?"));
    m_words->setPlaceholderText(tr("or in your own words"));
    m_signed->setText(tr("signed by %1").arg(QString::fromStdString(m_author())));
    m_cancel->setText(tr("Leave as it is"));
    const int gap = look().metrics().touchGap();
    for (QHBoxLayout* row : {m_columns, m_kindRow, m_reasonRow}) {
        row->setSpacing(gap);
    }
    layout()->setSpacing(look().space(Space::Medium));
    m_field->input().expect(m_subject.expected_mm, look().units());
    m_field->showInput();
    reconsider();
    FaceWidget::refresh();
}

void MeasurementForm::onTyped() {
    m_refusal = {};
    m_question = {};
    m_said.clear();
    reconsider();
}

QString MeasurementForm::message() const {
    return m_message->text();
}

void MeasurementForm::takeGauge(const GaugeReading& reading, const std::string& gauge) {
    if (m_pending) {
        return;
    }
    m_refusal = {};
    m_question = {};
    m_said.clear();
    const GaugeJudgement judgement =
        judgeReading(reading, m_subject.expected_mm, look().units().length(), m_subject.settingRing_mm);
    if (!correcting()) {
        m_said = tr("The gauge sent %1: not used. To put it in, touch “Correct the value” first and send it again.")
                     .arg(reading.frame);
    } else if (judgement.doubt == GaugeDoubt::Deviation) {
        m_said = tr("The gauge sent %1: a deviation, and the recipe has no setting ring. Not used.").arg(reading.frame);
    } else {
        m_field->input().set_mm(judgement.doubt == GaugeDoubt::OtherUnit ? judgement.otherUnit_mm : judgement.value_mm);
        m_field->showInput();
        m_fromGauge = true;
        m_gauge = gauge;
    }
    reconsider();
}

bool MeasurementForm::correcting() const {
    return m_correct->isChecked();
}

QString MeasurementForm::reason() const {
    const QString words = m_words->text().trimmed();
    const QString chip = m_reasons->checkedButton() != nullptr ? m_reasons->checkedButton()->text() : QString();
    return chip.isEmpty() ? words : words.isEmpty() ? chip : chip + QStringLiteral(" – ") + words;
}

QString MeasurementForm::whyNot() const {
    if (m_pending) {
        return tr("being stored");
    }
    if (m_author().empty()) {
        return tr("nobody is signed on");
    }
    if (correcting() && !m_field->input().value_mm()) {
        return tr("the right diameter is missing");
    }
    return reason().isEmpty() ? tr("a reason is missing") : QString();
}

void MeasurementForm::reconsider() {
    const bool correct = correcting();
    m_field->setEnabled(correct);
    m_keypad->setEnabled(correct);
    m_unit->setText(m_field->input().units().of("mm").symbol);
    const auto value_mm = m_field->input().value_mm();
    const UnitSystem& units = look().units();
    const bool asked = correct && !m_question.empty() && value_mm;
    m_apply->setText(asked     ? tr("Yes, %1").arg(units.withUnit(*value_mm, "mm", kDecimals))
                     : correct ? tr("Correct")
                               : tr("Take out"));
    if (!m_said.isEmpty()) {
        m_message->setText(m_said);
    } else if (asked) {
        m_message->setText(sentenceText(m_question, units));
    } else if (!m_refusal.empty()) {
        m_message->setText(tr("Not changed: %1").arg(sentenceText(m_refusal, units)));
    } else if (!correct) {
        m_message->setText(tr("This bore then waits for a diameter again."));
    } else if (value_mm) {
        m_message->setText(withParticles(tr("%1 becomes %2.", "diameters")
                                             .arg(units.withUnit(m_subject.diameter_mm, "mm", kDecimals),
                                                  units.withUnit(*value_mm, "mm", kDecimals))));
    } else {
        m_message->setText(tr("Type the right diameter: its last two figures, or the whole."));
    }
    m_field->setWrong(!m_refusal.empty() || asked);
    m_apply->reconsider();
}

void MeasurementForm::apply() {
    m_refusal = {};
    m_said.clear();
    if (correcting() && m_question.empty()) {
        const EntryCheck check = m_service.checkCorrection(m_subject.id, *m_field->input().value_mm());
        if (check.verdict != EntryVerdict::Accept) {
            (check.verdict == EntryVerdict::Ask ? m_question : m_refusal) = check.reason;
            reconsider();
            return;
        }
    }
    m_pending = true;
    if (m_sheet) {
        m_sheet->sent();
    }
    const auto done = [form = QPointer<MeasurementForm>(this)](const Result<void>& result) {
        if (form) {
            form->answered(result);
        }
    };
    if (correcting()) {
        m_service.correctValue({m_subject.id, *m_field->input().value_mm(), m_author(), reason().toStdString(),
                                m_fromGauge, !m_question.empty(), m_gauge},
                               done);
    } else {
        m_service.voidMeasurement(m_subject.id, m_author(), reason().toStdString(), done);
    }
    if (m_pending) {
        reconsider();
    }
}

void MeasurementForm::answered(const Result<void>& result) {
    m_pending = false;
    m_question = {};
    if (!result) {
        m_refusal = result.error();
        reconsider();
        return;
    }
    const UnitSystem& units = look().units();
    const QString old = units.withUnit(m_subject.diameter_mm, "mm", kDecimals);
    const QString sentence =
        correcting() ? tr("%1: %2 corrected to %3.")
                           .arg(m_subject.place, old, units.withUnit(*m_field->input().value_mm(), "mm", kDecimals))
                     : tr("%1: %2 taken out.").arg(m_subject.place, old);
    if (m_onDone) {
        m_onDone(withParticles(sentence));
    }
    if (m_sheet) {
        m_sheet->taken();
    }
}

}  // namespace kerf::ui
