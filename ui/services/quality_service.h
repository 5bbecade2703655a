// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "db/api/csv_export.h"
#include "db/api/rows.h"
#include "engine/core/result.h"
#include "engine/quality/capability.h"
#include "engine/quality/charts.h"
#include "engine/quality/gauge_study.h"
#include "engine/quality/verdict.h"

/// Quality of lots and gauges, as the pages and reports see it: plain values, each a pure function of what is stored.
namespace kerf {

/// What is judged of a part: the bores of a boring recipe, the figures of the other processes that have limits.
struct Characteristic {
    std::string key{};   ///< "bore_0", "surface_rms_um"
    std::string name{};  ///< a depth's name, or a figure's label; English, translated by the screen
    std::string unit{};
    int decimals{3};
    std::optional<double> nominal{};
    quality::Tolerance tolerance{};
};

/// What a process without lots works by now.
struct RecipeHeld {
    std::string partType{};        ///< empty: nothing to work by yet
    std::string parametersJson{};  ///< of its first revision, when it has none yet
    bool kept{true};               ///< the service keeps itself which part type was chosen when
};

/// Limits of one figure, in its stored unit.
struct FigureLimit {
    std::string key{};
    quality::Tolerance tolerance{};
};

struct JudgedValue {
    std::optional<double> value{};
    quality::Tolerance tolerance{};  ///< of the recipe revision the part was made under
    quality::Verdict verdict{quality::Verdict::NotJudged};
};

/// One part: a value for each characteristic, and the worst verdict. Aborted parts and parts that still want a value
/// are not judged, unless what is known of them is out of tolerance already.
struct PartJudgement {
    std::vector<JudgedValue> values{};
    quality::Verdict verdict{quality::Verdict::NotJudged};
};

/// A part on the charts. Boring: the one-step error of its bores. Other processes: the first judged figure against its
/// own centre and moving range.
struct ChartedPart {
    std::uint32_t number{0};
    PartId id{0};
    double error{0.0};     ///< e, standardised
    double tSquared{0.0};  ///< T² over its bores
    double tSquaredLimit{0.0};
    double tSquaredChance{1.0};  ///< of a T² as large as this, when the law is right
    double action{0.0};     ///< what the controller does: feed in the middle of the bore, mm/rev; 0: nothing to show
    bool perturbed{false};  ///< the estimator took it for a change of the process: the charts begin anew behind it
    bool announced{false};  ///< the first part after an announced change: the charts begin anew before it
    quality::ChartPoint point{};
};

struct LotPart {
    std::uint32_t number{0};
    PartId id{0};
    std::string serial{};
    bool complete{true};
    std::int64_t endedUtc_ms{0};
    PartJudgement judgement{};
    std::vector<std::size_t> groups{};  ///< of LotQuality::groups: the ones it belongs to
    std::uint32_t recipeRevision{0};    ///< made under; 0: not known
};

/// Parts that have something in common: to be looked at by tool, by person, by gauge.
struct PartGroup {
    enum class By : std::uint8_t { Lot, Tool, Person, Source };
    By by{By::Tool};
    /// Lot, where several are shown: its name; tool: the number of its first part; person: who entered; source: which
    /// gauge or file, empty when not known.
    std::string name{};
    MeasurementSource source{MeasurementSource::Keypad};  ///< By::Source
    std::vector<quality::Capability> capability{};  ///< one per characteristic, over the values of the group alone
};

struct QualitySignal {
    std::uint32_t part{0};
    PartId id{0};
    quality::Rule rule{quality::Rule::Nelson1};
};

struct LotQuality {
    LotRow lot{};
    std::uint32_t recipeRevision{0};
    /// Without lots: of every part that is shown, with the limits of the parts to come.
    std::vector<Characteristic> characteristics{};
    std::vector<quality::Capability> capability{};  ///< one per characteristic
    std::vector<PartGroup> groups{};                ///< by kind, then as they came
    std::vector<LotPart> parts{};                   ///< by number
    bool olderParts{false};                         ///< there are more before the first one …
    bool newerParts{false};                         ///< … and behind the last one
    std::vector<ChartedPart> charted{};             ///< by number
    std::vector<QualitySignal> found{};
    std::uint32_t good{0}, notJudged{0}, rework{0}, scrap{0};
    double gaugeSigma_mm{0.0};  ///< boring: what the estimator takes for the repeatability of a diameter
    Sentence sentence{};        ///< whether the process is in control and what drives it

