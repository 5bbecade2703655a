// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <set>
#include <string>

#include "app/service/asked_recipe.h"
#include "app/service/change_way.h"
#include "app/service/lot_book.h"
#include "app/service/milling/milling_json.h"
#include "app/service/rights.h"
#include "app/service/stored_recipe_history.h"
#include "db/api/part_reader.h"
#include "db/api/room_records.h"
#include "db/api/store_writer.h"
#include "engine/api/engine_api.h"
#include "engine/core/listeners.h"
#include "engine/process/milling/tool_memory.h"
#include "ui/services/milling_service.h"

namespace kerf {

/// The milling service on the database: part types with setup and blank, the tool, the log of cuts. Stores first, then
/// hands the engine what it is to use; a law or reference changed while cutting is stored behind it. After a restart
/// setup, blank, tool and log are what they were. GUI thread only.
///
/// A part type's setup and blank are its recipe: every accepted one is a revision. Room records: "part_type" (subject:
/// its name) when one is chosen, "tool" after each cut, "tool_memory" (subject: the tool) when one is left out or taken
/// in again; a "blank" of before it stood in the recipe is brought into it. Cuts the console did not live to see are
/// added to the tool's wear from their stored figures.
class StoredMillingService final : public MillingService {
 public:
    struct Links {
        StoreWriter& writer;
        EngineApi& engine;
        std::function<std::string()> author;  ///< who changes law and reference on the page
        /// A new tool is in the spindle, or `parts` have been cut with the one that is (simulated machines). May be
        /// empty.
        std::function<void(std::uint32_t parts)> toolChanged{};
        Rights rights{};
        std::string machineKind{"simulator"};  ///< as --machine names it
    };
    static constexpr const char* kFirstPartType = "Rail";

    /// Reads what is kept and hands it to the engine. What cannot be read is said in view().problem; the defaults hold.
    /// `lots` outlives the service, the others are used here only.
    StoredMillingService(Links links, RoomRecordReader& records, PartReader& parts, LotReader& lots);

    [[nodiscard]] const MillingServiceView& view() const override { return m_view; }
    [[nodiscard]] std::span<const MillingField> fields() const override;
    [[nodiscard]] std::optional<Sentence> whyUnusable(const MillingSetup& setup) const override;
    [[nodiscard]] Result<MillingBlank> blankOf(std::span<const MillingBlankStep> steps, double end_mm) const override;
    [[nodiscard]] Result<MillingBlank> readBlank(const std::string& file) const override;
    [[nodiscard]] RecipeHistory* recipes() override { return &m_history; }
    [[nodiscard]] LotService* lots() override { return &m_lots; }
    /// What holds, as it is stored.
    [[nodiscard]] std::string recipeJson() const { return millingRecipeJson(m_types.at(m_type).recipe); }
    /// Limits have made this revision of the recipe.
    void recipeRevised(RecipeRevisionId revision);
    /// What the next part is cut with is on its way to the disk or to the engine.
    [[nodiscard]] bool underWay() const { return m_types.at(m_type).asked.open() || m_lots.underWay(m_way); }
    void saveSetup(const MillingSetup& setup, const std::string& author, const std::string& reason, Done done) override;
    void saveBlank(const MillingBlank& blank, const std::string& source, const std::string& author, Done done) override;
    void choosePartType(const std::string& name, const std::string& author, Done done) override;
    void newTool(const std::string& author, Done done) override;
    void leaveOut(std::int64_t since, bool out, const std::string& author, const std::string& reason,
                  Done done) override;
    [[nodiscard]] std::unique_ptr<Subscription> onChanged(std::function<void()> changed) override {
        return m_listeners.add(std::move(changed));
    }

    /// A few times per second: what the engine has not taken is sent again, what was changed at the machine is stored.
    void poll();

