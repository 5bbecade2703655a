// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/service/quality/lot_dfq.h"

#include <fmt/format.h>

#include <algorithm>
#include <ctime>
#include <map>
#include <set>

namespace kerf {
namespace {

constexpr int kPartNumber = 1001, kPartName = 1002, kChangeState = 1004, kOrder = 1053, kMachineNumber = 1081,
              kMachineName = 1082, kOperation = 1086;
constexpr int kNumber = 2001, kName = 2002, kKind = 2004, kDecimals = 2022, kEventCatalogue = 2060, kNominal = 2101,
              kLower = 2110, kUpper = 2111, kLowerAllowance = 2112, kUpperAllowance = 2113, kLowerKind = 2120,
              kUpperKind = 2121, kUnit = 2142, kGaugeNumber = 2401, kSubgroup = 8500;
constexpr int kMachineKey = 4062, kMachineText = 4063, kGaugeKey = 4072, kGaugeText = 4073, kOperatorKey = 4092,
              kOperatorText = 4093, kCatalogue = 4220, kCatalogueEntry = 4221, kCatalogueNumber = 4222,
              kCatalogueText = 4223;

std::string number(double value) {
    return fmt::format("{}", value);
}

dfq::Time localTime(std::int64_t utc_ms) {
    const std::time_t seconds = static_cast<std::time_t>(utc_ms / 1000);
    std::tm parts{};
    localtime_r(&seconds, &parts);
    return {parts.tm_year + 1900, parts.tm_mon + 1, parts.tm_mday,
            parts.tm_hour,        parts.tm_min,     static_cast<double>(parts.tm_sec)};
}

class Builder {
 public:
    Builder(const LotHistory& history, const LotQuality& quality, DfqContent content)
        : m_history(history), m_quality(quality), m_content(content) {
        for (const ChartedPart& part : quality.charted) {
            if (part.perturbed) {
                m_changed.insert(part.number);
            }
        }
    }

    dfq::File run(std::optional<PartId> only) {
        m_file.characteristics = static_cast<std::uint32_t>(m_quality.characteristics.size());
        const auto part = only ? std::ranges::find(m_quality.parts, *only, &LotPart::id) : m_quality.parts.end();
        m_only = part == m_quality.parts.end() ? nullptr : &*part;
        describe();
        std::uint32_t row = 0;
        for (const PartDetail& detail : m_history.parts) {
            if (only && detail.part.id != *only) {
                continue;
            }
            ++row;
            detail.part.process == ProcessId::Boring ? addBores(detail.part, row) : addFigures(detail.part, row);
        }
        gauges();
        catalogues();
        return std::move(m_file);
    }

 private:
    void entry(int key, std::optional<std::uint32_t> index, std::string text) {
        m_file.entries.push_back({key, index, {}, std::move(text)});
    }

    void describe() {
        const LotRow& lot = m_history.lot;
        entry(kPartNumber, 1, lot.partTypeName);
        entry(kPartName, 1, lot.partTypeName);
        const bool own = m_only != nullptr && m_only->recipeRevision > 0;
        entry(kChangeState, 1, std::to_string(own ? m_only->recipeRevision : m_history.recipe.revision));
        entry(kOrder, 1, lot.name);
        entry(kMachineNumber, 1, std::to_string(lot.machine));
        entry(kMachineName, 1, lot.machineName);
        entry(kOperation, 1, processKey(lot.process));
        std::uint32_t index = 0;
        for (const Characteristic& characteristic : m_quality.characteristics) {
            ++index;
            entry(kNumber, index, std::to_string(index));
            entry(kName, index, characteristic.name);
            entry(kKind, index, "0");
            entry(kDecimals, index, std::to_string(characteristic.decimals));
            entry(kEventCatalogue, index, "1");
            if (characteristic.nominal) {
                entry(kNominal, index, number(*characteristic.nominal));
            }
            // The file of one part says what that part was judged by.
            const quality::Tolerance& tolerance =
                m_only != nullptr ? m_only->judgement.values[index - 1].tolerance : characteristic.tolerance;
            limit(characteristic, tolerance.lower, kLower, kLowerAllowance, kLowerKind, index);
            limit(characteristic, tolerance.upper, kUpper, kUpperAllowance, kUpperKind, index);
            entry(kUnit, index, characteristic.unit);
            entry(kSubgroup, index, "1");
        }
    }

    void limit(const Characteristic& characteristic, std::optional<double> value, int key, int allowance, int kind,
               std::uint32_t index) {
        if (!value) {
            return;
        }
        entry(key, index, number(*value));
        if (characteristic.nominal) {
            entry(allowance, index,
                  fmt::format("{:.{}f}", *value - *characteristic.nominal, characteristic.decimals + 3));
        }
        entry(kind, index, "1");
    }

    /// Of a characteristic, where all its values came from the same one; else each value names its own.
    void gauges() {
        for (const auto& [station, names] : m_gaugesOf) {
            if (names.size() == 1 && !names.begin()->empty()) {
                entry(kGaugeNumber, station + 1U, *names.begin());
            }
        }
    }

    void catalogues() {
        entry(kMachineKey, 1, "1");
        entry(kMachineText, 1, m_history.lot.machineName);
        for (const auto& [name, key] : m_operators) {
            entry(kOperatorKey, key, std::to_string(key));
            entry(kOperatorText, key, name);
        }
        for (const auto& [name, key] : m_gauges) {
            entry(kGaugeKey, key, std::to_string(key));
            entry(kGaugeText, key, name);
        }
        entry(kCatalogue, 1, "Kerf");
        const std::pair<std::uint32_t, const char*> events[] = {
            {kEventCorrected, "corrected"}, {kEventVoided, "voided"}, {kEventProcessChanged, "process changed"}};
        for (const auto& [event, text] : events) {
            entry(kCatalogueEntry, event, std::to_string(event));
            entry(kCatalogueNumber, event, std::to_string(event));
            entry(kCatalogueText, event, text);
        }
    }