    bool steady{true};  ///< the errors of the whole lot do not speak against a capability
};

/// Parts of processes that know no lots stand under this number.
[[nodiscard]] constexpr LotId partsWithoutLot(ProcessId process) {
    return -1 - static_cast<LotId>(process);
}

/// All lots of a part type, one after the other, stand under this number; their parts are numbered through.
inline constexpr LotId kFirstOfAllLots = -1000;
[[nodiscard]] constexpr LotId allLotsOf(PartTypeId type) {
    return kFirstOfAllLots - type;
}
[[nodiscard]] constexpr std::optional<PartTypeId> partTypeOfAllLots(LotId lot) {
    return lot <= kFirstOfAllLots ? std::optional(kFirstOfAllLots - lot) : std::nullopt;
}

/// What was done with a part that is out of tolerance.
struct Disposition {
    std::string what{};  ///< "reworked", "scrapped", "accepted under concession"
    std::string author{};
    std::int64_t utc_ms{0};
};

/// What the newest study of a gauge found, for pages and reports.
struct StudyFigures {
    std::string method{};  ///< "type1", "average-range", "anova"
    std::uint32_t readings{0};
    double tolerance_mm{0.0};
    std::optional<double> cg{}, cgk{};                              ///< type1; cgk only with a ring
    std::optional<double> grr_percent{}, grrOfTolerance_percent{};  ///< crossed: of all variation, of T
    std::uint32_t ndc{0};                                           ///< crossed
    std::string author{};
    std::int64_t utc_ms{0};
};

/// A gauge of the shop. Lengths in mm; a due date is a day.
struct Gauge {
    std::string identity{};  ///< unique: "G-07"
    std::string description{};
    double rangeFrom_mm{0.0};
    double rangeTo_mm{0.0};
    double resolution_mm{0.001};
    double ring_mm{0.0};               ///< true size of its setting ring; 0: none
    std::int64_t dueUtc_ms{0};         ///< 0: no date
    std::optional<double> sigma_mm{};  ///< repeatability of its newest study that was accepted, of a diameter
    double sigmaLow_mm{0.0};           ///< its 95 % interval
    double sigmaHigh_mm{0.0};
    bool pass{false};         ///< good enough for the tolerance of the study
    std::string sigmaFrom{};  ///< "type1", "anova"; empty: no study
    std::optional<StudyFigures> study{};
};

/// Q-DAS files that appear by themselves as parts finish.
struct DfqFiles {
    std::string folder{};   ///< empty: none
    std::string pattern{};  ///< "{type}_{lot}_{part}.dfq"
};

/// A study that is kept, with what it was computed from.
struct GaugeStudyRecord {
    std::string gauge{};
    std::string method{};  ///< "type1", "average-range", "anova"
    double tolerance_mm{0.0};
    std::vector<quality::StudyReading> readings{};
    std::string author{};
    std::int64_t utc_ms{0};
};

/// GUI thread. `Done` runs on it when the change is on disk, or has failed and why.
class QualityService {
 public:
    QualityService() = default;
    QualityService(const QualityService&) = delete;
    QualityService& operator=(const QualityService&) = delete;
    virtual ~QualityService() = default;

    using Done = std::function<void(const Result<void>&)>;

    /// The lot that is shown; null until the first one has been read.
    [[nodiscard]] virtual const LotQuality* shown() const = 0;
    /// A lot is being read on a worker.
    [[nodiscard]] virtual bool reading() const = 0;
    [[nodiscard]] virtual Sentence problem() const = 0;
    /// Read this lot on a worker; listeners are told when it is there.
    virtual void show(LotId lot) = 0;
    /// The parts of this lot up to this one.
    virtual void showUpTo(LotId lot, PartId last) = 0;

    /// Any part, with the recipe of its lot or the limits of its process.
    [[nodiscard]] virtual PartJudgement judge(const PartRow& part) = 0;
    [[nodiscard]] virtual std::vector<Characteristic> characteristics(const PartRow& part) = 0;
    /// Makes, on a worker, who judges the parts of an export there.
    [[nodiscard]] virtual std::function<VerdictOf()> openVerdicts() = 0;
    /// Limits for the figures of a process that is not measured by hand, of the parts to come: those of the recipe of
    /// the part type it works by.
    [[nodiscard]] virtual std::vector<FigureLimit> limits(ProcessId process) = 0;
    /// Whose recipe that is; empty: the process has none yet, and no part type.
    [[nodiscard]] virtual std::string limitsPartType(ProcessId process) = 0;
    /// One more revision of that recipe, with a reason. A part keeps the limits it was made under.
    virtual void setLimits(ProcessId process, const std::vector<FigureLimit>& limits, const std::string& author,
                           const std::string& reason, Done done) = 0;

    [[nodiscard]] virtual const std::map<PartId, Disposition>& dispositions() const = 0;
    virtual void dispose(PartId part, const std::string& what, const std::string& author, Done done) = 0;

    [[nodiscard]] virtual const std::vector<Gauge>& gauges() const = 0;
    virtual void saveGauge(const Gauge& gauge, const std::string& author, Done done) = 0;
    /// Computes, keeps and takes the repeatability over into the register.
    virtual void saveStudy(const GaugeStudyRecord& study, const std::string& author, Done done) = 0;

    /// The lot report as PDF with DFQ and CSV attached, on a worker; `firstArticle`: of the first part alone.
    virtual void writeReport(LotId lot, bool firstArticle, const std::string& file, Done done) = 0;
    virtual void writeDfq(LotId lot, const std::string& file, Done done) = 0;
    [[nodiscard]] virtual DfqFiles dfqFiles() = 0;
    virtual void setDfqFiles(const DfqFiles& files, const std::string& author, Done done) = 0;

    /// The rules of the charts that are switched on: on the page, in the report and for the alarm.
    [[nodiscard]] virtual quality::RuleSet rules() = 0;
    virtual void setRules(const quality::RuleSet& rules, const std::string& author, Done done) = 0;

    virtual void onChanged(std::function<void()> changed) = 0;
};

}  // namespace kerf
