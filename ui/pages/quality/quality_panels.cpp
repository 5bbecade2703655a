// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/quality/quality_panels.h"

#include <QCoreApplication>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "ui/link/texts.h"

namespace kerf::ui {
namespace {

struct QualityTexts {
    Q_DECLARE_TR_FUNCTIONS(QualityTexts)
};

constexpr std::size_t kClasses = 20;
constexpr double kControlLimit = 3.0;
constexpr double kMostShown = 6.0;  // σ; what is farther off lies at the edge, so that it does not flatten the others
constexpr double kFewestParts = 12.0;

/// Oldest first.
template <class Item>
std::vector<Item> shownOf(const std::vector<Item>& items, const PartWindow& window) {
    std::vector<Item> shown;
    for (auto item = items.rbegin(); item != items.rend() && shown.size() < kChartParts; ++item) {
        if ((window.last == 0 || item->id <= window.last) && (!window.belongs || window.belongs(item->id))) {
            shown.push_back(*item);
        }
    }
    std::ranges::reverse(shown);
    return shown;
}

}  // namespace

QString characteristicName(const Characteristic& characteristic) {
    const QString name = engineText(characteristic.name.c_str());
    if (!characteristic.key.starts_with("bore_")) {
        return name;
    }
    // The Boring page's words for the usual depths; any other name as it is.
    const QString depth = QCoreApplication::translate("BoringTexts", characteristic.name.c_str(), "depth of a bore");
    return QualityTexts::tr("Bore ⌀, %1").arg(depth);
}

QString groupName(const PartGroup& group) {
    switch (group.by) {
        case PartGroup::By::Lot:
            return QualityTexts::tr("lot %1").arg(QString::fromStdString(group.name));
        case PartGroup::By::Tool:
            return QualityTexts::tr("tool from part %1").arg(QString::fromStdString(group.name));
        case PartGroup::By::Person:
            return QualityTexts::tr("entered by %1").arg(QString::fromStdString(group.name));
        case PartGroup::By::Source:
            break;
    }
    const QString name = QString::fromStdString(group.name);
    switch (group.source) {
        case MeasurementSource::Keypad:
            return QualityTexts::tr("typed on the keypad");
        case MeasurementSource::Gauge:
            return name.isEmpty() ? QualityTexts::tr("read from the gauge")
                                  : QualityTexts::tr("read from gauge %1").arg(name);
        case MeasurementSource::File:
            break;
    }
    return QualityTexts::tr("from file %1").arg(name);
}

QString capabilityText(const quality::Capability& capability, const UnitSystem& units) {
    QStringList words{QualityTexts::tr("n %1").arg(capability.count)};
    const auto index = [](const QString& name, const std::optional<quality::IndexWithInterval>& value) {
        return value ? QualityTexts::tr("%1 %2 (%3 to %4)", "index with its interval")
                           .arg(name, UnitSystem::fixed(value->value, 2), UnitSystem::fixed(value->low, 2),
                                UnitSystem::fixed(value->high, 2))
                     : QString();
    };
    words << index(QStringLiteral("Pp"), capability.pp) << index(QStringLiteral("Ppk"), capability.ppk)
          << index(QStringLiteral("Cp"), capability.cp) << index(QStringLiteral("Cpk"), capability.cpk);
    if (capability.preliminary && capability.ppk) {
        words << QualityTexts::tr("preliminary");
    }
    words.removeAll(QString());
    QString text = words.join(QStringLiteral(" · "));
    if (!capability.reason.empty()) {
        text += u'\n' + sentenceText(capability.reason, units);
    }
    return text;
}

ResidualChart::ResidualChart(Look& look, QWidget* parent)
    : Chart(look, parent),
      m_errors(addCurve({Token::Measured, Kind::LineAndPoints, Marker::Disc, Stroke::Thin})),
      m_ewma(addCurve({Token::Predicted, Kind::Line, Marker::Ring, Stroke::Normal})) {
    setObjectName(QStringLiteral("qualityResiduals"));
    setLowTitles(true);
    retranslate();
}

void ResidualChart::retranslate() {
    setXAxis(tr("part"), "", true);
    setYAxis(tr("error against the law, σ"), "");
    setEmptyText(tr("The error of each part against the law's prediction appears here from the second part on."));
    setCurveLabel(m_ewma, tr("EWMA"));
    setAccessibleName(tr("One-step errors"));
}

void ResidualChart::setLot(const LotQuality& lot, const PartWindow& window) {
    std::vector<QPointF> errors;
    std::vector<QPointF> ewma;
    std::vector<Mark> marks;
    double limit = 0.0;
    double widest = kControlLimit + 1.0;
    const auto parts = shownOf(lot.charted, window);
    for (const ChartedPart& part : parts) {
        errors.emplace_back(part.number, std::clamp(part.error, -kMostShown, kMostShown));
        ewma.emplace_back(part.number, std::clamp(part.point.ewma, -kMostShown, kMostShown));
        limit = part.point.ewmaLimit;
        widest = std::max(widest, std::min(std::abs(part.error), kMostShown) + 0.5);
        if (part.point.fired.any()) {
            marks.push_back({static_cast<double>(part.number), tr("signal"), Token::Alarm3});
        }
    }
    setPoints(m_errors, errors);
    setPoints(m_ewma, ewma);
    setMarks(std::move(marks));
    setLimits({{kControlLimit, QStringLiteral("+3σ")},
               {-kControlLimit, QStringLiteral("−3σ"), Token::Limit, false, true},
               {limit, tr("EWMA limit"), Token::Limit, true},
               {-limit, {}, Token::Limit, true}});
    setYRange(-widest, widest);
    const double first = parts.empty() ? 1.0 : parts.front().number;
    const double last = parts.empty() ? 1.0 : parts.back().number;
    setXRange(first - 0.5, std::max(last + 0.5, first + kFewestParts));
}

RawChart::RawChart(Look& look, QWidget* parent)
    : Chart(look, parent), m_values(addCurve({Token::Measured, Kind::LineAndPoints, Marker::Disc, Stroke::Thin})) {
    setObjectName(QStringLiteral("qualityRaw"));
    setLowTitles(true);
    retranslate();
}

void RawChart::retranslate() {
    setXAxis(tr("part"), "", true);
    setEmptyText(tr("The measured values of the lot appear here."));
    setAccessibleName(tr("Measured values with their tolerance"));
}

void RawChart::setLot(const LotQuality& lot, std::size_t characteristic, const PartWindow& window) {
    if (characteristic >= lot.characteristics.size()) {
        setPoints(m_values, {});
        setLimits({});
        return;
    }
    const Characteristic& what = lot.characteristics[characteristic];
    const bool length = what.unit == "mm";
    // At most a tolerance width beyond either limit: one bad part does not flatten the others.
    const bool both = what.tolerance.lower && what.tolerance.upper;
    const double width = both ? *what.tolerance.upper - *what.tolerance.lower : 0.0;
    const double lowest = both ? *what.tolerance.lower - width : std::numeric_limits<double>::lowest();
    const double highest = both ? *what.tolerance.upper + width : std::numeric_limits<double>::max();
    setYAxis(characteristicName(what), length ? "mm" : "");
    std::vector<QPointF> points;
    const auto parts = shownOf(lot.parts, window);
    for (const LotPart& part : parts) {
        if (const auto& value = part.judgement.values[characteristic].value) {
            points.emplace_back(part.number, std::clamp(*value, lowest, highest));
        }
    }
    std::vector<Limit> limits;
    if (what.tolerance.upper) {
        limits.push_back({*what.tolerance.upper, tr("upper"), Token::Limit, false});
    }
    if (what.nominal) {
        limits.push_back({*what.nominal, {}, Token::Wanted, true});
    }
    if (what.tolerance.lower) {
        limits.push_back({*what.tolerance.lower, tr("lower"), Token::Limit, false, true});
    }
    setLimits(std::move(limits));
    setPoints(m_values, points);
    const double first = parts.empty() ? 1.0 : parts.front().number;
    const double last = parts.empty() ? 1.0 : parts.back().number;
    setXRange(first - 0.5, std::max(last + 0.5, first + kFewestParts));
}

ActionChart::ActionChart(Look& look, QWidget* parent)
    : Chart(look, parent), m_feed(addCurve({Token::Measured, Kind::LineAndPoints, Marker::Ring, Stroke::Thin})) {
    setObjectName(QStringLiteral("qualityAction"));
    setLowTitles(true);
    retranslate();
}

void ActionChart::retranslate() {
    setXAxis(tr("part"), "", true);
    setYAxis(tr("feed in the middle of the bore"), "mm/rev");
    setEmptyText(tr("What the controller does from part to part appears here."));
    setAccessibleName(tr("Control action"));
}

void ActionChart::setLot(const LotQuality& lot, const PartWindow& window) {
    std::vector<QPointF> points;
    const auto parts = shownOf(lot.charted, window);
    for (const ChartedPart& part : parts) {
        if (part.action > 0.0) {
            points.emplace_back(part.number, part.action);
        }
    }
    setPoints(m_feed, points);
    const double first = parts.empty() ? 1.0 : parts.front().number;
    const double last = parts.empty() ? 1.0 : parts.back().number;
    setXRange(first - 0.5, std::max(last + 0.5, first + kFewestParts));
}

SpreadChart::SpreadChart(Look& look, QWidget* parent)
    : Chart(look, parent), m_counts(addCurve({Token::Measured, Kind::Line, Marker::Disc, Stroke::Normal})) {
    setObjectName(QStringLiteral("qualitySpread"));
    setLowTitles(true);
    retranslate();
}

void SpreadChart::retranslate() {
    setYAxis(tr("parts"), "");
    setEmptyText(tr("How the values lie in their tolerance appears here."));
    setAccessibleName(tr("Histogram with tolerance"));
}

/// Classes as a stepped curve; the tolerance stands as two vertical marks.
void SpreadChart::setLot(const LotQuality& lot, std::size_t characteristic, const PartWindow& window) {
    std::vector<double> values;
    if (characteristic < lot.characteristics.size()) {
        for (const LotPart& part : lot.parts) {
            const auto& value = part.judgement.values[characteristic].value;
            if (value && std::isfinite(*value) && (!window.belongs || window.belongs(part.id))) {
                values.push_back(*value);
            }
        }
    }
    if (values.empty()) {
        setPoints(m_counts, {});
        setMarks({});
        return;
    }
    const Characteristic& what = lot.characteristics[characteristic];
    double from = *std::ranges::min_element(values);
    double to = *std::ranges::max_element(values);
    for (const auto& limit : {what.tolerance.lower, what.tolerance.upper}) {
        if (limit) {
            from = std::min(from, *limit);
            to = std::max(to, *limit);
        }
    }
    const double width = to > from ? (to - from) / static_cast<double>(kClasses) : 1.0;
    std::array<double, kClasses> counts{};
    for (const double value : values) {
        const auto at = static_cast<std::size_t>(std::clamp((value - from) / width, 0.0, kClasses - 1.0));
        counts[at] += 1.0;
    }
    std::vector<QPointF> steps{{from, 0.0}};
    for (std::size_t i = 0; i < kClasses; ++i) {
        steps.emplace_back(from + width * static_cast<double>(i), counts[i]);
        steps.emplace_back(from + width * static_cast<double>(i + 1), counts[i]);
    }
    steps.emplace_back(from + width * kClasses, 0.0);
    setXAxis(characteristicName(what), what.unit == "mm" ? "mm" : "");
    std::vector<Mark> marks;
    if (what.tolerance.lower) {
        marks.push_back({*what.tolerance.lower, tr("lower"), Token::Limit});
    }
    if (what.tolerance.upper) {
        marks.push_back({*what.tolerance.upper, tr("upper"), Token::Limit});
    }
    setMarks(std::move(marks));
    setPoints(m_counts, steps);
    setXRange(from - 2.0 * width, from + width * (kClasses + 2.0));
    setYRange(0.0, *std::ranges::max_element(counts) + 1.0);
}

}  // namespace kerf::ui
