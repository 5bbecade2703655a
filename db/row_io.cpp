// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/row_io.h"

#include <QtEndian>
#include <algorithm>
#include <bit>
#include <cmath>
#include <nlohmann/json.hpp>

namespace kerf::db {

const char* kindKey(MeasurementKind kind) {
    switch (kind) {
        case MeasurementKind::Entry:
            return "entry";
        case MeasurementKind::Correction:
            return "correction";
        case MeasurementKind::Void:
            break;
    }
    return "void";
}

ProcessId processOfKey(const std::string& key) {
    if (const ProcessDescriptor* process = findProcess(std::string_view(key))) {
        return process->id;
    }
    throw SqlFailure(sentenceForCode(11), 11, "unknown process " + key);
}

MeasurementRow readMeasurement(const Statement& row) {
    MeasurementRow m;
    m.id = row.integer(0);
    m.part = row.integer(1);
    const std::string kind = row.text(2);
    m.kind = kind == "entry"        ? MeasurementKind::Entry
             : kind == "correction" ? MeasurementKind::Correction
                                    : MeasurementKind::Void;
    m.replaces = row.maybeInteger(3);
    m.station = static_cast<std::uint8_t>(row.integer(4));
    m.position_mm = row.real(5);
    m.diameter_mm = row.maybeReal(6);
    // Before the sources had a table of their own only keypad or gauge was kept.
    const std::string source = row.isNull(12) ? row.text(7) : row.text(12);
    m.source = source == "gauge"  ? MeasurementSource::Gauge
               : source == "file" ? MeasurementSource::File
                                  : MeasurementSource::Keypad;
    m.sourceName = row.text(13);
    m.confirmed = row.integer(8) != 0;
    m.author = row.text(9);
    m.reason = row.text(10);
    m.acceptedUtc_ms = row.integer(11);
    return m;
}

EstimatorStateRow readState(const Statement& row) {
    EstimatorStateRow e;
    e.id = row.integer(0);
    e.measurement = row.integer(1);
    e.cause = row.integer(2);
    e.estimator = row.text(3);
    for (int i = 0; i < 3; ++i) {
        e.theta[static_cast<std::size_t>(i)] = row.real(4 + i);
    }
    for (int i = 0; i < 6; ++i) {
        e.covariance[static_cast<std::size_t>(i)] = row.real(7 + i);
    }
    e.perturbed = row.integer(13) != 0;
    e.stateJson = row.text(14);
    return e;
}

ScheduleRow readSchedule(const Statement& row, int from) {
    ScheduleRow s;
    s.id = row.integer(from);
    s.lot = row.maybeInteger(from + 1);
    s.schedule.revision = row.count(from + 2);
    s.schedule.lnC = row.real(from + 3);
    s.schedule.alpha = row.real(from + 4);
    s.schedule.beta = row.real(from + 5);
    s.schedule.targetDeflection_mm = row.real(from + 6);
    s.schedule.constantFeed_mmPerRev = row.real(from + 7);
    s.schedule.minFeed_mmPerRev = row.real(from + 8);
    s.schedule.maxFeed_mmPerRev = row.real(from + 9);
    s.schedule.overhangFrom_mm = row.real(from + 10);
    s.schedule.overhangTo_mm = row.real(from + 11);
    s.schedule.spindleSpeed_rpm = row.real(from + 12);
    s.predictionJson = row.text(from + 13);
    s.reason = row.text(from + 14);
    s.createdUtc_ms = row.integer(from + 15);
    s.acceptedBy = row.text(from + 16);
    s.acceptedUtc_ms = row.maybeInteger(from + 17);
    return s;
}

PartRow readPart(const Statement& row) {
    PartRow p;
    p.id = row.integer(0);
    p.process = processOfKey(row.text(1));
    p.lot = row.maybeInteger(2);
    p.lotName = row.text(3);
    p.partTypeName = row.text(4);
    p.number = row.count(5);
    p.serial = row.text(6);
    p.complete = row.integer(7) != 0;
    p.machineBegin_ns = row.integer(8);
    p.machineEnd_ns = row.integer(9);
    p.endedUtc_ms = row.integer(10);
    if (!row.isNull(11)) {
        p.figures = unpackFigures(p.process, row.text(11));
    }
    p.recipe = row.maybeInteger(12);
    p.recipeRevision = p.recipe ? row.count(13) : 0;
    return p;
}

RoomRecordRow readRoomRecord(const Statement& row) {
    return {row.integer(0), processOfKey(row.text(1)), row.text(2), row.text(3), row.text(4), row.text(5), row.text(6),
            row.integer(7)};
}

std::string packFigures(const std::vector<PartResult>& results) {
    nlohmann::json object = nlohmann::json::object();
    for (const PartResult& result : results) {
        object[result.spec->key] = result.value;
    }
    return object.dump();
}

std::vector<PartFigure> unpackFigures(ProcessId process, const std::string& json) {
    std::vector<PartFigure> figures;
    const nlohmann::json object = nlohmann::json::parse(json, nullptr, false);
    if (!object.is_object()) {
        return figures;
    }
    for (const auto& [spec, read] : partResultRows(process)) {
        const auto found = object.find(spec.key);
        if (found != object.end() && found->is_number()) {
            figures.push_back({spec.key, found->get<double>()});
        }
    }
    return figures;
}

RecipeRevision readRecipe(const Statement& row) {
    RecipeRevision r;
    r.id = row.integer(0);
    r.partType = row.integer(1);
    r.revision = row.count(2);
    r.parametersJson = row.text(3);
    if (!row.isNull(4)) {
        r.restoredFrom = row.count(4);
    }
    r.author = row.text(5);
    r.reason = row.text(6);
    r.createdUtc_ms = row.integer(7);
    return r;
}

LotRow readLot(const Statement& row) {
    LotRow l;
    l.id = row.integer(0);
    l.machine = row.integer(1);
    l.machineName = row.text(2);
    l.partType = row.integer(3);
    l.partTypeName = row.text(4);
    l.process = processOfKey(row.text(5));
    l.recipe = row.integer(6);
    l.name = row.text(7);
    l.size = row.count(8);
    l.estimator = row.text(9);
    l.openedUtc_ms = row.integer(10);
    l.closedUtc_ms = row.maybeInteger(11);
    l.tool = row.text(12);
    l.gauge = row.text(13);
    l.openedBy = row.text(14);
    l.closedBy = row.text(15);
    l.recipeRevision = row.count(16);
    return l;
}

AlarmRow readAlarm(const Statement& row) {
    AlarmRow a;
    a.id = row.integer(0);
    a.code = static_cast<AlarmCode>(row.integer(1));
    a.priority = static_cast<std::uint8_t>(row.integer(2));
    a.raisedUtc_ms = row.integer(3);
    a.clearedUtc_ms = row.maybeInteger(4);
    a.endedByRestart = row.text(5) == "restart";
    a.acknowledgedUtc_ms = row.maybeInteger(6);
    a.acknowledgedBy = row.text(7);
    a.detailText = row.text(8);
    a.detailArgs = unpackArgs(row.text(9));
    return a;
}

AuditRow readAudit(const Statement& row) {
    return AuditRow{row.integer(0), row.integer(1), row.text(2), row.text(3), row.text(4), row.integer(5),
                    row.text(6),    row.text(7),    row.text(8), row.text(9), row.text(10)};
}

QByteArray packTrace(const FeedTrace& trace) {
    const int count = std::min<int>(trace.count, static_cast<int>(kFeedTracePoints));
    QByteArray points(count * 8, '\0');
    for (int i = 0; i < count; ++i) {
        const auto index = static_cast<std::size_t>(i);
        qToLittleEndian(std::bit_cast<quint32>(trace.overhang_mm[index]), points.data() + i * 8);
        qToLittleEndian(std::bit_cast<quint32>(trace.feed_mmPerRev[index]), points.data() + i * 8 + 4);
    }
    return points;
}

FeedTrace unpackTrace(const QByteArray& points) {
    FeedTrace trace;
    trace.count = static_cast<std::uint16_t>(std::min<qsizetype>(points.size() / 8, kFeedTracePoints));
    for (std::size_t i = 0; i < trace.count; ++i) {
        const char* pair = points.constData() + i * 8;
        trace.overhang_mm[i] = std::bit_cast<float>(qFromLittleEndian<quint32>(pair));
        trace.feed_mmPerRev[i] = std::bit_cast<float>(qFromLittleEndian<quint32>(pair + 4));
    }
    return trace;
}

std::string packArgs(const Sentence& sentence) {
    nlohmann::json list = nlohmann::json::array();
    for (std::size_t i = 0; i < sentence.argCount; ++i) {
        const SentenceArg& arg = sentence.args[i];
        if (arg.decimals < 0) {
            list.push_back({{"n", arg.name.data()}});
        } else if (std::isfinite(arg.value)) {
            list.push_back({{"v", arg.value}, {"d", arg.decimals}});
        } else {
            list.push_back({{"n", "?"}});  // JSON knows no infinity
        }
    }
    // A name cut in the middle of a UTF-8 character must not throw.
    return list.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

std::vector<SentenceArg> unpackArgs(const std::string& json) {
    std::vector<SentenceArg> args;
    const nlohmann::json list = nlohmann::json::parse(json, nullptr, false);
    for (const auto& item : list) {
        if (item.is_object() && item.contains("n") && item["n"].is_string()) {
            args.emplace_back(item["n"].get<std::string>());
        } else if (item.is_object() && item.contains("v") && item["v"].is_number()) {
            args.emplace_back(item["v"].get<double>(), item.value("d", 0));
        }
    }
    return args;
}

std::string activeLotKey(ProcessId process) {
    return std::string("active_lot.") + processKey(process);
}

}  // namespace kerf::db