    std::uint32_t operatorKey(const std::string& name) {
        return m_operators.emplace(name, static_cast<std::uint32_t>(m_operators.size() + 1)).first->second;
    }
    std::uint32_t gaugeKey(const std::string& name) {
        return m_gauges.emplace(name, static_cast<std::uint32_t>(m_gauges.size() + 1)).first->second;
    }

    dfq::Value& add(std::uint32_t characteristic, std::uint32_t row, std::optional<double> value, int attribute,
                    std::int64_t utc_ms, const std::vector<std::uint32_t>& events) {
        dfq::Value entry;
        entry.characteristic = characteristic;
        entry.row = row;
        entry.value = value;
        entry.attribute = attribute;
        entry.time = localTime(utc_ms);
        entry.events = events;
        entry.fields = {{1, value ? number(*value) : std::string{}},
                        {2, std::to_string(attribute)},
                        {4, dfq::timeText(*entry.time)},
                        {5, fmt::format("{}", fmt::join(events, ","))},
                        {6, m_history.lot.name},
                        {10, "1"}};
        m_file.values.push_back(std::move(entry));
        return m_file.values.back();
    }

    void identify(dfq::Value& value, const PartRow& part) const {
        value.fields.push_back(
            {14, part.serial.empty() ? fmt::format("{}/{}", part.lotName, part.number) : part.serial});
        value.fields.push_back({53, m_history.lot.name});
    }

    void addFigures(const PartRow& part, std::uint32_t row) {
        const PartJudgement judged = judgePart(part, m_quality.characteristics);
        for (std::size_t i = 0; i < judged.values.size(); ++i) {
            const auto& value = judged.values[i].value;
            const int attribute = !value ? dfq::kNoValue : part.complete ? dfq::kValid : dfq::kVoid;
            identify(add(static_cast<std::uint32_t>(i + 1), row, value, attribute, part.endedUtc_ms, {}), part);
        }
    }

    /// The row a void or correction ends the life of, and how it came about.
    [[nodiscard]] static const MeasurementRow* find(const PartRow& part, MeasurementId id) {
        const auto found = std::ranges::find(part.measurements, id, &MeasurementRow::id);
        return found == part.measurements.end() ? nullptr : &*found;
    }
    [[nodiscard]] static const MeasurementRow* replacement(const PartRow& part, MeasurementId id) {
        const auto found =
            std::ranges::find_if(part.measurements, [id](const MeasurementRow& row) { return row.replaces == id; });
        return found == part.measurements.end() ? nullptr : &*found;
    }

    void addBores(const PartRow& part, std::uint32_t row) {
        const bool changed = m_changed.contains(part.number);
        for (const MeasurementRow& measured : part.measurements) {
            if (measured.kind == MeasurementKind::Void || measured.station >= m_quality.characteristics.size()) {
                continue;
            }
            const MeasurementRow* next = replacement(part, measured.id);
            const bool voided = next != nullptr && next->kind == MeasurementKind::Void;
            const bool replaced = next != nullptr && !voided;
            if (replaced && m_content == DfqContent::Standing) {
                continue;
            }
            std::vector<std::uint32_t> events;
            std::string remark;
            const MeasurementRow* before =
                measured.kind == MeasurementKind::Correction ? find(part, *measured.replaces) : nullptr;
            if (before != nullptr) {
                events.push_back(kEventCorrected);
                remark = fmt::format("corrected from {} by {}: {}",
                                     before->diameter_mm ? number(*before->diameter_mm) : "nothing", measured.author,
                                     measured.reason);
            }
            if (voided) {
                events.push_back(kEventVoided);
                remark += fmt::format("{}voided by {}: {}", remark.empty() ? "" : "; ", next->author, next->reason);
            } else if (replaced) {
                remark += fmt::format("{}replaced by {}: {}", remark.empty() ? "" : "; ", next->author, next->reason);
            }
            if (changed) {
                events.push_back(kEventProcessChanged);
            }
            const bool valid = !voided && !replaced && part.complete;
            dfq::Value& value = add(measured.station + 1U, row, measured.diameter_mm, valid ? dfq::kValid : dfq::kVoid,
                                    measured.acceptedUtc_ms, events);
            value.fields.push_back({8, std::to_string(operatorKey(measured.author))});
            if (measured.source == MeasurementSource::Gauge && !measured.sourceName.empty()) {
                value.fields.push_back({12, std::to_string(gaugeKey(measured.sourceName))});
            } else if (measured.source == MeasurementSource::File) {
                remark += fmt::format("{}from file {}", remark.empty() ? "" : "; ", measured.sourceName);
            }
            m_gaugesOf[measured.station].insert(measured.source == MeasurementSource::Gauge ? measured.sourceName
                                                                                            : std::string());
            if (!remark.empty()) {
                value.fields.push_back({9, remark});
            }
            identify(value, part);
        }
    }

    const LotHistory& m_history;
    const LotQuality& m_quality;
    DfqContent m_content;
    const LotPart* m_only{nullptr};  ///< the file is of this part alone
    dfq::File m_file{};
    std::map<std::string, std::uint32_t> m_operators{};
    std::map<std::string, std::uint32_t> m_gauges{};
    std::map<std::uint8_t, std::set<std::string>> m_gaugesOf{};  ///< by station
    std::set<std::uint32_t> m_changed{};
};

}  // namespace

dfq::File lotDfq(const LotHistory& history, const LotQuality& quality, DfqContent content, std::optional<PartId> only) {
    return Builder(history, quality, content).run(only);
}

}  // namespace kerf
