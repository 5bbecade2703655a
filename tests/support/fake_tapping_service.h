// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "engine/process/tapping/tap_trajectory.h"
#include "engine/process/tapping/thread_table.h"
#include "engine/process/tapping/trial_machine.h"
#include "ui/services/tapping_service.h"

namespace kerf::test {

/// A tapping service for GUI tests: a test writes its view and reads what was asked. A tuning on the simulated drive
/// fills it with what a real one shows.
class FakeTappingService : public TappingService {
 public:
    FakeTappingService() {
        for (const tapping::ThreadPreset& thread : tapping::threadPresets()) {
            m_threads.push_back(
                {thread.name, thread.pitch_mm, thread.allowedPp_um(), thread.allowedPpWornTap_um(), thread.coarse});
        }
        loadM8();
    }

    [[nodiscard]] const TappingServiceView& view() const override { return m_view; }
    [[nodiscard]] const std::vector<TapThreadView>& threads() const override { return m_threads; }
    [[nodiscard]] Result<void> load(const TapChoice& choice, const std::string&) override {
        if (!failWith.empty()) return tl::unexpected(failWith);
        loaded.push_back(choice);
        return {};
    }
    [[nodiscard]] Result<void> begin(const std::string& author, bool automatic) override {
        if (!failWith.empty()) return tl::unexpected(failWith);
        calls.push_back((automatic ? "begin automatic " : "begin ") + author);
        return {};
    }
    [[nodiscard]] Result<void> leaveOut(bool out, const std::string& author, const std::string& reason) override {
        if (!failWith.empty()) return tl::unexpected(failWith);
        calls.push_back((out ? "leave out " : "take in ") + author + " " + reason);
        return {};
    }
    void setAutomatic(bool automatic, const std::string&) override {
        edit().automatic = automatic;
        calls.emplace_back(automatic ? "automatic" : "by hand");
    }
    void oneMore(const std::string&) override { calls.emplace_back("one more"); }
    void accept(const std::string& author) override { calls.push_back("accept " + author); }
    void rollBack(const std::string& author) override { calls.push_back("roll back " + author); }
    void abort() override { calls.emplace_back("abort"); }
    void recover() override { calls.emplace_back("recover"); }
    void poll() override {}

    TappingServiceView& edit() {
        ++m_view.revision;
        return m_view;
    }
    /// Trials of a tuning of the reference drive with the noise of a shop floor; the last one proposes.
    void tune(int taps) {
        tapping::TunerSetup setup;
        setup.maxTaps = taps + 1;
        const tapping::Tuning tuning = tapping::runTuning(setup, {}, {2.0, 4096.0, 1.0, 0.2, 0.1}, 7);
        TappingServiceView& view = edit();
        view.trials.clear();
        for (int i = 0; i < taps && i < static_cast<int>(tuning.trials.size()); ++i) {
            const tapping::Trial& trial = tuning.trials[static_cast<std::size_t>(i)];
            TapTrialView row;
            row.number = static_cast<std::uint32_t>(i) + 1;
            row.figures = {trial.measured.saec_mm,
                           trial.measured.peak_um,
                           trial.measured.rms_um,
                           trial.measured.engagedPp_um,
                           1180,
                           0};
            row.settings = settingsOf(trial.settings);
            row.accepted = trial.step.accepted;
            view.trials.push_back(row);
            (i == 0 ? view.first : view.current) = curveOf(trial.settings);
            view.next = settingsOf(trial.step.next);
            view.reason = trial.step.reason;
            view.expectedSaec_mm = trial.step.expectedSaec_mm;
            view.lowestZKp_perS = trial.step.safe.lowest_perS;
            view.highestZKp_perS = trial.step.safe.highest_perS;
            view.criticalZKp_perS = trial.step.safe.critical_perS;
        }
        if (taps == 1) view.current = view.first;
        view.state = TuningState::Proposed;
    }
    /// Accept what tune() has left.
    void acceptTuning() {
        TappingServiceView& view = edit();
        view.state = TuningState::Done;
        view.source = GainsSource::Tuned;
        view.inForce = view.trials.back().settings;
        TuningProof proof;
        proof.before = view.trials.front().settings;
        proof.after = view.inForce;
        proof.first = view.trials.front().figures;
        proof.last = view.trials.back().figures;
        proof.taps = static_cast<std::uint32_t>(view.trials.size());
        proof.author = "Kim";
        view.proof = proof;
        for (const double speed_rpm : {6000.0, 4500.0, 3000.0, 1500.0}) {
            TapSpeedPoint point;
            point.choice.speed_rpm = speed_rpm;
            point.hole_s = tapping::TapTrajectory(22.0, speed_rpm, 500.0).end_s();
            point.firstPp_um = 500.0;
            point.engagedPp_um = 2.0 + speed_rpm / 1000.0;
            point.current = speed_rpm == 3000.0;
            view.speeds.push_back(point);
        }
    }

    std::vector<TapChoice> loaded{};
    std::vector<std::string> calls{};
    Sentence failWith{};

 private:
    void loadM8() {
        m_view.revision = 1;
        m_view.loaded = true;
        m_view.inForce = {40.0, 48.0, 0.0, 0.0, 0.0};
        for (const TapThreadView& thread : m_threads) {
            if (thread.name == "M8") m_view.thread = thread;
        }
    }
    static TapSettingsView settingsOf(const tapping::TapSettings& settings) {
        TapSettingsView view{settings.spindleKp_perS, settings.zKp_perS, settings.zVelocityFf, settings.zAccelFf, 0.0};
        for (const double trim_mm : settings.zTrim_mm) {
            view.trimPeak_um = std::max(view.trimPeak_um, 1000.0 * std::abs(trim_mm));
        }
        return view;
    }
    static TapCurve curveOf(const tapping::TapSettings& settings) {
        tapping::TrialMachine machine({}, {}, 1);
        const tapping::TapSignals tap = machine.tap(settings);
        TapCurve curve;
        for (std::size_t k = 0; k < tap.z_mm.size(); ++k) {
            curve.spindle_rev.push_back(static_cast<float>(tap.spindle_rev[k]));
            curve.error_um.push_back(static_cast<float>(1000.0 * (1.25 * tap.spindle_rev[k] - tap.z_mm[k])));
            if (curve.spindle_rev[k] > curve.spindle_rev[curve.reversal]) curve.reversal = k;
        }
        return curve;
    }

    std::vector<TapThreadView> m_threads{};
    TappingServiceView m_view{};
};

}  // namespace kerf::test
