// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/thermal/thermal_sheets.h"

#include <QDateTime>
#include <QGridLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QTableWidget>
#include <algorithm>
#include <array>
#include <cmath>

#include "engine/core/param_spec.h"
#include "ui/dialogs/recipe_sheet.h"
#include "ui/link/texts.h"
#include "ui/pages/thermal/error_map.h"
#include "ui/pages/thermal/thermal_texts.h"
#include "ui/widgets/action_button.h"
#include "ui/widgets/label.h"
#include "ui/widgets/value_field.h"

namespace kerf::ui {
namespace {

constexpr int kShownRows = 60;

QString timeOf(std::int64_t utc_ms) {
    return QDateTime::fromMSecsSinceEpoch(utc_ms).toString(QStringLiteral("MM-dd HH:mm"));
}

}  // namespace

ActionButton* ThermalSheets::named(const char* name, const QString& text) {
    auto* button = new ActionButton(m_context.look);
    button->setObjectName(QLatin1String(name));
    button->setText(text);
    return button;
}

Sheet* ThermalSheets::open(const QString& title, const QString& text) {
    m_update = {};
    Sheet* sheet = m_context.sheets.open(title, text);
    sheet->addButton(tr("Close"), {})->setObjectName(QStringLiteral("thermalSheetClose"));
    m_sheet = sheet;
    return sheet;
}

void ThermalSheets::follow(std::function<void()> update) {
    m_update = std::move(update);
    m_update();
}

void ThermalSheets::refresh() {
    if (m_sheet != nullptr && m_update) {
        m_update();
    }
}

void ThermalSheets::tell(const Result<void>& result) {
    if (!result) {
        m_context.notify(sentenceText(result.error(), m_context.look.units()));
    }
}

void ThermalSheets::withAuthor(Deed deed, std::function<Result<void>(const std::string&)> action) {
    m_context.withPermission(deed, [this, action = std::move(action)] { tell(action(m_context.session.author())); });
}

void ThermalSheets::openModel() {
    Sheet* sheet = open(tr("The model that is live"), {});
    QTableWidget* table = makeThermalTable(m_context.look, "thermalCard", {tr("what"), tr("value")}, sheet);
    table->horizontalHeader()->setSectionResizeMode(0, QHeaderView::ResizeToContents);
    sheet->body()->addWidget(table, 1);
    ActionButton* back = named("thermalRollBack", tr("Back to the model before"));
    back->setPredicate(
        [this] { return m_service.view().canRollBack ? QString() : tr("there is no model before this"); });
    allowOnly(back, m_context.session, Deed::ThermalModel);
    sheet->addButton(
        back,
        [this] {
            withAuthor(Deed::ThermalModel, [this](const std::string& author) { return m_service.rollBack(author); });
        },
        false);
    ActionButton* train = named("thermalTrainOpen", tr("Train a new one"));
    sheet->addButton(
        train, [this] { openTrain(); }, false);
    follow([this, table, back] {
        const ThermalModelCard& card = m_service.view().live;
        const UnitSystem& units = m_context.look.units();
        back->reconsider();
        if (card.revision == 0) {
            const bool training = m_service.view().training.state == TrainingState::Running;
            setTableRow(table, 0, {tr("model"), training ? tr("the first one is being trained") : tr("none yet")});
            return;
        }
        QStringList sensors;
        for (const std::string& name : card.sensors)
            sensors << QString::fromStdString(name);
        QStringList days;
        for (const std::string& day : card.trainedOn)
            days << QString::fromStdString(day);
        const double age_h =
            std::max(0.0, static_cast<double>(QDateTime::currentMSecsSinceEpoch() - card.createdUtc_ms) / 3'600'000.0);
        int row = 0;
        setTableRow(
            table, row++,
            {tr("model"),
             tr("%1, no. %2").arg(modelKindName(card.judgement.kind, m_context.look.wording())).arg(card.revision)});
        setTableRow(table, row++,
                    {card.judgement.heldOut ? tr("error on days left out, X / Y / Z")
                                            : tr("error on its own check rows, X / Y / Z"),
                     tr("rms %1, worst %2 %3")
                         .arg(threeText(card.judgement.rms_um, units, 2), threeText(card.judgement.worst_um, units, 1),
                              units.of("um").symbol)});
        setTableRow(table, row++,
                    {tr("live since"), tr("%1, %2 h ago, by %3")
                                           .arg(timeOf(card.createdUtc_ms), UnitSystem::fixed(age_h, 1),
                                                QString::fromStdString(card.author))});
        setTableRow(table, row++, {tr("thermocouples"), sensors.join(QStringLiteral(", "))});
        setTableRow(table, row++,
                    {tr("trained on"), tr("%1 (%2 rows)").arg(days.join(QStringLiteral(", "))).arg(card.rows)});
        for (const std::string& line : card.formula) {
            setTableRow(table, row++, {tr("formula"), QString::fromStdString(line)});
        }
        table->setRowCount(row);
    });
}

void ThermalSheets::openMeasure() {
    Sheet* sheet = open(tr("Measure the origin"), {});
    Look& look = m_context.look;
    QLabel* steps = makeLabel(TextRole::Body, sheet, true);
    steps->setObjectName(QStringLiteral("thermalSteps"));
    QTableWidget* table = makeThermalTable(
        look, "thermalGapTable",
        {tr("axis"), tr("measured"), tr("predicted"), tr("difference"), tr("verdict"), tr("left in a part")}, sheet);
    table->setMinimumHeight(4 * look.metrics().touch() * 2 / 3);
    ActionButton* byPart = named("thermalByPart", tr("By a measured part"));
    byPart->setPredicate([this]() -> QString {
        return m_status.thermal.partToMeasure ? QString() : tr("no part finished since the reference");
    });
    QObject::connect(byPart, &QPushButton::clicked, sheet, [this] { openPart(); });
    sheet->body()->addWidget(steps);
    sheet->body()->addWidget(table, 1);
    sheet->body()->addWidget(byPart);
    ActionButton* reference = named("thermalReference", tr("New reference"));
    ActionButton* session = named("thermalSession", {});
    ActionButton* adopt = named("thermalAdopt", tr("Take over"));
    ActionButton* measure = named("thermalMeasureNow", tr("Measure now"));
    measure->setPrimary(true);
    EngineClient& client = m_context.client;
    measure->setPredicate([this]() -> QString {
        const ThermalStatus& s = m_status.thermal;
        if (!s.gapsReadable) return tr("the gap sensors read nothing");
        if (!s.gapZeroKnown) return tr("take a reference first");
        return s.gap.phase == GapPhase::Measuring ? tr("being measured") : QString();
    });
    adopt->setPredicate([this]() -> QString {
        const GapMeasurement& gap = m_status.thermal.gap;
        if (m_status.thermal.learns) return tr("the model learns from every measurement by itself");
        return gap.phase == GapPhase::Done && gap.predictionKnown ? QString() : tr("measure first");
    });
    sheet->addButton(
        reference,
        [this] {
            m_context.sheets.ask(tr("Count from now on?"),
                                 tr("The machine must be as cold as it is at the start of a day, and the origin set "
                                    "anew. The shift goes "
                                    "back to zero."),
                                 tr("Leave it"), tr("Count from now on"), [this] {
                                     m_context.withPermission(Deed::ThermalReference, [this] {
                                         m_context.client.sendAction(TakeThermalReference{true});
                                     });
                                 });
        },
        false);
    sheet->addButton(
        session,
        [this] {
            withAuthor(Deed::ThermalSession, [this](const std::string& author) {
                return m_service.view().session.recording ? m_service.endSession(author)
                                                          : m_service.beginSession(author);
            });
        },
        false);
    sheet->addButton(
        adopt,
        [this, &client] {
            m_context.withPermission(Deed::ThermalReference, [&client] { client.sendAction(AdoptMeasurement{}); });
        },
        false);
    sheet->addButton(
        measure,
        [this, &client] {
            m_context.withPermission(Deed::ThermalReference, [&client] { client.sendAction(MeasureOrigin{}); });
        },
        false);
    follow([this, steps, table, byPart, reference, session, adopt, measure] {
        const ThermalStatus& s = m_status.thermal;
        const UnitSystem& units = m_context.look.units();
        const ThermalSessionView& view = m_service.view().session;
        const auto& gaps = m_service.view().gaps;
        session->setText(view.recording ? tr("End the session") : tr("Record a session"));
        for (ActionButton* button : {byPart, reference, session, adopt, measure})
            button->reconsider();
        QString text =
            tr("1. End the program. 2. Put the test bar in the spindle and move it between the three gap "
               "sensors. 3. Measure: five readings take five seconds.");
        if (view.recording) {
            text =
                tr("Recording: %n minutes measured. Let the spindle run as in a day's work; several hours make a good "
                   "day.",
                   nullptr, static_cast<int>(view.rows));
            if (!view.whyNotKept.empty()) text += u' ' + sentenceText(view.whyNotKept, units);
        } else if (s.gap.phase == GapPhase::Measuring) {
            text = tr("Measuring …");
        } else if (s.gap.phase == GapPhase::Failed) {
            text = sentenceText(s.gap.reason, units);
        } else if (s.gap.phase == GapPhase::Done && s.learns) {
            text = s.differs
                       ? tr("Measured and learnt from. Today differs from the days trained on: measure every hour.")
                       : tr("Measured and learnt from: the coefficients of today follow from the next minute on.");
        } else if (s.gap.phase == GapPhase::Done) {
            text =
                tr("Measured. If the difference is outside the interval on a machine that is warm, take it over and "
                   "train again with this state.");
        }
        steps->setText(text);
        const bool done = s.gap.phase == GapPhase::Done;
        for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
            const double difference_um = s.gap.measured_um[axis] - s.gap.predicted_um[axis];
            const bool measured = done && s.gap.known[axis];
            const bool known = measured && s.gap.predictionKnown;
            setTableRow(table, static_cast<int>(axis),
                        {QLatin1String(kThermalAxes[axis]),
                         measured ? units.withUnit(s.gap.measured_um[axis], "um", kDriftDecimals) : QStringLiteral("–"),
                         known ? units.number(s.gap.predicted_um[axis], "um", kDriftDecimals) + QStringLiteral(" ± ") +
                                     units.withUnit(s.gap.half_um[axis], "um", kDriftDecimals)
                               : QStringLiteral("–"),
                         known ? units.withUnit(difference_um, "um", kDriftDecimals) : QStringLiteral("–"),
                         !known                                           ? QStringLiteral("–")
                         : std::abs(difference_um) <= s.gap.half_um[axis] ? tr("inside the interval")
                                                                          : tr("outside the interval"),
                         measured && !gaps.empty() ? leftText(gaps.front(), axis, units) : QStringLiteral("–")});
        }
    });
}

