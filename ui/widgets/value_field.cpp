// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/value_field.h"

#include <QGridLayout>
#include <QStyle>

#include "ui/link/texts.h"
#include "ui/theme/particles.h"
#include "ui/widgets/label.h"

namespace kerf::ui {

ValueField::ValueField(Look& look, const ParamSpec& spec, QWidget* parent)
    : FaceWidget(look, parent),
      m_spec(spec),
      m_label(makeLabel(TextRole::Small, this)),
      m_edit(new QLineEdit(this)),
      m_unit(makeLabel(TextRole::Dim, this)),
      m_complaint(makeLabel(TextRole::Body, this, true)),
      m_typedIn(look.units()) {
    auto* grid = new QGridLayout(this);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->addWidget(m_label, 0, 0, 1, 2);
    grid->addWidget(m_edit, 1, 0);
    grid->addWidget(m_unit, 1, 1);
    grid->addWidget(m_complaint, 2, 0, 1, 2);
    grid->setColumnStretch(0, 1);
    m_edit->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    m_edit->setInputMethodHints(Qt::ImhFormattedNumbersOnly);
    m_complaint->hide();
    setFocusProxy(m_edit);
    connect(m_edit, &QLineEdit::textEdited, this, &ValueField::onEdited);
    connect(m_edit, &QLineEdit::returnPressed, this, &ValueField::onCommit);
    refresh();
}

void ValueField::setSpec(const ParamSpec& spec) {
    m_spec = spec;
    refresh();
}

void ValueField::setLabel(const QString& label) {
    m_labelText = label;
    m_label->setText(label);
}

void ValueField::setValue(double stored) {
    m_stored = stored;
    setComplaint({});
    showStored();
}

void ValueField::clear() {
    m_stored.reset();
    m_edit->clear();
    setComplaint({});
}

std::optional<double> ValueField::value() const {
    if (m_stored) {
        return whyOutOfRange(m_spec, *m_stored) ? std::nullopt : m_stored;
    }
    double shown = 0.0;
    if (!UnitSystem::parse(m_edit->text(), shown)) {
        return std::nullopt;
    }
    const double stored = m_typedIn.of(m_spec.unit).toStored(shown);
    return whyOutOfRange(m_spec, stored) ? std::nullopt : std::optional(stored);
}

QString ValueField::whyInvalid() const {
    if (value()) {
        return {};
    }
    if (m_edit->text().trimmed().isEmpty()) {
        return tr("Enter a number.");
    }
    double shown = 0.0;
    if (!UnitSystem::parse(m_edit->text(), shown)) {
        return withParticles(tr("“%1” is not a number.").arg(m_edit->text()));
    }
    const UnitSystem& units = look().units();
    return tr("Must be from %1 to %2.")
        .arg(units.number(m_spec.min, m_spec.unit, m_spec.decimals),
             units.withUnit(m_spec.max, m_spec.unit, m_spec.decimals));
}

void ValueField::setComplaint(const QString& sentence) {
    m_complaint->setText(sentence);
    m_complaint->setVisible(!sentence.isEmpty());
    m_edit->setProperty("wrong", !sentence.isEmpty());
    m_edit->style()->unpolish(m_edit);
    m_edit->style()->polish(m_edit);
}

void ValueField::onEdited() {
    m_stored.reset();
    m_typedIn = look().units();
    setComplaint({});
    emit edited();
}

void ValueField::onCommit() {
    if (const std::optional<double> stored = value()) {
        emit committed(*stored);
    } else {
        setComplaint(whyInvalid());
    }
}

void ValueField::showStored() {
    const UnitSystem& units = look().units();
    QString text = units.number(*m_stored, m_spec.unit, m_spec.decimals);
    m_edit->setText(text.replace(QChar(0x2212), u'-'));
    m_typedIn = units;
}

void ValueField::refresh() {
    const UnitSystem& units = look().units();
    if (!(m_typedIn == units)) {
        double shown = 0.0;
        if (m_stored) {
            showStored();
        } else if (UnitSystem::parse(m_edit->text(), shown)) {
            // A half-typed value follows the unit, too: it keeps meaning the same length.
            m_stored = m_typedIn.of(m_spec.unit).toStored(shown);
            showStored();
        }
        m_typedIn = units;
    }
    m_label->setText(m_labelText.isEmpty() ? engineText(m_spec.label) : m_labelText);
    m_unit->setText(units.of(m_spec.unit).symbol);
    auto* grid = static_cast<QGridLayout*>(layout());
    grid->setHorizontalSpacing(look().space(Space::Medium));
    grid->setVerticalSpacing(look().space(Space::Small));
    QFont font = look().font(TextSize::Card);
    m_edit->setFont(font);
    m_edit->setStyleSheet(QStringLiteral("font-size: %1px").arg(look().metrics().text(TextSize::Card)));
    m_edit->setMinimumWidth(QFontMetrics(font).horizontalAdvance(QStringLiteral("8888.88888")));
    if (!m_complaint->text().isEmpty()) {
        setComplaint(m_complaint->text());
    }
    FaceWidget::refresh();
}

}  // namespace kerf::ui
