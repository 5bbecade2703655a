// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/link/force_text.h"

#include <QCoreApplication>

namespace kerf::ui {
namespace {

struct ForceText {
    Q_DECLARE_TR_FUNCTIONS(ForceText)
};

QString zeroText(const ForceSignalView& force, const UnitSystem& units, int decimals) {
    switch (force.zero) {
        case ForceZeroState::Own:
            break;
        case ForceZeroState::Taking:
            return ForceText::tr("zero being taken");
        case ForceZeroState::Known:
            return ForceText::tr("zero %1").arg(units.withUnit(force.zero_N, "N", decimals));
        case ForceZeroState::Missed:
            return ForceText::tr("no zero");
        case ForceZeroState::Doubtful:
            return ForceText::tr("zero doubtful by %1").arg(units.withUnit(force.doubt_N, "N", decimals));
    }
    return {};
}

}  // namespace

QString forceSignalText(const ForceSignalView& force, const UnitSystem& units, int decimals) {
    if (force.signal.rate_Hz <= 0.0) {
        return {};
    }
    const double bandwidth_Hz = force.signal.bandwidth_Hz;
    const QString band =
        bandwidth_Hz > 0.0
            ? ForceText::tr("bandwidth %1").arg(units.withUnit(bandwidth_Hz, "Hz", bandwidth_Hz < 10.0 ? 1 : 0))
            : ForceText::tr("bandwidth not stated");
    const QString zero = zeroText(force, units, decimals);
    return zero.isEmpty() ? band : band + QStringLiteral(", ") + zero;
}

}  // namespace kerf::ui
