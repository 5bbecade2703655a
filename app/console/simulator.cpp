// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/simulator.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "engine/core/random.h"
#include "engine/process/boring/model.h"
#include "engine/process/boring/plant.h"

namespace kerf::console {
namespace {

constexpr std::size_t kHolesKept = 200;
constexpr std::int64_t kLatheCycle_ns = 200'000;  // force feedback at 5 kHz
constexpr double kGaugeStep_mm = 0.001;           // last digit of the gauge

/// The hard machine's law with its own change, or the reference one with the change asked for.
std::vector<BoringTruth> truths(std::uint64_t machineSeed, std::uint32_t changeAtPart) {
    if (machineSeed != 0) {
        std::vector<BoringTruth> list;
        for (const auto& change : boring::hardMachine(machineSeed, boring::kTableTargetDeflection_mm).truth.changes) {
            list.push_back({change.fromPart, change.law.alpha, change.law.beta, std::exp(change.law.lnC)});
        }
        return list;
    }
    std::vector<BoringTruth> list{BoringTruth{}};
    if (changeAtPart > 1) {
        list.push_back({changeAtPart, 0.7, 0.4, 0.15});  // the first change of the published experiment
    }
    return list;
}

}  // namespace

Simulator::Simulator(const Params& params, Plants plants) : m_params(params) {
    if (params.machineSeed != 0) {
        m_params.gaugeSigma_mm *=
            boring::hardMachine(params.machineSeed, boring::kTableTargetDeflection_mm).sigmaFactor;
    }
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
        boring.truths = truths(params.machineSeed, params.changeAtPart);
        boring.boredSoFar = params.partsSoFar;
        auto plant = std::make_unique<SimulatedBoring>(boring);
        m_boring = plant.get();
        plants.push_back(std::move(plant));
        std::ranges::rotate(plants, plants.end() - 1);  // before the plant of the heat, which sees what is cut
    }
    m_machine = std::make_unique<SimulatedMachine>(machine, std::move(plants));
}

std::optional<double> Simulator::deflection_mm(const GaugedPart& part, double overhang_mm) {
    BoredHole hole;
    while (m_boring != nullptr && m_boring->holes().tryPop(hole)) {
        m_holes[hole.partSequence] = hole;
    }
    while (m_holes.size() > kHolesKept) {
        m_holes.erase(m_holes.begin());
    }
    if (const auto found = m_holes.find(part.sequence); part.sequence != 0 && found != m_holes.end()) {
        return found->second.deflectionAt_mm(overhang_mm);
    }
    if (part.feed.count == 0) {
        return std::nullopt;
    }
    const std::vector<BoringTruth> all = truths(m_params.machineSeed, m_params.changeAtPart);
    const BoringTruth& truth = truthOf(all, part.bored);
    BoredHole again;
    again.count = std::min<std::uint16_t>(part.feed.count, BoredHole::kStations);
    for (std::size_t i = 0; i < again.count; ++i) {
        again.overhang_mm[i] = part.feed.overhang_mm[i];
        again.deflection_mm[i] = static_cast<float>(trueDeflection_mm(
            truth, static_cast<double>(part.feed.feed_mmPerRev[i]), static_cast<double>(part.feed.overhang_mm[i])));
    }
    return again.deflectionAt_mm(overhang_mm);
}

std::optional<double> Simulator::gaugeReading_mm(const GaugedPart& part, double overhang_mm, const Bore& bore) {
    const std::optional<double> true_mm = deflection_mm(part, overhang_mm);
    if (!true_mm) {
        return std::nullopt;
    }
    Random noise = Random(m_params.seed)
                       .stream(static_cast<std::uint64_t>(part.id))
                       .stream(static_cast<std::uint64_t>(std::lround(overhang_mm * 1000.0)));
    const double shown_mm = *true_mm + m_params.gaugeSigma_mm * noise.gauss();
    const double diameter_mm =
        boring::diameterFromDeflection_mm(shown_mm, bore.targetDiameter_mm, bore.targetDeflection_mm, bore.phi_deg);
    return std::round(diameter_mm / kGaugeStep_mm) * kGaugeStep_mm;
}

}  // namespace kerf::console
