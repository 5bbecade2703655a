// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/dialogs/limits_sheet.h"

#include <QComboBox>
#include <QCoreApplication>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QPointer>
#include <QTimer>
#include <algorithm>

#include "engine/api/part_results.h"
#include "ui/dialogs/sheet.h"
#include "ui/link/texts.h"
#include "ui/services/quality_service.h"
#include "ui/shell/page.h"
#include "ui/theme/look.h"
#include "ui/widgets/label.h"

namespace kerf::ui {
namespace {

struct FigureLimits {
    Q_DECLARE_TR_FUNCTIONS(FigureLimits)
};

/// Empty text: no limit. False: no number.
bool takeLimit(const QString& text, std::optional<double>& limit) {
    limit.reset();
    const QString plain = text.trimmed().replace(u',', u'.');
    if (plain.isEmpty()) {
        return true;
    }
    bool good = false;
    limit = QLocale::c().toDouble(plain, &good);
    return good;
}

QString limitText(const std::optional<double>& limit) {
    return limit ? QLocale::c().toString(*limit, 'g', 12) : QString();
}

QLineEdit* addField(Sheet* sheet, const char* name) {
    auto* field = new QLineEdit(sheet);
    field->setObjectName(QLatin1String(name));
    return field;
}

}  // namespace

void openLimitsSheet(const PageContext& context, ProcessId process) {
    QualityService* service = context.services.qualityService;
    if (service == nullptr) {
        return;
    }
    const QString type = QString::fromStdString(service->limitsPartType(process));
    Sheet* sheet = context.sheets.openOver(
        type.isEmpty() ? FigureLimits::tr("Limits: %1").arg(processName(process))
                       : FigureLimits::tr("Limits in the recipe of %1 (%2)").arg(type, processName(process)),
        FigureLimits::tr("A figure outside its limits makes the part scrap. In the stored unit; an empty field is no "
                         "limit. They hold for the parts to come: a part keeps the limits it was made under."));
    auto* form = new QFormLayout;
    auto* figure = new QComboBox(sheet);
    figure->setObjectName(QStringLiteral("limitFigure"));
    auto* lower = addField(sheet, "limitLower");
    auto* upper = addField(sheet, "limitUpper");
    auto* reason = addField(sheet, "limitReason");
    auto* why = makeLabel(TextRole::Body, sheet, true);
    why->setObjectName(QStringLiteral("limitWhy"));
    for (const auto& [spec, read] : partResultRows(process)) {
        QString label = engineText(spec.label);
        if (spec.unit[0] != '\0') {
            label += QStringLiteral(" [%1]").arg(QString::fromUtf8(spec.unit));
        }
        figure->addItem(label, QString::fromLatin1(spec.key));
    }
    form->addRow(FigureLimits::tr("Figure"), figure);
    form->addRow(FigureLimits::tr("Lower limit"), lower);
    form->addRow(FigureLimits::tr("Upper limit"), upper);
    form->addRow(FigureLimits::tr("Reason for the change"), reason);
    sheet->body()->addLayout(form);
    sheet->body()->addWidget(why);
    const auto show = [service, process, figure, lower, upper] {
        const std::vector<FigureLimit> limits = service->limits(process);
        const auto found = std::ranges::find(limits, figure->currentData().toString().toStdString(), &FigureLimit::key);
        lower->setText(found == limits.end() ? QString() : limitText(found->tolerance.lower));
        upper->setText(found == limits.end() ? QString() : limitText(found->tolerance.upper));
    };
    QObject::connect(figure, &QComboBox::currentIndexChanged, sheet, show);
    show();
    sheet->addButton(FigureLimits::tr("Close"), {})->setObjectName(QStringLiteral("sheetSafe"));
    const auto save = [context, service, process, figure, lower, upper, reason, why] {
        FigureLimit limit{figure->currentData().toString().toStdString(), {}};
        if (!takeLimit(lower->text(), limit.tolerance.lower) || !takeLimit(upper->text(), limit.tolerance.upper)) {
            why->setText(FigureLimits::tr("A limit is a number, or empty."));
            return;
        }
        std::vector<FigureLimit> limits = service->limits(process);
        const auto found = std::ranges::find(limits, limit.key, &FigureLimit::key);
        if (found == limits.end()) {
            limits.push_back(limit);
        } else {
            limit.tolerance.rework = found->tolerance.rework;
            found->tolerance = limit.tolerance;
        }
        std::erase_if(limits, [](const FigureLimit& one) { return !one.tolerance.given(); });
        const std::string words = reason->text().trimmed().toStdString();
        context.withPermission(
            Deed::QualityLimits, [context, service, process, limits, words, why = QPointer<QLabel>(why),
                                  reason = QPointer<QLineEdit>(reason)] {
                service->setLimits(process, limits, context.session.author(), words,
                                   [context, why, reason](const Result<void>& stored) {
                                       if (stored && reason) {
                                           reason->clear();
                                       }
                                       if (why) {
                                           why->setText(stored ? FigureLimits::tr("The limits stand in the recipe and "
                                                                                  "hold for the parts to come.")
                                                               : sentenceText(stored.error(), context.look.units()));
                                       }
                                   });
            });
    };
    sheet->addButton(FigureLimits::tr("Save"), save, false)->setObjectName(QStringLiteral("limitSave"));
    QTimer::singleShot(0, figure, qOverload<>(&QWidget::setFocus));
}

void offerLimitsSheet(const PageContext& context, ProcessId process) {
    Sheet* sheet = context.sheets.current();
    if (context.services.qualityService == nullptr || sheet == nullptr) {
        return;
    }
    sheet
        ->addButton(
            FigureLimits::tr("Limits of the parts"), [context, process] { openLimitsSheet(context, process); }, false)
        ->setObjectName(QStringLiteral("recipeLimits"));
}

}  // namespace kerf::ui
