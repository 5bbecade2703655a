// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/tapping/tapping_texts.h"

#include <QCoreApplication>
#include <cmath>

#include "ui/link/texts.h"

namespace kerf::ui {
namespace {
struct TappingTexts {
    Q_DECLARE_TR_FUNCTIONS(TappingTexts)
};

QString plain(double value) {
    return QString::number(value, 'g', 6);
}
}  // namespace

QString threadText(const TapThreadView& thread) {
    if (!thread.name.starts_with('M')) {
        return QString::fromStdString(thread.name) + (thread.coarse ? QStringLiteral(" UNC") : QStringLiteral(" UNF"));
    }
    const QString name = QString::fromStdString(thread.name).section(u'x', 0, 0);
    return name + QStringLiteral("\u00a0×\u00a0") + plain(thread.pitch_mm);
}

QString choiceText(const TapChoice& choice, const TapThreadView& thread) {
    return TappingTexts::tr("%1, %2 rpm, %3 rev, gear %4", "thread, speed, depth, gear")
        .arg(threadText(thread), plain(choice.speed_rpm), plain(choice.depth_rev))
        .arg(choice.gear);
}

QString stateText(const TappingServiceView& view) {
    const auto trials = static_cast<int>(view.trials.size());
    switch (view.state) {
        case TuningState::None:
            return view.source == GainsSource::Machine ? TappingTexts::tr("not tuned") : TappingTexts::tr("tuned");
        case TuningState::AirTap:
            return TappingTexts::tr("air tap");
        case TuningState::Trial:
            return TappingTexts::tr("trial %1").arg(trials + 1);
        case TuningState::Proposed:
            return view.finished ? TappingTexts::tr("tuned, to be accepted") : TappingTexts::tr("proposal");
        case TuningState::Done:
            return view.source == GainsSource::Tuned && view.proof && !view.proof->rolledBack
                       ? TappingTexts::tr("accepted")
                       : TappingTexts::tr("rolled back");
        case TuningState::Failed:
            return TappingTexts::tr("tuning ended");
    }
    return {};
}

int decimalsFor(double value) {
    const double size = std::abs(value);
    return size >= 99.95 ? 0 : size >= 9.995 ? 1 : 2;
}

QString errorText(double error_um, const UnitSystem& units) {
    return units.withUnit(error_um, "um", decimalsFor(error_um));
}

QString sourceText(const TappingServiceView& view) {
    switch (view.source) {
        case GainsSource::Machine:
            return TappingTexts::tr("The machine's own gains: nothing is stored for this job.");
        case GainsSource::Stored:
            return TappingTexts::tr("Gains and trim of the stored tuning of this job.");
        case GainsSource::StoredGains:
            return TappingTexts::tr(
                "Gains stored for this speed range; the trim does not fit: tune before production.");
        case GainsSource::Tuned:
            return TappingTexts::tr("Gains of this tuning.");
    }
    return {};
}

QString proofText(const TappingServiceView& view, const UnitSystem& units) {
    if (!view.proof) {
        return {};
    }
    const TuningProof& proof = *view.proof;
    const auto saec = [&units](double saec_mm) { return units.number(saec_mm, "mm", decimalsFor(saec_mm)); };
    const QString figures =
        TappingTexts::tr("sum of errors %1 → %2 (−%3 %), in the work %4 → %5 p-p")
            .arg(saec(proof.first.saec_mm), units.withUnit(proof.last.saec_mm, "mm", decimalsFor(proof.last.saec_mm)),
                 QString::number(100.0 * proof.reduction(), 'f', 1), errorText(proof.first.engagedPp_um, units),
                 errorText(proof.last.engagedPp_um, units));
    const QString author = QString::fromStdString(proof.author);
    return proof.rolledBack ? TappingTexts::tr("Rolled back by %1; the tuning had: %2.").arg(author, figures)
                            : TappingTexts::tr("Before and after, accepted by %1: %2.").arg(author, figures);
}

}  // namespace kerf::ui
