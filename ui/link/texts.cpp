// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/link/texts.h"

#include <QCoreApplication>
#include <array>

#include "engine/api/part_results.h"
#include "ui/theme/particles.h"

namespace kerf::ui {
namespace {

struct Words {
    Q_DECLARE_TR_FUNCTIONS(Words)
};

struct WrittenUnit {
    QLatin1StringView text;
    const char* stored;
};
// Longer spellings first: "mm/rev" before "mm". Texts may write µm and °C or their plain forms.
constexpr std::array<WrittenUnit, 6> kWritten{{
    {QLatin1StringView("mm/rev"), "mm/rev"},
    {QLatin1StringView("mm/s"), "mm/s"},
    {QLatin1StringView("mm/min"), "mm/min"},
    {QLatin1StringView("mm"), "mm"},
    {QLatin1StringView("um"), "um"},
    {QLatin1StringView("degC"), "degC"},
}};

/// The unit written at `from` (after one blank), and how many characters it takes.
const char* unitAt(const QString& text, qsizetype from, qsizetype& length) {
    if (from >= text.size() || (text[from] != u' ' && text[from] != QChar::Nbsp)) {
        return nullptr;
    }
    const QStringView rest = QStringView(text).mid(from + 1);
    const auto ends = [&rest](qsizetype n) {
        return n >= rest.size() || !(rest[n].isLetterOrNumber() || rest[n] == u'/');
    };
    for (const WrittenUnit& unit : kWritten) {
        if (rest.startsWith(unit.text) && ends(unit.text.size())) {
            length = unit.text.size() + 1;
            return unit.stored;
        }
    }
    if (rest.startsWith(QStringLiteral("µm")) && ends(2)) {
        length = 3;
        return "um";
    }
    if (rest.startsWith(QStringLiteral("°C")) && ends(2)) {
        length = 3;
        return "degC";
    }
    return nullptr;
}

QString fill(const QString& text, std::span<const SentenceArg> args, const UnitSystem& units) {
    QString out;
    out.reserve(text.size() + 16);
    for (qsizetype i = 0; i < text.size(); ++i) {
        const int index = text[i] == u'%' && i + 1 < text.size() ? text[i + 1].unicode() - u'1' : -1;
        if (index < 0 || index >= static_cast<int>(args.size())) {
            out += text[i];
            continue;
        }
        const SentenceArg& arg = args[static_cast<std::size_t>(index)];
        ++i;
        if (arg.decimals < 0) {
            out += engineText(arg.name.data());
            continue;
        }
        qsizetype length = 0;
        if (const char* unit = unitAt(text, i + 1, length)) {
            out += units.withUnit(arg.value, unit, arg.decimals);
            i += length;
        } else {
            out += UnitSystem::fixed(arg.value, arg.decimals);
        }
    }
    return withParticles(out);
}

}  // namespace

QString engineText(const char* english) {
    return english == nullptr || *english == '\0' ? QString() : QCoreApplication::translate("engine", english);
}

QString sentenceText(const Sentence& sentence, const UnitSystem& units) {
    return fill(engineText(sentence.text), std::span(sentence.args.data(), sentence.argCount), units);
}

QString sentenceText(const std::string& english, std::span<const SentenceArg> args, const UnitSystem& units) {
    return fill(engineText(english.c_str()), args, units);
}

AlarmText alarmText(const AlarmSpec* spec, AlarmCode code) {
    if (spec == nullptr) {
        return {Words::tr("Alarm %1, which this console does not know").arg(code),
                {},
                {},
                Words::tr("Note the number and call service.")};
    }
    return {engineText(spec->title), engineText(spec->cause), engineText(spec->consequence), engineText(spec->action)};
}

QString figureText(ProcessId process, const PartFigure& figure, const UnitSystem& units) {
    const PartResultSpec* spec = findPartResult(process, figure.key);
    if (spec == nullptr) {
        return QString::fromStdString(figure.key) + QLatin1Char(' ') + QString::number(figure.value);
    }
    return engineText(spec->label) + QLatin1Char(' ') + units.withUnit(figure.value, spec->unit, spec->decimals);
}

QString processName(ProcessId id) {
    const ProcessDescriptor* process = findProcess(id);
    return process != nullptr ? engineText(process->name) : Words::tr("process %1").arg(static_cast<int>(id) + 1);
}

QString stateName(LoopState state) {
    switch (state) {
        case LoopState::Off:
            return Words::tr("off");
        case LoopState::Advising:
            return Words::tr("advising");
        case LoopState::Controlling:
            return Words::tr("controlling");
        case LoopState::Limited:
            return Words::tr("limited");
        case LoopState::Held:
            return Words::tr("held");
        case LoopState::Faulted:
            return Words::tr("faulted");
    }
    return {};
}

QString modeName(LoopMode mode) {
    switch (mode) {
        case LoopMode::Off:
            return Words::tr("off");
        case LoopMode::Advise:
            return Words::tr("advise");
        case LoopMode::Control:
            return Words::tr("control");
    }
    return {};
}

}  // namespace kerf::ui
