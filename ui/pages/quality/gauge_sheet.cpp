// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/quality/gauge_sheet.h"

#include <QDate>
#include <QDateTime>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QTimer>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>

#include "ui/dialogs/sheet.h"
#include "ui/link/texts.h"
#include "ui/services/boring_lots.h"
#include "ui/theme/particles.h"
#include "ui/widgets/label.h"

namespace kerf::ui {
namespace {

constexpr std::uint32_t kTypeOneReadings = 25;
constexpr std::uint32_t kStudyParts = 10;
constexpr std::uint32_t kStudyPersons = 3;
constexpr std::uint32_t kStudyTrials = 2;
constexpr int kDecimals = 4;

std::optional<double> numberOf(const QString& text) {
    bool good = false;
    const double value = QLocale::c().toDouble(text.trimmed().replace(u',', u'.'), &good);
    return good ? std::optional(value) : std::nullopt;
}

/// Once it is laid out: what is not visible yet takes no focus, and a gauge's keys would go nowhere.
void focusOn(QWidget* field) {
    QTimer::singleShot(0, field, qOverload<>(&QWidget::setFocus));
}

QLineEdit* field(QFormLayout* form, const QString& label, const char* name, const QString& text) {
    auto* edit = new QLineEdit(text);
    edit->setObjectName(QLatin1String(name));
    form->addRow(label, edit);
    return edit;
}

}  // namespace

QString studyText(const Gauge& gauge, const UnitSystem& units) {
    if (!gauge.sigma_mm) {
        return GaugeSheets::tr("no study yet");
    }
    return GaugeSheets::tr("σ %1 (%2 to %3), from a study: %4", "repeatability with its interval, judgement")
        .arg(units.withUnit(*gauge.sigma_mm, "mm", kDecimals), units.number(gauge.sigmaLow_mm, "mm", kDecimals),
             units.number(gauge.sigmaHigh_mm, "mm", kDecimals),
             gauge.pass ? GaugeSheets::tr("good enough") : GaugeSheets::tr("not good enough"));
}

QString studyFigures(const Gauge& gauge, const UnitSystem& units) {
    if (!gauge.study) {
        return {};
    }
    const StudyFigures& study = *gauge.study;
    const QString tolerance = units.withUnit(study.tolerance_mm, "mm", 3);
    QString text;
    if (study.cg) {
        text = study.cgk ? GaugeSheets::tr("Study with one ring, n %1, tolerance %2: Cg %3, Cgk %4")
                               .arg(study.readings)
                               .arg(tolerance, UnitSystem::fixed(*study.cg, 2), UnitSystem::fixed(*study.cgk, 2))
                         : GaugeSheets::tr("Study with one ring, n %1, tolerance %2: Cg %3")
                               .arg(study.readings)
                               .arg(tolerance, UnitSystem::fixed(*study.cg, 2));
    } else {
        text = GaugeSheets::tr(
                   "Study with parts and persons, n %1: GRR %2 % of the spread of the parts, %3 % of the "
                   "tolerance %4, %5 categories")
                   .arg(study.readings)
                   .arg(UnitSystem::fixed(study.grr_percent.value_or(0.0), 1),
                        UnitSystem::fixed(study.grrOfTolerance_percent.value_or(0.0), 1), tolerance)
                   .arg(study.ndc);
    }
    return text + QStringLiteral(" · ") +
           QDateTime::fromMSecsSinceEpoch(study.utc_ms).toString(QStringLiteral("yyyy-MM-dd")) + QStringLiteral(", ") +
           QString::fromStdString(study.author);
}

bool isOverdue(const Gauge& gauge, std::int64_t nowUtc_ms) {
    return gauge.dueUtc_ms > 0 && nowUtc_ms > gauge.dueUtc_ms;
}

QString dueText(const Gauge& gauge, std::int64_t nowUtc_ms) {
    if (gauge.dueUtc_ms <= 0) {
        return GaugeSheets::tr("no due date");
    }
    const QString day = QDateTime::fromMSecsSinceEpoch(gauge.dueUtc_ms).toString(QStringLiteral("yyyy-MM-dd"));
    return isOverdue(gauge, nowUtc_ms) ? GaugeSheets::tr("overdue since %1").arg(day)
                                       : GaugeSheets::tr("due on %1").arg(day);
}

GaugeSheets::GaugeSheets(const PageContext& context, QualityService& service, QObject* parent)
    : QObject(parent), m_context(context), m_service(service) {}

void GaugeSheets::openRegister() {
    Sheet* sheet = m_context.sheets.open(tr("Gauges"), tr("Choose a gauge, or enter a new one."));
    sheet->setWide();
    const std::int64_t now_ms = QDateTime::currentMSecsSinceEpoch();
    auto* list = new QWidget(sheet);
    list->setObjectName(QStringLiteral("gaugeList"));
    auto* rows = new QVBoxLayout(list);
    for (const Gauge& gauge : m_service.gauges()) {
        const QString sigma = studyText(gauge, m_context.look.units());
        auto* button = new QPushButton(QString::fromStdString(gauge.identity) + QStringLiteral(" · ") +
                                           dueText(gauge, now_ms) + QStringLiteral(" · ") + sigma,
                                       list);
        button->setObjectName(QStringLiteral("gauge_") + QString::fromStdString(gauge.identity));
        connect(button, &QPushButton::clicked, this, [this, gauge] { openGauge(gauge); });
        rows->addWidget(button);
    }
    rows->addStretch();
    sheet->body()->addWidget(list);
    sheet->addButton(tr("Close"), {})->setObjectName(QStringLiteral("sheetSafe"));
    sheet
        ->addButton(
            tr("New gauge"), [this] { openGauge({}); }, false)
        ->setObjectName(QStringLiteral("gaugeNew"));
}

void GaugeSheets::openGauge(const Gauge& gauge) {
    const bool fresh = gauge.identity.empty();
    Sheet* sheet = m_context.sheets.open(fresh ? tr("New gauge") : QString::fromStdString(gauge.identity),
                                         tr("Lengths in mm; the due date as 2026-12-31."));
    auto* form = new QFormLayout;
    auto* identity = field(form, tr("Identity"), "gaugeIdentity", QString::fromStdString(gauge.identity));
    identity->setEnabled(fresh);
    auto* from = field(form, tr("Range from"), "gaugeFrom", UnitSystem::fixed(gauge.rangeFrom_mm, 3));
    auto* to = field(form, tr("Range to"), "gaugeTo", UnitSystem::fixed(gauge.rangeTo_mm, 3));
    auto* resolution =
        field(form, tr("Resolution"), "gaugeResolution", UnitSystem::fixed(gauge.resolution_mm, kDecimals));
    auto* ring = field(form, tr("Setting ring"), "gaugeRing", UnitSystem::fixed(gauge.ring_mm, kDecimals));
    auto* due = field(form, tr("Due date"), "gaugeDue",
                      gauge.dueUtc_ms > 0
                          ? QDateTime::fromMSecsSinceEpoch(gauge.dueUtc_ms).toString(QStringLiteral("yyyy-MM-dd"))
                          : QString());
    sheet->body()->addLayout(form);
    if (gauge.sigma_mm) {
        const UnitSystem& units = m_context.look.units();
        auto* found = makeLabel(TextRole::Body, sheet, true);
        found->setObjectName(QStringLiteral("gaugeStudy"));
        QStringList lines{studyText(gauge, units), studyFigures(gauge, units)};
        lines.removeAll(QString());
        found->setText(lines.join(u'\n'));
        sheet->body()->addWidget(found);
    }
    auto* why = makeLabel(TextRole::Body, sheet, true);
    why->setObjectName(QStringLiteral("gaugeWhy"));
    sheet->body()->addWidget(why);
    sheet->addButton(tr("Cancel"), {})->setObjectName(QStringLiteral("sheetSafe"));
    if (!fresh) {
        sheet
            ->addButton(
                tr("Study with one ring"),
                [this, gauge] {
                    m_context.withPermission(Deed::QualityStudy, [this, gauge] { openStudy(gauge, false); });
                },
                false)
            ->setObjectName(QStringLiteral("studyTypeOne"));
        sheet
            ->addButton(
                tr("Study with parts and persons"),
                [this, gauge] {
                    m_context.withPermission(Deed::QualityStudy, [this, gauge] { openStudy(gauge, true); });
                },
                false)
            ->setObjectName(QStringLiteral("studyCrossed"));
    }
    if (gauge.sigma_mm && m_context.services.boringLots != nullptr) {
        sheet
            ->addButton(
                tr("Use σ for the lots to come"),
                [this, gauge, why = QPointer<QLabel>(why)] {
                    m_context.withRole(Role::Engineer, [this, gauge, why] { useInRecipe(gauge, why); });
                },
                false)
            ->setObjectName(QStringLiteral("gaugeUse"));
    }
    const QPointer<Sheet> open = sheet;
    const auto save = [this, gauge, identity, from, to, resolution, ring, due, why, open] {
        Gauge changed = gauge;
        changed.identity = identity->text().simplified().toStdString();
        const QDate day = QDate::fromString(due->text().trimmed(), QStringLiteral("yyyy-MM-dd"));
        const auto first = numberOf(from->text());
        const auto last = numberOf(to->text());
        const auto step = numberOf(resolution->text());
        const auto size = numberOf(ring->text());
        if (!first || !last || !step || !size || (!due->text().trimmed().isEmpty() && !day.isValid())) {
            why->setText(tr("Numbers and a date as 2026-12-31 are needed."));
            return;
        }
        changed.rangeFrom_mm = *first;
        changed.rangeTo_mm = *last;
        changed.resolution_mm = *step;
        changed.ring_mm = *size;
        changed.dueUtc_ms = day.isValid() ? day.endOfDay().toMSecsSinceEpoch() : 0;
        m_context.withPermission(Deed::QualityGauge, [this, changed, why = QPointer<QLabel>(why), open] {
            if (open) open->sent();
            m_service.saveGauge(changed, m_context.session.name().toStdString(),
                                [this, why, open](const Result<void>& done) {
                                    if (!done && why) {
                                        why->setText(sentenceText(done.error(), m_context.look.units()));
                                    } else if (done && m_context.sheets.isOpen(open) && open->taken()) {
                                        openRegister();
                                    }
                                });
        });
    };
    QPushButton* accept = sheet->addButton(tr("Save"), save, false);
    accept->setObjectName(QStringLiteral("gaugeSave"));
    focusOn(fresh ? identity : from);
}

// The recipe of the part type that is being bored gets a new revision: σ of a deflection is that of the diameter over
// 2 cos φ (eq. 11).
void GaugeSheets::useInRecipe(const Gauge& gauge, const QPointer<QLabel>& why) {
    BoringLots& lots = *m_context.services.boringLots;
    const auto all = lots.lots();
    const auto current = all ? std::ranges::find_if(*all, &BoringLotView::current) : decltype(all->begin()){};
    const auto recipes =
        all && current != all->end() ? lots.recipes(current->partType) : Result<std::vector<BoringRecipeView>>{};
    const auto say = [why](const QString& text) {
        if (why) {
            why->setText(text);
        }
    };
    if (!recipes || recipes->empty()) {
        say(tr("No lot is open, so there is no recipe to take it."));
        return;
    }
    BoringRecipeForm form = recipes->front().form;
    const auto specs = lots.recipeSpecs();
    const auto valueOf = [&](std::string_view key) -> double* {
        const auto found = std::ranges::find_if(specs, [&](const ParamSpec& spec) { return spec.key == key; });
        return found == specs.end() ? nullptr : &form.values[static_cast<std::size_t>(found - specs.begin())];
    };
    double* sigma_mm = valueOf("boring.sigma_mm");
    const double* phi_deg = valueOf("boring.phi_deg");
    if (sigma_mm == nullptr || phi_deg == nullptr) {
        return;
    }
    *sigma_mm = *gauge.sigma_mm / (2.0 * std::cos(*phi_deg * std::numbers::pi / 180.0));
    lots.saveRecipe(current->partType, form, m_context.session.name().toStdString(),
                    "repeatability of gauge " + gauge.identity + ", study " + gauge.sigmaFrom,
                    [this, say](const Result<void>& done) {
                        say(done ? tr("Stored as a new revision of the recipe: it holds for the next lot.")
                                 : sentenceText(done.error(), m_context.look.units()));
                    });
}

QString GaugeSheets::promptFor(const GaugeStudyRecord& study, const Plan& plan, bool crossed) const {
    const std::size_t at = study.readings.size();
    if (at >= plan.readings()) {
        return tr("All %1 readings are there. Save the study.").arg(at);
    }
    if (!crossed) {
        return tr("Reading %1 of %2 of the ring").arg(at + 1).arg(plan.readings());
    }
    return tr("Person %1, trial %2: part %3")
        .arg(at / plan.parts / plan.trials + 1)
        .arg(at / plan.parts % plan.trials + 1)
        .arg(at % plan.parts + 1);
}

void GaugeSheets::openStudy(const Gauge& gauge, bool crossed) {
    const Plan plan = crossed ? Plan{kStudyParts, kStudyPersons, kStudyTrials} : Plan{1, 1, kTypeOneReadings};
    Sheet* sheet = m_context.sheets.open(
        crossed ? tr("Study with parts and persons") : tr("Study with one ring"),
        crossed ? tr("10 parts, 3 persons, 2 trials each. The person changes when all parts have been read twice.")
                : tr("25 readings of the setting ring, taken out and put back each time."));
    auto study = std::make_shared<GaugeStudyRecord>();
    study->gauge = gauge.identity;
    study->method = crossed ? "anova" : "type1";
    auto* form = new QFormLayout;
    auto* tolerance = field(form, tr("Width of the tolerance, mm"), "studyTolerance", QStringLiteral("0.030"));
    auto* reading = field(form, tr("Reading, mm"), "studyReading", QString());
    reading->setProperty("takesReadings", true);  // a gauge's frame is meant for this field, not for a bore
    auto* prompt = makeLabel(TextRole::Title, sheet, true);
    prompt->setObjectName(QStringLiteral("studyPrompt"));
    sheet->body()->addWidget(prompt);
    sheet->body()->addLayout(form);
    prompt->setText(promptFor(*study, plan, crossed));
    connect(reading, &QLineEdit::returnPressed, sheet, [this, study, plan, crossed, reading, prompt, gauge] {
        const auto value = numberOf(reading->text());
        const bool inRange = value && *value >= gauge.rangeFrom_mm && *value <= gauge.rangeTo_mm;
        if (!inRange) {
            prompt->setText(
                withParticles(tr("“%1” does not lie in the range of the gauge. Read again.").arg(reading->text())));
        } else if (study->readings.size() < plan.readings()) {
            const auto at = static_cast<std::uint32_t>(study->readings.size());
            study->readings.push_back(crossed ? quality::StudyReading{at % plan.parts, at / plan.parts / plan.trials,
                                                                      at / plan.parts % plan.trials, *value}
                                              : quality::StudyReading{0, 0, at, *value});
            prompt->setText(promptFor(*study, plan, crossed));
        }
        reading->clear();
    });
    sheet->addButton(tr("Cancel"), {})->setObjectName(QStringLiteral("sheetSafe"));
    sheet
        ->addButton(
            tr("Take back the last reading"),
            [this, study, plan, crossed, prompt, reading] {
                if (!study->readings.empty()) {
                    study->readings.pop_back();
                }
                prompt->setText(promptFor(*study, plan, crossed));
                reading->setFocus();
            },
            false)
        ->setObjectName(QStringLiteral("studyUndo"));
    const QPointer<Sheet> open = sheet;
    sheet
        ->addButton(
            tr("Save the study"),
            [this, study, plan, tolerance, prompt = QPointer<QLabel>(prompt), open] {
                const auto width = numberOf(tolerance->text());
                if (study->readings.size() < plan.readings() || !width) {
                    prompt->setText(tr("%1 of %2 readings are there; the tolerance must be a number.")
                                        .arg(study->readings.size())
                                        .arg(plan.readings()));
                    return;
                }
                study->tolerance_mm = *width;
                if (open) open->sent();
                m_service.saveStudy(*study, m_context.session.name().toStdString(),
                                    [this, prompt, open](const Result<void>& done) {
                                        if (!done && prompt) {
                                            prompt->setText(sentenceText(done.error(), m_context.look.units()));
                                        } else if (done && m_context.sheets.isOpen(open) && open->taken()) {
                                            openRegister();
                                        }
                                    });
            },
            false)
        ->setObjectName(QStringLiteral("studySave"));
    focusOn(reading);
}

}  // namespace kerf::ui
