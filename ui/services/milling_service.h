// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "engine/core/result.h"
#include "engine/core/subscription.h"
#include "engine/process/milling/milling_fields.h"
#include "ui/services/lot_service.h"
#include "ui/services/recipe_history.h"

/// What belongs to milling outside the cycle: part types with their setup and blank profile, the tool in the spindle,
/// the log of cuts. The page sees values; the service stores first, then hands the engine what it is to use.
namespace kerf {

/// One cut of the log.
struct MillingCutView {
    std::int64_t id{0};       ///< the part, as it is stored
    std::uint32_t number{0};  ///< in its lot, or among those of no lot
    std::string lot{};        ///< empty: of none
    bool complete{false};
    bool withThisTool{false};
    MillingCut cut{};
};

/// A tool that was in the spindle before, as a new one of its kind may begin from it.
struct MillingToolView {
    std::int64_t since{0};  ///< its identity: the last part cut before it
    std::uint32_t parts{0};
    std::string partType{};
    double firstStiffness{0.0};  ///< ln(C b) of its first part
    double kx_NPerMm{0.0};
    bool leftOut{false};
    std::string reason{}, author{};  ///< of leaving it out or taking it in again
};

/// A quantity of the next tool with its 95 % interval.
struct MillingExpected {
    double mean{0.0};
    double half95{0.0};
    std::uint32_t tools{0};  ///< that it rests on
};

/// What a new tool begins from; empty: what every machine begins with.
struct MillingMemoryView {
    std::vector<MillingToolView> tools{};        ///< of this radius and these flutes, newest first
    std::optional<MillingExpected> lnKx{};       ///< k_x in N/mm
    std::optional<MillingExpected> stiffness{};  ///< ln(C b) of the first part
    bool used{false};                            ///< the tool in the spindle began so
};

/// Everything the milling page shows that is not live. Rebuilt after each change; cheap to copy.
struct MillingServiceView {
    std::uint64_t revision{0};  ///< rises with each change
    std::string partType{};
    std::vector<std::string> partTypes{};  ///< all that are stored, by name
    MillingSetup setup{};
    MillingBlank blank{};
    std::string blankSource{};           ///< file it was imported from; empty: typed
    std::vector<MillingCutView> cuts{};  ///< the last ones, oldest first
    MillingMemoryView memory{};
    bool busy{false};    ///< a change is being stored
    Sentence problem{};  ///< what could not be stored or used; empty when all is well
};

/// One step of a blank profile as it is typed.
struct MillingBlankStep {
    double begin_mm{0.0};
    double height_mm{0.0};
};

class MillingService {
 public:
    MillingService() = default;
    MillingService(const MillingService&) = delete;
    MillingService& operator=(const MillingService&) = delete;
    virtual ~MillingService() = default;

    [[nodiscard]] virtual const MillingServiceView& view() const = 0;
    /// Every number of a setup that a person can change.
    [[nodiscard]] virtual std::span<const MillingField> fields() const = 0;

    /// Empty when it can be used; else what is wrong with it.
    [[nodiscard]] virtual std::optional<Sentence> whyUnusable(const MillingSetup& setup) const = 0;
    /// Steps with strictly rising begins, the last one ending at `end_mm`; no steps: no profile.
    [[nodiscard]] virtual Result<MillingBlank> blankOf(std::span<const MillingBlankStep> steps,
                                                       double end_mm) const = 0;
    /// A CSV file "begin_mm,height_mm" with a last row "end_mm,". The error names line and column.
    [[nodiscard]] virtual Result<MillingBlank> readBlank(const std::string& file) const = 0;

    /// The revisions of the part type's setup. Null: there is no store behind the service.
    [[nodiscard]] virtual RecipeHistory* recipes() { return nullptr; }
    /// The lots of milling. Null: there is no store behind the service.
    [[nodiscard]] virtual LotService* lots() { return nullptr; }

    /// Called on the caller's thread when the change is safely on disk and the engine uses it (or why not).
    using Done = std::function<void(const Result<void>&)>;
    virtual void saveSetup(const MillingSetup& setup, const std::string& author, const std::string& reason,
                           Done done) = 0;
    virtual void saveBlank(const MillingBlank& blank, const std::string& source, const std::string& author,
                           Done done) = 0;
    /// Go on with another part type; a new name begins with the present setup and no blank profile.
    virtual void choosePartType(const std::string& name, const std::string& author, Done done) = 0;
    /// Wear and tool stiffness are learnt anew, from what the tools of its kind before have shown.
    virtual void newTool(const std::string& author, Done done) = 0;

    /// Leave a tool before out of that, or take it in again; a reason is needed.
    virtual void leaveOut(std::int64_t since, bool out, const std::string& author, const std::string& reason,
                          Done done) = 0;

    /// `changed` runs on the GUI thread after every new view; the handle ends the subscription when destroyed.
    [[nodiscard]] virtual std::unique_ptr<Subscription> onChanged(std::function<void()> changed) = 0;
};

}  // namespace kerf
