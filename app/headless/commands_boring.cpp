// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/headless/commands_boring.h"

#include <cmath>

#include "app/files/output.h"
#include "app/files/slip.h"
#include "app/files/table.h"
#include "app/headless/commands.h"
#include "app/headless/read_options.h"
#include "engine/process/boring/lot_tracker.h"

namespace kerf::headless {
namespace {

constexpr double kMaxOverhang_mm = 1e5;
constexpr double kMaxFeed_mmPerRev = 1e3;
constexpr double kSmallest = 1e-9;

struct ReplayOptions {
    BoringOptions common{};
    std::string file{};
    double targetDiameter_mm{0.0};
    double phi_deg{boring::kTablePhi_deg};
    std::shared_ptr<files::ReadOptions> read{};
};

/// What a slipped value may have been meant as; empty without a guess.
std::string guess(double value_mm, double target_mm) {
    const auto slip = files::slipTo(value_mm, target_mm);
    return slip ? fmt::format(" {}", slip->guess) : std::string();
}

const char* valueColumn(const ReplayOptions& options, const Table& table) {
    return options.targetDiameter_mm > 0.0                                  ? "diameter_mm"
           : table.has(kSimulatedDeflection) && !table.has("deflection_mm") ? kSimulatedDeflection
                                                                            : "deflection_mm";
}

/// Rows of the file as the tracker takes them; the id of an entry is its row.
std::vector<boring::LotTracker::Entry> readMeasurements(const ReplayOptions& options, Table& table,
                                                        const boring::FeedLawParams& feed) {
    const bool diameters = options.targetDiameter_mm > 0.0;
    const char* valueName = valueColumn(options, table);
    if (diameters || valueName == kSimulatedDeflection) {
        // A bore without a value, or of which nobody knows how it was cut; what is computed must be there.
        table.dropRowsWithGaps({valueName, "overhang_mm", "feed_mm_per_rev"});
    }
    const auto& part = table.column("part");
    const auto& overhang_mm = table.column("overhang_mm");
    const auto& feed_mmPerRev = table.column("feed_mm_per_rev");
    const auto& value = table.column(valueName);
    table.requireRange("part", 1.0, kMaxPart);
    table.requireRange("overhang_mm", kSmallest, kMaxOverhang_mm);
    table.requireRange("feed_mm_per_rev", kSmallest, kMaxFeed_mmPerRev);
    if (const auto slipped = files::slippedStation(overhang_mm)) {
        files::askAbout(table, "overhang_mm", overhang_mm[slipped->row], slipped, options.read->acceptImplausible);
    }
    requireSpindleOverhang(table, overhang_mm, feed, options.read->acceptImplausible);
    if (table.rows() == 0) {
        throw BadInput(fmt::format("{}: no measurements; expected at least one row under the header.", table.file()));
    }
    std::vector<boring::LotTracker::Entry> entries;
    std::vector<std::uint8_t> rowsOfPart;
    for (std::size_t row = 0; row < table.rows(); ++row) {
        if (part[row] != std::floor(part[row])) {
            throw BadInput(fmt::format("{}{} is not a whole number; expected a part number from 1.",
                                       table.where(row, "part"), part[row]));
        }
        const double deflection_mm =
            diameters ? boring::deflectionFromDiameter_mm(value[row], options.targetDiameter_mm,
                                                          options.common.targetDeflection_mm, options.phi_deg)
                      : value[row];
        if (!(deflection_mm > 0.0)) {
            throw BadInput(
                diameters
                    ? fmt::format("{}{} means a deflection of {:.4f} mm; expected a bore that leaves it above 0.{}",
                                  table.where(row, valueName), value[row], deflection_mm,
                                  guess(value[row], options.targetDiameter_mm))
                    : fmt::format("{}{} is out of range; expected a deflection above 0.", table.where(row, valueName),
                                  value[row]));
        }
        const auto number = static_cast<std::uint32_t>(part[row]);
        rowsOfPart.resize(std::max<std::size_t>(rowsOfPart.size(), number + 1));
        if (++rowsOfPart[number] > kMaxBoreDepths) {
            throw BadInput(
                fmt::format("{}part {} stands more than {} times; expected at most {} measurements of one part.",
                            table.where(row, "part"), number, kMaxBoreDepths, kMaxBoreDepths));
        }
        const bool atLimit = feed_mmPerRev[row] <= feed.minFeed_mmPerRev || feed_mmPerRev[row] >= feed.maxFeed_mmPerRev;
        entries.push_back(
            {static_cast<std::int64_t>(row), number, {overhang_mm[row], feed_mmPerRev[row], deflection_mm, atLimit}});
    }
    return entries;
}

/// The console's own question, |ln(d/d_predicted)| against its limit, with what was known before the part.
void judgeRows(const ReplayOptions& options, const Table& table, const boring::LotTracker& tracker,
               const std::vector<boring::LotTracker::Entry>& entries) {
    const bool diameters = options.targetDiameter_mm > 0.0;
    const char* valueName = valueColumn(options, table);
    for (std::size_t row = 0; row < entries.size(); ++row) {
        const auto verdict =
            boring::judgeEntry(tracker.stateBefore(entries[row].part), tracker.params(), entries[row].measurement);
        if (verdict.verdict == boring::GateVerdict::Accept) {
            continue;
        }
        const double value = table.column(valueName)[row];
        const std::string what =
            diameters
                ? fmt::format("{}{} does not fit a target of {};{} {}", table.where(row, valueName), value,
                              options.targetDiameter_mm, guess(value, options.targetDiameter_mm),
                              verdict.reason.english())
                : fmt::format("{}{} cannot be meant: {}", table.where(row, valueName), value, verdict.reason.english());
        files::refuseUnless(options.read->acceptImplausible, table, what);
    }
}

void replay(const ReplayOptions& options) {
    const boring::EstimatorParams params = options.common.params();
    const boring::FeedLawParams feed = boring::feedLawParams(params.kind, options.common.targetDeflection_mm,
                                                             boring::FeedLawParams{}.firstFeed_mmPerRev);
    Table table = Table::read(options.file, *options.read);
    const auto entries = readMeasurements(options, table, feed);
    boring::LotTracker tracker(params);
    tracker.restore({}, entries);
    judgeRows(options, table, tracker, entries);
    if (!boring::estimateOf(tracker.state()).ready) {
        throw BadInput(
            fmt::format("{}, column overhang_mm: all measurements have the same overhang; expected two different ones "
                        "to begin with.",
                        options.file));
    }
    std::vector<const boring::RowOutcome*> results(entries.size());
    for (const auto& step : tracker.steps()) {
        for (std::size_t i = 0; i < step.visit.count; ++i) {
            results[static_cast<std::size_t>(step.ids[i])] = &step.rows[i];
        }
    }
    CsvOutput csv("part,overhang_mm,ln_c,alpha,beta,p00,p01,p02,p11,p12,p22,perturbed,next_feed_mm_per_rev");
    for (std::size_t row = 0; row < entries.size(); ++row) {
        const auto& measurement = entries[row].measurement;
        const boring::Estimate& estimate = results[row]->after;
        if (!estimate.ready) {  // the paper's estimator waits for a second overhang
            csv.row(entries[row].part, measurement.overhang_mm, "", "", "", "", "", "", "", "", "", false, "");
            continue;
        }
        const auto& p = estimate.covariance;
        const BoringSchedule next = boring::adviseFeed(estimate, feed).schedule;
        csv.row(entries[row].part, measurement.overhang_mm, estimate.law.lnC, estimate.law.alpha, estimate.law.beta,
                p[0], p[1], p[2], p[3], p[4], p[5], results[row]->perturbed,
                next.feed_mmPerRev(measurement.overhang_mm));
    }
    csv.flush();
    tellNotes(table);
}

}  // namespace

void requireSpindleOverhang(const files::Table& table, std::span<const double> overhang_mm,
                            const boring::FeedLawParams& feed, bool accepted) {
    if (const auto slip = files::slippedColumn(overhang_mm, feed.overhangFrom_mm, feed.overhangTo_mm)) {
        files::refuseUnless(accepted, table,
                            fmt::format("{}{} and all others lie outside {} to {} mm, where the spindle bores; {}",
                                        table.where(0, "overhang_mm"), overhang_mm[0], feed.overhangFrom_mm,
                                        feed.overhangTo_mm, slip->guess));
    }
}

void BoringOptions::addTo(CLI::App& command) {
    command.add_option("--estimator", estimator, "perturbation (the paper) or kalman (ours)")
        ->check(CLI::IsMember({"perturbation", "kalman"}))
        ->capture_default_str();
    command.add_option("--sigma-mm", sigma_mm, "standard deviation of a measured deflection, mm")
        ->check(CLI::Range(1e-6, 10.0))
        ->capture_default_str();
    command.add_option("--target-deflection-mm", targetDeflection_mm, "d0, mm")
        ->check(CLI::Range(1e-4, 100.0))
        ->capture_default_str();
    command
        .add_option(
            "--alpha0", alpha0,
            "exponent α by experience for eqs. 9-10 of the paper; kalman has its own prior (.55 ± .15) and ignores it")
        ->check(CLI::Range(1e-3, 1.0))
        ->capture_default_str();
}

boring::EstimatorKind BoringOptions::kind() const {
    return boring::estimatorOf(estimator).value();
}

boring::EstimatorParams BoringOptions::params() const {
    return boring::estimatorParams(kind(), sigma_mm, targetDeflection_mm, alpha0);
}

void addBoringReplay(CLI::App& boring) {
    auto options = std::make_shared<ReplayOptions>();
    CLI::App* command = boring.add_subcommand(
        "replay",
        "Run an estimator over measured bores.\n"
        "Input CSV: part,overhang_mm,feed_mm_per_rev,deflection_mm in measuring order (or diameter_mm with\n"
        "--target-diameter-mm: eq. 11). Output CSV, one row per input row: the estimate after it, whether it made the\n"
        "estimator notice a change, and the next part's feed at its overhang. perturbation takes the rows in the order "
        "of\n"
        "the file, kalman the parts in the order of their numbers (a late row counts where its part belongs).");
    command->add_option("file", options->file, "CSV file")->required();
    options->common.addTo(*command);
    command->add_option("--target-diameter-mm", options->targetDiameter_mm, "read diameter_mm against this target")
        ->check(CLI::Range(1e-3, 1e5));
    command->add_option("--phi-deg", options->phi_deg, "φ of eq. 11")
        ->check(CLI::Range(0.0, 89.0))
        ->capture_default_str();
    options->read = addReadOptions(*command);
    command->callback([options] { replay(*options); });
}

void addBoringCommands(CLI::App& kerf) {
    CLI::App* boring = kerf.add_subcommand("boring", "Feed of a boring spindle from post-process bore measurements");
    boring->require_subcommand(1);
    addBoringReplay(*boring);
    addBoringSimulate(*boring);
    addBoringTable(*boring);
    addBoringGcode(*boring);
    addBoringMemory(*boring);
    addBoringRobust(*boring);
}

}  // namespace kerf::headless
