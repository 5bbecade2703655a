// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/link/shift_texts.h"

#include <QCoreApplication>
#include <QHash>
#include <QStringList>
#include <cmath>

namespace kerf::ui {
namespace {

struct Shift {
    Q_DECLARE_TR_FUNCTIONS(Shift)
};

constexpr qsizetype kLongestValue = 40;

QString shortened(const std::string& text) {
    const QString whole = QString::fromStdString(text);
    return whole.size() > kLongestValue ? whole.left(kLongestValue) + QStringLiteral("…") : whole;
}

}  // namespace

const std::vector<std::string>& stopReasons() {
    static const std::vector<std::string> kReasons{"setup", "tool",    "material", "gauge", "fault",
                                                   "clean", "no_work", "people",   "other"};
    return kReasons;
}

QString stopReasonText(const std::string& key) {
    if (key.empty()) {
        return Shift::tr("no reason given yet");
    }
    const QHash<QString, QString> words{{QStringLiteral("setup"), Shift::tr("Setting up")},
                                        {QStringLiteral("tool"), Shift::tr("Tool change")},
                                        {QStringLiteral("material"), Shift::tr("No material")},
                                        {QStringLiteral("gauge"), Shift::tr("Measuring")},
                                        {QStringLiteral("fault"), Shift::tr("Fault, repair")},
                                        {QStringLiteral("clean"), Shift::tr("Cleaning, chips")},
                                        {QStringLiteral("no_work"), Shift::tr("No order")},
                                        {QStringLiteral("people"), Shift::tr("Break, nobody there")},
                                        {QStringLiteral("other"), Shift::tr("Something else")}};
    const QString text = QString::fromStdString(key);
    return words.value(text, text);
}

QString shiftPartsText(const ShiftParts& parts) {
    QStringList words{Shift::tr("%1 made").arg(parts.made), Shift::tr("%1 good").arg(parts.good)};
    if (parts.rework > 0) {
        words << Shift::tr("%1 rework").arg(parts.rework);
    }
    if (parts.scrap > 0) {
        words << Shift::tr("%1 scrap").arg(parts.scrap);
    }
    if (parts.notJudged > 0) {
        words << Shift::tr("%1 not judged").arg(parts.notJudged);
    }
    if (parts.aborted > 0) {
        words << Shift::tr("%1 broken off").arg(parts.aborted);
    }
    words << Shift::tr("%1 min in the cut").arg(std::lround(parts.cutting_s / 60.0));
    return words.join(QStringLiteral(" · "));
}

QString shiftSavingText(const ShiftSaving& saving) {
    QStringList words;
    if (saving.cuts > 0) {
        words << Shift::tr("%1 min saved in %n milled parts against the planned feed.", nullptr,
                           static_cast<int>(saving.cuts))
                     .arg(saving.saved_s / 60.0, 0, 'f', 1);
    }
    if (saving.bores > 0) {
        words << Shift::tr(
                     "%1 of %n bores are inside the tolerance that the recipe's first feed would have put outside.",
                     nullptr, static_cast<int>(saving.bores))
                     .arg(saving.partsKept);
    }
    return words.isEmpty() ? Shift::tr("What the loops have saved is computed from milled parts and measured bores.")
                           : words.join(QStringLiteral(" "));
}

QString changeText(const ShiftChange& change) {
    QStringList words{QString::fromStdString(change.action)};
    if (!change.object.empty()) {
        words << QString::fromStdString(change.object);
    }
    if (!change.newValue.empty()) {
        words << (change.oldValue.empty()
                      ? shortened(change.newValue)
                      : shortened(change.oldValue) + QStringLiteral(" → ") + shortened(change.newValue));
    }
    if (!change.reason.empty()) {
        words << QStringLiteral("(%1)").arg(QString::fromStdString(change.reason));
    }
    return words.join(QStringLiteral(" "));
}

}  // namespace kerf::ui
