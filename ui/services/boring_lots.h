// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "engine/core/param_spec.h"
#include "ui/services/boring_service.h"

/// Which lot is bored, of which part type, by which recipe. The page sees values; every change is stored first.
namespace kerf {

using LotId = std::int64_t;
using PartTypeId = std::int64_t;

/// A recipe as a page edits it.
struct BoringRecipeForm {
    std::vector<double> values{};     ///< one per BoringLots::recipeSpecs(), in that order, in stored units
    std::vector<DepthView> depths{};  ///< where the bore is measured, in measuring order
};

struct BoringPartTypeView {
    PartTypeId id{0};
    std::string name{};
};

/// Revisions are never changed; a roll back is a new one.
struct BoringRecipeView {
    std::uint32_t revision{0};
    std::optional<std::uint32_t> restoredFrom{};
    std::string author{};
    std::string reason{};
    std::int64_t createdUtc_ms{0};
    BoringRecipeForm form{};
};

/// One number that differs between two revisions; a depth has its place (1, 2 …) in `depth`, a parameter its spec.
struct BoringRecipeChange {
    const ParamSpec* spec{nullptr};
    std::uint32_t depth{0};
    std::optional<double> before{};  ///< empty: not there
    std::optional<double> after{};
};

struct BoringLotView {
    LotId id{0};
    PartTypeId partType{0};
    std::string partTypeName{};
    std::string name{};
    std::uint32_t size{0};  ///< 0: no limit
    std::string estimator{};
    std::int64_t openedUtc_ms{0};
    bool closed{false};
    bool current{false};
    std::string insertGrade{};  ///< as told when it was opened
    std::string material{};
    std::uint32_t partsWaiting{0};  ///< of the newest lots: finished parts without all their diameters
};

/// A lot to be opened. The newest recipe of the part type holds for it, and stays with it.
struct BoringLotOrder {
    PartTypeId partType{0};
    std::string name{};
    std::uint32_t size{30};
    std::string estimator{"kalman"};  ///< "kalman", "perturbation"
    std::string author{};
    std::string insertGrade{};  ///< what memory goes by, beside machine and part type; may be empty
    std::string material{};
};

/// A lot that the next one begins from, and how much it counts.
struct BoringMemoryLotView {
    LotId lot{0};
    std::string partType{}, name{}, insertGrade{}, material{};
    std::uint32_t tools{0};  ///< stretches with one and the same tool
    double share{0.0};       ///< of the expected bending; 0 when left out
    bool leftOut{false};
    std::string reason{};   ///< why it was left out or taken in again
    std::string machine{};  ///< of another console's lot in the shop: on which machine; empty: on this one
    std::string console{};  ///< and in which console's history
};

/// Which lot of memory.
struct BoringMemoryKey {
    LotId lot{0};
    std::string console{};  ///< empty: this one
};

/// The lots of this machine. GUI thread. `Done` runs on it when the change is on disk, or has failed and why; when a
/// lot was opened or chosen, the boring service shows it by then.
class BoringLots {
 public:
    static constexpr std::uint32_t kMostParts = 100'000;

    BoringLots() = default;
    BoringLots(const BoringLots&) = delete;
    BoringLots& operator=(const BoringLots&) = delete;
    virtual ~BoringLots() = default;

    using Done = std::function<void(const Result<void>&)>;
    using PartTypeDone = std::function<void(const Result<PartTypeId>&)>;

    [[nodiscard]] virtual std::span<const ParamSpec> recipeSpecs() const = 0;
    [[nodiscard]] virtual BoringRecipeForm standardRecipe() const = 0;
    /// Empty when the recipe can be used.
    [[nodiscard]] virtual std::optional<Sentence> whyUnusable(const BoringRecipeForm& form) const = 0;

    [[nodiscard]] virtual Result<std::vector<BoringPartTypeView>> partTypes() = 0;
    /// Newest first.
    [[nodiscard]] virtual Result<std::vector<BoringRecipeView>> recipes(PartTypeId partType) = 0;
    /// Newest first, of all part types on this machine.
    [[nodiscard]] virtual Result<std::vector<BoringLotView>> lots() = 0;
    /// What changes from one to the other, in the order of the specs, depths last.
    [[nodiscard]] virtual std::vector<BoringRecipeChange> compare(const BoringRecipeForm& before,
                                                                  const BoringRecipeForm& after) const = 0;

    /// Why no other lot can be taken at this moment (a part is in the machine); empty when one can.
    [[nodiscard]] virtual std::optional<Sentence> whyNoOther() const = 0;
    /// Refused when the name is empty or taken by another lot of the part type.
    virtual void open(const BoringLotOrder& order, Done done) = 0;
    /// Go on with an earlier lot, for a bore that still wants its diameter.
    virtual void choose(LotId lot, const std::string& author, Done done) = 0;
    /// What the current lot begins from: every measured lot before it, newest first; then other machines' lots.
    [[nodiscard]] virtual Result<std::vector<BoringMemoryLotView>> memory() = 0;
    /// Leaves a lot out of memory, or takes it in again; the current lot is computed anew. Reason and author must not
    /// be empty.
    virtual void leaveOut(const BoringMemoryKey& lot, bool out, const std::string& author, const std::string& reason,
                          Done done) = 0;
    /// What came of asking the shop for the current lot; empty: it was not asked, or has answered.
    [[nodiscard]] virtual Sentence shopAnswer() const = 0;
    /// No part is started for the current lot any more; its diameters may still be entered and corrected.
    virtual void close(const std::string& author, const std::string& reason, Done done) = 0;

    virtual void addPartType(const std::string& name, const BoringRecipeForm& form, const std::string& author,
                             PartTypeDone done) = 0;
    /// A new revision. A reason must be given.
    virtual void saveRecipe(PartTypeId partType, const BoringRecipeForm& form, const std::string& author,
                            const std::string& reason, Done done) = 0;
    /// Roll back to `revision`. A reason must be given.
    virtual void restoreRecipe(PartTypeId partType, std::uint32_t revision, const std::string& author,
                               const std::string& reason, Done done) = 0;
};

}  // namespace kerf
