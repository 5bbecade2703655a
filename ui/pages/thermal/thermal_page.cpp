// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/thermal/thermal_page.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "ui/link/start_obstacle.h"
#include "ui/link/texts.h"
#include "ui/link/vocabulary.h"
#include "ui/pages/thermal/thermal_texts.h"
#include "ui/shell/start_rest.h"
#include "ui/widgets/label.h"

namespace kerf::ui {
namespace {

constexpr double kTrend_min = 10.0;
constexpr double kShortestCourse_min = 20.0;
constexpr std::size_t kDrawnPoints = 400;

bool hasNews(const ThermalStatus& now, const ThermalStatus& before) {
    return now.updates != before.updates || now.stage != before.stage || now.model != before.model ||
           now.gap.number != before.gap.number || now.gap.phase != before.gap.phase ||
           now.gapsReadable != before.gapsReadable || now.gapZeroKnown != before.gapZeroKnown ||
           now.partToMeasure != before.partToMeasure || now.recording != before.recording ||
           now.count != before.count || now.couple != before.couple;
}

}  // namespace

ThermalPage::ThermalPage(const PageContext& page, QWidget* parent)
    : Page(page, parent), m_service(page.services.thermalService) {
    m_rows = new QVBoxLayout(this);
    if (m_service == nullptr) {
        m_missing = addNotice(m_rows);
    } else {
        build();
    }
    refresh();
}

void ThermalPage::build() {
    m_offsets = new OffsetPanel(look(), this);
    m_chartCard = new Card(look(), this);
    m_chart = new Chart(look(), m_chartCard);
    m_chart->setObjectName(QStringLiteral("thermalChart"));
    m_chart->setLowTitles(true);
    m_chart->setYIncludes({-2.0, 2.0});
    for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
        m_band[axis] = m_chart->addBand(Token::Predicted);
        m_predicted[axis] = m_chart->addCurve({Token::Predicted, Chart::Kind::Line});
        m_measured[axis] = m_chart->addCurve({Token::Measured, Chart::Kind::Points, Chart::Marker::Disc});
    }
    m_key = makeLabel(TextRole::Dim, m_chartCard);
    m_chartCard->header()->addWidget(m_key);
    m_chartCard->body()->addWidget(m_chart, 1);
    m_drawingCard = new Card(look(), this);
    m_drawing = new MachineDrawing(look(), m_drawingCard);
    m_health = makeLabel(TextRole::Body, m_drawingCard, true);
    m_health->setObjectName(QStringLiteral("thermalHealth"));
    m_touchedText = makeLabel(TextRole::Body, m_drawingCard, true);
    m_touchedText->setObjectName(QStringLiteral("thermalTouched"));
    m_trend = new Sparkline(look(), m_drawingCard);
    m_trend->setObjectName(QStringLiteral("thermalTrend"));
    m_drawingCard->body()->addWidget(m_health);
    m_drawingCard->body()->addWidget(m_drawing, 1);
    m_drawingCard->body()->addWidget(m_touchedText);
    m_drawingCard->body()->addWidget(m_trend);
    m_sheets = std::make_unique<ThermalSheets>(context(), *m_service);

    m_middle = new QHBoxLayout;
    m_middle->addWidget(m_chartCard, 3);
    m_middle->addWidget(m_drawingCard, 2);
    m_buttonRow = new QHBoxLayout;
    m_rows->addWidget(m_offsets);
    m_rows->addLayout(m_middle, 1);
    m_rows->addLayout(m_buttonRow);
    ActionButton* warm = addButton("thermalWarmUp", [this] { warmUp(); });
    warm->setPredicate([this]() -> QString {
        if (m_status.thermal.warmUpRunning) return {};
        return startObstacle(m_status, context().client.engine().capabilities().cycleStart, ProcessId::Thermal,
                             look().units());
    });
    restUntilShown(warm, context(), [this] {  // stopping rests for nothing
        return m_status.thermal.warmUpRunning ? std::nullopt : std::optional(ProcessId::Thermal);
    });
    addButton("thermalMeasure", [this] { m_sheets->openMeasure(); });
    addButton("thermalModel", [this] { m_sheets->openModel(); });
    addButton("thermalHistory", [this] { m_sheets->openHistory(); });
    addButton("thermalSensors", [this] { m_sheets->openSensors(); });
    addButton("thermalMap", [this] { m_sheets->openMap(); });
    addButton("thermalLimits", [this] { m_sheets->openLimits(); });
    m_offsets->setSession(context().session);
    connect(m_offsets, &OffsetPanel::modeRequested, this, [this](LoopMode mode) {
        context().withPermission(Deed::SwitchLoop, [this, mode] {
            context().client.sendAction(SetLoopMode{ProcessId::Thermal, mode});
        });
    });
    connect(m_drawing, &MachineDrawing::sensorTouched, this, [this](std::size_t sensor) {
        m_touched = sensor;
        m_drawing->select(sensor);
        showTouched();
    });
    connect(&context().client, &EngineClient::statusChanged, this, &ThermalPage::onStatus);
}

