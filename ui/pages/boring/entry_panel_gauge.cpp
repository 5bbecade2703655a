// SPDX-License-Identifier: GPL-3.0-or-later
// Where the readings of a hand gauge go.
#include <QLabel>
#include <QStackedWidget>

#include "ui/link/texts.h"
#include "ui/pages/boring/boring_texts.h"
#include "ui/pages/boring/entry_panel.h"
#include "ui/pages/boring/gauges_at_hand.h"

namespace kerf::ui {

bool EntryPanel::inBurst() const {
    constexpr qint64 kBurst_ms = 1000;  // nobody puts the next part on in this time
    return m_sinceReading.isValid() && m_sinceReading.elapsed() < kBurst_ms;
}

void EntryPanel::told() {
    emit gaugeTold(message());
}

void EntryPanel::tellLeftOut(const QString& sentence) {
    say([sentence] { return sentence; }, true);
    emit attentionNeeded();
    told();
}

void EntryPanel::setChannels(GaugeChannels channels) {
    m_channels = std::move(channels);
    showChannels();
}

std::string EntryPanel::gaugeOn(int channel) const {
    return m_signing.gauge ? m_signing.gauge(channel) : std::string();
}

std::string EntryPanel::gaugeOf(const GaugeReading& reading) const {
    return reading.gauge.empty() ? gaugeOn(reading.channel.value_or(GaugesAtHand::kNoChannel)) : reading.gauge;
}

void EntryPanel::setGaugesThere(bool there) {
    m_askGauge = there;
    showChannels();
}

void EntryPanel::showChannels() {
    QStringList words;
    if (const std::string gauge = gaugeOn(GaugesAtHand::kNoChannel); !gauge.empty()) {
        words << QString::fromStdString(gauge);
    } else if (m_askGauge) {
        words << tr("Which gauge?");
    }
    const auto& depths = m_service.view().depths;
    for (const auto& [channel, depth] : m_channels.all()) {
        if (depth < depths.size()) {
            words << tr("%1: %2", "gauge channel, depth").arg(channel).arg(depthName(depths[depth]));
        }
    }
    m_channelsButton->setVisible(!words.isEmpty());
    m_channelsButton->setText(words.join(QStringLiteral("  ")));
    m_channelsButton->setAccessibleName(tr("Gauge channels"));
}

/// Where a reading belongs; `why` says it when it belongs nowhere.
std::optional<EntryPanel::Target> EntryPanel::targetOf(const GaugeReading& reading, QString& why) {
    const BoringServiceView& view = m_service.view();
    std::optional<Target> target = m_target;
    if (!target) {
        why = tr("The gauge sent %1, but no part waits for a diameter: left out.").arg(reading.frame);
        return std::nullopt;
    }
    if (reading.depth) {
        if (*reading.depth >= view.depths.size()) {
            why = tr("The gauge sent %1 for depth %2 of the sensor file; this part type has %3: left out.")
                      .arg(reading.frame)
                      .arg(*reading.depth + 1)
                      .arg(view.depths.size());
            return std::nullopt;
        }
        target->depth = *reading.depth;
    } else if (reading.channel) {
        const bool known = m_channels.depthOf(*reading.channel).has_value();
        const auto depth =
            known ? m_channels.depthOf(*reading.channel) : m_channels.learn(*reading.channel, view.depths.size());
        if (!depth || *depth >= view.depths.size()) {
            why = tr("The gauge sent %1, but channel %2 belongs to no depth: left out.")
                      .arg(reading.frame)
                      .arg(*reading.channel);
            return std::nullopt;
        }
        if (!known) {
            showChannels();
            emit channelLearnt();
        }
        target->depth = *depth;
    }
    if (inBurst() && m_burstPart) {
        target->part = reading.channel || reading.depth ? *m_burstPart : target->part;
        if (target->part != *m_burstPart) {
            why = tr("The gauge sent %1 at once behind the others: one too many, left out. For the next part send it "
                     "again.")
                      .arg(reading.frame);
            return std::nullopt;
        }
    }
    const BorePartView* part = findPart(view, target->part);
    if (part == nullptr || measurementAt(*part, target->depth) != nullptr) {
        why =
            tr("The gauge sent %1, but %2 has its diameter: left out. Use Correct to change it.")
                .arg(reading.frame, part != nullptr ? placeName(part->number, view.depths[target->depth]) : QString());
        return std::nullopt;
    }
    return target;
}

void EntryPanel::takeNextWaiting() {
    if (!m_waiting.empty() && !m_pending && !m_question) {
        const GaugeReading next = m_waiting.front();
        m_waiting.pop_front();
        takeGauge(next);
    }
}

void EntryPanel::takeGauge(const GaugeReading& reading) {
    constexpr std::size_t kMostWaiting = 16;
    const auto isElsewhere = [&](std::uint8_t asked) {
        if (reading.depth) {
            return *reading.depth != asked;
        }
        return reading.channel && m_channels.depthOf(*reading.channel).value_or(asked) != asked;
    };
    const bool otherPlace = m_question && (inBurst() || isElsewhere(m_question->depth));
    if (m_pending || otherPlace) {
        if (m_waiting.size() < kMostWaiting) {
            m_waiting.push_back(reading);
        }
        m_sinceReading.start();
        return;
    }
    QString why;
    const std::optional<Target> target = targetOf(reading, why);
    m_sinceReading.start();
    if (!target) {
        tellLeftOut(why);
        takeNextWaiting();
        return;
    }
    m_burstPart = target->part;
    m_target = target;
    judgeAndSubmit(reading, *target);
    takeNextWaiting();
}

void EntryPanel::judgeAndSubmit(const GaugeReading& reading, const Target& target) {
    const LengthUnit shown = m_look.units().length();
    const GaugeJudgement judgement = judgeReading(reading, expected_mm(target), shown, m_service.view().settingRing_mm);
    if (judgement.doubt == GaugeDoubt::Deviation) {
        tellLeftOut(
            tr("The gauge sent %1: a deviation, and the recipe has no setting ring. Not taken.").arg(reading.frame));
        return;
    }
    BoreEntry entry;
    entry.part = target.part;
    entry.depth = target.depth;
    entry.diameter_mm = judgement.value_mm;
    entry.author = m_signing.author();
    entry.fromGauge = true;
    entry.gauge = gaugeOf(reading);
    m_gaugeOfField = entry.gauge;
    m_question.reset();
    m_confirmWords = nullptr;
    m_fromGauge = true;
    m_field->input().clear();
    m_field->input().expect(expected_mm(target), m_look.units());
    m_field->input().set_mm(judgement.doubt == GaugeDoubt::OtherUnit ? judgement.otherUnit_mm : judgement.value_mm);
    showTarget();
    switch (judgement.doubt) {
        case GaugeDoubt::Deviation:  // left out above
            break;
        case GaugeDoubt::None:
            submit(entry);
            break;
        case GaugeDoubt::OtherUnit:
            entry.diameter_mm = judgement.otherUnit_mm;
            ask(
                entry,
                [this, frame = reading.frame, shown] {
                    return shown == LengthUnit::Millimetre
                               ? tr("the gauge sent %1: that fits only in inch. Set the gauge to mm.").arg(frame)
                               : tr("the gauge sent %1: that fits only in mm. Set the gauge to inch.").arg(frame);
                },
                [this, entry] { return tr("Take %1").arg(diameterText(entry.diameter_mm, m_look.units())); });
            break;
        case GaugeDoubt::DecadeSlip:
            ask(
                entry,
                [this, frame = reading.frame] {
                    return tr("the gauge sent %1: its decimal point seems to have slipped.").arg(frame);
                },
                [this, entry] { return tr("Yes, %1").arg(diameterText(entry.diameter_mm, m_look.units())); });
            break;
    }
    if (m_field->property("wrong").toBool() && !m_question) {
        emit attentionNeeded();
        told();
    }
}

void EntryPanel::tellRepeated(const GaugeReading& reading) {
    say([this, reading] {
        return tr("The gauge sent %1 twice at once: the second one is left out.").arg(reading.frame);
    });
    told();
}

void EntryPanel::tellHalved(const QString& part) {
    if (m_field->input().typed() == part.trimmed()) {
        m_field->input().clear();
        refreshView();
    }
    say([this, part] { return tr("Only a part of a reading came (%1): nothing is taken. Send it again.").arg(part); },
        true);
    told();
}

void EntryPanel::tellNumLockOff() {
    say([this] { return tr("Num Lock is off: the keypad sends no figures. Switch it on and type again."); }, true);
}

}  // namespace kerf::ui
