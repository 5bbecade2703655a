// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/core/result.h"
#include "engine/core/subscription.h"

/// Lots of a process that is not boring (whose lots carry a law from part to part: boring_lots.h): so many parts of one
/// part type, begun with one revision of its recipe.
namespace kerf {

struct LotView {
    std::int64_t id{0};
    std::string name{};
    std::string partType{};
    std::uint32_t recipeRevision{0};  ///< what it was opened with; each part says its own
    std::uint32_t size{0};            ///< 0: not said
    std::string tool{};               ///< tool or insert; empty: not said
    std::string gauge{};
    std::string openedBy{};
    std::int64_t openedUtc_ms{0};
    std::optional<std::int64_t> closedUtc_ms{};
    std::string closedBy{};
};

/// A lot to be opened, of the part type that is in force.
struct NewLot {
    std::string name{};
    std::uint32_t size{0};
    std::string tool{};
    std::string gauge{};
};

class LotService {
 public:
    LotService() = default;
    LotService(const LotService&) = delete;
    LotService& operator=(const LotService&) = delete;
    virtual ~LotService() = default;

    /// Of this machine, newest first; open and closed.
    [[nodiscard]] virtual Result<std::vector<LotView>> lots() const = 0;
    /// Whose parts the next ones are; empty: of none. A lot of another part type waits until that is in force again.
    [[nodiscard]] virtual std::optional<LotView> current() const = 0;
    [[nodiscard]] virtual std::string partType() const = 0;

    /// Called when it is safely on disk and the engine has been told (or why not).
    using Done = std::function<void(const Result<void>&)>;
    virtual void open(const NewLot& lot, const std::string& author, Done done) = 0;
    /// Go on with an open lot of the part type in force.
    virtual void choose(std::int64_t lot, const std::string& author, Done done) = 0;
    /// Parts are of no lot from now on; the lot stays open.
    virtual void leave(const std::string& author, Done done) = 0;
    virtual void close(const std::string& author, const std::string& reason, Done done) = 0;

    [[nodiscard]] virtual std::unique_ptr<Subscription> onChanged(std::function<void()> changed) = 0;
};

}  // namespace kerf
