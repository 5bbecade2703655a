// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/headless/quality_lot.h"

#include <fmt/format.h>

#include <charconv>

#include "app/files/table.h"
#include "app/headless/data_file.h"
#include "app/service/boring/boring_memory.h"
#include "app/service/quality/stored_quality_service.h"

namespace kerf::headless {
namespace {

constexpr std::uint32_t kMostLots = 1'000'000;
constexpr std::uint32_t kMostParts = 10'000'000;

template <class Value>
Value valueOf(Result<Value> result, const std::string& path) {
    if (!result) {
        throw BadInput(fmt::format("{}: {}", path, result.error().english()));
    }
    return std::move(*result);
}

LotId idOf(const std::vector<LotRow>& lots, const std::string& wanted, const std::string& path) {
    std::vector<LotId> named;
    for (const LotRow& lot : lots) {
        if (lot.name == wanted) {
            named.push_back(lot.id);
        }
    }
    LotId number = 0;
    const auto [stop, error] = std::from_chars(wanted.data(), wanted.data() + wanted.size(), number);
    const bool isNumber = error == std::errc{} && stop == wanted.data() + wanted.size();
    if (named.empty() && isNumber) {
        for (const LotRow& lot : lots) {
            if (lot.id == number) {
                return number;
            }
        }
    }
    if (named.size() > 1) {
        throw BadInput(fmt::format("{}: {} lots are named '{}'; give the number instead: {}.", path, named.size(),
                                   wanted, fmt::join(named, ", ")));
    }
    if (named.empty()) {
        if (const ProcessDescriptor* process = findProcess(std::string_view(wanted));
            process != nullptr && !process->partResults.empty()) {
            return partsWithoutLot(process->id);
        }
        throw BadInput(
            fmt::format("{}: there is no lot '{}'; expected the name or number of a lot, or milling, turning "
                        "or tapping, whose parts belong to none.",
                        path, wanted));
    }
    return named.front();
}

}  // namespace

StoredLot storedLot(const std::string& folder, const std::string& lot) {
    const QtForSql qt;
    const std::string path = checkedDataFile(folder);
    const auto reader = openReader(path);
    const LotId id = idOf(valueOf(reader->lots(std::nullopt, kMostLots), path), lot, path);
    StoredLot stored;
    if (id < 0) {
        stored.history = valueOf(readQualityLot(*reader, id, kMostParts), path).history;
    } else {
        auto history = valueOf(reader->history(id), path);
        if (!history) {
            throw BadInput(fmt::format("{}: there is no lot '{}'.", path, lot));
        }
        stored.history = std::move(*history);
    }
    stored.limits = recipeLimits(*reader, *reader, stored.history.lot.process);
    if (id > 0) {
        stored.announced = valueOf(announcedIn(*reader, id), path);
    }
    return stored;
}

}  // namespace kerf::headless
