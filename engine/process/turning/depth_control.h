// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>

#include "engine/process/turning/pi_law.h"
#include "engine/process/turning/surface_observer.h"
#include "engine/process/turning/tone_canceller.h"

namespace kerf::turning {

enum class ControllerKind : std::uint8_t { Open, Paper, Pi, Default };

/// Gain of the PI for a plant; `gain` 0 takes the room's own value (paper: 1 − µ = .02 on R0, .3 on R1 and B1).
[[nodiscard]] PiGains paperGains(PlantKind plant, double gain = 0.0) noexcept;
[[nodiscard]] PiGains tunedGains(PlantKind plant, double gain = 0.0) noexcept;

struct DepthControlParams {
    PlantKind plant{PlantKind::B2};
    ControllerKind kind{ControllerKind::Default};
    ProcessParams process{};
    double slidePole{0.994};
    double nominalGain_NPerUm{0.24};
    std::size_t revolutionSamples{291};
    std::array<double, kMaxTones> knownTones_Hz{};
    std::size_t knownCount{0};
    double piGain{0.0};
    /// In the loop on a machine: every law comes and goes by a ramp (80 ms in, 4 ms out), follows the command that
    /// really acts, and the tones are watched whatever law acts. False in the simulations: the laws as published.
    bool onMachine{false};
};

/// One controller of the room: open, paper, pi or default, each regulating the depth error d0 − û and none the cut.
///
/// On R0, R1 and B1 the law sees x_i with its sensor's noise; on B2 only the force. update() takes the sample just
/// measured and returns the command for the next one, µm. It runs in the cycle: no allocation, lock, throw or I/O.
class DepthControl {
 public:
    struct Input {
        double force_N{0.0};
        double inner_um{0.0};  ///< not used on B2
    };
    explicit DepthControl(const DepthControlParams& params) noexcept;

    double update(const Input& input) noexcept;
    void reset() noexcept;
    /// Out of the cut, force only (B2); then the touch.
    void idle(double force_N) noexcept { m_observer.idle(force_N); }
    void beginCut() noexcept;
    /// Another law from the next sample on; the old one's trim ramps away first, what is known of the tones stays.
    void select(ControllerKind kind) noexcept { m_next = kind; }
    [[nodiscard]] ControllerKind kind() const noexcept { return m_params.kind; }
    /// The identified process has moved: the law works with this one from now on, without a step in x̂_i.
    /// @pre process.usable()
    void setProcess(const ProcessParams& process) noexcept;
    [[nodiscard]] const ProcessParams& process() const noexcept { return m_params.process; }

    /// The command that really acts in the sample to come (limits, a held output). On the machine only.
    void setApplied(double command_um) noexcept;
    /// No trim but keep listening; back in, the law ramps itself. On the machine only.
    void setSilent(bool silent) noexcept { m_silent = silent; }
    /// False while x_i is not known yet: the first revolution of B2.
    [[nodiscard]] bool ready() const noexcept { return m_params.plant != PlantKind::B2 || m_observer.ready(); }
    /// û of the last sample (B2).
    [[nodiscard]] double chip_um() const noexcept { return m_observer.chip_um(); }
    /// Its mean (B2): what stands for d0.
    [[nodiscard]] double meanChip_um() const noexcept { return m_observer.meanChip_um(); }
    /// x_i about its level as the law sees it.
    [[nodiscard]] double error_um() const noexcept { return m_error_um; }
    /// The same without the trim. On the machine, or with the default law.
    [[nodiscard]] double untreated_um() const noexcept { return m_canceller.untreatedNow_um(); }
    /// Of this sample: x_i beyond what the tones foresaw. On the machine.
    [[nodiscard]] double innovation_um() const noexcept { return m_canceller.innovation_um(); }
    /// The law acts, or is about to ramp in.
    [[nodiscard]] bool acting() const noexcept;
    /// The default law's inside; in the simulations at rest with another law.
    [[nodiscard]] const ToneCanceller& tones() const noexcept { return m_canceller; }
    /// The same; null for the other laws.
    [[nodiscard]] const ToneCanceller* canceller() const noexcept {
        return m_params.kind == ControllerKind::Default ? &m_canceller : nullptr;
    }

 private:
    [[nodiscard]] double piCommand_um(double inner_um) noexcept;
    void mendSurface(double inner_um) noexcept;

    DepthControlParams m_params;
    ControllerKind m_next;
    bool m_trimKnown;
    SurfaceObserver m_observer;
    DepthPath m_path;
    ToneCanceller m_canceller;
    PiLaw m_pi;
    CutReference m_reference;
    MeanGuard m_guard;
    double m_command_um{0.0};
    double m_error_um{0.0};
    double m_authority{0.0};  ///< of a PI on the machine: 0 … 1
    std::size_t m_actingSamples{0};
    bool m_silent{false};
};

}  // namespace kerf::turning
