// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/thermal/thermal_texts.h"

#include <QCoreApplication>
#include <QHeaderView>
#include <QScroller>
#include <cmath>

#include "ui/link/texts.h"
#include "ui/link/vocabulary.h"

namespace kerf::ui {
namespace {

struct ThermalTexts {
    Q_DECLARE_TR_FUNCTIONS(ThermalTexts)
};
constexpr int kRowsSeen = 5;

}  // namespace

QString coupleStateName(CoupleState state) {
    switch (state) {
        case CoupleState::Healthy:
            return ThermalTexts::tr("healthy");
        case CoupleState::Suspect:
            return ThermalTexts::tr("suspect");
        case CoupleState::Open:
            return ThermalTexts::tr("open");
        case CoupleState::Short:
            return ThermalTexts::tr("shorted");
        case CoupleState::Stuck:
            return ThermalTexts::tr("stuck");
        case CoupleState::Noisy:
            return ThermalTexts::tr("noisy");
        case CoupleState::Offset:
            return ThermalTexts::tr("jumped away");
        case CoupleState::Disagrees:
            return ThermalTexts::tr("disagrees");
        case CoupleState::Unread:
            break;
    }
    return ThermalTexts::tr("no reading");
}

QString modelKindName(const std::string& kind, Wording wording) {
    if (kind == "regression") {
        return termText(Term::ModelRegression, wording);
    }
    if (kind == "hierarchical") {
        return termText(Term::ModelHierarchical, wording);
    }
    if (kind == "gmdh") {
        return termText(Term::ModelNetwork, wording);
    }
    return kind == "gmdh-paper" ? termText(Term::ModelNetworkAsPrinted, wording) : QString::fromStdString(kind);
}

QString minutesText(double minutes) {
    return ThermalTexts::tr("%1 min").arg(UnitSystem::fixed(std::ceil(minutes), 0));
}

QString threeText(std::span<const double, kAxisCount> values_um, const UnitSystem& units, int decimals) {
    QStringList parts;
    for (const double value_um : values_um) {
        parts << units.number(value_um, "um", decimals);
    }
    return parts.join(QStringLiteral(" / "));
}

namespace {

QString verdictWords(quality::Verdict verdict, const ThermalGapRow& row, const UnitSystem& units) {
    const QString band = QStringLiteral("±") + units.withUnit(row.allowed_um, "um", kDriftDecimals);
    return verdict == quality::Verdict::NotJudged ? ThermalTexts::tr("not judged")
           : verdict == quality::Verdict::Good    ? ThermalTexts::tr("good, within %1").arg(band)
                                                  : ThermalTexts::tr("out of %1").arg(band);
}

}  // namespace

QString leftText(const ThermalGapRow& row, std::size_t axis, const UnitSystem& units) {
    const quality::Verdict verdict = row.verdict(axis);
    const QString words = verdictWords(verdict, row, units);
    return verdict == quality::Verdict::NotJudged
               ? words
               : units.number(row.left_um[axis], "um", kDriftDecimals) + QStringLiteral(", ") + words;
}

QString leftText(const ThermalGapRow& row, const UnitSystem& units) {
    // The worst of the axes that were measured.
    std::optional<quality::Verdict> worst;
    QStringList values;
    for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
        const quality::Verdict verdict = row.verdict(axis);
        const bool judged = verdict != quality::Verdict::NotJudged;
        values << (judged ? units.number(row.left_um[axis], "um", kDriftDecimals) : QStringLiteral("–"));
        if (judged) {
            worst = quality::worse(worst.value_or(verdict), verdict);
        }
    }
    const QString words = verdictWords(worst.value_or(quality::Verdict::NotJudged), row, units);
    return worst ? values.join(QStringLiteral(" / ")) + QStringLiteral(", ") + words : words;
}

QString warmUpText(const ThermalStatus& status, const UnitSystem& units) {
    const QString band = QStringLiteral("±") + units.withUnit(status.allowed_um, "um", kDriftDecimals);
    switch (status.warmUp) {
        case WarmUpState::Ready:
            return ThermalTexts::tr("Ready for %1").arg(band);
        case WarmUpState::Waiting:
            return ThermalTexts::tr("Ready for %1 in %2").arg(band, minutesText(status.ready_min));
        case WarmUpState::TooWide:
            return ThermalTexts::tr("Interval wider than %1: measure the origin").arg(band);
        case WarmUpState::Unknown:
            break;
    }
    return status.warmUpRunning ? ThermalTexts::tr("Warm-up: %1 left").arg(minutesText(status.warmUpLeft_min))
                                : ThermalTexts::tr("Readiness is known after 20 min of prediction");
}

QString sensorText(const ThermalSensorView& sensor) {
    const QString name = QString::fromStdString(sensor.name);
    if (!sensor.placeText.empty()) {
        return name + QStringLiteral(", ") + QString::fromStdString(sensor.placeText);
    }
    return *sensor.place == '\0' ? name : name + QStringLiteral(", ") + engineText(sensor.place);
}

QTableWidget* makeThermalTable(Look& look, const char* name, const QStringList& titles, QWidget* parent) {
    auto* table = new QTableWidget(0, static_cast<int>(titles.size()), parent);
    table->setObjectName(QLatin1String(name));
    table->setHorizontalHeaderLabels(titles);
    table->setEditTriggers(QAbstractItemView::NoEditTriggers);
    table->setSelectionMode(QAbstractItemView::NoSelection);
    table->setFocusPolicy(Qt::NoFocus);
    table->setWordWrap(true);
    table->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    table->setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
    table->verticalHeader()->hide();
    table->verticalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    table->verticalHeader()->setMinimumSectionSize(look.metrics().touch() * 2 / 3);
    table->horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
    QScroller::grabGesture(table->viewport(), QScroller::TouchGesture);
    table->setMinimumHeight(kRowsSeen * look.metrics().touch());
    return table;
}

void setTableRow(QTableWidget* table, int row, const QStringList& cells) {
    if (table->rowCount() <= row) {
        table->setRowCount(row + 1);
    }
    for (int column = 0; column < cells.size(); ++column) {
        if (table->item(row, column) == nullptr) {
            table->setItem(row, column, new QTableWidgetItem);
        }
        table->item(row, column)->setText(cells[column]);
    }
}

KeyFigure thermalFigure(const Services& services, const Status& status) {
    KeyFigure figure;
    figure.unit = "um";
    figure.decimals = kDriftDecimals;
    const ThermalStatus& thermal = status.thermal;
    std::size_t largest = 0;
    for (std::size_t axis = 1; axis < kAxisCount; ++axis) {
        if (std::abs(thermal.drift_um[axis]) > std::abs(thermal.drift_um[largest])) {
            largest = axis;
        }
    }
    figure.label = ThermalTexts::tr("Drift, %1").arg(QLatin1String(kThermalAxes[largest]));
    figure.limited = thermal.sizeLimited[largest] || thermal.rateLimited[largest];
    if (thermal.stage == ThermalStage::Following) {
        figure.value = thermal.drift_um[largest];
        figure.half95 = thermal.half_um[largest];
    }
    if (services.thermalService != nullptr) {
        for (const ThermalCoursePoint& point : services.thermalService->view().course) {
            figure.course.push_back(static_cast<double>(point.drift_um[largest]));
        }
    }
    return figure;
}

}  // namespace kerf::ui
