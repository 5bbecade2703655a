// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <vector>

#include "db/api/part_reader.h"

namespace kerf::test {

/// Parts in memory: newest first, in pages, searched by lot name. Fails on demand.
class FakePartReader : public PartReader {
 public:
    explicit FakePartReader(std::uint32_t count = 0) {
        for (std::uint32_t i = 1; i <= count; ++i) {
            add(i);
        }
    }
    PartDetail& add(std::uint32_t number, const std::string& lot = "12") {
        PartDetail detail;
        detail.part.id = static_cast<PartId>(details.size()) + 101;
        detail.part.lot = 1;
        detail.part.lotName = lot;
        detail.part.partTypeName = "Bearing bracket 50 H7";
        detail.part.number = number;
        detail.part.endedUtc_ms = 1'790'000'000'000 + 180'000LL * number;
        detail.part.machineEnd_ns = 96'000'000'000;
        BoringSchedule schedule;
        schedule.revision = number;
        schedule.lnC = -2.44;
        schedule.alpha = 0.5025;
        schedule.beta = 0.2676;
        schedule.targetDeflection_mm = 0.1165;
        detail.schedule = ScheduleRow{};
        detail.schedule->schedule = schedule;
        detail.feed.count = kFeedTracePoints;
        for (std::size_t i = 0; i < kFeedTracePoints; ++i) {
            const double overhang_mm = 40.0 + 270.0 * static_cast<double>(i) / (kFeedTracePoints - 1);
            detail.feed.overhang_mm[i] = static_cast<float>(overhang_mm);
            detail.feed.feed_mmPerRev[i] = static_cast<float>(schedule.feed_mmPerRev(overhang_mm) * 0.99);
        }
        measure(detail, 0, 50.011);
        measure(detail, 1, 50.008);
        details.push_back(detail);
        return details.back();
    }
    MeasurementRow& measure(PartDetail& detail, std::uint8_t station, std::optional<double> diameter_mm,
                            MeasurementKind kind = MeasurementKind::Entry, std::optional<MeasurementId> replaces = {},
                            const std::string& reason = {}) {
        MeasurementRow row;
        row.id = ++m_lastMeasurement;
        row.part = detail.part.id;
        row.kind = kind;
        row.replaces = replaces;
        row.station = station;
        row.position_mm = station == 0 ? 40.0 : 310.0;
        row.diameter_mm = diameter_mm;
        row.author = "Kim";
        row.reason = reason;
        row.acceptedUtc_ms = detail.part.endedUtc_ms + 60'000;
        detail.part.measurements.push_back(row);
        return detail.part.measurements.back();
    }

    Result<std::vector<PartRow>> parts(const PartQuery& query) override {
        ++queries;
        if (!failWith.empty()) {
            return tl::unexpected<Sentence>(failWith);
        }
        std::vector<PartRow> rows;
        for (auto it = details.rbegin(); it != details.rend() && rows.size() < query.limit; ++it) {
            if (matches(*it, query) && (!query.before || it->part.id < *query.before)) {
                rows.push_back(it->part);
            }
        }
        return rows;
    }
    Result<std::uint64_t> count(const PartQuery& query, std::uint64_t atMost) override {
        if (!failWith.empty()) {
            return tl::unexpected<Sentence>(failWith);
        }
        const auto count =
            std::count_if(details.begin(), details.end(), [&](const auto& d) { return matches(d, query); });
        return std::min(atMost, static_cast<std::uint64_t>(count));
    }
    Result<std::optional<PartDetail>> part(PartId id) override {
        if (!failWith.empty()) {
            return tl::unexpected<Sentence>(failWith);
        }
        const auto found =
            std::find_if(details.begin(), details.end(), [id](const auto& d) { return d.part.id == id; });
        return found == details.end() ? std::nullopt : std::optional(*found);
    }

    std::vector<PartDetail> details{};
    Sentence failWith{};
    int queries{0};

 private:
    static bool matches(const PartDetail& detail, const PartQuery& query) {
        return query.text.empty() || detail.part.lotName.find(query.text) != std::string::npos ||
               detail.part.partTypeName.find(query.text) != std::string::npos;
    }

    MeasurementId m_lastMeasurement{0};
};

}  // namespace kerf::test
