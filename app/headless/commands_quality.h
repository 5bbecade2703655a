// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CLI/CLI.hpp>
#include <cstddef>
#include <vector>

/// The parts of `kerf quality`.
namespace kerf::headless {

class LabelledTable;

/// A value a decade or an inch away from all others. @throws BadInput unless accepted
void askAboutSlips(const LabelledTable& table, std::size_t column, const std::vector<double>& values, bool accepted);

void addQualityCharts(CLI::App& quality);
void addQualityCapability(CLI::App& quality);
void addQualityGaugeStudy(CLI::App& quality);
void addQualityDfq(CLI::App& quality);
void addQualityRunLength(CLI::App& quality);

}  // namespace kerf::headless
