// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <map>

#include "app/service/boring/lot_records.h"
#include "ui/services/boring_service.h"

namespace kerf {

/// What the page of a lot is made from. The references must outlive the call of boringView().
struct BoringViewBasis {
    const LotRow& lot;
    const LotRecords& records;
    /// By schedule revision, as made before the cut.
    const std::map<std::uint32_t, Predictions>& predictions;
    std::uint32_t recipeRevision{0};
    boring::EstimatorKind kind{boring::EstimatorKind::Kalman};
    BoringSchedule next{};
    bool accepted{false};        ///< the next schedule has been
    bool showsAnnounced{false};  ///< the lot draws on earlier ones, so that announced changes count
};

/// The lot as the Boring page shows it: its newest 25 parts, the law's coefficients after each with 95 % intervals, the
/// next schedule, and the worst Cpk over the shown parts of any depth. Revision and store problem are the caller's.
[[nodiscard]] BoringServiceView boringView(const BoringViewBasis& basis);

}  // namespace kerf
