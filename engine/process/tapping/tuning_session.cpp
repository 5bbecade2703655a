// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/process/tapping/tuning_session.h"

#include <algorithm>
#include <utility>

#include "engine/process/tapping/trim_learning.h"

namespace kerf {
namespace {

constexpr int kMostRepeats = 3;  ///< taps in a row that do not count

}  // namespace

std::optional<Sentence> settleCommands(const Status& status, std::vector<std::uint32_t>& sent) {
    std::optional<Sentence> why;
    std::uint32_t oldest = 0;
    for (const CommandResult& result : status.recentCommands) {
        if (result.number == 0) continue;
        oldest = result.number;  // newest first
        if (std::erase(sent, result.number) > 0 && !result.done) why = result.reason;
    }
    // What is older than all that is remembered has been executed too.
    std::erase_if(sent, [oldest](std::uint32_t number) { return number < oldest; });
    return why;
}

LoadTapGains gainsToLoad(TapExchange& exchange, const tapping::TapSettings& settings, std::uint32_t revision) {
    LoadTapGains load;
    load.gains.revision = revision;
    load.gains.gains = {settings.spindleKp_perS, settings.zKp_perS, {settings.zVelocityFf, settings.zAccelFf}};
    if (settings.zTrim_mm.empty()) return load;
    load.gains.trimRevision = revision;
    TrimTable& table = exchange.trims.writeSlot();
    table.revision = revision;
    table.count = static_cast<std::uint32_t>(std::min(settings.zTrim_mm.size(), kMaxTapTicks));
    std::transform(settings.zTrim_mm.begin(), settings.zTrim_mm.begin() + table.count, table.trim_um.begin(),
                   [](double trim_mm) { return static_cast<float>(1000.0 * trim_mm); });
    exchange.trims.publish();
    return load;
}

TuningSession::TuningSession(EngineApi& engine, TapExchange& exchange, const tapping::TunerSetup& setup,
                             const TappingJob& job, bool automatic)
    : m_engine(engine),
      m_exchange(exchange),
      m_setup(setup),
      m_job(job),
      m_tuner(tapping::makeTuner(setup)),
      m_automatic(automatic),
      m_kept(setup.initial) {
    m_revision = engine.status().tapping.nextGains;
    send(LoadTappingJob{job});
    load(setup.initial, true, false);
    tap(State::Air);
}

void TuningSession::send(const decltype(Command::action)& action) {
    Command command;
    command.action = action;
    if (const auto number = m_engine.send(command)) {
        m_sent.push_back(*number);
        return;
    }
    m_state = State::Failed;
    m_reason = Sentence(KERF_TEXT("The engine takes no commands at the moment; try again."));
}

void TuningSession::load(const tapping::TapSettings& settings, bool accept, bool production) {
    LoadTapGains load = gainsToLoad(m_exchange, settings, ++m_revision);
    load.accept = accept;
    load.production = production;
    send(load);
}

void TuningSession::tap(State state) {
    m_tapsBefore = m_engine.status().tapping.taps;
    send(StartPart{ProcessId::Tapping});
    if (m_state != State::Failed) m_state = state;
}

bool TuningSession::commandsDone() {
    if (const auto why = settleCommands(m_engine.status(), m_sent); why && m_state != State::Failed) failed(*why);
    return m_sent.empty();
}

void TuningSession::failed(const Sentence& why) {
    m_state = State::Failed;
    m_reason = why;
    m_kept = m_setup.initial;
    load(m_setup.initial, true, true);  // an abort leaves the accepted gains, but the exchange has a trial's trim
}

void TuningSession::poll() {
    if (!commandsDone() || (m_state != State::Air && m_state != State::Trial)) return;
    const TappingStatus& status = m_engine.status().tapping;
    if (status.phase == TapPhase::InHole) {
        failed(Sentence(KERF_TEXT("The tap stands in the hole: turn it out in sync, then tune again.")));
        return;
    }
    if (status.taps == m_tapsBefore) {
        if (status.phase == TapPhase::Idle) {
            failed(status.problem.empty() ? Sentence(KERF_TEXT("The control did not start the tapping program."))
                                          : status.problem);
        }
        return;
    }
    (void)m_exchange.records.refresh();
    const TapRecord& record = m_exchange.records.value();
    if (status.outcome == TapOutcome::Aborted || record.number != status.taps) {
        failed(Sentence(KERF_TEXT("The tap was aborted: the accepted gains are back in force.")));
        return;
    }
    if (status.outcome == TapOutcome::NotCounted && ++m_repeats >= kMostRepeats) {
        failed(Sentence(KERF_TEXT("%1 taps in a row did not count: check the encoders."),
                        {static_cast<double>(m_repeats), 0}));
        return;
    }
    if (status.outcome == TapOutcome::Counted) m_repeats = 0;
    if (m_state == State::Air) {
        if (status.outcome == TapOutcome::Counted && !status.airTapPassed) {
            failed(Sentence(KERF_TEXT("The air tap shows another pitch than the one entered.")));
            return;
        }
        if (status.airTapPassed) {
            airTapped(record);
        } else {
            airTap(m_probeSign);  // it did not count
        }
        return;
    }
    if (status.outcome == TapOutcome::NotCounted) {
        repeat(record);
    } else {
        learn(record);
    }
    if (m_state == State::Proposed && m_automatic) setAutomatic(true);
}

// The first air tap shows the pitch and how far the axes follow the ramp; the next two measure Z's loop.
void TuningSession::airTapped(const TapRecord& record) {
    const std::vector<double> spindle_rev(record.spindle_rev.begin(), record.spindle_rev.begin() + record.count);
    std::vector<double> z_mm(record.z_mm.begin(), record.z_mm.begin() + record.count);
    const std::vector<std::uint8_t> valid(record.valid.begin(), record.valid.begin() + record.count);
    if (m_probeSign == 0.0) {
        m_reach = tapping::rampReach(m_setup.assumed, m_setup.initial, {spindle_rev, z_mm, valid});
        m_probe_mm = tapping::probeTrim_mm(record.count, m_setup.assumed.tick_s);
        const bool sweeps = std::ranges::any_of(m_probe_mm, [](double trim_mm) { return trim_mm != 0.0; });
        if (m_setup.trim && sweeps) return airTap(1.0);
    } else {
        m_probed_mm.push_back(std::move(z_mm));
        if (m_probeSign > 0.0) return airTap(-1.0);
        m_setup.measured =
            tapping::measureLoop(m_setup.assumed, m_setup.initial, m_probe_mm, {spindle_rev, m_probed_mm.front(), {}},
                                 {spindle_rev, m_probed_mm.back(), {}});
        if (m_setup.measured) m_tuner = tapping::makeTuner(m_setup);
        load(m_setup.initial, true, false);
    }
    tap(State::Trial);
}

void TuningSession::airTap(double probeSign) {
    m_probeSign = probeSign;
    if (probeSign != 0.0) {
        send(LoadTappingJob{m_job});  // its first tap is one in the air again
        tapping::TapSettings settings = m_setup.initial;
        settings.zTrim_mm.resize(std::max(settings.zTrim_mm.size(), m_probe_mm.size()), 0.0);
        for (std::size_t k = 0; k < m_probe_mm.size(); ++k)
            settings.zTrim_mm[k] += probeSign * m_probe_mm[k];
        load(settings, false, false);
    }
    tap(State::Air);
}

// The tuning has ended: inside the tolerance with what is kept, or why not.
void TuningSession::judge(const TapRecord& record) {
    const Trial* kept = nullptr;
    for (const Trial& trial : m_trials) {
        if (trial.counted && (kept == nullptr || trial.figures.engagedPp_um < kept->figures.engagedPp_um))
            kept = &trial;
    }
    if (kept == nullptr) return;
    std::vector<double> error_mm(record.count);
    for (std::size_t k = 0; k < record.count; ++k) {
        error_mm[k] = m_job.pitch_mm * static_cast<double>(record.spindle_rev[k]) - static_cast<double>(record.z_mm[k]);
    }
    const tapping::TuningVerdict verdict =
        tapping::judgeTuning({m_setup, m_reach, m_step.next, m_step.safe, kept->figures.engagedPp_um,
                              m_job.allowedPp_um, 1000.0 * tapping::errorNoise_mm(error_mm), !mayTapMore()});
    if (verdict.within) return;
    m_reason = verdict.why;
    m_help = verdict.help;
}

void TuningSession::repeat(const TapRecord& record) {
    Trial trial;
    trial.settings = m_tuner->settings();
    trial.figures = record.figures;
    trial.counted = false;
    m_trials.push_back(std::move(trial));
    m_step.finished = false;
    m_step.counted = false;
    m_step.next = m_tuner->settings();
    m_reason = Sentence(KERF_TEXT("The last tap does not count: repeat it."));
    m_state = State::Proposed;
}

void TuningSession::learn(const TapRecord& record) {
    const std::size_t count = record.count;
    std::vector<double> spindle_rev(record.spindle_rev.begin(), record.spindle_rev.begin() + record.count);
    std::vector<double> z_mm(record.z_mm.begin(), record.z_mm.begin() + record.count);
    const std::span<const std::uint8_t> valid(record.valid.data(), count);
    Trial trial;
    trial.settings = m_tuner->settings();
    trial.figures = record.figures;
    for (std::size_t k = 0; k < count; ++k) {
        if (record.valid[k] == 0) continue;
        trial.spindle_rev.push_back(record.spindle_rev[k]);
        trial.error_um.push_back(static_cast<float>(1000.0 * (m_setup.assumed.pitch_mm * spindle_rev[k] - z_mm[k])));
    }
    if (m_counted == 0) {
        m_reach = m_reach.lesser(tapping::rampReach(m_setup.assumed, trial.settings, {spindle_rev, z_mm, valid}));
    }
    m_step = m_tuner->observe({spindle_rev, z_mm, valid});
    m_counted += m_step.counted ? 1 : 0;
    trial.accepted = m_step.accepted;
    trial.counted = m_step.counted;
    m_trials.push_back(std::move(trial));
    m_reason = m_step.reason;
    m_state = State::Proposed;
    m_help = Sentence{};
    if (m_step.finished) judge(record);
}

void TuningSession::setAutomatic(bool automatic) {
    m_automatic = automatic;
    if (!automatic || m_state != State::Proposed) return;
    if (m_step.finished) {
        finish(m_step.next);
    } else {
        confirm();
    }
}

bool TuningSession::mayTapMore() const {
    return m_state == State::Proposed && m_counted < m_setup.maxTaps;
}

void TuningSession::confirm() {
    if (!mayTapMore()) return;
    load(m_step.next, false, false);
    tap(State::Trial);
}

void TuningSession::finish(const tapping::TapSettings& settings) {
    m_kept = settings;
    load(settings, true, true);
    if (m_state != State::Failed) m_state = State::Done;
}

void TuningSession::accept() {
    if (m_state != State::Proposed) return;
    if (m_step.finished) {
        finish(m_step.next);
        return;
    }
    m_tuner->rollBack();
    finish(m_tuner->settings());
}

void TuningSession::rollBack() {
    if (m_state == State::Proposed || m_state == State::Done) finish(m_setup.initial);
}

void TuningSession::abort() {
    if (m_state == State::Air || m_state == State::Trial) send(AbortTap{});
}

}  // namespace kerf
