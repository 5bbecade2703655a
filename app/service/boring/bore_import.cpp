// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/service/boring/bore_import.h"

#include <algorithm>
#include <cmath>

namespace kerf {
namespace {

constexpr double kSameDiameter_mm = 1e-9;

using Row = BoreImportPlan::Row;

SentenceArg number(std::uint32_t value) {
    return SentenceArg(static_cast<double>(value), 0);
}

/// The depth a row means; else why there is none.
Result<std::uint8_t> depthOf(const LotRecords& records, const ServicePart& part, const ReadBore& bore) {
    const auto& depths = records.recipe().depths;
    const std::size_t measured = records.depthsOf(part);
    if (!bore.overhang_mm) {
        if (measured != 1) {
            return fail(KERF_TEXT("The file says nowhere at which depth this is: a column overhang_mm is missing."));
        }
        return std::uint8_t{0};
    }
    for (std::size_t depth = 0; depth < measured; ++depth) {
        if (std::abs(depths[depth].overhang_mm - *bore.overhang_mm) <= kSamePlace_mm) {
            return static_cast<std::uint8_t>(depth);
        }
    }
    return tl::unexpected(Sentence(KERF_TEXT("Part %1 is not measured at %2 mm."), number(part.number),
                                   SentenceArg(*bore.overhang_mm, 1)));
}

/// Finds out what every row means, before any of them is judged.
class Placing {
 public:
    Placing(const LotRecords& records, BoreImportPlan& plan) : m_records(records), m_plan(plan) {}

    void take(const ReadBore& bore) {
        const auto part = std::ranges::find(m_records.parts(), bore.part, &ServicePart::number);
        if (part == m_records.parts().end()) {
            refuse(bore, Sentence(KERF_TEXT("Part %1 is not in this lot."), number(bore.part)));
            return;
        }
        const auto depth = depthOf(m_records, *part, bore);
        if (!depth) {
            refuse(bore, depth.error());
            return;
        }
        const auto same = [&](double value_mm) { return std::abs(value_mm - bore.diameter_mm) <= kSameDiameter_mm; };
        if (const MeasurementRow* stored = m_records.measured(part->id, *depth)) {
            if (same(stored->diameter_mm.value_or(0.0))) {
                ++m_plan.known;
                return;
            }
            refuse(bore, Sentence(KERF_TEXT("Part %1 has %2 mm here already; correct that one instead."),
                                  number(bore.part), SentenceArg(stored->diameter_mm.value_or(0.0), 3)));
            return;
        }
        const auto twice = std::ranges::find_if(
            m_plan.rows, [&](const Row& row) { return row.part == part->id && row.depth == *depth; });
        if (twice != m_plan.rows.end()) {
            if (!same(twice->diameter_mm)) {
                refuse(bore,
                       Sentence(KERF_TEXT("Part %1 stands in the file twice, with %2 mm and %3 mm."), number(bore.part),
                                SentenceArg(twice->diameter_mm, 3), SentenceArg(bore.diameter_mm, 3)));
            }
            return;
        }
        m_plan.rows.push_back({bore.line, bore.part, part->id, *depth, bore.diameter_mm, false});
    }

 private:
    void refuse(const ReadBore& bore, const Sentence& reason) {
        if (!m_plan.refused) {
            m_plan.refused = BoreImportPlan::Finding{bore.line, reason};
        }
    }

    const LotRecords& m_records;
    BoreImportPlan& m_plan;
};

MeasurementRow measurementOf(const LotRecords& records, const Row& row) {
    MeasurementRow measurement;
    measurement.part = row.part;
    measurement.station = row.depth;
    measurement.position_mm = records.recipe().depths[row.depth].overhang_mm;
    measurement.diameter_mm = row.diameter_mm;
    measurement.source = MeasurementSource::File;
    measurement.confirmed = row.asked;
    return measurement;
}

}  // namespace

BoreImportPlan planBores(const LotRecords& records, const ReadBores& read) {
    BoreImportPlan plan;
    Placing placing(records, plan);
    for (const ReadBore& bore : read.rows) {
        placing.take(bore);
    }
    if (plan.refused) {
        return plan;
    }
    std::ranges::sort(plan.rows, [](const Row& a, const Row& b) {
        return a.partNumber != b.partNumber ? a.partNumber < b.partNumber : a.depth < b.depth;
    });
    LotRecords tried = records;
    MeasurementId id = 0;
    for (Row& row : plan.rows) {
        const EntryCheck verdict = tried.check(row.part, row.depth, row.diameter_mm);
        if (verdict.verdict == EntryVerdict::Refuse) {
            plan.refused = BoreImportPlan::Finding{row.line, verdict.reason};
            return plan;
        }
        row.asked = verdict.verdict == EntryVerdict::Ask;
        if (row.asked) {
            plan.questions.push_back({row.line, verdict.reason});
        }
        MeasurementRow measurement = measurementOf(records, row);
        measurement.id = --id;
        tried.addRow(measurement);
    }
    return plan;
}

std::vector<MeasurementRow> importRows(const LotRecords& records, const BoreImportPlan& plan, const std::string& file,
                                       const std::string& author) {
    std::vector<MeasurementRow> rows;
    for (const Row& row : plan.rows) {
        MeasurementRow& made = rows.emplace_back(measurementOf(records, row));
        made.id = -static_cast<MeasurementId>(rows.size());
        made.sourceName = file;
        made.author = author;
    }
    return rows;
}

}  // namespace kerf
