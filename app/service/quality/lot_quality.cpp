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

void judgeParts(const LotHistory& history, LotQuality& quality) {
    std::vector<quality::Moments> moments(quality.characteristics.size());
    for (const PartDetail& detail : history.parts) {
        const PartRow& row = detail.part;
        LotPart part{row.number,   row.id,          row.serial,
                     row.complete, row.endedUtc_ms, judgePart(row, quality.characteristics)};
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
}

/// The lot replayed through its own estimator: what every part was predicted to be before it was measured.
void chartBores(const LotHistory& history, LotQuality& quality) {
    const Result<BoringRecipe> recipe = recipeFromJson(history.recipe.parametersJson);
    const auto kind = boring::estimatorOf(history.lot.estimator);
    if (!recipe || !kind) {
        return;
    }
    // Eq. 11: a deflection errs by the diameter's error over 2 cos φ.
    quality.gaugeSigma_mm = recipe->sigma_mm * 2.0 * std::cos(recipe->phi_deg * std::numbers::pi / 180.0);
    LotRecords records(*recipe, *kind);
    for (const PartDetail& detail : history.parts) {
        records.addPart({detail.part.id, detail.part.number, detail.part.complete, 0,
                         detail.schedule ? detail.schedule->schedule : BoringSchedule{}, detail.feed});
    }
    records.restoreRows(history.measurements);
    const boring::EstimatorParams params = recipe->estimator(*kind);
    boring::EstimatorState before = boring::initialState(params);
    const double middle_mm = 0.5 * (recipe->overhangFrom_mm + recipe->overhangTo_mm);
    for (const boring::LotTracker::Step& step : records.tracker().steps()) {
        const boring::OneStepError error = boring::oneStepError(before, params, step.visit);
        before = step.after;
        const auto& cut = records.parts();
        const auto part = std::ranges::find(cut, step.visit.part, &ServicePart::number);
        // A trace without a feed gives an error that is no number: such a part is not charted.
        const bool finite = std::isfinite(error.level) && std::isfinite(error.tSquared);
        if (error.count == 0 || !finite || part == cut.end()) {
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
                        SentenceArg(std::string_view(quality::ruleKey(last.rule))),
                        SentenceArg(static_cast<double>(last.part), 0));
    }
    // Since the process was last taken for another one: what an insert or a material changes is no wear.
    const auto changed =
        std::ranges::find_if(quality.charted.rbegin(), quality.charted.rend(), &ChartedPart::perturbed);
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
                        SentenceArg(std::string_view(quality::ruleKey(quality.found.back().rule))),
                        SentenceArg(static_cast<double>(quality.found.back().part), 0));
    }
    return quality.lot.process == ProcessId::Boring
               ? Sentence(KERF_TEXT("In control: the law predicts the parts, and the controller does not work harder."))
               : Sentence(KERF_TEXT("In control: the figures of the parts spread by chance."));
}

}  // namespace

LotQuality analyseLot(const LotHistory& history, const std::vector<FigureLimit>& limits,
                      const quality::ChartParams& params) {
    LotQuality quality;
    quality.lot = history.lot;
    quality.recipeRevision = history.recipe.revision;
    quality.characteristics = characteristicsOf(history.lot.process, history.recipe.parametersJson, limits);
    if (history.lot.process == ProcessId::Boring) {
        chartBores(history, quality);
    } else {
        chartFigure(history, quality);
    }
    runCharts(params, quality);
    quality.steady = isSteady(quality);
    judgeParts(history, quality);
    quality.sentence = sentenceOf(quality);
    return quality;
}

}  // namespace kerf
