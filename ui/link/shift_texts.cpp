// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/link/shift_texts.h"

#include <QCoreApplication>
#include <QHash>
#include <QStringList>
#include <cmath>
#include <optional>
#include <string_view>

#include "ui/link/reason_text.h"
#include "ui/link/texts.h"

namespace kerf::ui {
namespace {

struct Shift {
    Q_DECLARE_TR_FUNCTIONS(Shift)
};

constexpr qsizetype kLongestValue = 40;

/// What a room has kept (kind of its record).
QString keptText(const QString& kind) {
    static constexpr struct {
        const char* kind;
        const char* words;
    } kKinds[] = {
        {"boring.change", QT_TRANSLATE_NOOP("Shift", "change announced")},
        {"boring.lot", QT_TRANSLATE_NOOP("Shift", "tool and material of a lot named")},
        {"boring.memory", QT_TRANSLATE_NOOP("Shift", "lot left out of memory or taken in")},
        {"controller", QT_TRANSLATE_NOOP("Shift", "controller chosen")},
        {"disposition", QT_TRANSLATE_NOOP("Shift", "part out of tolerance dealt with")},
        {"figure_limits", QT_TRANSLATE_NOOP("Shift", "limits of the figures")},
        {"gap", QT_TRANSLATE_NOOP("Shift", "gap sensors read")},
        {"gap-zero", QT_TRANSLATE_NOOP("Shift", "gap sensors set to zero")},
        {"gauge", QT_TRANSLATE_NOOP("Shift", "gauge registered")},
        {"gauge_study", QT_TRANSLATE_NOOP("Shift", "gauge study made")},
        {"memory", QT_TRANSLATE_NOOP("Shift", "part left out of memory or taken in")},
        {"model", QT_TRANSLATE_NOOP("Shift", "model put live")},
        {"sensor-places", QT_TRANSLATE_NOOP("Shift", "sensors placed")},
        {"session", QT_TRANSLATE_NOOP("Shift", "session recorded")},
        {"setup", QT_TRANSLATE_NOOP("Shift", "setup changed")},
        {"tool_change", QT_TRANSLATE_NOOP("Shift", "new tool")},
        {"tool_life", QT_TRANSLATE_NOOP("Shift", "tool life set")},
        {"tool_memory", QT_TRANSLATE_NOOP("Shift", "tool left out of memory or taken in")},
        {"tuning", QT_TRANSLATE_NOOP("Shift", "tuning accepted")},
    };
    for (const auto& one : kKinds) {
        if (kind == QLatin1String(one.kind)) {
            return Shift::tr(one.words);
        }
    }
    return kind;
}

/// What the log calls it, in words of the shop; what a later version has added stays as it is.
QString deedText(const std::string& action) {
    static constexpr struct {
        const char* action;
        const char* words;
    } kDeeds[] = {
        {"account changed", QT_TRANSLATE_NOOP("Shift", "Account changed")},
        {"account made", QT_TRANSLATE_NOOP("Shift", "Account made")},
        {"account removed", QT_TRANSLATE_NOOP("Shift", "Account removed")},
        {"alarm acknowledged", QT_TRANSLATE_NOOP("Shift", "Alarm acknowledged")},
        {"corrected", QT_TRANSLATE_NOOP("Shift", "Diameter corrected")},
        {"lot closed", QT_TRANSLATE_NOOP("Shift", "Lot closed")},
        {"lot opened", QT_TRANSLATE_NOOP("Shift", "Lot opened")},
        {"measured", QT_TRANSLATE_NOOP("Shift", "Diameter entered")},
        {"measurement taken over", QT_TRANSLATE_NOOP("Shift", "Measured origin taken over")},
        {"origin measured", QT_TRANSLATE_NOOP("Shift", "Origin measured")},
        {"recipe rolled back", QT_TRANSLATE_NOOP("Shift", "Recipe rolled back")},
        {"recipe saved", QT_TRANSLATE_NOOP("Shift", "Recipe saved")},
        {"reference taken", QT_TRANSLATE_NOOP("Shift", "Thermal reference taken")},
        {"reference taken, shift back to zero",
         QT_TRANSLATE_NOOP("Shift", "Thermal reference taken, shift back to zero")},
        {"refused", QT_TRANSLATE_NOOP("Shift", "Refused for want of rights")},
        {"schedule accepted", QT_TRANSLATE_NOOP("Shift", "Feed schedule accepted")},
        {"serial number set", QT_TRANSLATE_NOOP("Shift", "Serial number set")},
        {"setting changed", QT_TRANSLATE_NOOP("Shift", "Setting changed:")},
        {"PIN refused", QT_TRANSLATE_NOOP("Shift", "Wrong PIN")},
        {"PIN removed", QT_TRANSLATE_NOOP("Shift", "PIN removed:")},
        {"PIN set", QT_TRANSLATE_NOOP("Shift", "PIN set:")},
        {"first process engineer made", QT_TRANSLATE_NOOP("Shift", "First process engineer made")},
        {"role set", QT_TRANSLATE_NOOP("Shift", "Role set:")},
        {"second person", QT_TRANSLATE_NOOP("Shift", "Second person:")},
        {"voided", QT_TRANSLATE_NOOP("Shift", "Diameter taken out")},
    };
    for (const auto& deed : kDeeds) {
        if (action == deed.action) {
            return Shift::tr(deed.words);
        }
    }
    const QString text = QString::fromStdString(action);
    for (const ProcessId process : allProcesses()) {  // "tapping tuning kept"
        const QString key = QLatin1String(processKey(process)) + u' ';
        if (text.startsWith(key) && text.endsWith(QStringLiteral(" kept"))) {
            return Shift::tr("%1: %2").arg(processName(process), keptText(text.mid(key.size()).chopped(5)));
        }
    }
    return text;
}

QString shortened(const std::string& text) {
    const QString whole = QString::fromStdString(text);
    return whole.size() > kLongestValue ? whole.left(kLongestValue) + QStringLiteral("…") : whole;
}

/// "setter, no PIN" in words of the shop.
QString accountText(const std::string& stored) {
    static constexpr struct {
        const char* stored;
        const char* words;
    } kWords[] = {
        {"operator", QT_TRANSLATE_NOOP("Shift", "operator")},
        {"setter", QT_TRANSLATE_NOOP("Shift", "setter")},
        {"engineer", QT_TRANSLATE_NOOP("Shift", "process engineer")},
        {"no PIN", QT_TRANSLATE_NOOP("Shift", "no PIN")},
        {"PIN", QT_TRANSLATE_NOOP("Shift", "PIN")},
        {"new PIN", QT_TRANSLATE_NOOP("Shift", "new PIN")},
    };
    QStringList words = QString::fromStdString(stored).split(QStringLiteral(", "));
    for (QString& word : words) {
        for (const auto& known : kWords) {
            if (word == QLatin1String(known.stored)) {
                word = Shift::tr(known.words);
                break;
            }
        }
    }
    return words.join(QStringLiteral(", "));
}

/// Whose account, and what became of it.
QString accountChange(const ShiftChange& change) {
    QStringList words{deedText(change.action), QString::fromStdString(change.object).section(u' ', 1)};
    words.back() += u':';
    if (!change.oldValue.empty()) {
        words << accountText(change.oldValue);
    }
    if (!change.newValue.empty()) {
        words << (change.oldValue.empty() ? QString() : QStringLiteral("→ ")) + accountText(change.newValue);
    }
    return words.join(u' ');
}

/// A lot made the one that parts go into: the setting's key and row number are for programs.
std::optional<QString> lotSelection(const ShiftChange& change) {
    constexpr std::string_view kKey = "setting active_lot.";
    if (!change.object.starts_with(kKey)) {
        return std::nullopt;
    }
    for (const ProcessId process : allProcesses()) {
        if (change.object.substr(kKey.size()) == processKey(process)) {
            return Shift::tr("%1: %2").arg(processName(process), change.newValue.empty()
                                                                     ? Shift::tr("no lot selected any more")
                                                                     : Shift::tr("lot selected"));
        }
    }
    return std::nullopt;
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
                     .arg(std::round(saving.saved_s / 6.0) / 10.0 + 0.0, 0, 'f', 1);
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
    if (const auto selected = lotSelection(change)) {
        return *selected;
    }
    if (change.object.starts_with("account ")) {
        return accountChange(change);
    }
    QStringList words{deedText(change.action)};
    if (change.object == "setting" || change.object.starts_with("setting ") || change.object.starts_with("loop.")) {
        words << QString::fromStdString(change.object).section(u' ', -1);
    }
    if (const auto hash = change.newValue.find("; sha256="); hash != std::string::npos) {
        if (!change.action.ends_with(" kept")) {  // a recipe: of which part type
            words << QString::fromStdString(change.newValue.substr(0, hash));
        }
    } else if (!change.newValue.empty() && !change.action.ends_with(" kept")) {  // what a room keeps is for programs
        words << (change.oldValue.empty()
                      ? shortened(change.newValue)
                      : shortened(change.oldValue) + QStringLiteral(" → ") + shortened(change.newValue));
    }
    if (!change.reason.empty()) {
        words << QStringLiteral("(%1)").arg(reasonText(change.reason));
    }
    return words.join(QStringLiteral(" "));
}

}  // namespace kerf::ui
