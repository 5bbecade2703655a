// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/service/quality/lot_quality.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "app/service/boring/boring_recipe.h"
#include "app/service/boring/lot_records.h"
#include "engine/process/boring/one_step_error.h"
#include "engine/quality/distributions.h"
#include "engine/quality/steadiness.h"

namespace kerf {
namespace {

constexpr std::uint32_t kFresh_parts = 25;  // a signal older than this is history, not the state
constexpr std::size_t kSettling_parts = 3;  // after a change, until the law is known again
constexpr double kHarder = 0.15;            // a feed that has moved by this share over the lot is worth a word

/// Groups in the order they come, each part with the places of its own.
class Grouping {
 public:
    Grouping(LotQuality& quality, const std::vector<boring::AnnouncedChange>& announced) : m_quality(quality) {
        m_tools.push_back(1);
        for (const boring::AnnouncedChange& change : announced) {
            const bool tool =
                change.kind == boring::StretchKind::Insert || change.kind == boring::StretchKind::Reground;
            if (tool && change.part > 1) {
                m_tools.push_back(change.part);
            }
        }
        std::ranges::sort(m_tools);
    }
    void take(const PartRow& row, LotPart& part) {
        using By = PartGroup::By;
        if (m_quality.lot.process == ProcessId::Boring) {
            const auto after = std::ranges::upper_bound(m_tools, row.number);
            const std::size_t tool = join(
                part, {By::Tool, std::to_string(after == m_tools.begin() ? m_tools.front() : *(after - 1)), {}, {}});
            for (std::size_t i = 0; i < part.judgement.values.size(); ++i) {
                count(part, tool, i);
            }
        }
        // Two bores of a part may come from two gauges, or be entered by two people: each value counts where it
        // belongs.
        for (const MeasurementRow& held : effectiveMeasurements(row.measurements)) {
            count(part, join(part, {By::Person, held.author, {}, {}}), held.station);
            count(part, join(part, {By::Source, held.sourceName, held.source, {}}), held.station);
        }
    }
    void finish() {
        for (std::size_t group = 0; group < m_quality.groups.size(); ++group) {
            for (std::size_t i = 0; i < m_quality.characteristics.size(); ++i) {
                m_quality.groups[group].capability.push_back(
                    quality::capability(m_moments[group][i], m_quality.characteristics[i].tolerance, m_quality.steady));
            }
        }
    }

 private:
    /// The place of this group, which the part then belongs to.
    std::size_t join(LotPart& part, const PartGroup& group) {
        const auto same = [&group](const PartGroup& other) {
            return other.by == group.by && other.name == group.name && other.source == group.source;
        };
        const auto found = std::ranges::find_if(m_quality.groups, same);
        const auto at = static_cast<std::size_t>(found - m_quality.groups.begin());
        if (at == m_quality.groups.size()) {
            m_quality.groups.push_back(group);
            m_moments.emplace_back(m_quality.characteristics.size());
        }
        if (std::ranges::find(part.groups, at) == part.groups.end()) {
            part.groups.push_back(at);
        }
        return at;
    }
    void count(const LotPart& part, std::size_t group, std::size_t characteristic) {
        if (characteristic >= m_moments[group].size()) {
            return;
        }
        if (const auto& value = part.judgement.values[characteristic].value; value && std::isfinite(*value)) {
            m_moments[group][characteristic].add(*value);
        }
    }

    LotQuality& m_quality;
    std::vector<std::uint32_t> m_tools{};
    std::vector<std::vector<quality::Moments>> m_moments{};
};

/// What each part is judged by: the places are those of the lot's characteristics, the limits those of the recipe the
/// part was made under.
class Limits {
 public:
    Limits(const LotQuality& quality, const RecipeLimits& limits) : m_quality(quality), m_limits(limits) {}
    [[nodiscard]] const std::vector<Characteristic>& of(const PartRow& part) {
        if (part.process == ProcessId::Boring) {
            return m_quality.characteristics;
        }
        const std::vector<FigureLimit>& limits = m_limits.of(part);
        if (m_of != &limits) {
            m_of = &limits;
            m_known = withLimits(m_quality.characteristics, limits);
        }
        return m_known;
    }

