// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CLI/CLI.hpp>

/// The parts of `kerf quality`.
namespace kerf::headless {

void addQualityCharts(CLI::App& quality);
void addQualityCapability(CLI::App& quality);
void addQualityGaugeStudy(CLI::App& quality);
void addQualityDfq(CLI::App& quality);
void addQualityRunLength(CLI::App& quality);

}  // namespace kerf::headless
