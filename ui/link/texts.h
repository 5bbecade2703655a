// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <span>
#include <string>

#include "db/api/rows.h"
#include "engine/core/alarm.h"
#include "engine/core/process.h"
#include "engine/core/sentence.h"
#include "ui/units/unit_system.h"

namespace kerf::ui {

/// Translation of an engine text (marked with KERF_TEXT); itself when there is none.
[[nodiscard]] QString engineText(const char* english);
/// "typed", "gauge G-07", "file bores.csv": where a measured value came from. An unknown gauge is "gauge".
[[nodiscard]] QString sourceText(MeasurementSource source, const std::string& name);

/// A sentence in the operator's language. A number followed by a unit that the screen converts ("%1 mm", "%2 degC")
/// is shown in the operator's unit.
[[nodiscard]] QString sentenceText(const Sentence& sentence, const UnitSystem& units = UnitSystem());

/// The same for a sentence that comes back from the database.
[[nodiscard]] QString sentenceText(const std::string& english, std::span<const SentenceArg> args,
                                   const UnitSystem& units = UnitSystem());

struct AlarmText {
    QString title{};
    QString cause{};
    QString consequence{};
    QString action{};
};
/// Texts of one alarm; an unknown code says so.
[[nodiscard]] AlarmText alarmText(const AlarmSpec* spec, AlarmCode code);

/// "Waviness 50.1 µm"; the bare key of a figure this version does not know.
[[nodiscard]] QString figureText(ProcessId process, const PartFigure& figure, const UnitSystem& units);

[[nodiscard]] QString processName(ProcessId id);
[[nodiscard]] QString stateName(LoopState state);
[[nodiscard]] QString modeName(LoopMode mode);

}  // namespace kerf::ui