void ThermalSheets::openHistory() {
    Sheet* sheet = open(tr("Shifts and measurements"), {});
    const QString unit = m_context.look.units().of("um").symbol;
    QTableWidget* shifts =
        makeThermalTable(m_context.look, "thermalShiftTable",
                         {tr("time"), tr("shift X / Y / Z, %1").arg(unit), tr("drift X / Y / Z")}, sheet);
    QTableWidget* gaps = makeThermalTable(
        m_context.look, "thermalGapHistory",
        {tr("time"), tr("measured X / Y / Z, %1").arg(unit), tr("predicted X / Y / Z"), tr("left in a part")}, sheet);
    shifts->setMinimumHeight(4 * m_context.look.metrics().touch());
    gaps->setMinimumHeight(3 * m_context.look.metrics().touch());
    sheet->body()->addWidget(shifts, 2);
    sheet->body()->addWidget(gaps, 1);
    follow([this, shifts, gaps] {
        const UnitSystem& units = m_context.look.units();
        int row = 0;
        for (const ThermalShiftRow& one : m_service.view().shifts) {
            if (row >= kShownRows) break;
            setTableRow(shifts, row++,
                        {timeOf(one.utc_ms), threeText(one.shift_um, units, 0),
                         threeText(one.drift_um, units, kDriftDecimals)});
        }
        if (row == 0) setTableRow(shifts, row++, {{}, tr("Each change of the shift appears here."), {}});
        shifts->setRowCount(row);
        row = 0;
        for (const ThermalGapRow& one : m_service.view().gaps) {
            if (row >= kShownRows) break;
            setTableRow(gaps, row++,
                        {one.byPart ? tr("%1, part").arg(timeOf(one.utc_ms)) : timeOf(one.utc_ms),
                         threeText(one.measured_um, units, kDriftDecimals),
                         one.predictionKnown ? threeText(one.predicted_um, units, kDriftDecimals) : QStringLiteral("–"),
                         leftText(one, units)});
        }
        if (row == 0) setTableRow(gaps, row++, {{}, tr("Each measurement of the origin appears here."), {}, {}});
        gaps->setRowCount(row);
    });
}

