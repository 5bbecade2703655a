// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstdio>
#include <memory>
#include <string>

#include "app/files/table.h"
#include "app/headless/commands_boring.h"
#include "engine/process/boring/gcode_export.h"

namespace kerf::headless {
namespace {

struct GcodeOptions {
    BoringSchedule schedule{};
    boring::GcodeParams params{};
    std::string dialect{"linuxcnc"};
};

void exportGcode(GcodeOptions options) {
    options.params.dialect = options.dialect == "macro" ? boring::GcodeDialect::Macro : boring::GcodeDialect::LinuxCnc;
    const auto lines = boring::boringSubroutine(options.schedule, options.params);
    if (!lines) {
        throw BadInput(lines.error().english());
    }
    for (const std::string& one : *lines) {
        std::printf("%s\n", one.c_str());
    }
}

}  // namespace

void addBoringGcode(CLI::App& boring) {
    auto options = std::make_shared<GcodeOptions>();
    BoringSchedule& s = options->schedule;
    s.revision = 1;
    auto* command = boring.add_subcommand(
        "export-gcode",
        "A feed schedule as a G-code subroutine on stdout, for controls without a live link: segments of constant "
        "feed\n"
        "per revolution (G95), the feeds as macro variables from #101 on. Z0 is where the bore begins.");
    command->add_option("--ln-c", s.lnC, "ln C of the law d = C S^alpha L^beta (mm, mm/rev)");
    command->add_option("--alpha", s.alpha, "alpha, > 0");
    command->add_option("--beta", s.beta, "beta");
    command->add_option("--target-deflection", s.targetDeflection_mm, "d0, mm, > 0");
    command->add_option("--constant-feed", s.constantFeed_mmPerRev, "One feed throughout instead of the law, mm/rev");
    command->add_option("--min-feed", s.minFeed_mmPerRev, "Lowest feed, mm/rev")->capture_default_str();
    command->add_option("--max-feed", s.maxFeed_mmPerRev, "Highest feed, mm/rev")->capture_default_str();
    command->add_option("--from", s.overhangFrom_mm, "Overhang where the bore begins, mm")->capture_default_str();
    command->add_option("--to", s.overhangTo_mm, "Overhang where it ends, mm")->capture_default_str();
    command->add_option("--speed", s.spindleSpeed_rpm, "Spindle speed, rpm")->capture_default_str();
    command->add_option("--revision", s.revision, "Number written into the program")->capture_default_str();
    command->add_option("--dialect", options->dialect, "linuxcnc: o<name> sub; macro: O9010 … M99")
        ->check(CLI::IsMember({"linuxcnc", "macro"}))
        ->capture_default_str();
    command->add_option("--name", options->params.name, "linuxcnc: name of the subroutine")->capture_default_str();
    command->add_option("--number", options->params.number, "macro: number of the subroutine")->capture_default_str();
    command
        ->add_option("--deviation", options->params.deviation, "Largest share by which a segment misses the schedule")
        ->capture_default_str();
    command->callback([options] { exportGcode(*options); });
}

}  // namespace kerf::headless
