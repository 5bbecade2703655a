// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/tapping/session_desk.h"

#include <algorithm>
#include <cmath>

#include "engine/tapping/tap_trajectory.h"
#include "engine/tapping/thread_table.h"
#include "engine/tapping/trial_machine.h"

namespace kerf {
namespace {

constexpr int kMaxTaps = 8;
constexpr double kAbortOverAllowed = 10.0;  ///< abort limit over the allowed peak-to-peak: an untuned drive must pass

TapThreadView viewOf(const tapping::ThreadPreset& thread) {
    return {thread.name, thread.pitch_mm, thread.allowedPp_um(), thread.allowedPpWornTap_um()};
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

TapCurve curveOf(const TuningSession::Trial& trial) {
    TapCurve curve{trial.spindle_rev, trial.error_um, 0};
    const auto deepest = std::ranges::max_element(trial.spindle_rev);
    curve.reversal = static_cast<std::size_t>(deepest - trial.spindle_rev.begin());
    return curve;
}

}  // namespace

SessionTappingDesk::SessionTappingDesk(EngineApi& engine, TapExchange& exchange, const tapping::DriveParams& assumed)
    : m_engine(engine), m_exchange(exchange), m_assumed(assumed) {
    for (const tapping::ThreadPreset& thread : tapping::threadPresets())
        m_threads.push_back(viewOf(thread));
}

Result<void> SessionTappingDesk::begin(const std::string& thread, double speed_rpm, double depth_rev) {
    const tapping::ThreadPreset* preset = tapping::findThread(thread);
    if (preset == nullptr) return fail(KERF_TEXT("This thread is not in the table."));
    const bool busy = m_session && (m_session->state() == TuningSession::State::Air ||
                                    m_session->state() == TuningSession::State::Trial ||
                                    m_session->state() == TuningSession::State::Proposed);
    if (busy) return fail(KERF_TEXT("A tuning is under way: accept it or roll it back first."));
    const ServoGains& set = m_engine.status().tapping.drive;
    tapping::TunerSetup setup;
    setup.assumed = m_assumed;
    setup.assumed.pitch_mm = preset->pitch_mm;
    setup.assumed.speed_rpm = speed_rpm;
    setup.assumed.depth_rev = depth_rev;
    setup.initial = tapping::settingsOf(m_assumed);
    if (set.zKp_perS > 0.0) {
        setup.initial.spindleKp_perS = set.spindleKp_perS;
        setup.initial.zKp_perS = set.zKp_perS;
        setup.initial.zVelocityFf = set.zFeedForward[0];
        setup.initial.zAccelFf = set.zFeedForward[1];
    }
    setup.maxTaps = kMaxTaps;
    TappingJob job;
    job.revision = ++m_jobs;
    job.pitch_mm = preset->pitch_mm;
    job.speed_rpm = speed_rpm;
    job.depth_rev = depth_rev;
    job.engage_rev = m_assumed.engage_rev;
    job.allowedPp_um = preset->allowedPp_um();
    job.abortError_um = kAbortOverAllowed * preset->allowedPp_um();
    const std::vector<TapSpeedPoint> speeds = m_view.speeds;
    const std::uint64_t revision = m_view.revision;
    m_view = TappingDeskView{};
    m_view.revision = revision + 1;
    m_view.speeds = speeds;
    m_view.thread = viewOf(*preset);
    m_view.speed_rpm = speed_rpm;
    m_view.depth_rev = depth_rev;
    m_session = std::make_unique<TuningSession>(m_engine, m_exchange, setup, job, false);
    m_shownTrials = 0;
    rebuild();
    return {};
}

void SessionTappingDesk::oneMore() {
    if (m_session) m_session->confirm();
    rebuild();
}

void SessionTappingDesk::accept() {
    if (m_session) m_session->accept();
    rebuild();
}

void SessionTappingDesk::rollBack() {
    if (m_session) m_session->rollBack();
    rebuild();
}

void SessionTappingDesk::abort() {
    if (m_session) m_session->abort();
}

void SessionTappingDesk::recover() {
    Command command;
    command.action = RecoverTap{};
    (void)m_engine.send(command);  // a refusal comes back in the status
}

void SessionTappingDesk::poll() {
    if (!m_session) return;
    m_session->poll();
    if (m_session->state() != m_shownState || m_session->trials().size() != m_shownTrials) rebuild();
}

void SessionTappingDesk::rebuild() {
    if (!m_session) return;
    const bool finishedNow =
        m_session->state() == TuningSession::State::Done && m_shownState != TuningSession::State::Done;
    m_shownState = m_session->state();
    m_shownTrials = m_session->trials().size();
    ++m_view.revision;
    m_view.state = stateOf(m_shownState);
    m_view.reason = m_session->reason();
    m_view.trials.clear();
    for (const TuningSession::Trial& trial : m_session->trials()) {
        TapTrialView row;
        row.number = static_cast<std::uint32_t>(m_view.trials.size() + 1);
        row.figures = trial.figures;
        row.zKp_perS = trial.settings.zKp_perS;
        row.zVelocityFf = trial.settings.zVelocityFf;
        for (const double trim_mm : trial.settings.zTrim_mm) {
            row.trimPeak_um = std::max(row.trimPeak_um, 1000.0 * std::abs(trim_mm));
        }
        row.accepted = trial.accepted;
        row.counted = trial.counted;
        m_view.trials.push_back(row);
    }
    if (m_session->trials().empty()) return;
    m_view.first = curveOf(m_session->trials().front());
    m_view.current = curveOf(m_session->trials().back());
    const tapping::TunerStep& step = m_session->proposal();
    m_view.nextZKp_perS = step.next.zKp_perS;
    m_view.nextVelocityFf = step.next.zVelocityFf;
    m_view.expectedSaec_mm = step.expectedSaec_mm;
    m_view.lowestZKp_perS = step.safe.lowest_perS;
    m_view.highestZKp_perS = step.safe.highest_perS;
    m_view.criticalZKp_perS = step.safe.critical_perS;
    if (finishedNow) {
        const tapping::TapTrajectory path(m_view.depth_rev, m_view.speed_rpm, m_assumed.ramp_revPerS2);
        m_view.speeds.push_back({m_view.speed_rpm, path.end_s(), m_view.trials.back().figures.engagedPp_um});
    }
}

}  // namespace kerf
