// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/simulator.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "engine/boring/model.h"
#include "engine/core/random.h"

namespace kerf::console {
namespace {

constexpr std::size_t kHolesKept = 200;
constexpr std::int64_t kLatheCycle_ns = 200'000;  // force feedback at 5 kHz
constexpr double kGaugeStep_mm = 0.001;           // last digit of the gauge

std::vector<BoringTruth> truths(std::uint32_t changeAtPart) {
    std::vector<BoringTruth> list{BoringTruth{}};
    if (changeAtPart > 1) {
        list.push_back({changeAtPart, 0.7, 0.4, 0.15});  // the first change of the published experiment
    }
    return list;
}

}  // namespace

Simulator::Simulator(const Params& params, Plants plants) : m_params(params) {
    SimulatedMachine::Params machine;
    machine.partsSoFar = params.partsSoFar;
    if (params.diamondLathe) {
        machine.name = "Kerf diamond lathe";
        machine.cycle_ns = kLatheCycle_ns;
        machine.absentProcess =
            Sentence(KERF_TEXT("On the built-in machining centre: start the console with --machine simulator."));
    } else {
        machine.absentProcess =
            Sentence(KERF_TEXT("On the built-in diamond lathe: start the console with --machine diamond-lathe."));
        SimulatedBoring::Params boring;
        boring.truths = truths(params.changeAtPart);
        auto plant = std::make_unique<SimulatedBoring>(boring);
        m_boring = plant.get();
        plants.push_back(std::move(plant));
        std::ranges::rotate(plants, plants.end() - 1);  // before the plant of the heat, which sees what is cut
    }
    m_machine = std::make_unique<SimulatedMachine>(machine, std::move(plants));
}

std::optional<double> Simulator::gaugeReading_mm(std::uint32_t partSequence, double overhang_mm, const Bore& bore) {
    BoredHole hole;
    while (m_boring != nullptr && m_boring->holes().tryPop(hole)) {
        m_holes[hole.partSequence] = hole;
    }
    while (m_holes.size() > kHolesKept) {
        m_holes.erase(m_holes.begin());
    }
    const auto found = m_holes.find(partSequence);
    if (found == m_holes.end()) {
        return std::nullopt;
    }
    Random noise = Random(m_params.seed)
                       .stream(partSequence)
                       .stream(static_cast<std::uint64_t>(std::lround(overhang_mm * 1000.0)));
    const double deflection_mm = found->second.deflectionAt_mm(overhang_mm) + m_params.gaugeSigma_mm * noise.gauss();
    const double diameter_mm = boring::diameterFromDeflection_mm(deflection_mm, bore.targetDiameter_mm,
                                                                 bore.targetDeflection_mm, bore.phi_deg);
    return std::round(diameter_mm / kGaugeStep_mm) * kGaugeStep_mm;
}

}  // namespace kerf::console
