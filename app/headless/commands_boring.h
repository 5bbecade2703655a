// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CLI/CLI.hpp>
#include <span>
#include <string>
#include <vector>

#include "engine/process/boring/campaign.h"

/// What the boring commands share.
namespace kerf::files {
class Table;
}

namespace kerf::headless {

void addBoringReplay(CLI::App& boring);
void addBoringSimulate(CLI::App& boring);
void addBoringTable(CLI::App& boring);
void addBoringGcode(CLI::App& boring);
void addBoringMemory(CLI::App& boring);
void addBoringRobust(CLI::App& boring);

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

/// Largest number of a part in a file.
inline constexpr double kMaxPart = 1e6;
/// Of the rows that `kerf boring simulate --csv` writes.
inline constexpr const char* kSimulatedDeflection = "deflection_measured_mm";

/// A whole column of overhangs in inch, cm or m: all of them where no spindle bores, and all inside when read so.
/// @throws BadInput unless accepted
void requireSpindleOverhang(const files::Table& table, std::span<const double> overhang_mm,
                            const boring::FeedLawParams& feed, bool accepted);

/// Noise and truth files of `simulate`. Runs count from 1, or from 0 when the file's lowest run is 0.
class NoiseFile {
 public:
    /// @throws BadInput
    explicit NoiseFile(const std::string& path);
    [[nodiscard]] std::uint32_t runs() const noexcept { return m_runs; }
    [[nodiscard]] std::uint32_t firstRun() const noexcept { return m_firstRun; }
    /// Where the campaign will ask: `firstPart_mm` in part 1 (its own depths when it teaches), `overhangs_mm` after it.
    struct Wanted {
        std::uint32_t runs, lots, parts;
        std::vector<double> firstPart_mm, overhangs_mm;
    };
    /// Everything the campaign will ask for. A file without a column lot holds lot 1. @throws BadInput naming what is
    /// missing
    void require(const Wanted& wanted);
    /// Run and lot from 1. @pre require() has passed
    [[nodiscard]] double z(std::uint32_t run, std::uint32_t lot, std::uint32_t part, std::size_t depth) const;

 private:
    struct Row {
        std::uint32_t run, lot, part;
        double overhang_mm, z;
    };
    [[nodiscard]] std::size_t place(std::uint32_t run, std::uint32_t lot, std::uint32_t part, std::size_t depth) const;
    std::string m_path;
    std::vector<Row> m_rows;
    std::vector<double> m_z;  ///< run-major, then lot, part, depth
    std::uint32_t m_runs{0}, m_firstRun{1}, m_lots{1}, m_parts{0};
    std::size_t m_depths{0};
};

class TruthFile {
 public:
    /// @throws BadInput
    explicit TruthFile(const std::string& path);
    [[nodiscard]] std::uint32_t runs() const noexcept { return m_runs; }
    [[nodiscard]] std::uint32_t firstRun() const noexcept { return m_firstRun; }
    /// 1 when there is no column lot.
    [[nodiscard]] std::uint32_t lots() const noexcept { return m_lots; }
    /// Lots count from 1, or from 0 when the file's lowest lot is 0.
    [[nodiscard]] std::uint32_t firstLot() const noexcept { return m_firstLot; }
    /// The plans of each run, lot by lot; a change wherever the law differs from the part before. Without a column lot
    /// all lots of a run have the same one. @throws BadInput
    [[nodiscard]] std::vector<std::vector<boring::TruthPlan>> plans(std::uint32_t runs, std::uint32_t lots,
                                                                    std::uint32_t parts) const;

 private:
    struct Row {
        std::uint32_t run, lot, part;
        boring::LawConstants law;
    };
    std::string m_path;
    std::vector<Row> m_rows;
    std::uint32_t m_runs{0}, m_firstRun{1}, m_lots{1}, m_firstLot{1};
    bool m_hasLots{false};
};

/// Changes of insert that the operator announces: run, lot, part, the first part cut with the new one.
class AnnouncedFile {
 public:
    /// Runs and lots count as in the truth file: from `firstRun` and `firstLot`. @throws BadInput
    AnnouncedFile(const std::string& path, std::uint32_t firstRun, std::uint32_t firstLot);
    /// Run and lot from 1.
    [[nodiscard]] std::vector<boring::AnnouncedChange> changes(std::uint32_t run, std::uint32_t lot) const;

 private:
    struct Row {
        std::uint32_t run, lot, part;
    };
    std::vector<Row> m_rows;
};

}  // namespace kerf::headless
