// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <type_traits>

namespace kerf {

/// Whose work the next part is, by the numbers under which the data file keeps them. It goes to the engine with what a
/// part is cut with, and comes back on the part's record: nobody joins a part with a lot afterwards.
struct WorkOrder {
    std::int64_t lot{0};        ///< 0: of no lot
    std::int64_t recipe{0};     ///< the revision of the recipe; 0: none was kept (what the program brings along)
    std::uint32_t schedule{0};  ///< boring: revision of the feed schedule within its lot; 0 otherwise
    friend bool operator==(const WorkOrder&, const WorkOrder&) = default;
};
static_assert(std::is_trivially_copyable_v<WorkOrder>);

}  // namespace kerf