ActionButton* ThermalPage::addButton(const char* name, std::function<void()> action) {
    auto* button = new ActionButton(look(), this);
    button->setObjectName(QLatin1String(name));
    connect(button, &QPushButton::clicked, this, std::move(action));
    m_buttonRow->addWidget(button, 1);
    m_buttons.push_back(button);
    return button;
}

void ThermalPage::refresh() {
    setObjectName(QStringLiteral("thermalPage"));
    const int gap = look().space(Space::Medium);
    m_rows->setContentsMargins(gap, gap, gap, gap);
    m_rows->setSpacing(gap);
    if (m_missing != nullptr) {
        m_missing->setText(tr("This machine reports no temperatures. The page fills as soon as it does."));
    } else {
        m_middle->setSpacing(gap);
        m_buttonRow->setSpacing(look().metrics().touchGap());
        m_chartCard->setTitle(tr("Drift over time, %1").arg(look().units().of("um").symbol));
        m_key->setText(termText(Term::DriftKey, look().wording()));
        m_chart->setXAxis(tr("time"), "min");
        m_chart->setYAxis(termText(Term::DriftAxis, look().wording()), "um");
        m_chart->setEmptyText(
            tr("The predicted drift appears here one minute after the reference, as soon as a model is live."));
        for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
            m_chart->setCurveLabel(m_predicted[axis], QLatin1String(kThermalAxes[axis]));
        }
        m_drawingCard->setTitle(tr("Temperatures"));
        const std::array names{tr("Warm up"), tr("Measure"),   tr("Model"), tr("History"),
                               tr("Sensors"), tr("Error map"), tr("Limits")};
        for (std::size_t i = 0; i < m_buttons.size(); ++i)
            m_buttons[i]->setText(names[i]);
        m_shownRevision = 0;
        showView();
        showHealth();
        showTouched();
    }
    Page::refresh();
}

void ThermalPage::showEvent(QShowEvent* event) {
    Page::showEvent(event);
    if (m_service != nullptr) onStatus(context().client.status());
}

void ThermalPage::onStatus(const Status& status) {
    if (!isVisible()) return;
    const bool news = m_service->view().revision != m_shownRevision || hasNews(status.thermal, m_status.thermal);
    m_status = status;
    m_offsets->setStatus(status.thermal, status.loops[static_cast<std::size_t>(ProcessId::Thermal)]);
    m_drawing->setStatus(status.thermal);
    m_buttons.front()->setText(status.thermal.warmUpRunning ? tr("Stop warm-up") : tr("Warm up"));
    m_buttons.front()->reconsider();
    m_sheets->take(status);
    if (!news) return;  // sixty times a second nothing has changed
    showView();
    showHealth();
    showTouched();
    m_sheets->refresh();
}

