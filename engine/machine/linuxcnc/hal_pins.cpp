// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/machine/linuxcnc/hal_pins.h"

namespace kerf::linuxcnc {
namespace {

/// Makes pins of one component and remembers whether all went well.
class Maker {
 public:
    explicit Maker(int component) : m_component(component) {}

    void operator()(FloatPin& pin, hal_pin_dir_t direction, const std::string& name) {
        make(pin,
             [&](hal_float_t** slot) { return hal_pin_float_newf(direction, slot, m_component, "%s", name.c_str()); });
    }
    void operator()(BitPin& pin, hal_pin_dir_t direction, const std::string& name) {
        make(pin, [&](hal_bit_t** slot) { return hal_pin_bit_newf(direction, slot, m_component, "%s", name.c_str()); });
    }
    void operator()(IntPin& pin, hal_pin_dir_t direction, const std::string& name) {
        make(pin, [&](hal_s32_t** slot) { return hal_pin_s32_newf(direction, slot, m_component, "%s", name.c_str()); });
    }
    [[nodiscard]] bool good() const { return m_good; }

 private:
    template <class Value, class Call>
    void make(Pin<Value>& pin, const Call& call) {
        auto** slot = static_cast<volatile Value**>(hal_malloc(sizeof(void*)));
        m_good = m_good && slot != nullptr && call(slot) == 0;
        if (m_good) {
            pin.take(slot);
        }
    }

    int m_component;
    bool m_good{true};
};

}  // namespace

bool Pins::make(int component) {
    Maker pin(component);
    const char* axes[3] = {"x", "y", "z"};
    pin(currentVelocity, HAL_IN, "kerf.current-vel");
    pin(requestedVelocity, HAL_IN, "kerf.requested-vel");
    pin(spindleSpeed, HAL_IN, "kerf.spindle-rps");
    pin(spindleRevs, HAL_IN, "kerf.spindle-revs");
    pin(feedOverride, HAL_IN, "kerf.feed-override");
    pin(driveBandwidth, HAL_IN, "kerf.z-bandwidth");
    pin(offsetRatio, HAL_IN, "kerf.offset-ratio");
    pin(maxFeedOverride, HAL_IN, "kerf.max-feed-override");
    pin(programProcess, HAL_IN, "kerf.program-process");
    pin(force, HAL_IN, "kerf.force");
    pin(forceBandwidth, HAL_IN, "kerf.force-bandwidth");
    pin(forceReset, HAL_OUT, "kerf.force-reset");
    for (std::size_t i = 0; i < 3; ++i) {
        const std::string axis = axes[i];
        pin(position[i], HAL_IN, "kerf.position-" + axis);
        pin(offsetActual[i], HAL_IN, "kerf.offset-actual-" + axis);
        pin(originShift[i], HAL_IN, "kerf.origin-shift-" + axis);
        pin(offsetCounts[i], HAL_OUT, "kerf.offset-counts-" + axis);
    }
    pin(machineOn, HAL_IN, "kerf.machine-on");
    pin(emergencyStop, HAL_IN, "kerf.estop");
    pin(programRunning, HAL_IN, "kerf.program-running");
    pin(programPaused, HAL_IN, "kerf.program-paused");
    pin(cutting, HAL_IN, "kerf.cutting");
    pin(finished, HAL_IN, "kerf.finished");
    pin(softLimit, HAL_IN, "kerf.on-soft-limit");
    pin(simulator, HAL_IN, "kerf.simulator");
    pin(originKnown, HAL_IN, "kerf.origin-known");
    for (std::size_t i = 0; i < requestWord.size(); ++i) {
        pin(requestWord[i], HAL_IN, "kerf.request-" + std::to_string(i));
    }
    for (std::size_t i = 0; i < temperature.size(); ++i) {
        pin(temperature[i], HAL_IN, "kerf.temperature-" + std::to_string(i));
        pin(temperatureFault[i], HAL_IN, "kerf.temperature-fault-" + std::to_string(i));
    }
    for (std::size_t i = 0; i < word.size(); ++i) {
        pin(word[i], HAL_OUT, "kerf.word-" + std::to_string(i));
    }
    pin(feedScale, HAL_OUT, "kerf.feed-scale");
    pin(lossScale, HAL_OUT, "kerf.loss-scale");
    pin(feedHold, HAL_OUT, "kerf.feed-hold");
    pin(holdIfGone, HAL_OUT, "kerf.hold-if-gone");
    pin(heartbeat, HAL_OUT, "kerf.heartbeat");
    pin(consoleLost, HAL_OUT, "kerf.console-lost");
    pin(pGain, HAL_IO, "kerf.z-pgain");
    pin(ff1, HAL_IO, "kerf.z-ff1");
    pin(ff2, HAL_IO, "kerf.z-ff2");
    pin(timeout_s, HAL_IN, "kerf.timeout");
    pin(holdOnLoss, HAL_IN, "kerf.hold-on-loss");
    return pin.good();
}

}  // namespace kerf::linuxcnc
