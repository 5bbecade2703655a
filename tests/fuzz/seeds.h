// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <random>
#include <string>
#include <vector>

namespace kerf::test {

/// Where a search begins: the fixtures, the examples that are installed, and records of loggers, each for the readers
/// that take its kind. `source`: the root of the source tree.
[[nodiscard]] std::vector<std::string> seedInputs(const std::string& source);

/// Another input made of one, as editors, loggers and cables spoil files: bytes changed, pieces lost, doubled, moved
/// from another input, words that mean something to a reader, another encoding, other separators.
[[nodiscard]] std::string mutated(const std::vector<std::string>& inputs, std::mt19937_64& random);

}  // namespace kerf::test
