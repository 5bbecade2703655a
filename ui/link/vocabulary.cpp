// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/link/vocabulary.h"

#include <QCoreApplication>
#include <array>

namespace kerf::ui {
namespace {

struct Names {
    const char* shop;
    const char* symbols;
};

constexpr const char* kContext = "Vocabulary";

// In the order of Term. The hat is a combining character: Noto Sans sets it over the letter.
constexpr std::array<Names, static_cast<std::size_t>(Term::Count)> kNames{{
    {QT_TRANSLATE_NOOP("Vocabulary", "How the bar bends"), QT_TRANSLATE_NOOP("Vocabulary", "Estimated law")},
    {QT_TRANSLATE_NOOP("Vocabulary", "by feed"), "α\u0302"},
    {QT_TRANSLATE_NOOP("Vocabulary", "by overhang"), "β\u0302"},
    {QT_TRANSLATE_NOOP("Vocabulary", "as a whole"), "C\u0302"},

    {QT_TRANSLATE_NOOP("Vocabulary", "Tool: how hard it cuts, per part"),
     QT_TRANSLATE_NOOP("Vocabulary", "Tool: mean ln(C·b) per part")},
    {QT_TRANSLATE_NOOP("Vocabulary", "how hard it cuts"), "ln(C·b)"},
    {QT_TRANSLATE_NOOP("Vocabulary", "how hard it cuts now"), QT_TRANSLATE_NOOP("Vocabulary", "ln(C·b) now")},
    {QT_TRANSLATE_NOOP("Vocabulary", "tool stiffness"), "k_x"},
    {QT_TRANSLATE_NOOP("Vocabulary", "reserve before it swings, times"),
     QT_TRANSLATE_NOOP("Vocabulary", "gain margin, times")},

    {QT_TRANSLATE_NOOP("Vocabulary", "unevenness, on average"), QT_TRANSLATE_NOOP("Vocabulary", "RMS")},
    {QT_TRANSLATE_NOOP("Vocabulary", "highest to lowest point"),
     QT_TRANSLATE_NOOP("Vocabulary", "P-V of a revolution")},
    {QT_TRANSLATE_NOOP("Vocabulary", "unevenness without the trim"),
     QT_TRANSLATE_NOOP("Vocabulary", "RMS without the trim")},
    {QT_TRANSLATE_NOOP("Vocabulary", "Reserves and trim"), QT_TRANSLATE_NOOP("Vocabulary", "Loop margins and trim")},
    {QT_TRANSLATE_NOOP("Vocabulary", "may be stronger, times"), QT_TRANSLATE_NOOP("Vocabulary", "gain, times")},
    {QT_TRANSLATE_NOOP("Vocabulary", "may be shifted by"), QT_TRANSLATE_NOOP("Vocabulary", "phase")},
    {QT_TRANSLATE_NOOP("Vocabulary", "may come later by"), QT_TRANSLATE_NOOP("Vocabulary", "more delay")},
    {QT_TRANSLATE_NOOP("Vocabulary", "distance from ringing"), QT_TRANSLATE_NOOP("Vocabulary", "smallest |1 + L|")},
    {QT_TRANSLATE_NOOP("Vocabulary", "share of the last force"), "a₁"},
    {QT_TRANSLATE_NOOP("Vocabulary", "force of the depth now"), "b₀"},
    {QT_TRANSLATE_NOOP("Vocabulary", "force of the depth before"), "b₁"},
    {QT_TRANSLATE_NOOP("Vocabulary", "doubt, log"), QT_TRANSLATE_NOOP("Vocabulary", "covariance, log")},

    {QT_TRANSLATE_NOOP("Vocabulary", "Drift of the origin, predicted"),
     QT_TRANSLATE_NOOP("Vocabulary", "Drift δ\u0302 of the origin, ± 1.96 σ")},
    {"%1", "δ\u0302 %1"},
    {QT_TRANSLATE_NOOP("Vocabulary", "drift"), "δ"},
    {QT_TRANSLATE_NOOP("Vocabulary", "line: predicted, band: 95 % interval, dots: measured"),
     QT_TRANSLATE_NOOP("Vocabulary", "line: δ\u0302, band: ± 1.96 σ, dots: δ measured")},
    {QT_TRANSLATE_NOOP("Vocabulary", "a few thermocouples, straight lines"),
     QT_TRANSLATE_NOOP("Vocabulary", "regression on few sensors")},
    {QT_TRANSLATE_NOOP("Vocabulary", "all days together, and today"),
     QT_TRANSLATE_NOOP("Vocabulary", "hierarchical over days")},
    {QT_TRANSLATE_NOOP("Vocabulary", "network of thermocouples"), QT_TRANSLATE_NOOP("Vocabulary", "network, guarded")},
    {QT_TRANSLATE_NOOP("Vocabulary", "network, as first published"),
     QT_TRANSLATE_NOOP("Vocabulary", "network, as printed")},

    {QT_TRANSLATE_NOOP("Vocabulary", "How spindle and Z are matched"), QT_TRANSLATE_NOOP("Vocabulary", "Gains")},
    {QT_TRANSLATE_NOOP("Vocabulary", "spindle, how firm, 1/s"), QT_TRANSLATE_NOOP("Vocabulary", "spindle Kp, 1/s")},
    {QT_TRANSLATE_NOOP("Vocabulary", "Z, how firm, 1/s"), QT_TRANSLATE_NOOP("Vocabulary", "Z Kp, 1/s")},
    {QT_TRANSLATE_NOOP("Vocabulary", "Z, ahead with speed"), QT_TRANSLATE_NOOP("Vocabulary", "Z speed FF")},
    {QT_TRANSLATE_NOOP("Vocabulary", "Z, ahead with accel."), QT_TRANSLATE_NOOP("Vocabulary", "Z accel. FF")},
    {QT_TRANSLATE_NOOP("Vocabulary", "How far Z is off the thread, %1, over spindle revolutions in and out"),
     QT_TRANSLATE_NOOP("Vocabulary", "Contour error E_r, %1, over spindle revolutions in and out")},
    {QT_TRANSLATE_NOOP("Vocabulary", "errors added up, %1"), QT_TRANSLATE_NOOP("Vocabulary", "SAEC = Σ |E_r|, %1")},
    {QT_TRANSLATE_NOOP("Vocabulary", "widest error in the work, %1"),
     QT_TRANSLATE_NOOP("Vocabulary", "E_r p-p in the work, %1")},
}};

}  // namespace

QString termText(Term term, Wording wording) {
    const Names& names = kNames[static_cast<std::size_t>(term)];
    return QCoreApplication::translate(kContext, wording == Wording::Symbols ? names.symbols : names.shop);
}

}  // namespace kerf::ui
