// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/tapping/tuning_session.h"

#include <algorithm>
#include <utility>

namespace kerf {
namespace {

ServoGains gainsOf(const tapping::TapSettings& settings) {
    return {settings.spindleKp_perS, settings.zKp_perS, {settings.zVelocityFf, settings.zAccelFf}};
}

}  // namespace

TuningSession::TuningSession(EngineApi& engine, TapExchange& exchange, const tapping::TunerSetup& setup,
                             const TappingJob& job, bool automatic)
    : m_engine(engine),
      m_exchange(exchange),
      m_setup(setup),
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
    TapGains gains;
    gains.revision = ++m_revision;
    gains.gains = gainsOf(settings);
    if (!settings.zTrim_mm.empty()) {
        gains.trimRevision = m_revision;
        TrimTable& table = m_exchange.trims.writeSlot();
        table.revision = m_revision;
        table.count = static_cast<std::uint32_t>(std::min(settings.zTrim_mm.size(), kMaxTapTicks));
        std::transform(settings.zTrim_mm.begin(), settings.zTrim_mm.begin() + table.count, table.trim_um.begin(),
                       [](double trim_mm) { return static_cast<float>(1000.0 * trim_mm); });
        m_exchange.trims.publish();
    }
    send(LoadTapGains{gains, accept, production});
}

void TuningSession::tap(State state) {
    m_tapsBefore = m_engine.status().tapping.taps;
    send(StartPart{ProcessId::Tapping});
    if (m_state != State::Failed) m_state = state;
}

bool TuningSession::commandsDone() {
    for (const CommandResult& result : m_engine.status().recentCommands) {
        const auto found = std::ranges::find(m_sent, result.number);
        if (result.number == 0 || found == m_sent.end()) continue;
        m_sent.erase(found);
        if (!result.done) {
            m_state = State::Failed;
            m_reason = result.reason;
        }
    }
    return m_sent.empty();
}

void TuningSession::poll() {
    if (!commandsDone() || (m_state != State::Air && m_state != State::Trial)) return;
    const TappingStatus& status = m_engine.status().tapping;
    if (status.phase == TapPhase::InHole) {
        m_state = State::Failed;
        m_reason = Sentence(KERF_TEXT("The tap stands in the hole: turn it out in sync, then tune again."));
        return;
    }
    if (status.taps == m_tapsBefore) return;
    (void)m_exchange.records.refresh();
    const TapRecord& record = m_exchange.records.value();
    if (status.outcome == TapOutcome::Aborted || record.number != status.taps) {
        m_tuner->rollBack();
        m_state = State::Failed;
        m_reason = Sentence(KERF_TEXT("The tap was aborted: the accepted gains are back in force."));
        return;
    }
    if (m_state == State::Air) {
        if (status.outcome == TapOutcome::Counted && !status.airTapPassed) {
            m_state = State::Failed;
            m_reason = Sentence(KERF_TEXT("The air tap shows another pitch than the one entered."));
            return;
        }
        tap(status.airTapPassed ? State::Trial : State::Air);
        return;
    }
    learn(record);
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
        trial.spindle_rev.push_back(record.spindle_rev[k]);
        trial.error_um.push_back(static_cast<float>(1000.0 * (m_setup.assumed.pitch_mm * spindle_rev[k] - z_mm[k])));
    }
    m_step = m_tuner->observe({spindle_rev, z_mm, valid});
    trial.accepted = m_step.accepted;
    trial.counted = m_step.counted;
    m_trials.push_back(std::move(trial));
    m_reason = m_step.reason;
    if (m_step.finished) {
        finish(m_step.next);
        return;
    }
    m_state = State::Proposed;
    if (m_automatic) confirm();
}

void TuningSession::confirm() {
    if (m_state != State::Proposed) return;
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
