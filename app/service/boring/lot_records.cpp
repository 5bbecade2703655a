// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/service/boring/lot_records.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>
#include <set>

namespace kerf {
namespace {

constexpr double kMicrometre = 1000.0;  // per mm
constexpr double kShownAim_mm = 0.002;  // an aim further from the target diameter than this is told

boring::CutPart cutPartOf(const ServicePart& part) {
    return {part.number, part.schedule, part.feed};
}

EstimatorStateRow stateRow(MeasurementId measurement, boring::EstimatorKind kind, const boring::Estimate& estimate,
                           bool perturbed, std::string json) {
    EstimatorStateRow row;
    row.measurement = measurement;
    row.estimator = boring::estimatorKey(kind);
    row.theta = {estimate.law.lnC, estimate.law.alpha, estimate.law.beta};
    row.covariance = estimate.covariance;
    row.perturbed = perturbed;
    row.stateJson = std::move(json);
    return row;
}

}  // namespace

LotRecords::LotRecords(BoringRecipe recipe, boring::EstimatorKind kind, boring::LotBegin begin)
    : m_recipe(std::move(recipe)),
      m_everyPart(m_recipe.depths.size()),
      m_kind(kind),
      m_tracker(m_recipe.estimator(kind), std::move(begin)) {
    const double middle_mm = boring::teachMiddle_mm(m_recipe.feedLaw(kind));
    const auto there = [&](const DepthView& depth) { return depth.overhang_mm == middle_mm; };
    if (m_recipe.teaches() && m_everyPart < boring::kTeachDepths && std::ranges::none_of(m_recipe.depths, there)) {
        m_recipe.depths.push_back({"middle", middle_mm});
    }
}

void LotRecords::setAnnounced(std::vector<boring::AnnouncedChange> announced) {
    m_tracker.setAnnounced(std::move(announced));
}

const boring::AnnouncedChange* LotRecords::announcedNext() const noexcept {
    const auto found = std::ranges::find(m_tracker.announced(), nextNumber(), &boring::AnnouncedChange::part);
    return found == m_tracker.announced().end() ? nullptr : &*found;
}

std::size_t LotRecords::depthsOf(const ServicePart& part) const noexcept {
    return boring::teaches(part.schedule) ? m_recipe.depths.size() : m_everyPart;
}

ServicePart servicePartOf(const PartDetail& detail) {
    ServicePart part;
    part.id = detail.part.id;
    part.number = detail.part.number;
    part.complete = detail.part.complete;
    part.schedule = detail.schedule ? detail.schedule->schedule : BoringSchedule{};
    part.feed = detail.feed;
    return part;
}

void LotRecords::addPart(const ServicePart& part) {
    const auto place = std::ranges::upper_bound(m_parts, part.number, {}, &ServicePart::number);
    m_parts.insert(place, part);
    const auto added = m_tracker.addPart(cutPartOf(part));
    assert(added.has_value());
    (void)added;
}

void LotRecords::track(const MeasurementRow& row) {
    const auto done = [&]() -> Result<void> {
        switch (row.kind) {
            case MeasurementKind::Entry: {
                const ServicePart* owner = part(row.part);
                return owner == nullptr ? Result<void>(fail(KERF_TEXT("There is no such part.")))
                                        : m_tracker.add(row.id, owner->number, row.position_mm,
                                                        deflectionOf_mm(row.diameter_mm.value_or(0.0)));
            }
            case MeasurementKind::Correction:
                return m_tracker.correct(*row.replaces, row.id, deflectionOf_mm(row.diameter_mm.value_or(0.0)));
            case MeasurementKind::Void:
                break;
        }
        return m_tracker.voidEntry(*row.replaces);
    }();
    assert(done.has_value());
    (void)done;
}

void LotRecords::addRow(const MeasurementRow& row) {
    track(row);
    m_rows.push_back(row);
}

void LotRecords::restoreRows(std::vector<MeasurementRow> rows) {
    assert(m_rows.empty());
    m_rows = std::move(rows);
    std::vector<boring::CutPart> cut;
    for (const ServicePart& part : m_parts) {
        cut.push_back(cutPartOf(part));
    }
    std::vector<boring::LotTracker::Entry> entries;
    for (const MeasurementRow& row : effectiveMeasurements(m_rows)) {
        const ServicePart* owner = part(row.part);
        const double deflection_mm = deflectionOf_mm(row.diameter_mm.value_or(0.0));
        if (owner == nullptr || !(deflection_mm > 0.0)) {
            continue;  // a file from outside: what the service would have refused does not count
        }
        boring::Measurement measurement = boring::measurementAt(owner->schedule, row.position_mm, deflection_mm);
        measurement.feed_mmPerRev = boring::cutFeed_mmPerRev(cutPartOf(*owner), row.position_mm);
        entries.push_back({row.id, owner->number, measurement});
    }
    const auto announced = m_tracker.announced();
    m_tracker = boring::LotTracker(m_recipe.estimator(m_kind), m_tracker.begin());
    m_tracker.setAnnounced(announced);
    m_tracker.restore(std::move(cut), std::move(entries));
}

const ServicePart* LotRecords::part(PartId id) const noexcept {
    const auto found = std::ranges::find(m_parts, id, &ServicePart::id);
    return found == m_parts.end() ? nullptr : &*found;
}

const MeasurementRow* LotRecords::standing(MeasurementId id) const noexcept {
    const auto row = std::ranges::find(m_rows, id, &MeasurementRow::id);
    if (row == m_rows.end() || row->kind == MeasurementKind::Void) {
        return nullptr;
    }
    const bool replaced = std::any_of(row, m_rows.end(), [&](const auto& later) { return later.replaces == id; });
    return replaced ? nullptr : &*row;
}

std::optional<MeasurementId> LotRecords::newestStanding() const noexcept {
    for (auto row = m_rows.rbegin(); row != m_rows.rend(); ++row) {
        if (standing(row->id) != nullptr) {
            return row->id;
        }
    }
    return std::nullopt;
}

const MeasurementRow* LotRecords::measured(PartId part, std::uint8_t depth) const noexcept {
    for (auto row = m_rows.rbegin(); row != m_rows.rend(); ++row) {
        if (row->part == part && row->station == depth && standing(row->id) != nullptr) {
            return &*row;
        }
    }
    return nullptr;
}

double LotRecords::deflectionOf_mm(double diameter_mm) const noexcept {
    return boring::deflectionFromDiameter_mm(diameter_mm, m_recipe.targetDiameter_mm, m_recipe.targetDeflection_mm,
                                             m_recipe.phi_deg);
}

EntryCheck LotRecords::check(PartId id, std::uint8_t depth, double diameter_mm) const {
    const ServicePart* owner = part(id);
    if (owner == nullptr || !owner->complete) {
        return {EntryVerdict::Refuse, Sentence(KERF_TEXT("This part has no finished bore to measure."))};
    }
    if (depth >= m_recipe.depths.size()) {
        return {EntryVerdict::Refuse, Sentence(KERF_TEXT("The part type has no such depth."))};
    }
    if (!std::isfinite(diameter_mm) || diameter_mm <= 0.0) {
        return {EntryVerdict::Refuse, Sentence(KERF_TEXT("A diameter is a number above zero."))};
    }
    const double overhang_mm = m_recipe.depths[depth].overhang_mm;
    const double deflection_mm = deflectionOf_mm(diameter_mm);
    if (deflection_mm <= 0.0) {
        return {EntryVerdict::Refuse,
                Sentence(KERF_TEXT("A bore of %1 mm cannot be: without any bending it would be %2 mm. Measure again."),
                         SentenceArg(diameter_mm, 3),
                         SentenceArg(boring::diameterFromDeflection_mm(0.0, m_recipe.targetDiameter_mm,
                                                                       m_recipe.targetDeflection_mm, m_recipe.phi_deg),
                                     3))};
    }
    boring::Measurement measurement = boring::measurementAt(owner->schedule, overhang_mm, deflection_mm);
    measurement.feed_mmPerRev = boring::cutFeed_mmPerRev(cutPartOf(*owner), overhang_mm);
    if (!(measurement.feed_mmPerRev > 0.0)) {
        return {EntryVerdict::Refuse, Sentence(KERF_TEXT("Part %1 has no known feed at %2 mm."),
                                               SentenceArg(owner->number, 0), SentenceArg(overhang_mm, 0))};
    }
    // What this part's other bores have taught counts: after a change the second bore is no surprise any more.
    const boring::EstimatorState& state = m_tracker.stateBefore(owner->number + 1);
    if (boring::judgeEntry(state, m_tracker.params(), measurement).verdict == boring::GateVerdict::Ask) {
        const auto expected = boring::predict(state, m_tracker.params(), measurement.feed_mmPerRev, overhang_mm);
        const double expected_mm = boring::diameterFromDeflection_mm(
            expected ? expected->deflection_mm
                     : boring::deflection_mm(m_tracker.params().kalman.prior, measurement.feed_mmPerRev, overhang_mm),
            m_recipe.targetDiameter_mm, m_recipe.targetDeflection_mm, m_recipe.phi_deg);
        return {
            EntryVerdict::Ask,
            Sentence(KERF_TEXT("%1 mm is far from the %2 mm expected here. Measure again, or confirm that it is so."),
                     SentenceArg(diameter_mm, 3), SentenceArg(expected_mm, 3))};
    }
    return {EntryVerdict::Accept, {}};
}

boring::FeedAdvice LotRecords::advice() const noexcept {
    const bool memory = m_kind == boring::EstimatorKind::Kalman && m_tracker.drewOnMemory();
    const boring::FeedLawParams law = memory ? m_recipe.feedLawWithMemory() : m_recipe.feedLaw(m_kind);
    boring::FeedAdvice advice = boring::adviseFeed(m_tracker.state(), law);
    if (m_recipe.teaches() && !boring::estimateOf(m_tracker.state()).ready) {
        advice.schedule = boring::teachSchedule(law);
    }
    return advice;
}

Predictions LotRecords::predictionFor(const BoringSchedule& schedule) const {
    Predictions out;
    const double diameterPerDeflection = 2.0 * std::cos(m_recipe.phi_deg * std::numbers::pi / 180.0);
    for (const DepthView& depth : m_recipe.depths) {
        const double feed_mmPerRev = schedule.feed_mmPerRev(depth.overhang_mm);
        const auto expected = boring::predict(m_tracker.state(), m_tracker.params(), feed_mmPerRev, depth.overhang_mm);
        out.push_back(expected
                          ? std::optional(DiameterPrediction{
                                boring::diameterFromDeflection_mm(expected->deflection_mm, m_recipe.targetDiameter_mm,
                                                                  m_recipe.targetDeflection_mm, m_recipe.phi_deg),
                                expected->half95_mm * diameterPerDeflection})
                          : std::nullopt);
    }
    return out;
}

Sentence LotRecords::reason() const {
    const double aim_mm = advice().schedule.targetDeflection_mm;
    const double aimed_mm = boring::diameterFromDeflection_mm(aim_mm, m_recipe.targetDiameter_mm,
                                                              m_recipe.targetDeflection_mm, m_recipe.phi_deg);
    if (std::abs(aimed_mm - m_recipe.targetDiameter_mm) >= kShownAim_mm) {
        return Sentence(KERF_TEXT("Too little is known to be sure of the tolerance: the feed aims at %1 mm, from where "
                                  "both limits are equally far by the law."),
                        SentenceArg(aimed_mm, 3));
    }
    if (announcedNext() != nullptr && m_tracker.begin().memory) {
        return Sentence(KERF_TEXT("A change is announced for part %1: it begins from what such changes have brought."),
                        SentenceArg(nextNumber(), 0));
    }
    if ((m_rows.empty() || m_tracker.steps().empty()) && m_tracker.fromMemory()) {
        return Sentence(KERF_TEXT("Nothing is measured in this lot yet: it begins from the lots before it."));
    }
    if ((m_rows.empty() || m_tracker.steps().empty()) && m_recipe.teaches()) {
        return Sentence(KERF_TEXT("Nothing is known yet: the feed falls from %1 to %2 mm/rev near the bottom, so that "
                                  "this part shows what the feed does. Measure it in the middle too."),
                        SentenceArg(m_recipe.firstFeed_mmPerRev, 3),
                        SentenceArg(advice().schedule.minFeed_mmPerRev, 3));
    }
    if (m_rows.empty() || m_tracker.steps().empty()) {
        return Sentence(KERF_TEXT("Nothing is measured yet: the part is cut at the constant feed of %1 mm/rev."),
                        SentenceArg(m_recipe.firstFeed_mmPerRev, 3));
    }
    const MeasurementRow& last = m_rows.back();
    const ServicePart* owner = part(last.part);
    const double number = owner == nullptr ? 0.0 : owner->number;
    if (last.kind == MeasurementKind::Correction) {
        return Sentence(KERF_TEXT("A bore of part %1 was corrected; everything after it was computed again."),
                        SentenceArg(number, 0));
    }
    if (last.kind == MeasurementKind::Void) {
        return Sentence(KERF_TEXT("A bore of part %1 was taken out; everything after it was computed again."),
                        SentenceArg(number, 0));
    }
    const auto step = std::ranges::find_if(m_tracker.steps(), [&](const auto& s) {
        return owner != nullptr && s.visit.part == owner->number && s.perturbed();
    });
    if (step != m_tracker.steps().end()) {
        const bool fresh = std::ranges::any_of(m_tracker.announced(),
                                               [&](const auto& change) { return change.part == step->visit.part; });
        if (m_tracker.begin().memory && (fresh || (step == m_tracker.steps().begin() && m_tracker.fromMemory()))) {
            return Sentence(
                KERF_TEXT(
                    "Part %1 contradicts what was expected from the past: the past is let go, the law learned anew."),
                SentenceArg(number, 0));
        }
        return Sentence(KERF_TEXT("The process changed with part %1: the law is learned anew from there."),
                        SentenceArg(number, 0));
    }
    double error_mm = 0.0;
    double bores = 0.0;
    for (std::size_t depth = 0; depth < m_recipe.depths.size(); ++depth) {
        if (const MeasurementRow* row = measured(last.part, static_cast<std::uint8_t>(depth))) {
            error_mm += row->diameter_mm.value_or(m_recipe.targetDiameter_mm) - m_recipe.targetDiameter_mm;
            bores += 1.0;
        }
    }
    const double mean_um = bores > 0.0 ? kMicrometre * error_mm / bores : 0.0;
    const char* text = mean_um > 0.5    ? KERF_TEXT("Part %1 came out %2 µm larger than its target on average.")
                       : mean_um < -0.5 ? KERF_TEXT("Part %1 came out %2 µm smaller than its target on average.")
                                        : KERF_TEXT("Part %1 came out on its target.");
    return Sentence(text, SentenceArg(number, 0), SentenceArg(std::abs(mean_um), 0));
}

Sentence LotRecords::restsOn() const {
    if (!boring::estimateOf(m_tracker.state()).ready) {
        return {};
    }
    const std::uint32_t measured = m_tracker.steps().empty() ? 0 : m_tracker.steps().back().visit.part;
    const bool changes = announcedNext() != nullptr && announcedNext()->part > measured && m_tracker.begin().memory;
    if (measured > 0 && !changes) {
        return Sentence(KERF_TEXT("Expected from the %1 measured parts of this lot."),
                        SentenceArg(static_cast<double>(m_tracker.steps().size()), 0));
    }
    constexpr double kPercent = 100.0;
    const boring::Memory memory = m_tracker.memoryNow();
    const auto others =
        std::ranges::count_if(memory.weights(), [](const boring::MemoryWeight& weight) { return weight.lot < 0; });
    const double lots = static_cast<double>(memory.weights().size()) - static_cast<double>(others);
    const auto kind = changes ? announcedNext()->kind : boring::StretchKind::Insert;
    const SentenceArg spread(kPercent * memory.start(kind).spread[0], 0);
    if (others > 0) {
        const SentenceArg fromOthers(static_cast<double>(others), 0);
        return measured == 0
                   ? Sentence(KERF_TEXT("Expected from %1 earlier lots and %2 of other machines; the bending of a new "
                                        "tool differs by ± %3 % (1σ)."),
                              SentenceArg(lots, 0), fromOthers, spread)
                   : Sentence(
                         KERF_TEXT("Expected from this lot, %1 earlier ones and %2 of other machines; after such a "
                                   "change the bending differs by ± %3 % (1σ)."),
                         SentenceArg(lots, 0), fromOthers, spread);
    }
    if (measured == 0) {
        return Sentence(KERF_TEXT("Expected from %1 earlier lots; the bending of a new tool differs by ± %2 % (1σ)."),
                        SentenceArg(lots, 0), spread);
    }
    return Sentence(
        KERF_TEXT(
            "Expected from this lot and %1 earlier ones; after such a change the bending differs by ± %2 % (1σ)."),
        SentenceArg(lots, 0), spread);
}

EstimatorStateRow LotRecords::lastState() const {
    const boring::EstimatorState& state = m_tracker.measuredState();
    return stateRow(0, m_kind, boring::estimateOf(state),
                    !m_tracker.steps().empty() && m_tracker.steps().back().perturbed(), stateJson(state));
}

std::vector<EstimatorStateRow> LotRecords::changedStates(const boring::LotTracker& before) const {
    struct Known {
        boring::RowOutcome outcome;
        const boring::EstimatorState* after;  // null unless the visit's last bore
    };
    std::map<MeasurementId, Known> known;
    const auto lastOf = [](const boring::LotTracker::Step& step, std::size_t row) {
        return row + 1 == step.visit.count ? &step.after : nullptr;
    };
    for (const auto& step : before.steps()) {
        for (std::size_t i = 0; i < step.visit.count; ++i) {
            known[step.ids[i]] = {step.rows[i], lastOf(step, i)};
        }
    }
    std::vector<EstimatorStateRow> out;
    const auto& steps = m_tracker.steps();
    for (const auto& step : steps) {
        for (std::size_t i = 0; i < step.visit.count; ++i) {
            const boring::EstimatorState* after = lastOf(step, i);
            const auto old = known.find(step.ids[i]);
            const bool same = old != known.end() && old->second.outcome == step.rows[i] &&
                              (after == nullptr || (old->second.after != nullptr && *old->second.after == *after));
            if (!same) {
                out.push_back(stateRow(step.ids[i], m_kind, step.rows[i].after, step.rows[i].perturbed,
                                       after == nullptr ? "{}" : stateJson(*after)));
            }
        }
    }
    const bool endsWithLast =
        !out.empty() && !steps.empty() && out.back().measurement == steps.back().ids[steps.back().visit.count - 1U];
    if (!endsWithLast) {
        out.push_back(lastState());
    }
    return out;
}

std::string predictionsJson(const Predictions& predictions) {
    nlohmann::json json = nlohmann::json::array();
    for (const auto& one : predictions) {
        json.push_back(one ? nlohmann::json{one->diameter_mm, one->half95_mm} : nlohmann::json(nullptr));
    }
    return json.dump();
}

Predictions predictionsFromJson(const std::string& text) {
    Predictions out;
    const auto json = nlohmann::json::parse(text, nullptr, false);
    for (const auto& one : json.is_array() ? json : nlohmann::json::array()) {
        const bool pair = one.is_array() && one.size() == 2 && one[0].is_number() && one[1].is_number();
        out.push_back(pair ? std::optional(DiameterPrediction{one[0].get<double>(), one[1].get<double>()})
                           : std::nullopt);
    }
    return out;
}

bool sameLaw(const BoringSchedule& a, const BoringSchedule& b) noexcept {
    return a.lnC == b.lnC && a.alpha == b.alpha && a.beta == b.beta && a.targetDeflection_mm == b.targetDeflection_mm &&
           a.constantFeed_mmPerRev == b.constantFeed_mmPerRev && a.minFeed_mmPerRev == b.minFeed_mmPerRev &&
           a.maxFeed_mmPerRev == b.maxFeed_mmPerRev && a.overhangFrom_mm == b.overhangFrom_mm &&
           a.overhangTo_mm == b.overhangTo_mm && a.spindleSpeed_rpm == b.spindleSpeed_rpm;
}

std::string stateJson(const boring::EstimatorState& state) {
    const boring::StateNumbers numbers = boring::numbersOf(state);
    nlohmann::json json;
    json["numbers"] =
        std::vector<double>(numbers.value.begin(), numbers.value.begin() + static_cast<std::ptrdiff_t>(numbers.count));
    return json.dump();
}

}  // namespace kerf
