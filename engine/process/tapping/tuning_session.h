// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "engine/api/engine_api.h"
#include "engine/process/tapping/tap_exchange.h"
#include "engine/process/tapping/tuning_verdict.h"

namespace kerf {

/// Takes the commands that have been executed out of `sent`; the reason when one of them was refused.
[[nodiscard]] std::optional<Sentence> settleCommands(const Status& status, std::vector<std::uint32_t>& sent);

/// The command that loads settings as revision `revision`; publishes their trim first, so that both arrive together.
[[nodiscard]] LoadTapGains gainsToLoad(TapExchange& exchange, const tapping::TapSettings& settings,
                                       std::uint32_t revision);

/// One tuning on the machine: air tap, two more with the stability probe where the machine takes a trim, first tap with
/// the initial gains, then propose, confirm, tap, decide.
///
/// However it ends, gains and trim of an accepted setting are loaded: the kept ones, or after an abort, a refusal or a
/// roll back the initial ones.
/// Lives beside the page or on a worker, never in the cycle: it takes records from the exchange, asks the tuner, and
/// sends commands. poll() is called on a timer; every call returns at once but the one that asks the tuner (some ms).
class TuningSession {
 public:
    enum class State : std::uint8_t {
        Air,       ///< the job's first taps, without work
        Trial,     ///< a tap with the settings of `trials().back()` or the initial ones
        Proposed,  ///< waits for confirm(), accept() or rollBack()
        Done,      ///< settings accepted; production may go on with them
        Failed,    ///< aborted or refused: reason() says why, the initial settings are loaded
    };
    struct Trial {
        tapping::TapSettings settings{};
        TapFigures figures{};
        bool accepted{false};
        bool counted{true};
        std::vector<float> spindle_rev{};
        std::vector<float> error_um{};  ///< E_r over the tap, for the chart
    };

    /// `automatic`: proposals are confirmed at once, and accepted when the tuner has finished. @pre engine and exchange
    /// outlive the session.
    TuningSession(EngineApi& engine, TapExchange& exchange, const tapping::TunerSetup& setup, const TappingJob& job,
                  bool automatic);

    void poll();
    void setAutomatic(bool automatic);
    /// Make the proposed tap; nothing happens unless mayTapMore(). @pre state() == Proposed
    void confirm();
    /// A proposal stands and the taps of the tuning are not used up.
    [[nodiscard]] bool mayTapMore() const;
    /// Keep the best settings so far; ends the session.
    void accept();
    /// Back to the initial settings; ends the session.
    void rollBack();
    /// End the running tap in sync.
    void abort();

    [[nodiscard]] State state() const { return m_state; }
    [[nodiscard]] const Sentence& reason() const { return m_reason; }
    /// What would help a tuning that has ended outside the tolerance; empty when it holds or goes on.
    [[nodiscard]] const Sentence& help() const { return m_help; }
    [[nodiscard]] const std::vector<Trial>& trials() const { return m_trials; }
    [[nodiscard]] const tapping::TunerStep& proposal() const { return m_step; }
    /// Settings in force when Done.
    [[nodiscard]] const tapping::TapSettings& kept() const { return m_kept; }

 private:
    void send(const decltype(Command::action)& action);
    void load(const tapping::TapSettings& settings, bool accept, bool production);
    void tap(State state);
    void finish(const tapping::TapSettings& settings);
    void failed(const Sentence& why);
    void learn(const TapRecord& record);
    void repeat(const TapRecord& record);
    void airTapped(const TapRecord& record);
    void airTap(double probeSign);
    void judge(const TapRecord& record);
    [[nodiscard]] bool commandsDone();

    EngineApi& m_engine;
    TapExchange& m_exchange;
    tapping::TunerSetup m_setup;
    TappingJob m_job;
    std::vector<double> m_probe_mm{};
    std::vector<std::vector<double>> m_probed_mm{};  ///< Z of the air taps with the probe
    double m_probeSign{0.0};                         ///< of the running air tap
    tapping::RampReach m_reach{};
    Sentence m_help{};
    std::unique_ptr<tapping::Tuner> m_tuner;
    bool m_automatic;
    State m_state{State::Air};
    Sentence m_reason{};
    std::vector<Trial> m_trials{};
    tapping::TunerStep m_step{};
    tapping::TapSettings m_kept{};
    std::vector<std::uint32_t> m_sent{};
    std::uint32_t m_revision{0};
    std::uint32_t m_tapsBefore{0};
    int m_counted{0};
    int m_repeats{0};  ///< taps in a row that did not count
};

}  // namespace kerf
