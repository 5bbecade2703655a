// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/service/boring/bore_file.h"

#include <fmt/format.h>

#include <cmath>
#include <exception>

#include "app/files/table.h"

namespace kerf {
namespace {

constexpr double kMaxPart = 1e6;
constexpr double kMaxOverhang_mm = 1e5;
constexpr double kSmallest_mm = 1e-9;
constexpr double kMaxDiameter_mm = 1e5;

void readInto(const std::string& path, ReadBores& read) {
    files::Table table = files::Table::read(path);
    const bool places = table.has("overhang_mm");
    table.dropRowsWithGaps(places ? std::vector<std::string_view>{"part", "overhang_mm", "diameter_mm"}
                                  : std::vector<std::string_view>{"part", "diameter_mm"});
    table.requireRange("part", 1.0, kMaxPart);
    table.requireRange("diameter_mm", kSmallest_mm, kMaxDiameter_mm);
    if (places) {
        table.requireRange("overhang_mm", kSmallest_mm, kMaxOverhang_mm);
    }
    if (table.rows() == 0) {
        throw files::BadInput(fmt::format("{}: no diameters; expected at least one row under the header.", path));
    }
    const auto& part = table.column("part");
    const auto& diameter_mm = table.column("diameter_mm");
    for (std::size_t row = 0; row < table.rows(); ++row) {
        if (part[row] != std::floor(part[row])) {
            throw files::BadInput(fmt::format("{}{} is not a whole number; expected a part number from 1.",
                                              table.where(row, "part"), part[row]));
        }
        ReadBore bore{table.lineOf(row), static_cast<std::uint32_t>(part[row]), {}, diameter_mm[row]};
        if (places) {
            bore.overhang_mm = table.column("overhang_mm")[row];
        }
        read.rows.push_back(bore);
    }
    read.notes = table.notes();
}

}  // namespace

ReadBores readBores(const std::string& path) {
    ReadBores read;
    read.file = path.substr(path.find_last_of('/') + 1);
    try {
        readInto(path, read);
    } catch (const std::exception& fault) {  // BadInput, or no memory for it
        read.rows.clear();
        read.problem = fault.what();
    }
    return read;
}

}  // namespace kerf
