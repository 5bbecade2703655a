// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gateway/observations.h"

#include <algorithm>

namespace kerf::gateway {
namespace {

const DataItem* itemOf(const char* id) {
    const auto& items = dataItems();
    const auto found =
        std::find_if(items.begin(), items.end(), [id](const DataItem& item) { return qstrcmp(item.id, id) == 0; });
    return found == items.end() ? nullptr : &*found;
}

}  // namespace

const std::vector<Component>& components() {
    static const std::vector<Component> kComponents{
        {"axes", "Axes", "base", ""},     {"x", "Linear", "X", "axes"}, {"y", "Linear", "Y", "axes"},
        {"z", "Linear", "Z", "axes"},     {"c", "Rotary", "C", "axes"}, {"cont", "Controller", "controller", ""},
        {"path", "Path", "path", "cont"},
    };
    return kComponents;
}

const std::vector<DataItem>& dataItems() {
    using C = Category;
    static const std::vector<DataItem> kItems{
        {"avail", C::Event, "AVAILABILITY", "", "", "Availability", ""},
        {"asset_chg", C::Event, "ASSET_CHANGED", "", "", "AssetChanged", ""},
        {"asset_rem", C::Event, "ASSET_REMOVED", "", "", "AssetRemoved", ""},
        {"Xpos", C::Sample, "POSITION", "ACTUAL", "MILLIMETER", "Position", "x"},
        {"Xdrift", C::Sample, "DISPLACEMENT", "", "MILLIMETER", "Displacement", "x"},
        {"Ypos", C::Sample, "POSITION", "ACTUAL", "MILLIMETER", "Position", "y"},
        {"Ydrift", C::Sample, "DISPLACEMENT", "", "MILLIMETER", "Displacement", "y"},
        {"Zpos", C::Sample, "POSITION", "ACTUAL", "MILLIMETER", "Position", "z"},
        {"Zdrift", C::Sample, "DISPLACEMENT", "", "MILLIMETER", "Displacement", "z"},
        {"Cspeed", C::Sample, "ROTARY_VELOCITY", "ACTUAL", "REVOLUTION/MINUTE", "RotaryVelocity", "c"},
        {"estop", C::Event, "EMERGENCY_STOP", "", "", "EmergencyStop", "cont"},
        {"temp1", C::Sample, "TEMPERATURE", "", "CELSIUS", "Temperature", "cont"},
        {"temp2", C::Sample, "TEMPERATURE", "", "CELSIUS", "Temperature", "cont"},
        {"temp3", C::Sample, "TEMPERATURE", "", "CELSIUS", "Temperature", "cont"},
        {"temp4", C::Sample, "TEMPERATURE", "", "CELSIUS", "Temperature", "cont"},
        {"temp5", C::Sample, "TEMPERATURE", "", "CELSIUS", "Temperature", "cont"},
        {"temp6", C::Sample, "TEMPERATURE", "", "CELSIUS", "Temperature", "cont"},
        {"temp7", C::Sample, "TEMPERATURE", "", "CELSIUS", "Temperature", "cont"},
        {"temp8", C::Sample, "TEMPERATURE", "", "CELSIUS", "Temperature", "cont"},
        {"alarms", C::Condition, "SYSTEM", "", "", "", "cont"},
        {"execution", C::Event, "EXECUTION", "", "", "Execution", "path"},
        {"mode", C::Event, "CONTROLLER_MODE", "", "", "ControllerMode", "path"},
        {"program", C::Event, "PROGRAM", "", "", "Program", "path"},
        {"feed", C::Sample, "PATH_FEEDRATE", "ACTUAL", "MILLIMETER/SECOND", "PathFeedrate", "path"},
        {"feedrev", C::Sample, "PATH_FEEDRATE_PER_REVOLUTION", "ACTUAL", "MILLIMETER/REVOLUTION",
         "PathFeedratePerRevolution", "path"},
        {"override", C::Event, "PATH_FEEDRATE_OVERRIDE", "PROGRAMMED", "PERCENT", "PathFeedrateOverride", "path"},
        {"force", C::Sample, "LINEAR_FORCE", "ACTUAL", "NEWTON", "LinearForce", "path"},
        {"offsets", C::Event, "WORK_OFFSETS", "", "", "WorkOffsetsTable", "path", "TABLE"},
        {"partcount", C::Event, "PART_COUNT", "ALL", "", "PartCount", "path"},
        {"partid", C::Event, "PART_UNIQUE_ID", "UUID", "", "PartUniqueId", "path"},
        {"bore", C::Event, "FEATURE_MEASUREMENT", "", "", "FeatureMeasurementTable", "path", "TABLE"},
    };
    return kItems;
}

Observations::Observations(std::size_t capacity)
    : m_capacity(std::max<std::size_t>(capacity, 64)),
      m_instance(static_cast<quint64>(QDateTime::currentSecsSinceEpoch())) {
    const qint64 now = QDateTime::currentMSecsSinceEpoch();
    for (const DataItem& item : dataItems()) {
        m_values[item.id] = {};
        append({0, now, &item, {}, {QStringLiteral("Unavailable"), {}, {}}});
    }
}

void Observations::append(Observation observation) {
    observation.sequence = m_next++;
    std::vector<Observation>& newest = m_newest[observation.item->id];
    if (observation.item->category == Category::Condition) {
        // The conditions that stand; "normal" or "unavailable" takes the place of all, and any of them that of these
        // two.
        const QString& code = observation.condition.code;
        const bool all = code.isEmpty();
        std::erase_if(newest, [&](const Observation& old) {
            return all || old.condition.code.isEmpty() || old.condition.code == code;
        });
        newest.push_back(observation);
    } else {
        newest.assign(1, observation);
    }
    if (m_buffer.size() == m_capacity) {
        m_buffer.pop_front();
    }
    m_buffer.push_back(std::move(observation));
}

void Observations::set(const char* id, const Value& value, qint64 utc_ms) {
    Value& known = m_values.at(id);
    if (known == value) {
        return;
    }
    const DataItem* item = itemOf(id);
    if (item == nullptr) {
        return;
    }
    if (item->category != Category::Condition) {
        known = value;
        append({0, utc_ms, item, value, {}});
        return;
    }
    if (!value.available) {
        append({0, utc_ms, item, value, {QStringLiteral("Unavailable"), {}, {}}});
    } else if (value.conditions.empty()) {
        append({0, utc_ms, item, value, {QStringLiteral("Normal"), {}, {}}});
    } else {
        for (const Condition& old : known.conditions) {
            const bool stands = std::any_of(value.conditions.begin(), value.conditions.end(),
                                            [&](const Condition& now) { return now.code == old.code; });
            if (!stands) {
                append({0, utc_ms, item, value, {QStringLiteral("Normal"), old.code, {}}});
                std::erase_if(m_newest[id], [&](const Observation& o) { return o.condition.code == old.code; });
            }
        }
        for (const Condition& now : value.conditions) {
            if (std::find(known.conditions.begin(), known.conditions.end(), now) == known.conditions.end()) {
                append({0, utc_ms, item, value, now});
            }
        }
    }
    known = value;
}

void Observations::setAllUnavailable(qint64 utc_ms) {
    for (const DataItem& item : dataItems()) {
        set(item.id, {}, utc_ms);
    }
}

}  // namespace kerf::gateway