 private:
    struct PartType {
        MillingRecipe recipe{};
        RecipeRevisionId revision{0};  ///< the recipe's; 0: none was kept
        AskedRecipe<MillingRecipe> asked{};
    };
    /// What a revision was of, as long as parts of it may come back.
    struct Used {
        std::string partType{};
        double toolRadius_mm{0.0};
        std::uint8_t flutes{0};
    };
    enum class ToolOwed : std::uint8_t { Nothing, Fresh, Kept };
    void restore(RoomRecordReader& records, PartReader& parts);
    void restorePartTypes(RoomRecordReader& records);
    /// Blanks of before they stood in the recipe.
    void bringBlanks(const std::vector<RoomRecordRow>& rows, const std::set<std::string>& said);
    void restoreTool(RoomRecordReader& records, PartReader& parts);
    void restorePast(RoomRecordReader& records);
    void tellTool();
    /// A tool that has not cut yet begins from the tools before it.
    void beginFromMemory();
    [[nodiscard]] milling::ToolMemory memory() const;
    [[nodiscard]] MillingMemoryView memoryView() const;
    /// Checked, stored as a revision of the present part type's recipe, then used.
    void accept(const Result<void>& may, const MillingRecipe& recipe, const std::string& author,
                const std::string& reason, std::optional<std::uint32_t> restoredFrom, Done done);
    /// A recipe on its way to the disk, as one more revision of the present part type's.
    [[nodiscard]] ChangeWay::Store storing(const MillingRecipe& recipe, const std::string& author,
                                           const std::string& reason, std::optional<std::uint32_t> restoredFrom);
    [[nodiscard]] Result<void> mayAccept(const MillingSetup& setup, const std::string& author,
                                         const std::string& reason) const;
    [[nodiscard]] Result<void> mayAccept(const MillingBlank& blank, const std::string& author) const;
    /// What the present part type's was asked to be last.
    [[nodiscard]] const MillingRecipe& asked() const;
    void restoreRevision(const RecipeRevision& revision, const std::string& author, const std::string& reason,
                         Done done);
    template <class Value>
    [[nodiscard]] Value keep(const Result<Value>& value, const Value& fallback) {
        if (!value) {
            m_way.setStoreProblem(value.error());
            return fallback;
        }
        return *value;
    }
    void partStored(const StoredPart& part);
    void store(const std::string& kind, const std::string& subject, const std::string& body, const std::string& author,
               const std::string& reason, Done done, std::function<void()> then);
    void use(const std::string& partType);
    /// Law and reference that people have chosen at the machine since, in a setup that the engine has yet to take.
    void takeAlong(MillingSetup& setup, const MillingStatus& then, const MillingStatus& now) const;
    /// The recipe that is in force now, without anything to load.
    void useRecipe();
    [[nodiscard]] bool settled();
    void rebuild();
    [[nodiscard]] std::optional<Sentence> whyBusy() const;

    Links m_links;
    ChangeWay m_way{m_links.engine, [this] { rebuild(); }};
    RecipeBook m_recipes;
    StoredRecipeHistory m_history;
    LotBook m_lots;
    Listeners<> m_listeners;
    MillingServiceView m_view{};
    std::map<std::string, PartType> m_types;
    std::map<RecipeRevisionId, Used> m_used;
    std::string m_type{kFirstPartType};
    std::uint32_t m_revision{0};  ///< of setups and blanks handed to the engine
    MillingSetup m_setup{};       ///< as handed over, with its revision
    MillingBlank m_blank{};
    MillingToolRecord m_tool{};
    bool m_begun{false};                                 ///< the tool in the spindle began from memory
    ToolOwed m_toolOwed{ToolOwed::Nothing};              ///< what the engine has yet to be told
    std::map<std::int64_t, MillingToolRecord> m_past;    ///< newest record of each tool before, by its `since`
    std::map<std::int64_t, RoomRecordRow> m_toldOfPast;  ///< left out or taken in again, with reason and author
    std::deque<MillingCutView> m_cuts;
    std::shared_ptr<int> m_alive{std::make_shared<int>(0)};
    std::unique_ptr<Subscription> m_partsSubscription;
};

}  // namespace kerf
