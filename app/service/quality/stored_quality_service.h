// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "app/service/quality/lot_quality.h"
#include "app/service/quality/part_judge.h"
#include "app/service/rights.h"
#include "db/api/room_records.h"
#include "db/api/settings_reader.h"
#include "db/api/store_writer.h"
#include "ui/services/quality_service.h"

namespace kerf::db {
class DatabaseReader;
}

namespace kerf {

/// A lot with everything that its file and report need.
struct QualityLot {
    LotHistory history{};
    LotQuality quality{};
};
/// The first look at a lot: enough for the charts, so that they stand at once. All that are read at once follow.
inline constexpr std::uint32_t kFirstLook_parts = 500;
/// Parts of a lot that are read at once: a page, a report and a chart show the newest ones, whatever the lot's size.
inline constexpr std::uint32_t kNewestParts = 5'000;
/// Reads and judges the newest parts of a lot, or of a process without lots.
[[nodiscard]] Result<QualityLot> readQualityLot(db::DatabaseReader& reader, LotId lot,
                                                std::uint32_t count = kNewestParts, std::optional<PartId> last = {});
/// On a connection of its own: for a worker.
[[nodiscard]] Result<QualityLot> readQualityLot(const std::string& databasePath, LotId lot,
                                                std::uint32_t count = kNewestParts, std::optional<PartId> last = {});

/// Setting: keys of the chart rules that are on, apart by commas; empty text: none. Without it the default set.
inline constexpr const char* kChartRules = "quality.chart_rules";
[[nodiscard]] std::string rulesText(const quality::RuleSet& rules);
/// Keys that are none (of a later version) are passed over.
[[nodiscard]] quality::RuleSet rulesFromText(std::string_view text);

/// What a report says beside the parts.
struct LotPapers {
    bool firstArticle{false};
    std::map<PartId, Disposition> dispositions{};
    std::vector<Gauge> gauges{};
    std::vector<AlarmRow> alarms{};  ///< raised between the lot's first part and its last, oldest first
    std::vector<std::pair<std::uint32_t, std::string>> changes{};  ///< announced: from this part on, what
    std::int64_t auditEntry{0};                                    ///< head of the audit chain when the report was made
    std::string auditHash{};
};
/// Fills in what the data file knows; the rest stays as it is.
[[nodiscard]] Result<void> readLotPapers(db::DatabaseReader& reader, const QualityLot& lot, LotPapers& papers);

/// Quality on the data file. GUI thread; what is slow goes to `background`.
class StoredQualityService final : public QualityService {
 public:
    using Work = std::function<Result<void>()>;
    /// Writes the report of a lot into a file.
    using Report = std::function<Result<void>(const QualityLot&, const LotPapers&, const std::string& file)>;
    struct Links {
        StoreWriter& writer;
        RoomRecordReader& records;
        LotReader& lots;
        SettingsReader& settings;
        std::string databasePath{};
        std::function<void(Work, Done)> background{};
        /// Asked on the GUI thread; what it returns runs on a worker.
        std::function<Report()> makeReport{};
        Rights rights{};
        /// What a process without lots works by now; asked on the GUI thread.
        std::function<RecipeHeld(ProcessId)> recipe{};
        /// Limits have made a revision of it: what is begun from now on is cut with that one.
        std::function<void(ProcessId, RecipeRevisionId)> revised{};
    };
    explicit StoredQualityService(Links links);

    [[nodiscard]] const LotQuality* shown() const override { return m_lot ? m_lot.get() : nullptr; }
    [[nodiscard]] bool reading() const override { return m_reading; }
    [[nodiscard]] Sentence problem() const override { return m_problem; }
    void show(LotId lot) override { want({lot, {}, kNewestParts}); }
    void showUpTo(LotId lot, PartId last) override { want({lot, last, kNewestParts}); }
    [[nodiscard]] PartJudgement judge(const PartRow& part) override { return judgeOf(part).judge(part); }
    [[nodiscard]] std::vector<Characteristic> characteristics(const PartRow& part) override {
        return judgeOf(part).characteristics(part);
    }
    [[nodiscard]] std::function<VerdictOf()> openVerdicts() override;
    [[nodiscard]] std::vector<FigureLimit> limits(ProcessId process) override {
        return recipeLimits(m_links.lots, m_links.records, process).inForce;
    }
    [[nodiscard]] std::string limitsPartType(ProcessId process) override;
    void setLimits(ProcessId process, const std::vector<FigureLimit>& limits, const std::string& author,
                   const std::string& reason, Done done) override;
    [[nodiscard]] const std::map<PartId, Disposition>& dispositions() const override { return m_dispositions; }
    void dispose(PartId part, const std::string& what, const std::string& author, Done done) override;
    [[nodiscard]] const std::vector<Gauge>& gauges() const override { return m_gauges; }
    void saveGauge(const Gauge& gauge, const std::string& author, Done done) override;
    void saveStudy(const GaugeStudyRecord& study, const std::string& author, Done done) override;
    void writeReport(LotId lot, bool firstArticle, const std::string& file, Done done) override;
    void writeDfq(LotId lot, const std::string& file, Done done) override;
    [[nodiscard]] DfqFiles dfqFiles() override { return m_files; }
    void setDfqFiles(const DfqFiles& files, const std::string& author, Done done) override;
    [[nodiscard]] quality::RuleSet rules() override;
    void setRules(const quality::RuleSet& rules, const std::string& author, Done done) override;
    void onChanged(std::function<void()> changed) override { m_listeners.push_back(std::move(changed)); }

 private:
    struct Wish {
        LotId lot{0};
        std::optional<PartId> last{};
        std::uint32_t count{kNewestParts};
        friend bool operator==(const Wish&, const Wish&) = default;
    };
    /// A part newer than any before may have been made under a newer recipe.
    [[nodiscard]] PartJudge& judgeOf(const PartRow& part) {
        if (part.id > m_newestJudged) {
            m_newestJudged = part.id;
            m_judge.forget();
        }
        return m_judge;
    }
    void want(const Wish& wish);
    void read(const Wish& wish);
    void tell();
    void store(AddRoomRecord record, std::function<void()> kept, Done done);
    void readRecords();
    void keepGauge(const Gauge& gauge, const std::string& author, Done done);

    Links m_links;
    PartJudge m_judge;
    PartId m_newestJudged{0};
    std::shared_ptr<LotQuality> m_lot{};
    std::optional<Wish> m_wanted{};
    bool m_reading{false};
    bool m_again{false};  ///< wished for while another was being read
    Sentence m_problem{};
    std::map<PartId, Disposition> m_dispositions{};
    std::vector<Gauge> m_gauges{};
    DfqFiles m_files{};
    std::vector<std::function<void()>> m_listeners{};
};

}  // namespace kerf
