// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "app/files/table.h"
#include "app/headless/commands_boring.h"

namespace kerf::headless {
namespace {

constexpr double kMaxRun = 1e7;

std::uint32_t wholeNumber(const Table& table, std::size_t row, const char* name) {
    const double value = table.column(name)[row];
    if (value != std::floor(value)) {
        throw BadInput(fmt::format("{}{} is not a whole number; expected a count.", table.where(row, name), value));
    }
    return static_cast<std::uint32_t>(value);
}

struct RunRange {
    std::uint32_t first{1};
    std::uint32_t runs{0};
};

RunRange runsOf(const Table& table, const std::string& path) {
    table.requireRange("run", 0.0, kMaxRun);
    table.requireRange("part", 1.0, kMaxPart);
    if (table.rows() == 0) {
        throw BadInput(fmt::format("{}: no rows; expected one per run and part under the header.", path));
    }
    const auto& run = table.column("run");
    const auto [low, high] = std::ranges::minmax(run);
    const std::uint32_t first = low == 0.0 ? 0U : 1U;
    return {first, static_cast<std::uint32_t>(high) - first + 1U};
}

/// The lot of each row from 1; without a column lot it is 1 everywhere.
struct Lots {
    std::vector<std::uint32_t> ofRow{};
    std::uint32_t first{1}, count{1};
};

Lots lotsOf(const Table& table) {
    Lots lots;
    lots.ofRow.assign(table.rows(), 1);
    if (!table.has("lot")) {
        return lots;
    }
    table.requireRange("lot", 0.0, kMaxRun);
    const auto [low, high] = std::ranges::minmax(table.column("lot"));
    lots.first = low == 0.0 ? 0U : 1U;
    lots.count = static_cast<std::uint32_t>(high) - lots.first + 1U;
    for (std::size_t row = 0; row < table.rows(); ++row) {
        lots.ofRow[row] = wholeNumber(table, row, "lot") - lots.first + 1U;
    }
    return lots;
}

void requireRuns(const std::string& path, std::uint32_t have, std::uint32_t want) {
    if (have < want) {
        throw BadInput(fmt::format("{}, column run: {} runs; expected {}.", path, have, want));
    }
}

}  // namespace

NoiseFile::NoiseFile(const std::string& path) : m_path(path) {
    const Table table = Table::read(path);
    const auto& overhang_mm = table.column("overhang_mm");
    const auto& z = table.column("z");
    (void)table.column("run");
    (void)table.column("part");
    const RunRange range = runsOf(table, path);
    const Lots lots = lotsOf(table);
    m_firstRun = range.first;
    m_runs = range.runs;
    for (std::size_t row = 0; row < table.rows(); ++row) {
        m_rows.push_back({wholeNumber(table, row, "run") - m_firstRun + 1U, lots.ofRow[row],
                          wholeNumber(table, row, "part"), overhang_mm[row], z[row]});
    }
}

std::size_t NoiseFile::place(std::uint32_t run, std::uint32_t lot, std::uint32_t part, std::size_t depth) const {
    return (((run - 1U) * std::size_t{m_lots} + (lot - 1U)) * m_parts + (part - 1U)) * m_depths + depth;
}

void NoiseFile::require(const Wanted& wanted) {
    requireRuns(m_path, m_runs, wanted.runs);
    m_lots = wanted.lots;
    m_parts = wanted.parts;
    m_depths = std::max(wanted.firstPart_mm.size(), wanted.overhangs_mm.size());
    m_z.assign(std::size_t{wanted.runs} * m_lots * m_parts * m_depths,
               std::numeric_limits<double>::quiet_NaN());  // marks what is missing
    const auto depthsOf = [&](std::uint32_t part) -> const std::vector<double>& {
        return part == 1 ? wanted.firstPart_mm : wanted.overhangs_mm;
    };
    for (const Row& row : m_rows) {
        if (row.run > wanted.runs || row.lot > m_lots || row.part > m_parts) {
            continue;
        }
        const auto& depths_mm = depthsOf(row.part);
        const auto depth = std::ranges::find(depths_mm, row.overhang_mm);
        if (depth != depths_mm.end()) {
            m_z[place(row.run, row.lot, row.part, static_cast<std::size_t>(depth - depths_mm.begin()))] = row.z;
        }
    }
    for (std::uint32_t run = 1; run <= wanted.runs; ++run) {
        for (std::uint32_t lot = 1; lot <= m_lots; ++lot) {
            for (std::uint32_t part = 1; part <= m_parts; ++part) {
                const auto& depths_mm = depthsOf(part);
                for (std::size_t depth = 0; depth < depths_mm.size(); ++depth) {
                    if (std::isnan(m_z[place(run, lot, part, depth)])) {
                        throw BadInput(fmt::format(
                            "{}, column z: nothing for run {}, lot {}, part {}, overhang {} mm; expected a row.",
                            m_path, run + m_firstRun - 1U, lot, part, depths_mm[depth]));
                    }
                }
            }
        }
    }
}

double NoiseFile::z(std::uint32_t run, std::uint32_t lot, std::uint32_t part, std::size_t depth) const {
    return m_z[place(run, lot, part, depth)];
}

TruthFile::TruthFile(const std::string& path) : m_path(path) {
    const Table table = Table::read(path);
    const auto& alpha = table.column("alpha");
    const auto& beta = table.column("beta");
    const auto& c_mm = table.column("c_mm");
    (void)table.column("run");
    (void)table.column("part");
    const RunRange range = runsOf(table, path);
    const Lots lots = lotsOf(table);
    table.requireRange("alpha", 1e-3, 10.0);
    table.requireRange("beta", -10.0, 10.0);
    table.requireRange("c_mm", 1e-12, 1e6);
    m_firstRun = range.first;
    m_runs = range.runs;
    m_firstLot = lots.first;
    m_lots = lots.count;
    m_hasLots = table.has("lot");
    for (std::size_t row = 0; row < table.rows(); ++row) {
        m_rows.push_back({wholeNumber(table, row, "run") - m_firstRun + 1U,
                          lots.ofRow[row],
                          wholeNumber(table, row, "part"),
                          {std::log(c_mm[row]), alpha[row], beta[row]}});
    }
}

std::vector<std::vector<boring::TruthPlan>> TruthFile::plans(std::uint32_t runs, std::uint32_t lots,
                                                             std::uint32_t parts) const {
    requireRuns(m_path, m_runs, runs);
    const std::uint32_t own = m_hasLots ? lots : 1U;
    if (m_hasLots && m_lots < lots) {
        throw BadInput(fmt::format("{}, column lot: {} lots; expected {}.", m_path, m_lots, lots));
    }
    std::vector<std::optional<boring::LawConstants>> laws(std::size_t{runs} * own * parts);
    const auto place = [&](std::uint32_t run, std::uint32_t lot, std::uint32_t part) {
        return ((run - 1U) * std::size_t{own} + (lot - 1U)) * parts + (part - 1U);
    };
    for (const Row& row : m_rows) {
        if (row.run <= runs && row.lot <= own && row.part <= parts) {
            laws[place(row.run, row.lot, row.part)] = row.law;
        }
    }
    std::vector<std::vector<boring::TruthPlan>> out(runs);
    for (std::uint32_t run = 1; run <= runs; ++run) {
        for (std::uint32_t lot = 1; lot <= own; ++lot) {
            boring::TruthPlan plan;
            plan.changes.clear();
            for (std::uint32_t part = 1; part <= parts; ++part) {
                const auto& law = laws[place(run, lot, part)];
                if (!law) {
                    const std::string ofLot = m_hasLots ? fmt::format(", lot {}", lot + m_firstLot - 1U) : "";
                    throw BadInput(fmt::format("{}, column part: nothing for run {}{}, part {}; expected a row.",
                                               m_path, run + m_firstRun - 1U, ofLot, part));
                }
                if (plan.changes.empty() || !(plan.changes.back().law == *law)) {
                    plan.changes.push_back({part, *law});
                }
            }
            out[run - 1U].push_back(std::move(plan));
        }
        out[run - 1U].resize(lots, out[run - 1U].front());
    }
    return out;
}

AnnouncedFile::AnnouncedFile(const std::string& path, std::uint32_t firstRun, std::uint32_t firstLot) {
    const Table table = Table::read(path);
    (void)table.column("run");
    (void)table.column("lot");
    (void)table.column("part");
    table.requireRange("run", firstRun, kMaxRun);
    table.requireRange("lot", firstLot, kMaxRun);
    table.requireRange("part", 1.0, kMaxPart);
    for (std::size_t row = 0; row < table.rows(); ++row) {
        m_rows.push_back({wholeNumber(table, row, "run") - firstRun + 1U,
                          wholeNumber(table, row, "lot") - firstLot + 1U, wholeNumber(table, row, "part")});
    }
}

std::vector<boring::AnnouncedChange> AnnouncedFile::changes(std::uint32_t run, std::uint32_t lot) const {
    std::vector<boring::AnnouncedChange> out;
    for (const Row& row : m_rows) {
        if (row.run == run && row.lot == lot) {
            out.push_back({row.part, boring::StretchKind::Insert});
        }
    }
    return out;
}

}  // namespace kerf::headless
