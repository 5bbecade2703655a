// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "app/files/dfq.h"

/// What the keys of a description belong to.
namespace kerf::dfq {

[[nodiscard]] constexpr bool isOfPart(int key) noexcept {
    return key >= 1000 && key < 2000;
}
[[nodiscard]] constexpr bool isOfCharacteristic(int key) noexcept {
    return (key >= 2000 && key < 3000) || (key >= 8000 && key < 9000);
}
/// Decimals, nominal, limits, allowances, plausibility, subgroup: fields that hold a number.
[[nodiscard]] bool isNumeric(int key) noexcept;

/// Files put one behind the other: what stands from `begin` on describes the parts and characteristics in front of it
/// once more (nothing is changed, the result is 0), or others. Others are counted on behind the `before` known
/// characteristics, so that no value comes to stand under a description that is not its own; `/0` is spread over their
/// `count`. The result is what their numbers grew by.
[[nodiscard]] std::uint32_t countOn(std::vector<Entry>& entries, std::size_t begin, std::uint32_t before,
                                    std::uint32_t count);

}  // namespace kerf::dfq
