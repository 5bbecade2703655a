// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "app/service/quality/lot_quality.h"
#include "db/api/room_records.h"
#include "db/api/store_writer.h"
#include "ui/services/quality_service.h"

namespace kerf {

/// A lot with everything that its file and report need.
struct QualityLot {
    LotHistory history{};
    LotQuality quality{};
};
/// Reads and judges a lot on its own connection: for a worker.
[[nodiscard]] Result<QualityLot> readQualityLot(const std::string& databasePath, LotId lot);

/// Quality on the data file. GUI thread; what is slow goes to `background`.
class StoredQualityService final : public QualityService {
 public:
    using Work = std::function<Result<void>()>;
    /// Writes the report of a lot into a file.
    using Report = std::function<Result<void>(const QualityLot&, const std::map<PartId, Disposition>&,
                                              const std::vector<Gauge>&, const std::string& file)>;
    struct Links {
        StoreWriter& writer;
        RoomRecordReader& records;
        std::string databasePath{};
        std::function<void(Work, Done)> background{};
        /// Asked on the GUI thread; what it returns runs on a worker.
        std::function<Report()> makeReport{};
    };
    explicit StoredQualityService(Links links);

    [[nodiscard]] const LotQuality* shown() const override { return m_lot ? m_lot.get() : nullptr; }
    [[nodiscard]] bool reading() const override { return m_reading; }
    [[nodiscard]] Sentence problem() const override { return m_problem; }
    void show(LotId lot) override;
    [[nodiscard]] const std::map<PartId, Disposition>& dispositions() const override { return m_dispositions; }
    void dispose(PartId part, const std::string& what, const std::string& author, Done done) override;
    [[nodiscard]] const std::vector<Gauge>& gauges() const override { return m_gauges; }
    void saveGauge(const Gauge& gauge, const std::string& author, Done done) override;
    void saveStudy(const GaugeStudyRecord& study, const std::string& author, Done done) override;
    void writeReport(LotId lot, const std::string& file, Done done) override;
    void writeDfq(LotId lot, const std::string& file, Done done) override;
    void onChanged(std::function<void()> changed) override { m_listeners.push_back(std::move(changed)); }

 private:
    void tell();
    void store(AddRoomRecord record, std::function<void()> kept, Done done);
    void readRecords();

    Links m_links;
    std::shared_ptr<LotQuality> m_lot{};
    std::optional<LotId> m_wanted{};
    bool m_reading{false};
    Sentence m_problem{};
    std::map<PartId, Disposition> m_dispositions{};
    std::vector<Gauge> m_gauges{};
    std::vector<std::function<void()>> m_listeners{};
};

}  // namespace kerf
