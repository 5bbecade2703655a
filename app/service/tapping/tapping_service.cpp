// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/service/tapping/tapping_service.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/core/number_text.h"
#include "engine/core/units.h"
#include "engine/process/tapping/tap_trajectory.h"
#include "engine/process/tapping/thread_table.h"
#include "engine/process/tapping/trial_machine.h"

namespace kerf {
namespace {

constexpr std::size_t kCurvePoints = 240;     ///< of a stored curve
constexpr std::size_t kProductionTaps = 200;  ///< shown
constexpr double kMargin_s = 0.5;             ///< a control may begin and end a tap late

std::string jobText(const TapChoice& choice) {
    return choice.thread + ", " + fixedText(choice.speed_rpm, 0) + " rpm, " + fixedText(choice.depth_rev, 1) + " rev";
}

TapThreadView viewOf(const tapping::ThreadPreset& thread) {
    return {thread.name, thread.pitch_mm, thread.allowedPp_um(), thread.allowedPpWornTap_um(), thread.coarse};
}

TapSettingsView viewOf(const tapping::TapSettings& settings) {
    TapSettingsView view{settings.spindleKp_perS, settings.zKp_perS, settings.zVelocityFf, settings.zAccelFf, 0.0};
    for (const double trim_mm : settings.zTrim_mm) {
        view.trimPeak_um = std::max(view.trimPeak_um, 1000.0 * std::abs(trim_mm));
    }
    return view;
}

TuningState stateOf(TuningSession::State state) {
    switch (state) {
        case TuningSession::State::Air:
            return TuningState::AirTap;
        case TuningSession::State::Trial:
            return TuningState::Trial;
        case TuningSession::State::Proposed:
            return TuningState::Proposed;
        case TuningSession::State::Done:
            return TuningState::Done;
        case TuningSession::State::Failed:
            break;
    }
    return TuningState::Failed;
}

TapCurve curveOf(std::vector<float> spindle_rev, std::vector<float> error_um) {
    TapCurve curve{std::move(spindle_rev), std::move(error_um), 0};
    const auto deepest = std::ranges::max_element(curve.spindle_rev);
    curve.reversal = static_cast<std::size_t>(deepest - curve.spindle_rev.begin());
    return curve;
}

bool sameGains(const tapping::TapSettings& a, const tapping::TapSettings& b) {
    const auto same = [](double x, double y) { return std::abs(x - y) <= 1e-6 * std::max(1.0, std::abs(y)); };
    return same(a.spindleKp_perS, b.spindleKp_perS) && same(a.zKp_perS, b.zKp_perS) &&
           same(a.zVelocityFf, b.zVelocityFf) && same(a.zAccelFf, b.zAccelFf);
}

/// The trial that was made with the settings kept: the last accepted one.
const TuningSession::Trial& keptTrial(const std::vector<TuningSession::Trial>& trials) {
    const auto found = std::find_if(trials.rbegin(), trials.rend(), [](const auto& trial) { return trial.accepted; });
    return found == trials.rend() ? trials.back() : *found;
}

}  // namespace

StoredTappingService::StoredTappingService(EngineApi& engine, TapExchange& exchange, Params params)
    : m_engine(engine), m_exchange(exchange), m_params(std::move(params)) {
    for (const tapping::ThreadPreset& thread : tapping::threadPresets())
        m_threads.push_back(viewOf(thread));
}

bool StoredTappingService::busy() const {
    return m_session && m_session->state() != TuningSession::State::Done &&
           m_session->state() != TuningSession::State::Failed;
}

std::optional<Sentence> StoredTappingService::whyNotNow() {
    if (busy()) return Sentence(KERF_TEXT("A tuning is under way: accept it or roll it back first."));
    const TappingStatus& status = m_engine.status().tapping;
    if (status.phase == TapPhase::InHole) return Sentence(KERF_TEXT("A tap stands in the hole: turn it out first."));
    if (status.phase != TapPhase::Idle) return Sentence(KERF_TEXT("A tap is under way."));
    return {};
}

std::optional<Sentence> StoredTappingService::whyNot(const TapChoice& choice) {
    if (tapping::findThread(choice.thread) == nullptr) {
        return Sentence(KERF_TEXT("This thread is not in the table."));
    }
    if (!(choice.speed_rpm >= 10.0 && choice.speed_rpm <= 20'000.0)) {
        return Sentence(KERF_TEXT("The spindle speed must be from 10 to 20000 rpm."));
    }
    if (!(choice.depth_rev >= 1.0 && choice.depth_rev <= 200.0)) {
        return Sentence(KERF_TEXT("The depth must be from 1 to 200 revolutions."));
    }
    if (choice.gear < 1 || choice.gear > 9) return Sentence(KERF_TEXT("The gear must be from 1 to 9."));
    const tapping::TapTrajectory path(choice.depth_rev, choice.speed_rpm, m_params.assumed.ramp_revPerS2);
    const double hole_s = path.end_s() + m_params.assumed.tail_s;
    const double longest_s =
        static_cast<double>(kMaxTapTicks * static_cast<std::size_t>(m_engine.capabilities().cycle_ns)) /
            kNanosecondPerSecond -
        kMargin_s;
    if (hole_s > longest_s) {
        return Sentence(KERF_TEXT("This tap takes %1 s; at most %2 s can be recorded: a higher speed or less depth."),
                        {hole_s, 1}, {longest_s, 1});
    }
    return {};
}

TappingJob StoredTappingService::jobFor(const TapChoice& choice) {
    const tapping::ThreadPreset* preset = tapping::findThread(choice.thread);
    TappingJob job;
    job.revision = ++m_jobs;
    job.pitch_mm = preset->pitch_mm;
    job.speed_rpm = choice.speed_rpm;
    job.depth_rev = choice.depth_rev;
    job.engage_rev = m_params.assumed.engage_rev;
    job.allowedPp_um = preset->allowedPp_um();
    job.abortError_um = m_params.abortOverAllowed * preset->allowedPp_um();
    job.gear = choice.gear;
    return job;
}

// The drive may still have gains of an earlier run: then that tuning knows what was there before.
tapping::TapSettings StoredTappingService::machinesOwn() {
    const ServoGains& set = m_engine.status().tapping.drive;
    tapping::TapSettings own = tapping::settingsOf(m_params.assumed);
    if (set.zKp_perS > 0.0) {
        own.spindleKp_perS = set.spindleKp_perS;
        own.zKp_perS = set.zKp_perS;
        own.zVelocityFf = set.zFeedForward[0];
        own.zAccelFf = set.zFeedForward[1];
    }
    for (const tapping::StoredTuning& tuning : m_params.known) {
        if (sameGains(tuning.settings, own)) return tuning.own;
    }
    return own;
}

const tapping::StoredTuning* StoredTappingService::newestFor(const TapChoice& choice, GainsSource& how) const {
    const tapping::StoredTuning* nearby = nullptr;
    how = GainsSource::Machine;
    const auto known = tapping::standing(m_params.known);
    for (auto at = known.rbegin(); at != known.rend(); ++at) {
        const tapping::StoredTuning* tuning = *at;
        const GainsSource serves = tapping::serves(*tuning, choice);
        if (serves == GainsSource::Stored) {
            how = serves;
            return tuning;
        }
        if (serves == GainsSource::StoredGains && nearby == nullptr) nearby = tuning;
    }
    if (nearby != nullptr) how = GainsSource::StoredGains;
    return nearby;
}

void StoredTappingService::send(const decltype(Command::action)& action) {
    Command command;
    command.action = action;
    if (const auto number = m_engine.send(command)) {
        m_sent.push_back(*number);
    } else {
        m_view.reason = Sentence(KERF_TEXT("The engine takes no commands at the moment; try again."));
    }
}

Result<void> StoredTappingService::load(const TapChoice& wanted, const std::string& author) {
    if (const auto may = permitted(m_params.rights, author, Deed::TappingJob); !may) return may;
    const TapChoice choice = wanted;  // it may be one of the view, which is made anew
    if (const auto why = whyNotNow()) return tl::unexpected(*why);
    if (const auto why = whyNot(choice)) return tl::unexpected(*why);
    if (!m_own) m_own = machinesOwn();
    m_session.reset();
    const std::uint64_t revision = m_view.revision;
    const bool automatic = m_view.automatic;
    const Sentence problem = m_view.storeProblem;
    m_view = TappingServiceView{};
    m_view.revision = revision + 1;
    m_view.automatic = automatic;
    m_view.storeProblem = problem;
    m_view.loaded = true;
    m_view.choice = choice;
    m_view.thread = viewOf(*tapping::findThread(choice.thread));
    m_view.engage_rev = m_params.assumed.engage_rev;
    m_inForce = *m_own;
    const tapping::StoredTuning* stored = newestFor(choice, m_view.source);
    if (stored != nullptr) {
        m_inForce = stored->settings;
        if (m_view.source == GainsSource::StoredGains) m_inForce.zTrim_mm.clear();
        m_view.proof = stored->proof;
        m_view.first = stored->first;
        if (m_view.source == GainsSource::Stored) m_view.current = stored->last;
    }
    m_view.inForce = viewOf(m_inForce);
    if (const tapping::StoredTuning* out = tapping::leftOutFor(m_params.known, choice)) {
        m_view.leftOut = out->leftOutAuthor + ": " + out->leftOutReason;
    }
    showStored();
    std::optional<WorkOrder> order;
    if (m_params.order) order = m_params.order(stored != nullptr ? stored->recipe : 0);
    const TappingJob job = jobFor(choice);
    m_way.owe(LoadTappingJob{job, order},
              [wanted = job.revision](const Status& status) { return status.tapping.job == wanted; });
    if (author != kItself) note(author, Deed::TappingJob, jobText(choice));
    if (m_engine.capabilities().servoGains.fitted) {
        // Of a number that no other has: those of a load before may still be on their way.
        m_gains = std::max(m_gains, m_engine.status().tapping.nextGains) + 1;
        LoadTapGains gains = gainsToLoad(m_exchange, m_inForce, m_gains);
        gains.accept = true;
        gains.production = true;
        m_way.owe(gains, [wanted = m_gains](const Status& status) { return status.tapping.nextGains == wanted; });
    }
    m_seenTaps = m_engine.status().tapping.taps;
    return {};
}

Result<void> StoredTappingService::leaveOut(bool out, const std::string& author, const std::string& reason) {
    if (const auto may = permitted(m_params.rights, author, Deed::TappingMemory, reason); !may) return may;
    if (const auto why = whyNotNow()) return tl::unexpected(*why);
    if (!m_view.loaded) return fail(KERF_TEXT("No tapping job is loaded."));
    GainsSource how{};
    const tapping::StoredTuning* tuning =
        out ? newestFor(m_view.choice, how) : tapping::leftOutFor(m_params.known, m_view.choice);
    if (tuning == nullptr) {
        return out ? fail(KERF_TEXT("This job began from no stored tuning."))
                   : fail(KERF_TEXT("No stored tuning of this job is left out."));
    }
    tapping::StoredTuning word = *tuning;
    word.leftOut = out;
    word.leftOutReason = reason;
    word.leftOutAuthor = author;
    keep(word, {author, reason, {}}, true);
    return load(m_view.choice, author);
}

void StoredTappingService::takeBack(const tapping::StoredTuning& tuning, std::uint32_t revision,
                                    const std::string& author, const std::string& reason,
                                    const RecipeHistory::Done& done) {
    const auto answer = [&done](const Result<void>& result) {
        if (done) done(result);
    };
    if (const auto may = permitted(m_params.rights, author, Deed::TappingTuning); !may) return answer(may);
    if (const auto why = whyNotNow()) return answer(tl::unexpected(*why));
    if (tuning.leftOut) {
        return answer(
            fail(KERF_TEXT("This revision leaves a tuning out or takes it in; it has no settings of its own.")));
    }
    if (!m_params.store) return answer(fail(KERF_TEXT("Nothing is stored here.")));
    m_way.keep(
        storing(tuning, {author, reason, revision}),
        [this, tuning, author](const Receipt& stored) {
            m_params.known.push_back(tuning);
            m_params.known.back().recipe = stored.id;
            if (m_view.loaded) {
                if (const auto loaded = load(m_view.choice, author); !loaded) refused(loaded.error());
            }
        },
        done);
}

void StoredTappingService::keep(const tapping::StoredTuning& tuning, const tapping::TuningWords& words, bool isWord) {
    m_params.known.push_back(tuning);
    m_params.known.back().recipe = isWord ? tuning.recipe : 0;
    if (!m_params.store) return;
    m_way.keep(storing(tuning, words),
               [this, isWord, place = m_params.known.size() - 1](const Receipt& stored) {
                   if (isWord) return;
                   m_params.known[place].recipe = stored.id;
                   useRecipe(stored.id);
               },
               {});
}

ChangeWay::Store StoredTappingService::storing(const tapping::StoredTuning& tuning,
                                               const tapping::TuningWords& words) const {
    return [this, tuning, words](StoreWriter::Done stored) {
        m_params.store(tuning, words, [stored = std::move(stored)](const Result<std::int64_t>& revision) {
            stored(revision ? Result<Receipt>(Receipt{*revision, 0}) : tl::unexpected(revision.error()));
        });
    };
}

void StoredTappingService::show() {
    if (!m_way.problem().empty()) m_view.reason = m_way.problem();
    ++m_view.revision;
}

void StoredTappingService::recipeRevised(std::int64_t revision) {
    GainsSource how{};
    const tapping::StoredTuning* held = newestFor(m_view.choice, how);
    for (tapping::StoredTuning& known : m_params.known) {
        known.recipe = &known == held ? revision : known.recipe;
    }
    useRecipe(revision);
}

void StoredTappingService::useRecipe(std::int64_t recipe) {
    if (!m_params.order) return;
    const WorkOrder order = m_params.order(recipe);
    m_way.owe(NameOrder{ProcessId::Tapping, order}, [order](const Status& status) {
        return status.orders[static_cast<std::size_t>(ProcessId::Tapping)] == order;
    });
}

Result<void> StoredTappingService::begin(const std::string& author, bool automatic) {
    if (const auto may = permitted(m_params.rights, author, Deed::TappingTuning); !may) return may;
    if (const auto why = whyNotNow()) return tl::unexpected(*why);
    if (!m_view.loaded) return fail(KERF_TEXT("No tapping job is loaded."));
    const Capability& gains = m_engine.capabilities().servoGains;
    if (!gains.fitted) return tl::unexpected(gains.why);
    const TapChoice& choice = m_view.choice;
    tapping::TunerSetup setup;
    setup.assumed = m_params.assumed;
    setup.assumed.tick_s = static_cast<double>(m_engine.capabilities().cycle_ns) / kNanosecondPerSecond;
    setup.assumed.pitch_mm = m_view.thread.pitch_mm;
    setup.assumed.speed_rpm = choice.speed_rpm;
    setup.assumed.depth_rev = choice.depth_rev;
    setup.initial = m_inForce;
    setup.maxTaps = m_params.maxTaps;
    setup.trim = m_engine.capabilities().zTrim.fitted;
    m_before = m_inForce;
    m_author = author;
    m_view.automatic = automatic;
    m_way.forgetOwed();  // the session loads its own
    m_session = std::make_unique<TuningSession>(m_engine, m_exchange, setup, jobFor(choice), automatic);
    note(author, Deed::TappingTuning, "begun for " + jobText(choice));
    m_shownTrials = 0;
    m_shownState = m_session->state();
    rebuild();
    return {};
}

void StoredTappingService::setAutomatic(bool automatic, const std::string& author) {
    if (const auto may = permitted(m_params.rights, author, Deed::TappingTuning); !may) return refused(may.error());
    note(author, Deed::TappingTuning, automatic ? "proposals accepted by themselves" : "proposals asked for");
    m_view.automatic = automatic;
    if (m_session) m_session->setAutomatic(automatic);
    rebuild();
}

void StoredTappingService::oneMore(const std::string& author) {
    if (const auto may = permitted(m_params.rights, author, Deed::TappingTuning); !may) return refused(may.error());
    if (m_session) m_session->confirm();
    rebuild();
}

void StoredTappingService::note(const std::string& author, Deed deed, const std::string& what) const {
    if (m_params.note) m_params.note(author, permissionOf(deed).key, what);
}

void StoredTappingService::refused(const Sentence& why) {
    m_view.reason = why;
    ++m_view.revision;
}

void StoredTappingService::accept(const std::string& author) {
    if (const auto may = permitted(m_params.rights, author, Deed::TappingTuning); !may) return refused(may.error());
    m_author = author;
    if (m_session) m_session->accept();
    rebuild();
}

void StoredTappingService::rollBack(const std::string& author) {
    if (const auto may = permitted(m_params.rights, author, Deed::TappingTuning); !may) return refused(may.error());
    m_author = author;
    if (!m_session) return;
    const bool wasDone = m_session->state() == TuningSession::State::Done;
    m_session->rollBack();
    if (wasDone && m_view.source == GainsSource::Tuned) decided(author, true);
    rebuild();
}

void StoredTappingService::abort() {
    if (m_session && busy()) {
        m_session->abort();
    } else {
        send(AbortTap{});
    }
}

void StoredTappingService::recover() {
    send(RecoverTap{});
}

void StoredTappingService::setStoreProblem(const Sentence& why) {
    m_view.storeProblem = why;
    ++m_view.revision;
}

void StoredTappingService::poll() {
    const Status& status = m_engine.status();
    m_way.poll();
    if (const auto why = settleCommands(status, m_sent)) {
        m_view.reason = *why;
        ++m_view.revision;
    }
    if (!m_view.loaded) {  // what was tapped last, as soon as the drive has told its gains
        const bool known = status.tapping.drive.zKp_perS > 0.0 || !m_engine.capabilities().servoGains.fitted;
        if (status.cycle > 0 && known)
            (void)load(m_params.known.empty() ? TapChoice{} : m_params.known.back().choice, kItself);
        return;
    }
    if (m_session) {
        m_session->poll();
        if (m_session->state() != m_shownState || m_session->trials().size() != m_shownTrials) rebuild();
    }
    if (!busy()) watchProduction();
}

void StoredTappingService::watchProduction() {
    const TappingStatus& status = m_engine.status().tapping;
    if (status.taps == m_seenTaps) return;
    m_seenTaps = status.taps;
    (void)m_exchange.records.refresh();
    const TapRecord& record = m_exchange.records.value();
    if (record.number != status.taps || record.kind != TapKind::Production || record.job != status.job) return;
    std::vector<float> spindle_rev;
    std::vector<float> error_um;
    for (std::size_t k = 0; k < record.count; ++k) {
        if (record.valid[k] == 0) continue;
        spindle_rev.push_back(record.spindle_rev[k]);
        error_um.push_back(
            static_cast<float>(1000.0 * (m_view.thread.pitch_mm * static_cast<double>(record.spindle_rev[k]) -
                                         static_cast<double>(record.z_mm[k]))));
    }
    m_view.current = curveOf(std::move(spindle_rev), std::move(error_um));
    if (record.outcome == TapOutcome::Counted) {
        m_view.productionSaec_mm.push_back(static_cast<float>(record.figures.saec_mm));
        if (m_view.productionSaec_mm.size() > kProductionTaps) {
            m_view.productionSaec_mm.erase(m_view.productionSaec_mm.begin());
        }
    }
    ++m_view.revision;
}

void StoredTappingService::showStored() {
    m_view.speeds.clear();
    const auto known = tapping::standing(m_params.known);
    for (auto at = known.rbegin(); at != known.rend(); ++at) {
        const tapping::StoredTuning* tuning = *at;
        TapChoice there = m_view.choice;
        there.speed_rpm = tuning->choice.speed_rpm;
        there.depth_rev = tuning->choice.depth_rev;
        const auto newer = [&](const TapSpeedPoint& p) {
            return p.choice.speed_rpm == there.speed_rpm && p.choice.depth_rev == there.depth_rev;
        };
        if (tapping::serves(*tuning, there) != GainsSource::Stored || std::ranges::any_of(m_view.speeds, newer)) {
            continue;
        }
        m_view.speeds.push_back({there, tuning->hole_s, tuning->proof.first.engagedPp_um,
                                 (tuning->proof.rolledBack ? tuning->proof.first : tuning->proof.last).engagedPp_um,
                                 tapping::serves(*tuning, m_view.choice) == GainsSource::Stored});
    }
    std::ranges::sort(m_view.speeds, {}, &TapSpeedPoint::hole_s);
}

// Somebody (or the automatic) has accepted settings: they are in force, kept and proven.
void StoredTappingService::decided(const std::string& author, bool rolledBack) {
    m_inForce = m_session->kept();
    m_view.source = GainsSource::Tuned;
    tapping::StoredTuning tuning;
    tuning.choice = m_view.choice;
    tuning.settings = m_inForce;
    tuning.own = *m_own;
    const auto& trials = m_session->trials();
    tuning.proof.before = viewOf(m_before);
    tuning.proof.after = viewOf(rolledBack ? m_before : m_inForce);
    tuning.proof.first = trials.front().figures;
    tuning.proof.last = keptTrial(trials).figures;
    tuning.proof.taps = static_cast<std::uint32_t>(trials.size());
    tuning.proof.author = author;
    tuning.proof.rolledBack = rolledBack;
    tuning.hole_s =
        tapping::TapTrajectory(m_view.choice.depth_rev, m_view.choice.speed_rpm, m_params.assumed.ramp_revPerS2)
            .end_s();
    tuning.first = tapping::thinned(m_view.first, kCurvePoints);
    tuning.last = tapping::thinned(curveOf(keptTrial(trials).spindle_rev, keptTrial(trials).error_um), kCurvePoints);
    m_view.proof = tuning.proof;
    keep(tuning, {author, rolledBack ? "rolled back" : "accepted", {}}, false);
    showStored();
}

void StoredTappingService::rebuild() {
    ++m_view.revision;
    if (!m_session) return;
    const bool finishedNow =
        m_session->state() == TuningSession::State::Done && m_shownState != TuningSession::State::Done;
    m_shownState = m_session->state();
    m_shownTrials = m_session->trials().size();
    m_view.state = stateOf(m_shownState);
    m_view.reason = m_session->reason();
    m_view.help = m_session->help();
    m_view.mayTapMore = m_session->mayTapMore();
    m_view.trials.clear();
    for (const TuningSession::Trial& trial : m_session->trials()) {
        TapTrialView row;
        row.number = static_cast<std::uint32_t>(m_view.trials.size() + 1);
        row.figures = trial.figures;
        row.settings = viewOf(trial.settings);
        row.accepted = trial.accepted;
        row.counted = trial.counted;
        m_view.trials.push_back(row);
    }
    if (!m_session->trials().empty()) {
        const auto& first = m_session->trials().front();
        const auto& last = m_session->trials().back();
        m_view.first = curveOf(first.spindle_rev, first.error_um);
        m_view.current = curveOf(last.spindle_rev, last.error_um);
        const tapping::TunerStep& step = m_session->proposal();
        m_view.next = viewOf(step.next);
        m_view.finished = m_view.state == TuningState::Proposed && step.finished;
        m_view.expectedSaec_mm = step.expectedSaec_mm;
        m_view.lowestZKp_perS = step.safe.lowest_perS;
        m_view.highestZKp_perS = step.safe.highest_perS;
        m_view.criticalZKp_perS = step.safe.critical_perS;
        // Rolled back before anything was accepted: nothing has changed, nothing is stored.
        const bool changed = !sameGains(m_session->kept(), m_before) || m_session->kept().zTrim_mm != m_before.zTrim_mm;
        if (finishedNow && changed) decided(m_author, false);
        if (finishedNow) m_inForce = m_session->kept();
    }
    m_view.inForce = viewOf(m_inForce);
}

}  // namespace kerf
