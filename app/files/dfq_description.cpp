// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/files/dfq_description.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <map>
#include <tuple>
#include <utility>

namespace kerf::dfq {

bool isNumeric(int key) noexcept {
    constexpr std::array kNumeric{2022, 2100, 2101, 2110, 2111, 2112, 2113, 2120, 2121, 2130, 2131, 8500};
    return std::ranges::find(kNumeric, key) != kNumeric.end();
}

std::uint32_t countOn(std::vector<Entry>& entries, std::size_t begin, std::uint32_t before, std::uint32_t count) {
    const auto first = entries.begin() + static_cast<std::ptrdiff_t>(begin);
    const auto addressOf = [](const Entry& entry) {
        return std::tuple(entry.key, entry.index.value_or(1), entry.subIndex);
    };
    std::map<std::tuple<int, std::uint32_t, std::string>, std::string> known;
    std::uint32_t parts = 0;
    for (auto entry = entries.begin(); entry != first; ++entry) {
        known[addressOf(*entry)] = entry->text;
        parts = std::max(parts, isOfPart(entry->key) ? entry->index.value_or(1) : 0U);
    }
    const bool others = std::any_of(first, entries.end(), [&](const Entry& entry) {
        const auto found = known.find(addressOf(entry));
        return (isOfPart(entry.key) || isOfCharacteristic(entry.key)) && found != known.end() &&
               found->second != entry.text;
    });
    if (!others) {
        return 0;
    }
    const std::vector<Entry> own(std::make_move_iterator(first), std::make_move_iterator(entries.end()));
    entries.erase(first, entries.end());
    for (const Entry& entry : own) {
        const bool ofPart = isOfPart(entry.key);
        if (!ofPart && !isOfCharacteristic(entry.key)) {
            entries.push_back(entry);
            continue;
        }
        const std::uint32_t onto = ofPart ? parts : before;
        const bool all = entry.index == 0U;
        const std::uint32_t from = all ? 1 : entry.index.value_or(1);
        const std::uint32_t to = !all ? from : ofPart ? 1 : count;
        for (std::uint32_t i = from; i <= to; ++i) {
            entries.push_back({entry.key, onto + i, entry.subIndex, entry.text});
        }
    }
    return before;
}

}  // namespace kerf::dfq
