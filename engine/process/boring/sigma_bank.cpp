// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/process/boring/sigma_bank.h"

#include <algorithm>
#include <cmath>

namespace kerf::boring {
namespace {

constexpr std::array<double, kSigmaFactors.size()> kPriorWeight{0.02, 0.08, 0.8, 0.08, 0.02};

}  // namespace

SigmaBank SigmaBank::from(const KalmanState& state) noexcept {
    SigmaBank bank;
    bank.states.fill(state);
    for (std::size_t i = 0; i < kPriorWeight.size(); ++i) {
        bank.lnWeight[i] = std::log(kPriorWeight[i]);
    }
    return bank;
}

std::size_t SigmaBank::inForce() const noexcept {
    return static_cast<std::size_t>(std::ranges::max_element(lnWeight) - lnWeight.begin());
}

SigmaBank update(const SigmaBank& before, const KalmanParams& params, const PartVisit& visit,
                 RowOutcome* outcome) noexcept {
    SigmaBank bank = before;
    std::array<RowOutcome, kSigmaFactors.size()> outcomes{};
    for (std::size_t i = 0; i < bank.states.size(); ++i) {
        KalmanParams candidate = params;
        candidate.sigma_mm = params.sigma_mm * kSigmaFactors[i];
        double lnEvidence = 0.0;
        bank.states[i] =
            update(before.states[i], candidate, visit, &outcomes[i], ChangeKnowledge::Unknown, &lnEvidence);
        bank.lnWeight[i] += lnEvidence;
    }
    if (outcome != nullptr) {
        *outcome = outcomes[bank.inForce()];
    }
    return bank;
}

}  // namespace kerf::boring
