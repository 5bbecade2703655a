// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/core/process.h"

#include <algorithm>
#include <array>

namespace kerf {
namespace {

/// The processes of this program. Not in the cycle's way: it grows before there is one.
struct Table {
    std::array<const ProcessDescriptor*, kProcessPlaces> rows{};
    std::array<ProcessId, kProcessPlaces> ids{};
    std::size_t count{0};

    constexpr Table() {
        for (const ProcessDescriptor* process : kOwnProcesses) {
            rows[count] = process;
            ids[count] = static_cast<ProcessId>(count);
            ++count;
        }
    }
};

constinit Table g_table{};

}  // namespace

std::span<const ProcessDescriptor* const> processes() noexcept {
    return {g_table.rows.data(), g_table.count};
}

std::span<const ProcessId> allProcesses() noexcept {
    return {g_table.ids.data(), g_table.count};
}

bool fitProcess(const ProcessDescriptor& process) noexcept {
    if (g_table.count == kProcessPlaces || static_cast<std::size_t>(process.id) >= kProcessPlaces ||
        findProcess(process.id) != nullptr || findProcess(std::string_view(process.key)) != nullptr) {
        return false;
    }
    g_table.rows[g_table.count] = &process;
    g_table.ids[g_table.count] = process.id;
    ++g_table.count;
    return true;
}

const ProcessDescriptor* findProcess(ProcessId id) noexcept {
    const auto rows = processes();
    const auto found = std::ranges::find(rows, id, [](const ProcessDescriptor* row) { return row->id; });
    return found == rows.end() ? nullptr : *found;
}

const ProcessDescriptor* findProcess(std::string_view key) noexcept {
    const auto rows = processes();
    const auto found = std::ranges::find_if(rows, [key](const ProcessDescriptor* row) { return row->key == key; });
    return found == rows.end() ? nullptr : *found;
}

ProcessAuthority authorityOf(ProcessId id) noexcept {
    const ProcessDescriptor* process = findProcess(id);
    return process != nullptr ? process->may : ProcessAuthority{};
}

const char* processKey(ProcessId id) noexcept {
    const ProcessDescriptor* process = findProcess(id);
    return process != nullptr ? process->key : "";
}

}  // namespace kerf