 private:
    const LotQuality& m_quality;
    const RecipeLimits& m_limits;
    const std::vector<FigureLimit>* m_of{nullptr};
    std::vector<Characteristic> m_known{};
};

/// Of the parts to come, and then what only earlier ones were judged by.
std::vector<Characteristic> figuresOf(const LotHistory& history, const RecipeLimits& limits) {
    std::vector<FigureLimit> all = limits.inForce;
    for (const PartDetail& detail : history.parts) {
        for (const FigureLimit& limit : limits.of(detail.part)) {
            if (std::ranges::find(all, limit.key, &FigureLimit::key) == all.end()) {
                all.push_back(limit);
            }
        }
    }
    return withLimits(characteristicsOf(history.lot.process, {}, all), limits.inForce);
}

void judgeParts(const LotHistory& history, const std::vector<boring::AnnouncedChange>& announced,
                const RecipeLimits& recipes, LotQuality& quality) {
    Limits limits(quality, recipes);
    std::vector<quality::Moments> moments(quality.characteristics.size());
    Grouping groups(quality, announced);
    for (const PartDetail& detail : history.parts) {
        const PartRow& row = detail.part;
        LotPart part{row.number,
                     row.id,
                     row.serial,
                     row.complete,
                     row.endedUtc_ms,
                     judgePart(row, limits.of(row)),
                     {},
                     recipes.revisionOf(row)};
        groups.take(row, part);
        for (std::size_t i = 0; i < moments.size(); ++i) {
            if (const auto& value = part.judgement.values[i].value; value && std::isfinite(*value)) {
                moments[i].add(*value);
            }
        }
        switch (part.judgement.verdict) {
            case quality::Verdict::Good:
                ++quality.good;
                break;
            case quality::Verdict::NotJudged:
                ++quality.notJudged;
                break;
            case quality::Verdict::Rework:
                ++quality.rework;
                break;
            case quality::Verdict::Scrap:
                ++quality.scrap;
                break;
        }
        quality.parts.push_back(std::move(part));
    }
    for (std::size_t i = 0; i < moments.size(); ++i) {
        quality.capability.push_back(
            quality::capability(moments[i], quality.characteristics[i].tolerance, quality.steady));
    }
    groups.finish();
}

/// The lot replayed through its own estimator: what every part was predicted to be before it was measured.
void chartBores(const LotHistory& history, const std::vector<boring::AnnouncedChange>& announced, LotQuality& quality) {
    const Result<BoringRecipe> recipe = recipeFromJson(history.recipe.parametersJson);
    const auto kind = boring::estimatorOf(history.lot.estimator);
    if (!recipe || !kind) {
        return;
    }
    // Eq. 11: a deflection errs by the diameter's error over 2 cos φ.
    quality.gaugeSigma_mm = recipe->sigma_mm * 2.0 * std::cos(recipe->phi_deg * std::numbers::pi / 180.0);
    boring::LotBegin begin;
    begin.memory = !announced.empty();  // of this lot alone: what an announced change brings back
    LotRecords records(*recipe, *kind, begin);
    records.setAnnounced(announced);
    for (const PartDetail& detail : history.parts) {
        records.addPart({detail.part.id, detail.part.number, detail.part.complete, 0,
                         detail.schedule ? detail.schedule->schedule : BoringSchedule{}, detail.feed});
    }
    records.restoreRows(history.measurements);
    const boring::EstimatorParams params = recipe->estimator(*kind);
    boring::EstimatorState before = boring::initialState(params);
    const double middle_mm = 0.5 * (recipe->overhangFrom_mm + recipe->overhangTo_mm);
    std::uint32_t measured = 0;
    const auto changedSince = [&](std::uint32_t part) {
        return std::ranges::any_of(announced, [&](const boring::AnnouncedChange& change) {
            return change.part > std::max(measured, 1U) && change.part <= part;
        });
    };
    for (const boring::LotTracker::Step& step : records.tracker().steps()) {
        const bool changed = changedSince(step.visit.part);
        if (changed) {
            before = records.tracker().stateFor(step.visit.part);
        }
        const boring::OneStepError error = boring::oneStepError(before, params, step.visit);
        before = step.after;
        measured = step.visit.part;
        const auto& cut = records.parts();
        const auto part = std::ranges::lower_bound(cut, step.visit.part, {}, &ServicePart::number);
        // A trace without a feed gives an error that is no number: such a part is not charted.
        const bool finite = std::isfinite(error.level) && std::isfinite(error.tSquared);
        if (error.count == 0 || !finite || part == cut.end() || part->number != step.visit.part) {
            continue;
        }
        ChartedPart charted;
        charted.number = step.visit.part;
        charted.id = part->id;
        charted.error = error.level;
        charted.tSquared = error.tSquared;
        charted.tSquaredLimit = quality::tSquaredLimit(error.count);
        charted.tSquaredChance = quality::chiSquareUpperTail(static_cast<double>(error.count), error.tSquared);
        charted.action = part->schedule.feed_mmPerRev(middle_mm);
        charted.perturbed = step.perturbed();
        charted.announced = changed;
        quality.charted.push_back(charted);
    }
}

/// Figures of processes without a law of the part: the first judged one, against its own centre.
void chartFigure(const LotHistory& history, LotQuality& quality) {
    if (quality.characteristics.empty()) {
        return;
    }
    std::vector<double> values;
    for (const PartDetail& detail : history.parts) {
        const PartJudgement judged = judgePart(detail.part, quality.characteristics);
        if (const auto& value = judged.values.front().value; value && std::isfinite(*value) && detail.part.complete) {
            values.push_back(*value);
            ChartedPart charted;
            charted.number = detail.part.number;
            charted.id = detail.part.id;
            charted.tSquaredLimit = quality::tSquaredLimit(1);
            quality.charted.push_back(charted);
        }
    }
    const quality::CentreLine line = quality::centreLine(values);
    for (std::size_t i = 0; i < values.size() && line.sigma > 0.0; ++i) {
        quality.charted[i].error = (values[i] - line.centre) / line.sigma;
        quality.charted[i].tSquared = quality.charted[i].error * quality.charted[i].error;
    }
}

void runCharts(const quality::ChartParams& params, LotQuality& quality) {
    quality::ChartState chart(params);
    for (ChartedPart& part : quality.charted) {
        if (part.announced) {
            chart.reset();  // another tool: the sums of the one before say nothing about it
        }
        part.point = chart.push(part.error, part.tSquared > part.tSquaredLimit);
        for (std::size_t rule = 0; rule < quality::kRules; ++rule) {
            if (part.point.fired[rule]) {
                quality.found.push_back({part.number, part.id, static_cast<quality::Rule>(rule)});
            }
        }
        if (part.perturbed) {
            chart.reset();  // the law has begun anew, and so do the sums
        }
    }
}

/// Of the lot as a whole, for the indices: charts that run from part to part alarm by chance now and then.
bool isSteady(const LotQuality& quality) {
    std::vector<double> errors;
    for (const ChartedPart& part : quality.charted) {
        errors.push_back(part.error);
    }
    const bool together = std::ranges::all_of(quality.charted, [&](const ChartedPart& part) {
        return part.tSquaredChance >= quality::chanceOfOnePoint(quality.charted.size());
    });
    return quality.lot.process == ProcessId::Boring ? together && quality::isSteady(errors)
                                                    : quality::isSteadySeries(errors);
}

Sentence sentenceOf(const LotQuality& quality) {
    if (quality.charted.size() < quality::kFewestForIndices) {
        return Sentence(KERF_TEXT("%1 parts on the charts: too few to say whether the process is in control."),
                        SentenceArg(static_cast<double>(quality.charted.size()), 0));
    }
    const std::uint32_t newest = quality.charted.back().number;
    if (!quality.found.empty() && quality.found.back().part + kFresh_parts > newest) {
        const QualitySignal& last = quality.found.back();
        return Sentence(KERF_TEXT("Not in control: %1 at part %2; look at tool, gauge and blank of that part."),
                        SentenceArg(std::string_view(quality::ruleText(last.rule))),
                        SentenceArg(static_cast<double>(last.part), 0));
    }
    // Since the process was last taken for another one: what an insert or a material changes is no wear.
    const auto changed = std::ranges::find_if(quality.charted.rbegin(), quality.charted.rend(),
                                              [](const ChartedPart& part) { return part.perturbed || part.announced; });
    const auto behind = static_cast<std::size_t>(changed - quality.charted.rbegin());
    const std::size_t since =
        changed == quality.charted.rend()
            ? 0
            : std::min(quality.charted.size() - 1, quality.charted.size() - behind + kSettling_parts);
    const double first = quality.charted[since].action;
    const double last = quality.charted.back().action;
    if (first > 0.0 && std::abs(last / first - 1.0) > kHarder) {
        return Sentence(KERF_TEXT("In control: the law predicts the parts. The controller has moved the feed by %1 % "
                                  "since part %2: the tool wears."),
                        SentenceArg(100.0 * (last / first - 1.0), 0),
                        SentenceArg(static_cast<double>(quality.charted[since].number), 0));
    }
    if (!quality.found.empty()) {
        return Sentence(KERF_TEXT("In control: the law predicts the parts. The last signal was %1 at part %2."),
                        SentenceArg(std::string_view(quality::ruleText(quality.found.back().rule))),
                        SentenceArg(static_cast<double>(quality.found.back().part), 0));
    }
    return quality.lot.process == ProcessId::Boring
               ? Sentence(KERF_TEXT("In control: the law predicts the parts, and the controller does not work harder."))
               : Sentence(KERF_TEXT("In control: the figures of the parts spread by chance."));
}

}  // namespace

LotQuality analyseLot(const LotHistory& history, const RecipeLimits& limits,
                      const std::vector<boring::AnnouncedChange>& announced, const quality::ChartParams& params) {
    LotQuality quality;
    quality.lot = history.lot;
    quality.recipeRevision = history.recipe.revision;
    const bool bores = history.lot.process == ProcessId::Boring;
    quality.characteristics =
        bores ? characteristicsOf(history.lot.process, history.recipe.parametersJson, {}) : figuresOf(history, limits);
    if (bores) {
        chartBores(history, announced, quality);
    } else {
        chartFigure(history, quality);
    }
    runCharts(params, quality);
    quality.steady = isSteady(quality);
    judgeParts(history, announced, limits, quality);
    quality.sentence = sentenceOf(quality);
    return quality;
}

LotQuality joinLots(std::vector<LotQuality> lots, const quality::ChartParams& params) {
    LotQuality joined;
    joined.lot = lots.back().lot;
    joined.lot.id = allLotsOf(joined.lot.partType);
    joined.recipeRevision = lots.back().recipeRevision;
    joined.characteristics = lots.back().characteristics;
    joined.gaugeSigma_mm = lots.back().gaugeSigma_mm;
    std::vector<quality::Moments> moments(joined.characteristics.size());
    std::uint32_t taken = 0;
    for (LotQuality& lot : lots) {
        if (!std::ranges::equal(lot.characteristics, joined.characteristics, {}, &Characteristic::key,
                                &Characteristic::key)) {
            continue;
        }
        ++taken;
        joined.steady = joined.steady && lot.steady;
        joined.groups.push_back({PartGroup::By::Lot, lot.lot.name, {}, lot.capability});
        for (LotPart& part : lot.parts) {
            part.groups = {joined.groups.size() - 1};
            for (std::size_t i = 0; i < moments.size(); ++i) {
                if (const auto& value = part.judgement.values[i].value; value && std::isfinite(*value)) {
                    moments[i].add(*value);
                }
            }
            joined.parts.push_back(std::move(part));
        }
        if (!lot.charted.empty()) {
            lot.charted.front().announced = true;  // the charts of another lot begin anew
        }
        joined.charted.insert(joined.charted.end(), lot.charted.begin(), lot.charted.end());
        joined.good += lot.good;
        joined.notJudged += lot.notJudged;
        joined.rework += lot.rework;
        joined.scrap += lot.scrap;
    }
    std::ranges::sort(joined.parts, {}, &LotPart::id);
    std::ranges::sort(joined.charted, {}, &ChartedPart::id);
    for (std::size_t i = 0; i < joined.parts.size(); ++i) {
        joined.parts[i].number = static_cast<std::uint32_t>(i + 1);
    }
    for (ChartedPart& part : joined.charted) {
        part.number = std::ranges::lower_bound(joined.parts, part.id, {}, &LotPart::id)->number;
    }
    for (std::size_t i = 0; i < moments.size(); ++i) {
        joined.capability.push_back(
            quality::capability(moments[i], joined.characteristics[i].tolerance, joined.steady));
    }
    runCharts(params, joined);
    joined.sentence =
        Sentence(KERF_TEXT("%1 lots one after the other, %2 parts on the charts, %3 signals."),
                 SentenceArg(static_cast<double>(taken), 0), SentenceArg(static_cast<double>(joined.charted.size()), 0),
                 SentenceArg(static_cast<double>(joined.found.size()), 0));
    return joined;
}

}  // namespace kerf
