// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "engine/process/boring/campaign.h"

/// What the boring commands share.
namespace kerf::headless {

void addBoringReplay(CLI::App& boring);
void addBoringSimulate(CLI::App& boring);
void addBoringTable(CLI::App& boring);
void addBoringGcode(CLI::App& boring);

/// Options every boring command understands.
struct BoringOptions {
    std::string estimator{"kalman"};
    double sigma_mm{boring::kTableSigma_mm};
    double targetDeflection_mm{boring::kTableTargetDeflection_mm};
    double alpha0{0.5};

    void addTo(CLI::App& command);
    [[nodiscard]] boring::EstimatorKind kind() const;
    [[nodiscard]] boring::EstimatorParams params() const;
};

/// Noise and truth files of `simulate`. Runs count from 1, or from 0 when the file's lowest run is 0.
class NoiseFile {
 public:
    /// @throws BadInput
    explicit NoiseFile(const std::string& path);
    [[nodiscard]] std::uint32_t runs() const noexcept { return m_runs; }
    [[nodiscard]] std::uint32_t firstRun() const noexcept { return m_firstRun; }
    /// Everything the campaign will ask for. @throws BadInput naming what is missing
    void require(std::uint32_t runs, std::uint32_t parts, const std::vector<double>& overhangs_mm);
    /// Run from 1. @pre require() has passed
    [[nodiscard]] double z(std::uint32_t run, std::uint32_t part, std::size_t depth) const;

 private:
    struct Row {
        std::uint32_t run, part;
        double overhang_mm, z;
    };
    std::string m_path;
    std::vector<Row> m_rows;
    std::vector<double> m_z;  ///< run-major, then part, then depth
    std::uint32_t m_runs{0}, m_firstRun{1}, m_parts{0};
    std::size_t m_depths{0};
};

class TruthFile {
 public:
    /// @throws BadInput
    explicit TruthFile(const std::string& path);
    [[nodiscard]] std::uint32_t runs() const noexcept { return m_runs; }
    [[nodiscard]] std::uint32_t firstRun() const noexcept { return m_firstRun; }
    /// The plan of each run, a change wherever the law differs from the part before. @throws BadInput
    [[nodiscard]] std::vector<boring::TruthPlan> plans(std::uint32_t runs, std::uint32_t parts) const;

 private:
    struct Row {
        std::uint32_t run, part;
        boring::LawConstants law;
    };
    std::string m_path;
    std::vector<Row> m_rows;
    std::uint32_t m_runs{0}, m_firstRun{1};
};

}  // namespace kerf::headless