void ThermalSheets::openSensors() {
    Sheet* sheet = open(tr("Thermocouples"), tr("Sick ones first, then the model's own."));
    QTableWidget* table = makeThermalTable(m_context.look, "thermalSensorTable",
                                           {tr("thermocouple"), tr("temperature"), tr("state"), tr("model")}, sheet);
    sheet->body()->addWidget(table, 1);
    follow([this, table] {
        const ThermalStatus& s = m_status.thermal;
        const auto& sensors = m_service.view().sensors;
        std::vector<std::size_t> order;
        const auto rank = [&](std::size_t k) {
            return isSick(s.couple[k])                   ? 0
                   : s.couple[k] != CoupleState::Healthy ? 1
                   : (s.inModel >> k & 1U) != 0U         ? 2
                                                         : 3;
        };
        for (std::size_t k = 0; k < sensors.size() && k < s.count; ++k)
            order.push_back(k);
        std::ranges::stable_sort(order, {}, rank);
        int row = 0;
        for (const std::size_t k : order) {
            const bool read = s.couple[k] != CoupleState::Unread;
            setTableRow(table, row++,
                        {sensorText(sensors[k]),
                         read ? m_context.look.units().withUnit(static_cast<double>(s.temp_degC[k]), "degC",
                                                                kTemperatureDecimals)
                              : QStringLiteral("–"),
                         coupleStateName(s.couple[k]), (s.inModel >> k & 1U) != 0U ? tr("used") : QString()});
        }
        table->setRowCount(row);
    });
}

