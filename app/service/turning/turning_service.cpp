// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/service/turning/turning_service.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numbers>

#include "app/service/turning/turning_memory.h"
#include "app/service/turning/turning_records.h"
#include "engine/process/turning/blind.h"
#include "engine/process/turning/depth_control.h"
#include "engine/process/turning/margins.h"
#include "engine/process/turning/overlap.h"
#include "engine/process/turning/spectrum.h"
#include "engine/process/turning/turning_setup.h"

namespace kerf {
namespace {

constexpr std::size_t kPartsShown = 25;
constexpr const char* kAuthor = "Kerf";
constexpr const char* kController = "controller";
constexpr const char* kBroughtLaw = "law of before";
constexpr const char* kPart = "part";
constexpr const char* kMemory = "memory";  // subject: the part
constexpr double kHighestShown_Hz = 420.0;
constexpr double kShareMoved = 0.05;  ///< trust in the tones, weights of the predictions: more are other margins
constexpr double kWeightMoved = 0.1;
constexpr double kToneMoved_Hz = 0.5;
constexpr double kMarginStep = 0.02;  // change of a process parameter or Kalman gain worth another computation
constexpr double kSecondsPerMinute = 60.0;

bool near(double a, double b, double share) {
    return std::abs(a - b) <= share * std::max({std::abs(a), std::abs(b), 1e-9});
}

/// The means of four samples let a high tone through smaller than it is.
double droop(double frequency_Hz) {
    const double x = std::numbers::pi * frequency_Hz / turning::kSampleRate_Hz;
    constexpr auto kCount = static_cast<double>(TurningSurface::kDecimation);
    return x > 0.0 ? std::sin(kCount * x) / (kCount * std::sin(x)) : 1.0;
}

turning::ProcessParams paramsOf(const TurningProcess& process) {
    return {process.a1, process.b0, process.b1};
}

/// A cut without the loop, or one under it, that can be compared: whole, and its second half reached.
bool comparable(const TurningPartView& part) {
    return part.complete && part.record.steadyRms_um > 0.0 && !part.record.leftLoop;
}
bool isClosed(const TurningPartView& part) {
    return part.record.controlled && part.record.controller != TurningController::Open;
}
}  // namespace

StoredTurningService::StoredTurningService(const Links& links)
    : m_links(links),
      m_recipes(m_links.writer, m_links.lots, ProcessId::Turning),
      m_history({m_recipes, [] { return std::string(kPartType); },
                 [this](const RecipeRevision& revision, const std::string& author, const std::string& reason,
                        Done done) { restoreRevision(revision, author, reason, std::move(done)); }}),
      m_lots({m_links.writer, m_links.engine, m_links.lots, ProcessId::Turning, m_links.rights,
              [] { return std::string(kPartType); }, [this] { return recipeJson(); },
              [this] { return m_sentSetup == m_view.setup.revision && m_way.settled(); }, m_links.machineKind}) {
    m_view.setup.revision = 1;
    restore();
    recall();
    m_parts = m_links.writer.onPartStored([this](const StoredPart& stored) { partStored(stored); });
    m_problems = m_links.writer.onProblemChanged([this] { changed(); });
    (void)followBlindTones(m_links.engine.status());
    changed();
}

StoredTurningService::~StoredTurningService() = default;

void StoredTurningService::restore() {
    bool saysLaw = false;
    if (const auto recipes = m_recipes.newest(); recipes && !recipes->empty()) {
        const RecipeRevision& newest = recipes->back().revision;
        if (const auto recipe = turningRecipeFrom(newest.parametersJson, m_view.controller)) {
            m_view.setup = recipe->setup;
            m_view.controller = recipe->controller;
            m_lots.use(newest.id);
        } else {
            m_way.setStoreProblem(
                Sentence(KERF_TEXT("This recipe revision is of another version, or cannot be used.")));
        }
        saysLaw = turningRecipeSaysLaw(newest.parametersJson);
    }
    if (!saysLaw) {
        bringLaw();
    }
    restoreParts();
    compare();
}

void StoredTurningService::restoreParts() {
    const auto rows = m_links.reader.roomRecords(ProcessId::Turning, kPart, {}, kPartsShown);
    if (!rows) {
        m_way.setStoreProblem(rows.error());
        return;
    }
    for (auto row = rows->rbegin(); row != rows->rend(); ++row) {
        if (auto part = turningPartFrom(row->bodyJson)) {
            part->endedUtc_ms = row->createdUtc_ms;
            m_view.parts.push_back(std::move(*part));
        }
    }
    if (!m_view.parts.empty()) {
        m_view.live = m_view.parts.back().spectrum;
    }
    const auto told = m_links.reader.newestRoomRecords(ProcessId::Turning, kMemory);
    if (!told) {
        m_way.setStoreProblem(told.error());
        return;
    }
    for (const RoomRecordRow& row : *told) {
        const auto part = std::ranges::find_if(
            m_view.parts, [&](const TurningPartView& one) { return std::to_string(one.id) == row.subject; });
        if (part != m_view.parts.end()) {
            part->leftOut = row.bodyJson.find("true") != std::string::npos;
            part->leftOutReason = row.reason;
            part->leftOutAuthor = row.author;
        }
    }
}

void StoredTurningService::bringLaw() {
    const auto rows = m_links.reader.roomRecords(ProcessId::Turning, kController, {}, 1);
    const auto law = rows && !rows->empty() ? turningControllerFrom(rows->front().bodyJson) : std::nullopt;
    if (!law) {
        return;
    }
    m_view.controller = *law;
    m_way.keep(
        [this](StoreWriter::Done stored) {
            m_recipes.keep(kPartType, recipeJson(), kAuthor, kBroughtLaw, std::nullopt, std::move(stored));
        },
        [this](const Receipt& revision) { m_lots.use(revision.id); }, {});
}

std::span<const ParamSpec> StoredTurningService::setupSpecs() const {
    return turning::setupSpecs();
}
const ParamSpec& StoredTurningService::toneSpec() const {
    return turning::toneSpec();
}
double StoredTurningService::setupValue(const TurningSetup& setup, std::size_t field) const {
    return turning::valueOf(setup, static_cast<turning::SetupField>(field));
}
void StoredTurningService::changeSetup(TurningSetup& setup, std::size_t field, double value) const {
    turning::setValue(setup, static_cast<turning::SetupField>(field), value);
}
std::optional<Sentence> StoredTurningService::whyUnusable(const TurningSetup& setup) const {
    return turning::whyUnusable(setup);
}
Result<double> StoredTurningService::overlap(double toolRadius_um, double depth_um, double feed_umPerRev) const {
    return turning::overlapFactor(toolRadius_um, depth_um, feed_umPerRev);
}

void StoredTurningService::store(const char* kind, std::string subject, std::string json, const std::string& author,
                                 const std::string& reason, Done done, std::function<void()> stored) {
    AddRoomRecord record;
    record.process = ProcessId::Turning;
    record.kind = kind;
    record.subject = std::move(subject);
    record.bodyJson = std::move(json);
    record.author = author;
    record.reason = reason;
    m_way.keep([&](StoreWriter::Done answer) { m_links.writer.submit(record, std::move(answer)); },
               [stored = std::move(stored)](const Receipt&) {
                   if (stored) {
                       stored();
                   }
               },
               std::move(done));
}

void StoredTurningService::loadSetup(const TurningSetup& setup, const std::string& author, const std::string& reason,
                                     Done done) {
    accept(mayAccept(setup, author, reason), {setup, asked().controller}, author,
           reason.empty() ? "setup changed" : reason, std::nullopt, std::move(done));
}

void StoredTurningService::restoreRevision(const RecipeRevision& revision, const std::string& author,
                                           const std::string& reason, Done done) {
    const auto recipe = turningRecipeFrom(revision.parametersJson, asked().controller);
    if (!recipe) {
        return answer(done, fail(KERF_TEXT("This recipe revision is of another version, or cannot be used.")));
    }
    const auto may = mayAccept(recipe->setup, author, reason);
    const bool otherLaw = recipe->controller != asked().controller;
    accept(may && otherLaw ? permitted(m_links.rights, author, Deed::TurningLaw) : may, *recipe, author, reason,
           revision.revision, std::move(done));
}

void StoredTurningService::accept(const Result<void>& may, const TurningRecipe& recipe, const std::string& author,
                                  const std::string& reason, std::optional<std::uint32_t> restoredFrom, Done done) {
    TurningRecipe next = recipe;
    // Where only the law is another one, the loop has the setup already.
    next.setup.revision = asked().setup.revision;
    if (turningRecipeJson(next) != turningRecipeJson({asked().setup, next.controller})) {
        ++next.setup.revision;
    }
    const auto store = [&](StoreWriter::Done stored) {
        m_asked.ask(next);
        m_recipes.begin(kPartType, recipeJson(), kAuthor);
        m_recipes.keep(
            kPartType, turningRecipeJson(next), author, reason, restoredFrom,
            [this, alive = std::weak_ptr(m_alive), stored = std::move(stored)](const Result<Receipt>& receipt) {
                if (alive.lock()) {
                    m_asked.answered();
                    stored(receipt);
                }
            });
    };
    m_way.change(
        may, store,
        [this, next](const Receipt& revision) {
            m_view.setup = next.setup;
            m_view.controller = next.controller;
            m_lots.use(revision.id);
            recall();
            (void)followBlindTones(m_links.engine.status());
            send();
        },
        std::move(done));
}

Result<void> StoredTurningService::mayAccept(const TurningSetup& setup, const std::string& author,
                                             const std::string& reason) const {
    if (const auto why = turning::whyUnusable(setup)) {
        return tl::unexpected(*why);
    }
    const bool limits = setup.trimAuthority_um > m_view.setup.trimAuthority_um;
    const bool far = raisedFar(m_view.setup.trimAuthority_um, setup.trimAuthority_um);
    return permittedLimit(m_links.rights, author, limits ? Deed::TurningLimits : Deed::TurningSetup, reason, far);
}

void StoredTurningService::setController(TurningController controller, const std::string& author, Done done) {
    accept(permitted(m_links.rights, author, Deed::TurningLaw), {asked().setup, controller}, author, "law chosen",
           std::nullopt, std::move(done));
}

void StoredTurningService::leaveOut(std::int64_t part, bool out, const std::string& author, const std::string& reason,
                                    Done done) {
    const auto place = [this, part] { return std::ranges::find(m_view.parts, part, &TurningPartView::id); };
    Result<void> may = permitted(m_links.rights, author, Deed::TurningMemory, reason);
    if (may && place() == m_view.parts.end()) {
        may = fail(KERF_TEXT("There is no such part."));
    }
    if (may && m_links.engine.status().turning.stage != TurningStage::Idle) {
        may = fail(KERF_TEXT("A part is being cut: leave parts out between two of them."));
    }
    if (!may) {
        if (done) {
            done(may);
        }
        return;
    }
    store(kMemory, std::to_string(part), out ? R"({"left_out":true})" : R"({"left_out":false})", author, reason,
          std::move(done), [this, place, out, author, reason] {
              if (const auto found = place(); found != m_view.parts.end()) {
                  found->leftOut = out;
                  found->leftOutReason = reason;
                  found->leftOutAuthor = author;
              }
              m_anewAfter = m_links.engine.status().partSequence;
              recall();
          });
}

void StoredTurningService::send() {
    if (m_sentSetup != m_view.setup.revision) {
        m_way.owe(
            LoadTurningSetup{m_view.setup, m_lots.withLoad()},
            [wanted = m_view.setup.revision](const Status& status) { return status.turning.nextSetup == wanted; });
        m_sentSetup = m_view.setup.revision;
    }
    if (m_sentController != m_view.controller) {
        m_way.owe(SetTurningController{m_view.controller},
                  [wanted = m_view.controller](const Status& status) { return status.turning.controller == wanted; });
        m_sentController = m_view.controller;
    }
}

void StoredTurningService::poll() {
    send();
    m_way.poll();
    m_lots.send();
    const Status& status = m_links.engine.status();
    const bool surface = takeSurface();
    const bool margins = followMargins(status);
    const bool tones = followBlindTones(status);
    if (surface || margins || tones) {
        changed();
    }
}

TurningSpectrum StoredTurningService::SurfaceSum::mean() const {
    TurningSpectrum spectrum;
    spectrum.step_Hz = step_Hz;
    const auto root = [this](const std::vector<double>& sum, std::vector<float>& out) {
        for (const double power_um2 : sum) {
            out.push_back(static_cast<float>(std::sqrt(power_um2 / static_cast<double>(count))));
        }
    };
    root(treated_um2, spectrum.treated_um);
    root(untreated_um2, spectrum.untreated_um);
    return spectrum;
}

bool StoredTurningService::takeSurface() {
    if (!m_links.exchange.surfaces.refresh()) {
        return false;
    }
    const TurningSurface& surface = m_links.exchange.surfaces.value();
    const bool settled = surface.number > 1;
    if (surface.partSequence != m_sum.partSequence || (settled && !m_sum.settled)) {
        m_sum = {};  // the first surface of a part has the law's own start in it: it counts until there is another one
        m_sum.partSequence = surface.partSequence;
        m_sum.settled = settled;
    }
    const auto add = [&](const std::array<float, TurningSurface::kPoints>& values, std::vector<double>& sum,
                         std::vector<float>& now) {
        now = turning::amplitudeSpectrum(std::span(values).first(surface.count));
        m_sum.step_Hz = turning::spectrumStep_Hz(now.size(), TurningSurface::kRate_Hz);
        now.resize(std::min(now.size(), static_cast<std::size_t>(kHighestShown_Hz / std::max(m_sum.step_Hz, 0.1))));
        sum.resize(now.size());
        for (std::size_t i = 0; i < now.size(); ++i) {
            now[i] /= static_cast<float>(droop(static_cast<double>(i) * m_sum.step_Hz));
            sum[i] += static_cast<double>(now[i]) * static_cast<double>(now[i]);
        }
    };
    m_view.live = {};
    add(surface.treated_um, m_sum.treated_um2, m_view.live.treated_um);
    add(surface.untreated_um, m_sum.untreated_um2, m_view.live.untreated_um);
    ++m_sum.count;
    m_view.live.step_Hz = m_sum.step_Hz;
    m_view.livePart = surface.partSequence;
    return true;
}

StoredTurningService::MarginBasis StoredTurningService::marginBasis(const TurningStatus& status) {
    MarginBasis basis;
    basis.controller = status.controller;
    basis.law = status.lawProcess;
    basis.identified = status.identification.sure;
    basis.value = status.identification.value;
    basis.half95 = status.identification.half95;
    for (std::size_t j = 0; j < status.toneCount && status.controller == TurningController::Tones; ++j) {
        basis.tones.emplace_back(status.tones[j].frequency_Hz, status.tones[j].share);
    }
    if (status.controller == TurningController::Tones && status.acting) {
        basis.toneShare = status.toneShare;
        basis.plain = status.plainWeights;
        basis.underTones = status.underToneWeights;
    }
    return basis;
}

TurningMargins StoredTurningService::computeMargins(const MarginBasis& basis) {
    TurningMargins out;
    const turning::ProcessParams law = paramsOf(basis.law);
    std::vector<turning::FollowedTone> tones;
    for (const auto& [frequency_Hz, share] : basis.tones) {
        tones.push_back({frequency_Hz, share});
    }
    const auto ofTruth = [&](const turning::ProcessParams& truth) {
        switch (basis.controller) {
            case TurningController::Paper:
                return turning::lawMargins(turning::PlantKind::B2, turning::paperGains(turning::PlantKind::B2), law,
                                           truth);
            case TurningController::Pi:
                return turning::lawMargins(turning::PlantKind::B2, turning::tunedGains(turning::PlantKind::B2), law,
                                           truth);
            case TurningController::Open:
            case TurningController::Tones:
                break;
        }
        return turning::defaultMargins({tones, basis.toneShare, basis.plain, basis.underTones}, law, truth,
                                       turning::kSampleRate_Hz);
    };
    const bool toneActs = basis.toneShare > 0.0 && !tones.empty();
    const bool predictionActs = basis.plain != decltype(basis.plain){} || basis.underTones != decltype(basis.plain){};
    out.known = basis.controller != TurningController::Open &&
                (basis.controller != TurningController::Tones || toneActs || predictionActs);
    if (!out.known) {
        return out;
    }
    out.identified = basis.identified;
    const turning::Margins margins =
        basis.identified
            ? turning::guaranteedMargins({basis.value[0], basis.value[1], basis.value[2]}, basis.half95, ofTruth)
            : ofTruth(law);
    if (std::isfinite(margins.gain)) {
        out.gain = margins.gain;
    }
    if (std::isfinite(margins.delay_samples)) {
        out.delay_samples = margins.delay_samples;
    }
    out.phase_deg = margins.phase_deg;
    out.modulus = margins.modulus;
    return out;
}

/// The margins follow the process and the tones; they are computed on a worker, one at a time.
bool StoredTurningService::followMargins(const Status& status) {
    if (m_marginsToCome.valid()) {
        if (m_marginsToCome.wait_for(std::chrono::seconds(0)) != std::future_status::ready) {
            return false;
        }
        m_view.margins = m_marginsToCome.get();
        return true;
    }
    if (status.turning.stage != TurningStage::Cutting) {
        return false;
    }
    MarginBasis basis = marginBasis(status.turning);
    const auto same = [](const MarginBasis& a, const MarginBasis& b) {
        const auto close = [](const auto& x, const auto& y) {
            return near(x[0], y[0], kMarginStep) && near(x[1], y[1], kMarginStep) && near(x[2], y[2], kMarginStep);
        };
        const auto vector = [](const TurningProcess& p) { return std::array{p.a1, p.b0, p.b1}; };
        const auto likeWeights = [](const auto& x, const auto& y) {
            double largest = 0.0;
            double apart = 0.0;
            for (std::size_t i = 0; i < x.size(); ++i) {
                largest = std::max({largest, std::abs(x[i]), std::abs(y[i])});
                apart = std::max(apart, std::abs(x[i] - y[i]));
            }
            return apart <= kWeightMoved * largest;
        };
        return a.controller == b.controller && a.identified == b.identified && close(vector(a.law), vector(b.law)) &&
               std::abs(a.toneShare - b.toneShare) < kShareMoved && likeWeights(a.plain, b.plain) &&
               likeWeights(a.underTones, b.underTones) && (!a.identified || close(a.value, b.value)) &&
               std::equal(a.tones.begin(), a.tones.end(), b.tones.begin(), b.tones.end(),
                          [](const auto& x, const auto& y) {
                              return std::abs(x.first - y.first) < kToneMoved_Hz && near(x.second, y.second, 0.3);
                          });
    };
    if (m_marginBasis && same(*m_marginBasis, basis)) {
        return false;
    }
    m_marginBasis = basis;
    m_marginsToCome = std::async(std::launch::async, [basis = std::move(basis)] { return computeMargins(basis); });
    return false;
}

bool StoredTurningService::followBlindTones(const Status& status) {
    std::vector<double> tones_Hz(m_view.setup.knownTones_Hz.begin(),
                                 m_view.setup.knownTones_Hz.begin() + m_view.setup.knownToneCount);
    const std::size_t known = tones_Hz.size();
    for (std::size_t j = 0; j < status.turning.toneCount; ++j) {
        const double found_Hz = status.turning.tones[j].frequency_Hz;
        // A found tone stands for the known one it is.
        const auto same = std::find_if(tones_Hz.begin(), tones_Hz.end(),
                                       [found_Hz](double tone) { return std::abs(tone - found_Hz) < 2.0; });
        if (same == tones_Hz.end()) {
            tones_Hz.push_back(found_Hz);
        }
    }
    const double speed_rpm = m_view.setup.spindleSpeed_rpm;
    const bool unchanged = speed_rpm == m_blindSpeed_rpm &&
                           std::equal(tones_Hz.begin(), tones_Hz.end(), m_blindTones_Hz.begin(), m_blindTones_Hz.end(),
                                      [](double a, double b) { return std::abs(a - b) < kToneMoved_Hz; });
    if (unchanged) {
        return false;
    }
    m_blindSpeed_rpm = speed_rpm;
    m_blindTones_Hz = tones_Hz;
    m_view.blind = {};
    m_view.blind.spindleSpeed_rpm = speed_rpm;
    const auto report = turning::blindFrequencies(speed_rpm / kSecondsPerMinute, tones_Hz, turning::kSampleRate_Hz);
    if (report) {
        for (std::size_t j = 0; j < report->tones.size(); ++j) {
            const turning::ToneVisibility& tone = report->tones[j];
            m_view.blind.tones.push_back({tone.frequency_Hz, tone.visibility, tone.blind, j >= known});
            m_view.blind.anyBlind = m_view.blind.anyBlind || tone.blind;
        }
        if (report->suggestedWorst > report->worst) {
            m_view.blind.suggestedSpeed_rpm = report->suggested_rps * kSecondsPerMinute;
            m_view.blind.suggestedVisibility = report->suggestedWorst;
        }
    }
    return true;
}

void StoredTurningService::partStored(const StoredPart& stored) {
    if (stored.record.process != ProcessId::Turning || !stored.record.turning.valid) {
        return;
    }
    (void)takeSurface();
    TurningPartView part;
    part.id = stored.id;
    part.number = stored.number;
    part.endedUtc_ms =
        std::chrono::duration_cast<std::chrono::milliseconds>(std::chrono::system_clock::now().time_since_epoch())
            .count();
    part.complete = stored.record.complete;
    part.forceMean_N = stored.record.forceMean_N;
    part.forcePeak_N = stored.record.forcePeak_N;
    part.record = stored.record.turning;
    if (m_sum.partSequence == stored.record.partSequence && m_sum.count > 0) {
        part.spectrum = m_sum.mean();
        m_view.live = part.spectrum;
    }
    (void)m_links.exchange.traces.refresh();
    const TurningForceTrace& trace = m_links.exchange.traces.value();
    for (std::size_t i = 0; trace.partSequence == stored.record.partSequence && i < TurningForceTrace::kPieces; ++i) {
        if (trace.samples[i] > 0) {
            part.force.push_back({(static_cast<double>(i) + 0.5) / TurningForceTrace::kPieces,
                                  static_cast<double>(trace.low_N[i]), static_cast<double>(trace.mean_N[i]),
                                  static_cast<double>(trace.high_N[i])});
        }
    }
    store(kPart, std::to_string(part.id), turningPartJson(part), kAuthor, {}, {}, {});
    m_view.parts.push_back(std::move(part));
    if (m_view.parts.size() > kPartsShown) {
        m_view.parts.erase(m_view.parts.begin());
    }
    m_cutSinceStart = true;
    if (m_anewAfter && stored.record.partSequence > *m_anewAfter) {  // it has begun from what counts
        m_anewAfter.reset();
    }
    recall();
    compare();
    changed();
}

/// What the next part begins from. The process only until the first part after a start: then the loop's own is newer,
/// until a part that it may rest on is left out.
void StoredTurningService::recall() {
    const TurningPast past = turningPast(m_view.parts, m_view.setup);
    m_view.memory = past.view;
    TurningRecall kept = past.recall;
    kept.assumed = m_anewAfter && !kept.processKnown;
    kept.processKnown = kept.processKnown && (!m_cutSinceStart || m_anewAfter);
    m_links.exchange.recall.publish(kept);
}

/// The newest part under the loop, and the newest one without it that was cut with the same setup.
void StoredTurningService::compare() {
    m_view.comparison.reset();
    for (auto closed = m_view.parts.rbegin(); closed != m_view.parts.rend(); ++closed) {
        if (!comparable(*closed) || !isClosed(*closed)) {
            continue;
        }
        for (auto open = m_view.parts.rbegin(); open != m_view.parts.rend(); ++open) {
            const TurningRecord& without = open->record;
            const TurningRecord& with = closed->record;
            // Nothing may have moved the tool in the open one; what the loop would have done does not count.
            const bool untouched = without.trimPeak_um == 0.0;
            if (comparable(*open) && !isClosed(*open) && untouched && sameCut(without.setup, with.setup)) {
                m_view.comparison = TurningComparison{open->number,         closed->number,        with.controller,
                                                      without.steadyRms_um, with.steadyRms_um,     without.steadyPv_um,
                                                      with.steadyPv_um,     without.steadyForce_N, with.steadyForce_N};
                return;
            }
        }
    }
}

std::unique_ptr<Subscription> StoredTurningService::onChanged(std::function<void()> changed) {
    return m_listeners.add(std::move(changed));
}

void StoredTurningService::changed() {
    m_view.storeProblem = m_way.problem().empty() ? m_links.writer.problem() : m_way.problem();
    const TurningSetup& setup = m_view.setup;
    m_view.overlap = turning::overlapFactor(setup.toolRadius_um, setup.depth_um, setup.feed_umPerRev).value_or(0.0);
    ++m_view.revision;
    m_listeners.tell();
}

}  // namespace kerf
