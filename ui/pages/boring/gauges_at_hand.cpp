// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/boring/gauges_at_hand.h"

#include <QStringList>
#include <algorithm>

namespace kerf::ui {

GaugesAtHand GaugesAtHand::fromText(const QString& text) {
    GaugesAtHand gauges;
    for (const QString& one : text.split(u';', Qt::SkipEmptyParts)) {
        bool number = false;
        const qsizetype sign = one.indexOf(u'=');
        const int channel = one.left(std::max<qsizetype>(sign, 0)).toInt(&number);
        if (sign > 0 && number && channel >= 0) {
            gauges.set(channel,
                       QString::fromUtf8(QByteArray::fromPercentEncoding(one.mid(sign + 1).toUtf8())).toStdString());
        }
    }
    return gauges;
}

QString GaugesAtHand::text() const {
    QStringList words;
    for (const auto& [channel, identity] : m_chosen) {
        // An identity may hold any sign.
        words << QString::number(channel) + u'=' +
                     QString::fromLatin1(QByteArray::fromStdString(identity).toPercentEncoding());
    }
    return words.join(u';');
}

void GaugesAtHand::set(int channel, const std::string& identity) {
    m_chosen[channel] = identity;
}

std::string GaugesAtHand::of(int channel, const std::vector<Gauge>& registered, double bore_mm) const {
    const auto chosen = m_chosen.find(channel);
    const auto known = [&] {
        return chosen->second.empty() ||
               std::ranges::find(registered, chosen->second, &Gauge::identity) != registered.end();
    };
    if (chosen != m_chosen.end() && known()) {
        return chosen->second;
    }
    const auto fits = [bore_mm](const Gauge& gauge) {
        return bore_mm >= gauge.rangeFrom_mm && bore_mm <= gauge.rangeTo_mm;
    };
    const auto first = std::ranges::find_if(registered, fits);
    const bool only = first != registered.end() && std::none_of(first + 1, registered.end(), fits);
    return only ? first->identity : std::string();
}

}  // namespace kerf::ui