void ThermalPage::showView() {
    const ThermalServiceView& view = m_service->view();
    m_drawing->setSensors(view.sensors);
    if (view.revision == m_shownRevision) return;
    m_shownRevision = view.revision;
    double last_min = kShortestCourse_min;
    const std::size_t stride = view.course.size() / kDrawnPoints + 1;
    for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
        std::vector<QPointF> predicted;
        std::vector<QPointF> measured;
        std::vector<Chart::BandPoint> band;
        for (std::size_t k = 0; k < view.course.size(); ++k) {
            const ThermalCoursePoint& point = view.course[k];
            const bool drawn = k % stride == 0 || k + 1 == view.course.size();
            const auto drift_um = static_cast<double>(point.drift_um[axis]);
            const auto half_um = static_cast<double>(point.half_um[axis]);
            last_min = std::max(last_min, point.minutes);
            if (point.predicted && drawn) {
                predicted.emplace_back(point.minutes, drift_um);
                band.push_back({point.minutes, drift_um - half_um, drift_um + half_um});
            }
            if (point.measured) measured.emplace_back(point.minutes, static_cast<double>(point.measured_um[axis]));
        }
        m_chart->setPoints(m_predicted[axis], predicted);
        m_chart->setBand(m_band[axis], band);
        m_chart->setPoints(m_measured[axis], measured);
    }
    m_chart->setXRange(
        view.course.empty() ? 0.0 : std::min(view.course.front().minutes, last_min - kShortestCourse_min), last_min);
}

void ThermalPage::showHealth() {
    const ThermalServiceView& view = m_service->view();
    const ThermalStatus& status = m_status.thermal;
    QStringList sick;
    int unread = 0;
    for (std::size_t k = 0; k < status.count && k < view.sensors.size(); ++k) {
        if (isSick(status.couple[k])) {
            sick << QString::fromStdString(view.sensors[k].name) + u' ' + coupleStateName(status.couple[k]);
        }
        unread += status.couple[k] == CoupleState::Unread ? 1 : 0;
    }
    QString text;
    if (!view.storeProblem.empty()) {
        text = tr("Nothing can be stored at the moment: %1").arg(sentenceText(view.storeProblem, look().units()));
    } else if (status.count == 0) {
        text = tr("No temperatures yet.");
    } else if (unread > 0) {
        text = tr("%n thermocouples give no reading.", nullptr, unread);
    } else if (!sick.isEmpty()) {
        text = tr("Left out: %1").arg(sick.join(QStringLiteral(", ")));
    } else {
        text = tr("All %1 thermocouples are healthy; filled points belong to the model.").arg(status.count);
    }
    m_health->setText(text);
}

void ThermalPage::showTouched() {
    const ThermalServiceView& view = m_service->view();
    const bool known = m_touched && *m_touched < view.sensors.size() && *m_touched < m_status.thermal.count;
    m_trend->setVisible(known);
    if (!known) {
        m_touchedText->setText(tr("Touch a point to read it."));
        return;
    }
    const auto course = m_service->temperatures(*m_touched);
    std::vector<double> values;
    double before_degC = course.empty() ? 0.0 : course.front().second;
    for (const auto& [minutes, temp_degC] : course) {
        values.push_back(temp_degC);
        if (minutes <= course.back().first - kTrend_min) before_degC = temp_degC;
    }
    const auto now_degC = static_cast<double>(m_status.thermal.temp_degC[*m_touched]);
    const UnitSystem& units = look().units();
    const QString change =
        units.difference(values.empty() ? 0.0 : values.back() - before_degC, "degC", kTemperatureDecimals);
    m_touchedText->setText(tr("%1: %2, %3; %4 in 10 min", "sensor, temperature, state, change")
                               .arg(sensorText(view.sensors[*m_touched]),
                                    units.withUnit(now_degC, "degC", kTemperatureDecimals),
                                    coupleStateName(m_status.thermal.couple[*m_touched]), change));
    m_trend->setValues(values);
}

void ThermalPage::warmUp() {
    if (m_status.thermal.warmUpRunning) {
        context().client.sendAction(StopWarmUp{});
        return;
    }
    const ThermalSetup& setup = m_service->view().setup;
    context().sheets.ask(
        tr("Warm up the spindle?"),
        tr("The spindle turns at %1 for %2. Take care that nothing is in its way.")
            .arg(look().units().withUnit(setup.warmUpSpeed_rpm, "rpm", 0), minutesText(setup.warmUp_min)),
        tr("Not now"), tr("Start the spindle"), [this] { context().client.startPart(ProcessId::Thermal); });
}

}  // namespace kerf::ui