void ThermalSheets::openMap() {
    Sheet* sheet =
        open(tr("Error over the work space"),
             tr("From the machine's measured error elements, against the corner X0 Y0 of the table; the darker "
                "the larger. Independent of the drift with time."));
    const double middle_mm = m_service.errorMap(0.0, true).range_mm[2].second / 2.0;
    const ThermalErrorMap map = m_service.errorMap(middle_mm, true);
    if (!map.known) {
        QLabel* none = makeLabel(TextRole::Body, sheet, true);
        none->setText(tr("The error elements of this machine have not been measured."));
        sheet->body()->addWidget(none);
        return;
    }
    auto* row = new QHBoxLayout;
    const double scale_um = largestError_um(map);
    for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
        auto* one = new ErrorMap(m_context.look, axis, sheet);
        one->setMap(map, scale_um);
        row->addWidget(one, 1);
    }
    sheet->body()->addLayout(row, 1);
    const ThermalErrorMap first = m_service.errorMap(middle_mm, false);
    double apart_um = 0.0;
    for (std::size_t k = 0; k < map.error_um.size(); ++k) {
        for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
            apart_um = std::max(apart_um, std::abs(map.error_um[k][axis] - first.error_um[k][axis]));
        }
    }
    QLabel* note = makeLabel(TextRole::Dim, sheet, true);
    note->setText(tr("Exact, at Z %1; the first-order formula differs by at most %2.")
                      .arg(m_context.look.units().withUnit(middle_mm, "mm", 0),
                           m_context.look.units().withUnit(apart_um, "um", 4)));
    sheet->body()->addWidget(note);
}

