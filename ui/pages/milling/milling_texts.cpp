// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/milling/milling_texts.h"

#include <QCoreApplication>
#include <QStringList>
#include <algorithm>
#include <cmath>

namespace kerf::ui {
namespace {
struct Milling {
    Q_DECLARE_TR_FUNCTIONS(Milling)
};
}  // namespace

QString lawName(MillingLaw law) {
    switch (law) {
        case MillingLaw::Constant:
            return Milling::tr("Constant feed");
        case MillingLaw::Pi:
            return Milling::tr("PI");
        case MillingLaw::Model:
            return Milling::tr("Model");
        case MillingLaw::Preview:
            return Milling::tr("Preview");
    }
    return {};
}

QString savedText(double saved_s) {
    const QString time = UnitSystem::fixed(std::abs(saved_s), 1);
    if (std::abs(saved_s) < 0.05) {
        return Milling::tr("as long as planned");
    }
    return saved_s > 0.0 ? Milling::tr("%1 s faster than planned").arg(time)
                         : Milling::tr("%1 s slower than planned").arg(time);
}

QString cutText(const MillingCutView& view, const UnitSystem& units) {
    const MillingCut& cut = view.cut;
    QStringList parts;
    const QString saved = savedText(cut.plannedTime_s - cut.controlledTime_s);
    parts << (cut.advised ? Milling::tr("control would be %1").arg(saved) : saved);
    parts << Milling::tr("peak %1 at %2")
                 .arg(units.withUnit(cut.peakForce_N, "N", kForceDecimals), units.withUnit(cut.peakAt_mm, "mm", 1));
    if (cut.waviness_um > 0.0) {
        parts << Milling::tr("waviness %1").arg(units.withUnit(cut.waviness_um, "um", kWallDecimals));
    }
    if (cut.stops > 0) {
        parts << (cut.advised ? Milling::tr("would have been stopped") : Milling::tr("was stopped"));
    }
    const QString head = view.complete ? Milling::tr("Cut %1: %2.") : Milling::tr("Cut %1, aborted: %2.");
    return head.arg(view.number).arg(parts.join(QStringLiteral("; ")));
}

const ParamSpec* millingRecipeSpec(const MillingService& service, const std::string& key) {
    static const ParamSpec kLaw{"milling.law", KERF_TEXT("Law"), "", 0.0, 0.0, 0.0, 0, ""};
    static const ParamSpec kBlank{"blank.source", KERF_TEXT("Blank profile"), "", 0.0, 0.0, 0.0, 0, ""};
    static const ParamSpec kHeight{"blank.height_mm.", KERF_TEXT("Blank height"), "mm", 0.0, 0.0, 0.0, 3, ""};
    if (key == kLaw.key) {
        return &kLaw;
    }
    if (key == kBlank.key) {
        return &kBlank;
    }
    if (key.starts_with(kHeight.key)) {  // of one step; where they begin is only counted
        return &kHeight;
    }
    const auto fields = service.fields();
    const auto found =
        std::ranges::find_if(fields, [&key](const MillingField& field) { return key == field.spec.key; });
    return found == fields.end() ? nullptr : &found->spec;
}

QString millingRecipeWord(const std::string& key, const QString& stored) {
    if (key == "milling.law") {
        return stored == QLatin1String("constant")  ? lawName(MillingLaw::Constant)
               : stored == QLatin1String("pi")      ? lawName(MillingLaw::Pi)
               : stored == QLatin1String("model")   ? lawName(MillingLaw::Model)
               : stored == QLatin1String("preview") ? lawName(MillingLaw::Preview)
                                                    : QString();
    }
    return key == "blank.source" && stored.isEmpty() ? Milling::tr("typed", "blank profile") : QString();
}

}  // namespace kerf::ui
