// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "app/files/table.h"
#include "engine/core/result.h"
#include "engine/process/milling/cut_simulation.h"

/// Files of the milling commands: plant constants (JSON) and blank profiles (CSV).
namespace kerf::headless {

/// Value of a result, or BadInput naming where the text came from.
template <class T>
[[nodiscard]] T checked(const std::string& where, const Result<T>& result) {
    if (!result) {
        throw BadInput(where + ": " + result.error().english());
    }
    return *result;
}

/// Every key optional, none unknown; what is absent keeps B0's value. @throws BadInput
void readMillingPlant(const std::string& path, milling::CutCase& cut);
/// The plant as a file that readMillingPlant() reads back.
void printMillingPlant(const milling::CutCase& cut);
/// x_mm,height_mm: each row begins a step; the last row's position ends the blank. `notes`: what was found out
/// rather than known, such as another unit. @throws BadInput
[[nodiscard]] milling::BlankProfile readBlank(const std::string& path, const ReadOptions& read = {},
                                              std::vector<std::string>* notes = nullptr);

}  // namespace kerf::headless
