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
constexpr double kMaxPart = 1e6;

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
    m_firstRun = range.first;
    m_runs = range.runs;
    for (std::size_t row = 0; row < table.rows(); ++row) {
        m_rows.push_back({wholeNumber(table, row, "run") - m_firstRun + 1U, wholeNumber(table, row, "part"),
                          overhang_mm[row], z[row]});
    }
}

void NoiseFile::require(std::uint32_t runs, std::uint32_t parts, const std::vector<double>& overhangs_mm) {
    requireRuns(m_path, m_runs, runs);
    m_parts = parts;
    m_depths = overhangs_mm.size();
    m_z.assign(std::size_t{runs} * parts * m_depths,
               std::numeric_limits<double>::quiet_NaN());  // marks what is missing
    const auto place = [&](std::uint32_t run, std::uint32_t part, std::size_t depth) {
        return ((run - 1U) * std::size_t{m_parts} + (part - 1U)) * m_depths + depth;
    };
    for (const Row& row : m_rows) {
        const auto depth = std::ranges::find(overhangs_mm, row.overhang_mm);
        if (row.run <= runs && row.part <= parts && depth != overhangs_mm.end()) {
            m_z[place(row.run, row.part, static_cast<std::size_t>(depth - overhangs_mm.begin()))] = row.z;
        }
    }
    for (std::uint32_t run = 1; run <= runs; ++run) {
        for (std::uint32_t part = 1; part <= parts; ++part) {
            for (std::size_t depth = 0; depth < m_depths; ++depth) {
                if (std::isnan(m_z[place(run, part, depth)])) {
                    throw BadInput(
                        fmt::format("{}, column z: nothing for run {}, part {}, overhang {} mm; expected a row.",
                                    m_path, run + m_firstRun - 1U, part, overhangs_mm[depth]));
                }
            }
        }
    }
}

double NoiseFile::z(std::uint32_t run, std::uint32_t part, std::size_t depth) const {
    return m_z[((run - 1U) * std::size_t{m_parts} + (part - 1U)) * m_depths + depth];
}

TruthFile::TruthFile(const std::string& path) : m_path(path) {
    const Table table = Table::read(path);
    const auto& alpha = table.column("alpha");
    const auto& beta = table.column("beta");
    const auto& c_mm = table.column("c_mm");
    (void)table.column("run");
    (void)table.column("part");
    const RunRange range = runsOf(table, path);
    table.requireRange("alpha", 1e-3, 10.0);
    table.requireRange("beta", -10.0, 10.0);
    table.requireRange("c_mm", 1e-12, 1e6);
    m_firstRun = range.first;
    m_runs = range.runs;
    for (std::size_t row = 0; row < table.rows(); ++row) {
        m_rows.push_back({wholeNumber(table, row, "run") - m_firstRun + 1U,
                          wholeNumber(table, row, "part"),
                          {std::log(c_mm[row]), alpha[row], beta[row]}});
    }
}

std::vector<boring::TruthPlan> TruthFile::plans(std::uint32_t runs, std::uint32_t parts) const {
    requireRuns(m_path, m_runs, runs);
    std::vector<std::vector<std::optional<boring::LawConstants>>> laws(
        runs, std::vector<std::optional<boring::LawConstants>>(parts));
    for (const Row& row : m_rows) {
        if (row.run <= runs && row.part <= parts) {
            laws[row.run - 1U][row.part - 1U] = row.law;
        }
    }
    std::vector<boring::TruthPlan> out;
    for (std::uint32_t run = 0; run < runs; ++run) {
        boring::TruthPlan plan;
        plan.changes.clear();
        for (std::uint32_t part = 0; part < parts; ++part) {
            const auto& law = laws[run][part];
            if (!law) {
                throw BadInput(fmt::format("{}, column part: nothing for run {}, part {}; expected a row.", m_path,
                                           run + m_firstRun, part + 1U));
            }
            if (plan.changes.empty() || !(plan.changes.back().law == *law)) {
                plan.changes.push_back({part + 1U, *law});
            }
        }
        out.push_back(std::move(plan));
    }
    return out;
}

}  // namespace kerf::headless
