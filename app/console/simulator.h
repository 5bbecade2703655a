// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "engine/machine/simulated/simulated_boring.h"
#include "engine/machine/simulated/simulated_machine.h"
#include "engine/process/boring/boring_types.h"

namespace kerf::console {

/// The built-in machine as the console runs it, with the gauge an operator would hold in the bores.
class Simulator {
 public:
    struct Params {
        std::uint32_t partsSoFar{0};  ///< of what the machine is there for: bored, or turned
        std::uint64_t seed{1};
        double gaugeSigma_mm{0.005};     ///< standard deviation of one gauged deflection
        std::uint64_t machineSeed{0};    ///< a hard machine (boring::hardMachine); 0: the reference machine
        std::uint32_t changeAtPart{14};  ///< a new insert: the process is another one from here on; 0: never
        bool diamondLathe{false};        ///< the lathe with the .2 ms cycle; it does not bore
    };
    using Plants = std::vector<std::unique_ptr<SimulatedProcess>>;
    /// What a diameter means for the part type being made (boring, eq. 11).
    struct Bore {
        double targetDiameter_mm{50.0};
        double targetDeflection_mm{0.1165};
        double phi_deg{60.0};
    };
    /// A finished part as the console knows it.
    struct GaugedPart {
        std::int64_t id{0};         ///< the same before and after a restart: seed of the gauge's noise
        std::uint32_t sequence{0};  ///< the machine's count; 0: from an earlier run
        std::uint32_t bored{0};     ///< how many have ever been bored on this machine, this one included
        FeedTrace feed{};           ///< really cut
    };
    /// `plants`: of the processes beside boring.
    Simulator(const Params& params, Plants plants);

    [[nodiscard]] SimulatedMachine& machine() noexcept { return *m_machine; }
    /// What the gauge shows for a finished part; the same bore always reads the same. A bore of an earlier run is made
    /// again from the feed it was cut with, within the gauge's last digit. Empty: not finished, or nothing known of its
    /// feed.
    [[nodiscard]] std::optional<double> gaugeReading_mm(const GaugedPart& part, double overhang_mm, const Bore& bore);

 private:
    [[nodiscard]] std::optional<double> deflection_mm(const GaugedPart& part, double overhang_mm);

    Params m_params;
    SimulatedBoring* m_boring{nullptr};
    std::unique_ptr<SimulatedMachine> m_machine;
    std::map<std::uint32_t, BoredHole> m_holes;
};

}  // namespace kerf::console
