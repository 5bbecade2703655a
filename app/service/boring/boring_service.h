// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>

#include "app/service/boring/boring_memory.h"
#include "app/service/boring/boring_recipe.h"
#include "app/service/boring/lot_records.h"
#include "app/service/change_way.h"
#include "app/service/rights.h"
#include "db/api/lot_reader.h"
#include "db/api/store_writer.h"
#include "engine/api/engine_api.h"
#include "engine/core/listeners.h"
#include "ui/services/boring_service.h"

namespace kerf {

/// What a lot of bores needs before the service can open it.
struct BoringLotRequest {
    std::string machineName{};
    std::string machineKind{"simulator"};
    std::string partTypeName{};
    BoringRecipe recipe{};  ///< used when the part type is new
    std::string lotName{};
    std::uint32_t lotSize{0};  ///< 0: no limit
    boring::EstimatorKind estimator{boring::EstimatorKind::Kalman};
    std::string author{};
};
/// Finds or makes machine, part type and lot, and sends finished bores there from now on. `done` gets the lot or why
/// not.
void openBoringLot(StoreWriter& writer, const BoringLotRequest& request,
                   std::function<void(const Result<LotId>&)> done);

/// The boring service on the database: stores first, then accepts, then sends the schedule to the engine.
///
/// One change at a time: a measurement, correction or void is submitted together with every estimator state and the
/// schedule that follow from it, and takes effect when the store says it is on disk. When the store fails, nothing has
/// changed and the caller gets the sentence. After a restart the lot is replayed from its stored rows; it is compared
/// with the state stored last, and a difference raises an alarm (the replayed state is used). GUI thread only.
class StoredBoringService final : public BoringService {
 public:
    struct Links {
        StoreWriter& writer;
        EngineApi& engine;
        /// What the machine's gauge shows for a finished part at an overhang. May be empty.
        std::function<std::optional<double>(const ServicePart& part, const BoringRecipe& recipe, double overhang_mm)>
            gauge{};
        /// Mode of the loop; empty: as the engine's status says.
        std::function<LoopMode()> mode{};
        Rights rights{};
        /// The view's revision goes on from here when this service follows that of another lot.
        std::uint64_t firstRevision{0};
        /// Where announced changes and lots left out stand; null: no memory.
        RoomRecordReader* records{nullptr};
    };
    /// Reads the lot and goes on where it was. Links must outlive the service.
    [[nodiscard]] static Result<std::unique_ptr<StoredBoringService>> open(const Links& links, LotReader& reader,
                                                                           LotId lot);

    [[nodiscard]] const BoringServiceView& view() const override { return m_view; }
    [[nodiscard]] EntryCheck check(const BoreEntry& entry) const override;
    [[nodiscard]] BoreImportPlan planImport(const ReadBores& read) const override;
    void importBores(const ReadBores& read, const std::string& author, bool confirmed, Done done) override;
    void enter(const BoreEntry& entry, Done done) override;
    void correct(MeasurementId id, double diameter_mm, const std::string& author, const std::string& reason,
                 Done done) override;
    [[nodiscard]] EntryCheck checkCorrection(MeasurementId id, double diameter_mm) const override;
    void correctValue(const BoreCorrection& correction, Done done) override;
    void voidMeasurement(MeasurementId id, const std::string& author, const std::string& reason, Done done) override;
    void undoLast(const std::string& author, Done done) override;
    void acceptSchedule(const std::string& author, Done done) override;
    void announceChange(BoringChange change, const std::string& author, Done done) override;
    void withdrawChange(const std::string& author, Done done) override;
    [[nodiscard]] std::optional<double> gaugeReading_mm(PartId part, std::uint8_t depth) override;
    [[nodiscard]] std::unique_ptr<Subscription> onChanged(std::function<void()> changed) override;

    /// Now and then (a few times per second): sends a schedule the engine could not take, and accepts the proposed one
    /// when the loop has been switched to control.
    void poll();
    /// Nothing is on its way to the disk.
    [[nodiscard]] bool idle() const noexcept { return !m_way.busy() && m_waiting.empty(); }
    /// What the next part is cut with is on its way to the disk or to the engine.
    [[nodiscard]] bool underWay() const noexcept { return !idle() || m_way.underWay(); }
    /// Another lot is current: what is on its way is still stored and answered, but no schedule goes to the engine.
    void retire();
    /// What the comparison after a restart found; empty: the replayed state is the stored one.
    [[nodiscard]] const Sentence& restartFinding() const noexcept { return m_restartFinding; }

 private:
    /// A change waiting for its turn: makes its rows from the records as they are then, or says why not. Many rows have
    /// ids −1, −2 … until the store has given theirs.
    using Rows = Result<std::vector<MeasurementRow>>;
    struct Change {
        std::function<Rows()> rows{};
        Done done{};
    };

    StoredBoringService(const Links& links, const LotHistory& history, BoringRecipe recipe, boring::EstimatorKind kind,
                        const BoringMemoryBasis& basis);

    void restore(const LotHistory& history);
    void compareWithStored(const LotHistory& history);
    void queue(Change change);
    void queueOne(std::function<Result<MeasurementRow>()> row, Done done);
    void runNext();
    void submit(std::vector<MeasurementRow> rows, Done done);
    /// Stored, then taken over and sent; then whatever waits for its turn.
    void keep(StoreCommand command, std::function<void(const Receipt&)> then, Done done);
    void partStored(const StoredPart& part);
    void propose();
    void tellChange(std::optional<boring::StretchKind> kind, const std::string& author, Done done);
    void adopt(const BoringSchedule& schedule, const Predictions& predictions, bool accepted);
    void send();
    [[nodiscard]] WorkOrder order(std::uint32_t schedule) const { return {m_lot.id, m_lot.recipe, schedule}; }
    void rebuild();
    [[nodiscard]] ScheduleRow scheduleRow(const LotRecords& records, const BoringSchedule& schedule) const;
    [[nodiscard]] LoopMode mode() const;
    [[nodiscard]] Result<MeasurementRow> correctedRow(const BoreCorrection& correction) const;
    [[nodiscard]] Result<MeasurementRow> entryRow(const BoreEntry& entry) const;
    [[nodiscard]] Rows rowsOf(const ReadBores& read, const std::string& author, bool confirmed) const;

    Links m_links;
    ChangeWay m_way{m_links.engine, [this] {
                        rebuild();
                        m_listeners.tell();
                    }};
    LotRow m_lot;
    bool m_lotNamed{false};
    std::uint32_t m_recipeRevision;
    boring::EstimatorKind m_kind;
    LotRecords m_records;
    BoringSchedule m_next{};                     ///< proposed; revision 0: none yet
    std::optional<BoringSchedule> m_accepted{};  ///< what the engine should have
    std::uint32_t m_sentRevision{0};
    std::map<std::uint32_t, Predictions> m_predictions{};  ///< by schedule revision, as made before the cut
    std::deque<Change> m_waiting{};
    bool m_retired{false};
    bool m_hasMemory{false};
    Sentence m_restartFinding{};
    BoringServiceView m_view{};
    Listeners<> m_listeners{};
    std::shared_ptr<bool> m_alive{std::make_shared<bool>(true)};
    std::unique_ptr<Subscription> m_partsSubscription{};
    std::unique_ptr<Subscription> m_problemSubscription{};
};

}  // namespace kerf
