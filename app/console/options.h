// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QSize>
#include <cstdint>
#include <optional>
#include <string>

#include "engine/port/machine_description.h"

namespace kerf::console {

/// What the command line asks of kerf-console.
struct Options {
    std::string dataDir{};  ///< empty: the user's data folder
    std::string machine{"simulator"};
    std::string machineFile{};       ///< how the machine is described; empty: not at all
    MachineDescription described{};  ///< as that file says
    std::string replayFile{};        ///< of --machine replay: the recorded day
    std::string sensors{};           ///< sensor file of the machine; empty: only what the machine itself brings
    double simulationSpeed{20.0};    ///< simulator only
    std::uint64_t seed{1};           ///< of the simulator's noise
    std::uint64_t machineSeed{0};    ///< simulator: a hard machine drawn from this seed; 0: the reference machine
    std::string season{"none"};      ///< simulator: what is different today (thermal::kSeasonKeys)
    std::uint32_t changeAtPart{14};  ///< simulator: from this part on another insert cuts, another process; 0: never
    std::uint32_t lotSize{30};       ///< of a lot opened by this start
    std::uint32_t preparedParts{6};  ///< simulator, empty database: parts bored and measured before the operator comes
    bool autoOperator{false};        ///< simulator: bores are measured and entered by themselves
    std::string language{};          ///< "en", "ko"; empty: as last time
    std::string theme{};             ///< "light", "dark"; empty: as last time
    std::string unit{};              ///< "mm", "inch"; empty: as last time
    std::optional<QSize> size{};
    bool fullScreen{false};
    std::string screenshotDir{};   ///< not empty: render every page to PNG there and end
    bool timeStart{false};         ///< say when the first page has been painted with its content, and end
    bool ownThread{true};          ///< false: whoever made the console runs the engine's cycles itself (tests)
    bool printAcceptances{false};  ///< print one line per accepted measurement once it is on disk
};

/// Exit code in `exitCode` when the program should end at once (--help, wrong usage).
[[nodiscard]] std::optional<Options> parseOptions(int argc, char** argv, int& exitCode);

}  // namespace kerf::console
