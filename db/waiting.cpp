// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/waiting.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "db/row_io.h"

namespace kerf::db {
namespace {

using nlohmann::json;

constexpr auto kReplace = json::error_handler_t::replace;

template <class Visit>
void eachLawValue(BoringSchedule& s, const Visit& visit) {
    visit("ln_c", s.lnC);
    visit("alpha", s.alpha);
    visit("beta", s.beta);
    visit("target_deflection_mm", s.targetDeflection_mm);
    visit("constant_feed_mm_per_rev", s.constantFeed_mmPerRev);
    visit("min_feed_mm_per_rev", s.minFeed_mmPerRev);
    visit("max_feed_mm_per_rev", s.maxFeed_mmPerRev);
    visit("overhang_from_mm", s.overhangFrom_mm);
    visit("overhang_to_mm", s.overhangTo_mm);
    visit("spindle_speed_rpm", s.spindleSpeed_rpm);
}

json scheduleJson(BoringSchedule schedule) {
    json values{{"revision", schedule.revision}};
    eachLawValue(schedule, [&values](const char* key, double& value) {
        if (std::isfinite(value)) {
            values[key] = value;
        }
    });
    return values;
}

BoringSchedule scheduleOf(const json& values) {
    BoringSchedule schedule;
    schedule.revision = values.at("revision").get<std::uint32_t>();
    eachLawValue(schedule, [&values](const char* key, double& value) {
        value = values.contains(key) ? values.at(key).get<double>() : std::nan("");
    });
    return schedule;
}

json textOf(const FinishedPart& part) {
    const PartRecord& r = part.record;
    return {{"kind", "part"},
            {"process", processKey(r.process)},
            {"sequence", r.partSequence},
            {"complete", r.complete},
            {"begin_ns", r.begin_ns},
            {"end_ns", r.end_ns},
            {"ended_utc_ms", part.endedUtc_ms},
            {"lot", r.order.lot},
            {"recipe", r.order.recipe},
            {"schedule", scheduleJson(r.schedule)},
            {"feed", packTrace(r.feed).toHex().toStdString()},
            {"figures", part.figuresJson.empty() ? packFigures(partResults(r)) : part.figuresJson}};
}

json textOf(const RaiseAlarm& alarm) {
    return {{"kind", "alarm"},
            {"code", alarm.code},
            {"priority", alarm.priority},
            {"utc_ms", alarm.utc_ms},
            {"text", alarm.detailText.empty() ? std::string(alarm.detail.text) : alarm.detailText},
            {"args", alarm.detailText.empty() ? packArgs(alarm.detail) : alarm.detailArgs}};
}

json textOf(const ClearAlarm& alarm) {
    return {{"kind", "cleared"}, {"code", alarm.code}, {"utc_ms", alarm.utc_ms}};
}

json textOf(const AddAudit& entry) {
    return {{"kind", "audit"},        {"author", entry.author},      {"action", entry.action},
            {"object", entry.object}, {"object_id", entry.objectId}, {"old", entry.oldValue},
            {"new", entry.newValue},  {"reason", entry.reason}};
}

FinishedPart partOf(const json& item) {
    FinishedPart part;
    PartRecord& r = part.record;
    r.process = processOfKey(item.at("process").get<std::string>());
    r.partSequence = item.at("sequence").get<std::uint32_t>();
    r.complete = item.at("complete").get<bool>();
    r.begin_ns = item.at("begin_ns").get<std::int64_t>();
    r.end_ns = item.at("end_ns").get<std::int64_t>();
    r.order.lot = item.at("lot").get<std::int64_t>();
    r.order.recipe = item.value("recipe", std::int64_t{0});
    r.schedule = scheduleOf(item.at("schedule"));
    r.order.schedule = r.schedule.revision;
    r.feed = unpackTrace(QByteArray::fromHex(QByteArray::fromStdString(item.at("feed").get<std::string>())));
    part.endedUtc_ms = item.at("ended_utc_ms").get<std::int64_t>();
    part.figuresJson = item.at("figures").get<std::string>();
    return part;
}

}  // namespace

std::string waitingText(const Waiting& item) {
    return std::visit([](const auto& each) { return textOf(each).dump(-1, ' ', false, kReplace); }, item);
}

std::optional<Waiting> waitingOf(const std::string& text) {
    try {
        const json item = json::parse(text);
        const auto kind = item.at("kind").get<std::string>();
        if (kind == "part") {
            return partOf(item);
        }
        if (kind == "alarm") {
            RaiseAlarm alarm;
            alarm.code = item.at("code").get<AlarmCode>();
            alarm.priority = item.at("priority").get<std::uint8_t>();
            alarm.utc_ms = item.at("utc_ms").get<std::int64_t>();
            alarm.detailText = item.at("text").get<std::string>();
            alarm.detailArgs = item.at("args").get<std::string>();
            return alarm;
        }
        if (kind == "cleared") {
            return ClearAlarm{item.at("code").get<AlarmCode>(), item.at("utc_ms").get<std::int64_t>()};
        }
        if (kind == "audit") {
            return AddAudit{item.at("author").get<std::string>(), item.at("action").get<std::string>(),
                            item.at("object").get<std::string>(), item.at("object_id").get<std::int64_t>(),
                            item.at("old").get<std::string>(),    item.at("new").get<std::string>(),
                            item.at("reason").get<std::string>()};
        }
    } catch (const json::exception&) {
    } catch (const SqlFailure&) {  // a process of a later version
    }
    return std::nullopt;
}

}  // namespace kerf::db