void ThermalSheets::openLimits() {
    static const std::array kSpecs{
        ParamSpec{"thermal.allowed_um", KERF_TEXT("Error the part allows"), "um", 0.1, 100.0, 4.0, 1, ""},
        ParamSpec{"thermal.period_min", KERF_TEXT("Time between two shifts"), "min", 0.1, 60.0, 1.0, 1, ""},
        ParamSpec{"thermal.max_shift_um", KERF_TEXT("Largest shift"), "um", 1.0, 200.0, 100.0, 0, ""},
        ParamSpec{"thermal.max_step_um_per_min", KERF_TEXT("Largest shift in a minute"), "um", 1.0, 60.0, 15.0, 0, ""},
        ParamSpec{"thermal.warm_up_speed_rpm", KERF_TEXT("Warm-up speed"), "rpm", 100.0, 30'000.0, 3000.0, 0, ""},
        ParamSpec{"thermal.warm_up_min", KERF_TEXT("Warm-up time"), "min", 1.0, 120.0, 20.0, 0, ""}};
    static const ParamSpec kBetween{
        "thermal.between_parts", KERF_TEXT("Shift only between parts"), "", 0.0, 1.0, 0.0, 0, ""};
    static constexpr std::array kNames{"thermalAllowed", "thermalPeriod",    "thermalMaxShift",
                                       "thermalMaxStep", "thermalWarmSpeed", "thermalWarmMinutes"};
    Sheet* sheet = open(tr("Limits and warm-up"), {});
    const ThermalSetup now = m_service.view().setup;
    const std::array values{now.allowed_um,       now.period_min,      now.maxShift_um,
                            now.maxStep_umPerMin, now.warmUpSpeed_rpm, now.warmUp_min};
    std::array<ValueField*, kSpecs.size()> fields{};
    auto* grid = new QGridLayout;
    for (std::size_t i = 0; i < kSpecs.size(); ++i) {
        fields[i] = new ValueField(m_context.look, kSpecs[i], sheet);
        fields[i]->setObjectName(QLatin1String(kNames[i]));
        fields[i]->setLabel(engineText(kSpecs[i].label));
        fields[i]->setValue(values[i]);
        grid->addWidget(fields[i], static_cast<int>(i / 2), static_cast<int>(i % 2));
    }
    sheet->body()->addLayout(grid);
    auto* between = new ActionButton(m_context.look, sheet);
    between->setObjectName(QStringLiteral("thermalBetweenParts"));
    between->setCheckable(true);
    const auto name = [between] {
        between->setText(between->isChecked() ? tr("The shift moves only between parts")
                                              : tr("The shift follows while a part is cut"));
    };
    QObject::connect(between, &QPushButton::toggled, between, name);
    between->setChecked(now.betweenParts);
    name();
    sheet->body()->addWidget(between);
    auto* reason = new QLineEdit(sheet);
    reason->setObjectName(QStringLiteral("thermalLimitsReason"));
    reason->setPlaceholderText(tr("Reason for the change"));
    reason->setMinimumHeight(m_context.look.metrics().touch());
    sheet->body()->addWidget(reason);
    ActionButton* use = named("thermalLimitsUse", tr("Use"));
    allowOnly(use, m_context.session, Deed::ThermalLimits);
    const auto whyNot = [fields, reason]() -> QString {
        for (const ValueField* field : fields) {
            if (!field->value()) return field->whyInvalid();
        }
        return reason->text().trimmed().isEmpty() ? tr("give a reason") : QString();
    };
    QObject::connect(reason, &QLineEdit::textChanged, use, [use] { use->reconsider(); });
    use->setPredicate(whyNot);
    for (ValueField* field : fields)
        QObject::connect(field, &ValueField::edited, use, [use] { use->reconsider(); });
    const auto typed = [fields, between, now] {
        ThermalSetup next = now;
        next.betweenParts = between->isChecked();
        const std::array targets{&next.allowed_um,       &next.period_min,      &next.maxShift_um,
                                 &next.maxStep_umPerMin, &next.warmUpSpeed_rpm, &next.warmUp_min};
        for (std::size_t i = 0; i < targets.size(); ++i)
            *targets[i] = fields[i]->value().value_or(*targets[i]);
        return next;
    };
    const auto keep = [this, sheet = QPointer(sheet), use, typed, reason] {
        if (!sheet) return;  // closed by the question who is there
        const auto told = [context = m_context, there = QPointer(&m_context.sheets)](const Result<void>& result) {
            if (result && there) context.notify(tr("The new limits are stored and hold from now on."));
        };
        m_service.changeSetup(typed(), m_context.session.author(), reason->text().trimmed().toStdString(),
                              sheet->whenStored(use, told));
    };
    sheet->addButton(
        use, [this, keep] { m_context.withPermission(Deed::ThermalLimits, keep); }, false);
    offerRecipeSheet(
        m_context, m_service.recipes(), Deed::ThermalLimits, [](const std::string& key) -> const ParamSpec* {
            const std::string whole = "thermal." + key;
            const auto found =
                std::ranges::find_if(kSpecs, [&whole](const ParamSpec& spec) { return whole == spec.key; });
            return found != kSpecs.end() ? &*found : whole == kBetween.key ? &kBetween : nullptr;
        });
}

}  // namespace kerf::ui
