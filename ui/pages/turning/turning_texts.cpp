// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/turning/turning_texts.h"

#include <QCoreApplication>
#include <QStringList>
#include <algorithm>

namespace kerf::ui {
namespace {
struct TurningTexts {
    Q_DECLARE_TR_FUNCTIONS(TurningTexts)
};
}  // namespace

QString controllerName(TurningController controller) {
    switch (controller) {
        case TurningController::Open:
            return TurningTexts::tr("Open", "turning controller");
        case TurningController::Paper:
            return TurningTexts::tr("Paper's PI", "turning controller");
        case TurningController::Pi:
            return TurningTexts::tr("Tuned PI", "turning controller");
        case TurningController::Tones:
            break;
    }
    return TurningTexts::tr("Tones", "turning controller");
}

QString stageName(TurningStage stage) {
    switch (stage) {
        case TurningStage::Air:
            return TurningTexts::tr("out of the cut");
        case TurningStage::Entry:
            return TurningTexts::tr("first revolution");
        case TurningStage::Cutting:
            return TurningTexts::tr("cutting");
        case TurningStage::Out:
            return TurningTexts::tr("out of the loop");
        case TurningStage::Idle:
            break;
    }
    return TurningTexts::tr("not cutting");
}

QString setupText(const TurningSetup& setup, const UnitSystem& units) {
    return TurningTexts::tr("%1 deep, %2, %3 per revolution, tool radius %4", "depth, speed, feed, radius")
        .arg(units.withUnit(setup.depth_um, "um", kDepthDecimals), units.withUnit(setup.spindleSpeed_rpm, "rpm", 0),
             units.withUnit(setup.feed_umPerRev, "um", kDepthDecimals), units.withUnit(setup.toolRadius_um, "um", 0));
}

QString toneList(const TurningSetup& setup) {
    QStringList tones;
    for (std::size_t j = 0; j < setup.knownToneCount; ++j) {
        tones << UnitSystem::fixed(setup.knownTones_Hz[j], kToneDecimals);
    }
    return tones.isEmpty() ? QStringLiteral("–")
                           : tones.join(QStringLiteral(", ")) + QChar(QChar::Nbsp) + QStringLiteral("Hz");
}

const ParamSpec* turningRecipeSpec(const TurningService& service, const std::string& key) {
    static const ParamSpec kLaw{"turning.law", KERF_TEXT("Law"), "", 0.0, 0.0, 0.0, 0, ""};
    if (key == kLaw.key) {
        return &kLaw;
    }
    const auto specs = service.setupSpecs();
    const auto found = std::ranges::find_if(specs, [&key](const ParamSpec& spec) { return key == spec.key; });
    return found == specs.end() ? nullptr : &*found;
}

QString turningRecipeWord(const std::string& key, const QString& stored) {
    return key != "turning.law"               ? QString()
           : stored == QLatin1String("open")  ? controllerName(TurningController::Open)
           : stored == QLatin1String("paper") ? controllerName(TurningController::Paper)
           : stored == QLatin1String("pi")    ? controllerName(TurningController::Pi)
           : stored == QLatin1String("tones") ? controllerName(TurningController::Tones)
                                              : QString();
}

}  // namespace kerf::ui
