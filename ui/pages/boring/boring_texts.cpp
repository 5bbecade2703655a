// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/boring/boring_texts.h"

#include <QCoreApplication>
#include <algorithm>

namespace kerf::ui {
namespace {
struct BoringTexts {
    Q_DECLARE_TR_FUNCTIONS(BoringTexts)
};
}  // namespace

QString depthName(const DepthView& depth) {
    if (depth.name == "top") {
        return BoringTexts::tr("top", "depth of a bore");
    }
    if (depth.name == "middle") {
        return BoringTexts::tr("middle", "depth of a bore");
    }
    if (depth.name == "bottom") {
        return BoringTexts::tr("bottom", "depth of a bore");
    }
    return QString::fromStdString(depth.name);
}

QString changeName(BoringChange change) {
    switch (change) {
        case BoringChange::Reground:
            return BoringTexts::tr("Tool reground");
        case BoringChange::Material:
            return BoringTexts::tr("Other material");
        case BoringChange::Insert:
            break;
    }
    return BoringTexts::tr("New insert");
}

QString placeName(std::uint32_t partNumber, const DepthView& depth) {
    return BoringTexts::tr("part %1, %2", "part number, depth of its bore").arg(partNumber).arg(depthName(depth));
}

QString diameterText(double diameter_mm, const UnitSystem& units) {
    return units.withUnit(diameter_mm, "mm", kDiameterDecimals);
}

quality::Verdict boreVerdict(const BoringServiceView& view, double diameter_mm) {
    if (!(view.lowerTolerance_mm < view.upperTolerance_mm)) {
        return quality::Verdict::NotJudged;
    }
    return quality::judge(diameter_mm, {view.lowerTolerance_mm, view.upperTolerance_mm, quality::ReworkSide::Below});
}

QString outOfToleranceText(const BoringServiceView& view, double diameter_mm, const UnitSystem& units) {
    const quality::Verdict verdict = boreVerdict(view, diameter_mm);
    if (!isBad(verdict)) {
        return {};
    }
    return diameter_mm < view.lowerTolerance_mm
               ? BoringTexts::tr("Below %1: %2.").arg(diameterText(view.lowerTolerance_mm, units), verdictText(verdict))
               : BoringTexts::tr("Above %1: %2.")
                     .arg(diameterText(view.upperTolerance_mm, units), verdictText(verdict));
}

const BoreMeasurementView* measurementAt(const BorePartView& part, std::uint8_t depth) {
    const auto found = std::find_if(part.measurements.rbegin(), part.measurements.rend(),
                                    [depth](const BoreMeasurementView& m) { return m.depth == depth && !m.voided; });
    return found == part.measurements.rend() ? nullptr : &*found;
}

const BorePartView* findPart(const BoringServiceView& view, PartId id) {
    const auto found = std::find_if(view.parts.begin(), view.parts.end(), [id](const auto& p) { return p.id == id; });
    return found == view.parts.end() ? nullptr : &*found;
}

LastMeasurement lastMeasurement(const BoringServiceView& view) {
    LastMeasurement last;
    for (const BorePartView& part : view.parts) {
        for (const BoreMeasurementView& measurement : part.measurements) {
            if (!measurement.voided && (last.measurement == nullptr || measurement.id > last.measurement->id)) {
                last = {&part, &measurement};
            }
        }
    }
    return last;
}

}  // namespace kerf::ui
