// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/boring/entry_panel.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPointer>
#include <QStackedWidget>
#include <utility>

#include "ui/link/texts.h"
#include "ui/pages/boring/boring_texts.h"
#include "ui/pages/boring/gauges_at_hand.h"
#include "ui/theme/particles.h"
#include "ui/widgets/label.h"

namespace kerf::ui {

EntryPanel::EntryPanel(Look& look, BoringService& service, Signing signing, QWidget* parent)
    : Card(look, parent),
      m_look(look),
      m_service(service),
      m_signing(std::move(signing)),
      m_prompt(makeLabel(TextRole::Title, this)),
      m_gaugeDue(makeLabel(TextRole::Body, this, true)),
      m_field(new DiameterField(look, this)),
      m_unit(makeLabel(TextRole::Dim, this)),
      m_message(makeLabel(TextRole::Body, this, true)),
      m_rows(new QStackedWidget(this)),
      m_buttons(nullptr),
      m_answers(nullptr),
      m_gauge(new ActionButton(look, this)),
      m_undo(new ActionButton(look, this)),
      m_channelsButton(new QPushButton(this)),
      m_correct(new QPushButton(this)),
      m_again(new QPushButton(this)),
      m_confirm(new QPushButton(this)),
      m_keypad(new Keypad(look, Keypad::Shape::Wide, this)),
      m_columns(new QHBoxLayout),
      m_fieldRow(new QHBoxLayout),
      m_left(new QVBoxLayout) {
    setObjectName(QStringLiteral("boringEntry"));
    m_prompt->setObjectName(QStringLiteral("boringEntryPrompt"));
    m_gaugeDue->setObjectName(QStringLiteral("boringGaugeDue"));
    m_gaugeDue->hide();
    m_field->setObjectName(QStringLiteral("boringDiameterField"));
    m_unit->setObjectName(QStringLiteral("boringEntryUnit"));
    m_message->setObjectName(QStringLiteral("boringEntryMessage"));
    m_gauge->setObjectName(QStringLiteral("boringGauge"));
    m_undo->setObjectName(QStringLiteral("boringUndo"));
    m_correct->setObjectName(QStringLiteral("boringCorrect"));
    m_channelsButton->setObjectName(QStringLiteral("boringChannels"));
    m_again->setObjectName(QStringLiteral("boringMeasureAgain"));
    m_confirm->setObjectName(QStringLiteral("boringConfirm"));
    m_keypad->setObjectName(QStringLiteral("boringKeypad"));
    m_keypad->setTarget(m_field);
    m_message->setAlignment(Qt::AlignLeft | Qt::AlignTop);

    auto* buttons = new QWidget(m_rows);
    m_buttons = new QHBoxLayout(buttons);
    m_buttons->setContentsMargins(0, 0, 0, 0);
    m_buttons->addWidget(m_gauge, 1);
    m_buttons->addWidget(m_channelsButton, 1);
    m_buttons->addWidget(m_correct, 1);
    m_buttons->addWidget(m_undo, 2);
    auto* answers = new QWidget(m_rows);
    m_answers = new QHBoxLayout(answers);
    m_answers->setContentsMargins(0, 0, 0, 0);
    m_answers->addWidget(m_again, 1);
    m_answers->addWidget(m_confirm, 1);
    m_rows->addWidget(buttons);
    m_rows->addWidget(answers);
    m_rows->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    m_again->setProperty("primary", true);

    m_fieldRow->addWidget(m_field, 1);
    m_fieldRow->addWidget(m_unit);
    m_left->addWidget(m_prompt);
    m_left->addLayout(m_fieldRow);
    m_left->addWidget(m_gaugeDue);
    m_left->addWidget(m_message, 1);
    m_left->addWidget(m_rows);
    m_columns->addLayout(m_left, 1);
    m_columns->addWidget(m_keypad, 0);
    body()->addLayout(m_columns, 1);

    for (QPushButton* button :
         std::initializer_list<QPushButton*>{m_gauge, m_undo, m_channelsButton, m_correct, m_again, m_confirm}) {
        button->setFocusPolicy(Qt::TabFocus);  // a touch leaves the focus in the field
    }
    connect(m_field, &DiameterField::typed, this, &EntryPanel::onTyped);
    connect(m_field, &DiameterField::cleared, this, &EntryPanel::measureAgain);
    connect(m_field, &DiameterField::entered, this, [this] { m_signing.withOperator([this] { commit(); }); });
    connect(m_field, &DiameterField::numLockOff, this, &EntryPanel::tellNumLockOff);
    connect(m_channelsButton, &QPushButton::clicked, this, &EntryPanel::channelsRequested);
    connect(m_gauge, &QPushButton::clicked, this, &EntryPanel::readGauge);
    connect(m_undo, &QPushButton::clicked, this, &EntryPanel::undoRequested);
    connect(m_correct, &QPushButton::clicked, this, &EntryPanel::measurementsRequested);
    connect(m_again, &QPushButton::clicked, this, &EntryPanel::measureAgain);
    connect(m_confirm, &QPushButton::clicked, this, &EntryPanel::confirm);
    m_gauge->setPredicate([this]() -> QString {
        if (!m_target) {
            return tr("no part waits");
        }
        const bool there =
            m_service.gaugeReading_mm(m_target->part, m_target->depth) || (m_askGauges && m_askGauges(false));
        return there ? QString() : tr("none fitted");
    });
    m_undo->setPredicate([this]() -> QString {
        return lastMeasurement(m_service.view()).measurement == nullptr ? tr("nothing entered") : QString();
    });
    connect(&look, &Look::changed, this, [this] { retranslate(); });
    retranslate();
}

void EntryPanel::setGaugeNote(const QString& note) {
    m_gaugeDue->setText(note);
    m_gaugeDue->setVisible(!note.isEmpty());
}

void EntryPanel::retranslate() {
    setTitle(tr("Enter the bore"));
    m_gauge->setText(tr("Gauge"));
    m_undo->setText(tr("Undo last"));
    m_correct->setText(tr("Correct"));
    showChannels();
    m_again->setText(tr("Measure again"));
    const int gap = m_look.metrics().touchGap();
    for (QHBoxLayout* row : {m_buttons, m_answers}) {
        row->setSpacing(gap);
    }
    m_columns->setSpacing(gap);
    m_fieldRow->setSpacing(m_look.space(Space::Medium));
    m_left->setSpacing(m_look.space(Space::Small));
    m_gauge->reconsider();
    m_undo->reconsider();
    showTarget();
    showWords();
}

std::optional<EntryPanel::Target> EntryPanel::nextTarget() const {
    const BoringServiceView& view = m_service.view();
    const auto open = [&view](const Target& target) {
        const BorePartView* part = findPart(view, target.part);
        return part != nullptr && target.depth < view.depths.size() && measurementAt(*part, target.depth) == nullptr;
    };
    if (m_chosen && open(*m_chosen)) {
        return m_chosen;
    }
    if (view.awaiting) {
        return Target{*view.awaiting, view.awaitingDepth};
    }
    return std::nullopt;
}

void EntryPanel::refreshView() {
    tryKeptAgain();
    const bool untouched = m_field->input().empty() && !m_question && !m_pending;
    if (untouched) {
        m_target = nextTarget();
    } else if (m_target && !m_pending) {
        // Measured meanwhile by somebody else: what is typed belongs to nothing any more.
        const BorePartView* part = findPart(m_service.view(), m_target->part);
        if (part == nullptr || measurementAt(*part, m_target->depth) != nullptr) {
            m_question.reset();
            m_field->input().clear();
            m_target = nextTarget();
        }
    }
    m_gauge->reconsider();
    m_undo->reconsider();
    showChannels();
    showTarget();
}

void EntryPanel::choose(PartId part, std::uint8_t depth) {
    m_chosen = Target{part, depth};
    m_question.reset();
    m_field->input().clear();
    m_field->setWrong(false);
    m_target = nextTarget();
    say({});
    refreshView();
    m_field->setFocus();
}

double EntryPanel::expected_mm(const Target& target) const {
    const BoringServiceView& view = m_service.view();
    const BorePartView* part = findPart(view, target.part);
    if (part != nullptr && target.depth < part->predicted.size() && part->predicted[target.depth]) {
        return part->predicted[target.depth]->diameter_mm;
    }
    return view.targetDiameter_mm;
}

void EntryPanel::showTarget() {
    const BoringServiceView& view = m_service.view();
    if (m_target) {
        const BorePartView* part = findPart(view, m_target->part);
        const QString name = part != nullptr && m_target->depth < view.depths.size()
                                 ? placeName(part->number, view.depths[m_target->depth])
                                 : QString();
        m_prompt->setText(tr("⌀ of %1", "part and depth").arg(name));
        m_field->input().expect(expected_mm(*m_target), m_look.units());
    } else {
        m_prompt->setText(tr("No part waits for a diameter"));
        m_field->input().expect(0.0, m_look.units());
    }
    m_field->setEnabled(m_target.has_value());
    m_field->setAccessibleName(m_prompt->text());
    m_field->showInput();
    m_unit->setText(m_field->input().units().of("mm").symbol);
    m_rows->setCurrentIndex(m_question ? 1 : 0);
    if (m_words == nullptr) {
        showWords();
    }
}

void EntryPanel::say(Words words, bool wrong) {
    m_words = std::move(words);
    m_field->setWrong(wrong);
    showWords();
}

void EntryPanel::showWords() {
    if (m_words) {
        m_message->setText(withParticles(m_words()));
    } else if (!m_target) {
        m_message->setText(whyNoTarget());
    } else if (const auto other = m_field->input().alternative_mm()) {
        m_message->setText(tr("For %1 type all figures.").arg(diameterText(*other, m_field->input().units())));
    } else if (m_field->input().empty()) {
        m_message->setText(tr("Type the last two figures, or the whole diameter."));
    } else {
        m_message->clear();
    }
    if (m_confirmWords) {
        m_confirm->setText(withParticles(m_confirmWords()));
    }
}

QString EntryPanel::whyNoTarget() const {
    const BoringServiceView& view = m_service.view();
    if (!view.storeProblem.empty()) {
        return sentenceText(view.storeProblem, m_look.units());
    }
    return view.parts.empty() ? tr("The first part is not cut yet. Its diameters are asked for here.")
                              : tr("All parts cut so far are measured.");
}

QString EntryPanel::message() const {
    return m_message->text();
}

QString EntryPanel::place(const BoreEntry& entry) const {
    const BoringServiceView& view = m_service.view();
    const BorePartView* part = findPart(view, entry.part);
    return part != nullptr && entry.depth < view.depths.size() ? placeName(part->number, view.depths[entry.depth])
                                                               : QString();
}

void EntryPanel::tryKeptAgain() {
    if (!m_kept || m_pending || !m_service.view().storeProblem.empty()) {
        return;
    }
    const BoreEntry entry = *std::exchange(m_kept, std::nullopt);
    if (m_target && m_target->part == entry.part && m_target->depth == entry.depth) {
        store(entry);
    }
}

void EntryPanel::onTyped() {
    m_typedMeanwhile = m_pending;
    m_kept.reset();
    m_question.reset();  // typing is the answer "measured again"
    m_confirmWords = nullptr;
    m_fromGauge = false;
    say({});
    m_unit->setText(m_field->input().units().of("mm").symbol);
    m_rows->setCurrentIndex(0);
}

void EntryPanel::commit() {
    if (m_pending) {
        m_enterMeanwhile = m_typedMeanwhile;  // else the last key twice
        return;
    }
    if (!m_target) {
        return;
    }
    constexpr qint64 kEcho_ms = 1500;  // the last key twice
    if (!m_question && m_field->input().empty() && m_sinceStored.isValid() && m_sinceStored.elapsed() < kEcho_ms) {
        return;
    }
    if (m_question) {
        say([this] { return tr("Please answer: measure again, or confirm the value."); }, true);
        emit attentionNeeded();
        return;
    }
    const DiameterInput& input = m_field->input();
    BoreEntry entry;
    entry.part = m_target->part;
    entry.depth = m_target->depth;
    entry.author = m_signing.author();
    entry.fromGauge = m_fromGauge;
    entry.gauge = m_fromGauge ? m_gaugeOfField : std::string();
    if (input.empty()) {
        say([this, entry] { return tr("Nothing typed for %1: type its last two figures.").arg(place(entry)); }, true);
        return;
    }
    const std::optional<double> value_mm = input.value_mm();
    if (!value_mm) {
        const QString typed = input.typed();
        const double expected = expected_mm(*m_target);
        const UnitSystem units = input.units();
        const bool short_ = input.completing();
        say(
            [this, entry, typed, expected, units, short_] {
                return short_ ? tr("“%1” for %2 is one figure short: type the last two, or the whole diameter.")
                                    .arg(typed, place(entry))
                              : tr("“%1” for %2 is not a number: type a diameter such as %3.")
                                    .arg(typed, place(entry), diameterText(expected, units));
            },
            true);
        return;
    }
    entry.diameter_mm = *value_mm;
    submit(entry);
}

void EntryPanel::submit(const BoreEntry& entry) {
    const EntryCheck verdict = m_service.check(entry);
    switch (verdict.verdict) {
        case EntryVerdict::Refuse:
            say(
                [this, entry, reason = verdict.reason] {
                    return tr("Not taken for %1: %2").arg(place(entry), sentenceText(reason, m_look.units()));
                },
                true);
            return;
        case EntryVerdict::Ask:
            ask(
                entry, [this, reason = verdict.reason] { return sentenceText(reason, m_look.units()); },
                [this, entry] { return tr("Yes, %1").arg(diameterText(entry.diameter_mm, m_look.units())); });
            return;
        case EntryVerdict::Accept:
            store(entry);
            return;
    }
}

void EntryPanel::ask(const BoreEntry& entry, Words words, Words confirmWords) {
    m_question = entry;
    m_confirmWords = std::move(confirmWords);
    say([this, entry, words = std::move(words)] { return tr("%1: %2").arg(place(entry), words()); }, true);
    m_field->input().beginAnew();
    m_rows->setCurrentIndex(1);
    if (entry.fromGauge) {
        emit attentionNeeded();
        told();
    }
}

void EntryPanel::measureAgain() {
    m_question.reset();
    m_confirmWords = nullptr;
    m_fromGauge = false;
    m_field->input().clear();
    say({});
    refreshView();
    m_field->setFocus();
    takeNextWaiting();
}

void EntryPanel::confirm() {
    if (!m_question || m_pending) {
        return;
    }
    BoreEntry entry = *m_question;
    entry.confirmed = true;
    entry.author = m_signing.author();
    m_question.reset();
    m_confirmWords = nullptr;
    m_rows->setCurrentIndex(0);
    submit(entry);
}

void EntryPanel::store(const BoreEntry& entry) {
    m_pending = true;
    m_typedMeanwhile = false;
    m_enterMeanwhile = false;
    m_field->input().beginAnew();  // who types on means the next bore
    say([this, entry] { return tr("%1: being stored …").arg(place(entry)); });
    m_service.enter(entry, [panel = QPointer<EntryPanel>(this), entry](const Result<void>& result) {
        if (panel) {
            panel->stored(entry, result);
        }
    });
}

void EntryPanel::stored(const BoreEntry& entry, const Result<void>& result) {
    m_pending = false;
    m_kept.reset();
    if (!result) {
        if (!m_service.view().storeProblem.empty()) {
            m_kept = entry;
        }
        say(
            [this, entry, reason = result.error()] {
                const QString value = diameterText(entry.diameter_mm, m_look.units());
                const QString why = sentenceText(reason, m_look.units());
                return m_kept ? tr("%1 is kept here and is stored as soon as there is room: %2").arg(value, why)
                              : tr("Not stored, %1 is kept here: %2 Enter tries again.").arg(value, why);
            },
            true);
        // It came from a gauge, or the next one was being typed: into the field, so that Enter can try again.
        if (m_field->input().empty() || m_typedMeanwhile) {
            m_field->input().set_mm(entry.diameter_mm);
            m_fromGauge = entry.fromGauge;
            m_gaugeOfField = entry.gauge;
        }
        showTarget();
        emit attentionNeeded();
        if (entry.fromGauge) {
            told();
        }
        if (!m_waiting.empty()) {  // they would be refused one after another
            m_waiting.clear();
            tellLeftOut(tr("Further readings are left out until this one is stored: send them again then."));
        }
        return;
    }
    m_sinceStored.start();
    if (!std::exchange(m_typedMeanwhile, false)) {
        m_field->input().clear();
    }
    m_fromGauge = false;
    m_chosen.reset();
    m_target = nextTarget();
    say([this, entry] {
        const QString value = diameterText(entry.diameter_mm, m_look.units());
        const QString said = entry.fromGauge ? tr("%1: %2 from the gauge, stored.").arg(place(entry), value)
                                             : tr("%1: %2 stored.").arg(place(entry), value);
        const QString out = outOfToleranceText(m_service.view(), entry.diameter_mm, m_look.units());
        return out.isEmpty() ? said : said + u' ' + out;
    });
    refreshView();
    if (entry.fromGauge) {
        told();
    }
    if (std::exchange(m_enterMeanwhile, false)) {
        commit();
    }
    takeNextWaiting();
}

void EntryPanel::reconsiderGauge() {
    m_gauge->reconsider();
}

void EntryPanel::readGauge() {
    if (!m_target || m_pending) {
        return;
    }
    const std::optional<double> reading_mm = m_service.gaugeReading_mm(m_target->part, m_target->depth);
    if (!reading_mm) {
        if (m_askGauges && m_askGauges(false)) {
            m_field->setFocus();  // it has the keys again after a question which gauge is meant
            (void)m_askGauges(true);
        }
        m_gauge->reconsider();
        return;
    }
    m_question.reset();
    m_field->input().set_mm(*reading_mm);
    m_fromGauge = true;
    m_gaugeOfField = gaugeOn(GaugesAtHand::kNoChannel);
    say({});
    showTarget();
    m_field->setFocus();
}

}  // namespace kerf::ui
