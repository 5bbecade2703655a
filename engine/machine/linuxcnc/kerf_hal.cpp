// SPDX-License-Identifier: GPL-3.0-or-later
// kerf-hal: the HAL component between LinuxCNC and the console. Load it with `loadusr -W kerf-hal`.
//
// Its pins exist as long as LinuxCNC runs, whether or not a console is there. When the console's beat stops for longer
// than kerf.timeout it lets go by itself: feed-scale goes to 1 (programmed feed) or stays below, or the feed is held
// when kerf.hold-on-loss is set; offsets stay; kerf.console-lost tells the control.
#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <time.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <new>

#include "engine/machine/linuxcnc/link_memory.h"

#define ULAPI
extern "C" {
#include <rtapi.h>
//
#include <hal.h>
}

namespace {

using kerf::linuxcnc::FromControl;
using kerf::linuxcnc::LinkMemory;
using kerf::linuxcnc::ToControl;

constexpr long kPeriod_ns = 1'000'000;
constexpr double kDefaultTimeout_s = 0.06;  // console and control together must settle within 100 ms

struct Pins {
    // from the control
    hal_float_t* servoClock;
    hal_float_t* position[3];
    hal_float_t* currentVelocity;
    hal_float_t* requestedVelocity;
    hal_float_t* spindleSpeed;
    hal_float_t* spindleRevs;
    hal_float_t* feedOverride;
    hal_float_t* offsetActual[3];
    hal_bit_t* machineOn;
    hal_bit_t* emergencyStop;
    hal_bit_t* programRunning;
    hal_bit_t* programPaused;
    hal_bit_t* cutting;
    hal_bit_t* finished;
    hal_bit_t* softLimit;
    // to the control
    hal_float_t* feedScale;
    hal_bit_t* feedHold;
    hal_s32_t* offsetCounts[3];  // 1 count = 1 µm: set axis.N.eoffset-scale to .001
    hal_bit_t* heartbeat;        // toggles every round: for HAL's own watchdog
    hal_bit_t* consoleLost;
    // settings of the bridge
    hal_float_t* timeout_s;
    hal_bit_t* holdOnLoss;
};

volatile std::sig_atomic_t g_stop = 0;
void onSignal(int /*signal*/) {
    g_stop = 1;
}

bool makePins(Pins& p, int component) {
    const char* axis[3] = {"x", "y", "z"};
    int bad = 0;
    bad |= hal_pin_float_newf(HAL_IN, &p.servoClock, component, "kerf.servo-clock");
    for (int i = 0; i < 3; ++i) {
        bad |= hal_pin_float_newf(HAL_IN, &p.position[i], component, "kerf.position-%s", axis[i]);
        bad |= hal_pin_float_newf(HAL_IN, &p.offsetActual[i], component, "kerf.offset-actual-%s", axis[i]);
        bad |= hal_pin_s32_newf(HAL_OUT, &p.offsetCounts[i], component, "kerf.offset-counts-%s", axis[i]);
    }
    bad |= hal_pin_float_newf(HAL_IN, &p.currentVelocity, component, "kerf.current-vel");
    bad |= hal_pin_float_newf(HAL_IN, &p.requestedVelocity, component, "kerf.requested-vel");
    bad |= hal_pin_float_newf(HAL_IN, &p.spindleSpeed, component, "kerf.spindle-rps");
    bad |= hal_pin_float_newf(HAL_IN, &p.spindleRevs, component, "kerf.spindle-revs");
    bad |= hal_pin_float_newf(HAL_IN, &p.feedOverride, component, "kerf.feed-override");
    bad |= hal_pin_bit_newf(HAL_IN, &p.machineOn, component, "kerf.machine-on");
    bad |= hal_pin_bit_newf(HAL_IN, &p.emergencyStop, component, "kerf.estop");
    bad |= hal_pin_bit_newf(HAL_IN, &p.programRunning, component, "kerf.program-running");
    bad |= hal_pin_bit_newf(HAL_IN, &p.programPaused, component, "kerf.program-paused");
    bad |= hal_pin_bit_newf(HAL_IN, &p.cutting, component, "kerf.cutting");
    bad |= hal_pin_bit_newf(HAL_IN, &p.finished, component, "kerf.finished");
    bad |= hal_pin_bit_newf(HAL_IN, &p.softLimit, component, "kerf.on-soft-limit");
    bad |= hal_pin_float_newf(HAL_OUT, &p.feedScale, component, "kerf.feed-scale");
    bad |= hal_pin_bit_newf(HAL_OUT, &p.feedHold, component, "kerf.feed-hold");
    bad |= hal_pin_bit_newf(HAL_OUT, &p.heartbeat, component, "kerf.heartbeat");
    bad |= hal_pin_bit_newf(HAL_OUT, &p.consoleLost, component, "kerf.console-lost");
    bad |= hal_pin_float_newf(HAL_IN, &p.timeout_s, component, "kerf.timeout");
    bad |= hal_pin_bit_newf(HAL_IN, &p.holdOnLoss, component, "kerf.hold-on-loss");
    return bad == 0;
}

LinkMemory* openLink() {
    const int file = shm_open(kerf::linuxcnc::kLinkName, O_RDWR | O_CREAT, 0600);
    if (file < 0 || ftruncate(file, sizeof(LinkMemory)) != 0) {
        return nullptr;
    }
    void* block = mmap(nullptr, sizeof(LinkMemory), PROT_READ | PROT_WRITE, MAP_SHARED, file, 0);
    close(file);
    return block == MAP_FAILED ? nullptr : new (block) LinkMemory();
}

FromControl look(const Pins& p, std::uint64_t beat) {
    FromControl seen;
    seen.beat = beat;
    seen.servoClock_s = *p.servoClock;
    for (int i = 0; i < 3; ++i) {
        seen.position_mm[static_cast<std::size_t>(i)] = *p.position[i];
        seen.externalOffset_mm[static_cast<std::size_t>(i)] = *p.offsetActual[i];
    }
    seen.currentVelocity_mmPerS = *p.currentVelocity;
    seen.requestedVelocity_mmPerS = *p.requestedVelocity;
    seen.spindleSpeed_rps = *p.spindleSpeed;
    seen.spindleAngle_rev = *p.spindleRevs;
    seen.feedOverride = *p.feedOverride;
    seen.appliedFeedScale = *p.feedScale;
    seen.machineOn = *p.machineOn != 0;
    seen.emergencyStop = *p.emergencyStop != 0;
    seen.programRunning = *p.programRunning != 0;
    seen.programPaused = *p.programPaused != 0;
    seen.cutting = *p.cutting != 0;
    seen.finished = *p.finished != 0;
    seen.onSoftLimit = *p.softLimit != 0;
    seen.consoleLost = *p.consoleLost != 0;
    return seen;
}

void obey(const Pins& p, const ToControl& wish) {
    *p.feedScale = std::isfinite(wish.feedScale) ? std::max(wish.feedScale, 0.0) : 1.0;
    *p.feedHold = wish.feedHold ? 1 : 0;
    for (int i = 0; i < 3; ++i) {
        const double offset_um = wish.externalOffset_um[static_cast<std::size_t>(i)];
        if (std::isfinite(offset_um)) {
            *p.offsetCounts[i] = static_cast<std::int32_t>(std::lround(offset_um));
        }
    }
}

void letGo(const Pins& p) {
    *p.feedScale = 1.0;
    *p.feedHold = *p.holdOnLoss;
}

}  // namespace

int main() {
    std::signal(SIGTERM, onSignal);
    std::signal(SIGINT, onSignal);
    const int component = hal_init("kerf-hal");
    if (component < 0) {
        std::fprintf(stderr, "kerf-hal: HAL does not take the component (code %d); is one already loaded?\n",
                     component);
        return 1;
    }
    auto* pins = static_cast<Pins*>(hal_malloc(sizeof(Pins)));
    LinkMemory* link = openLink();
    if (pins == nullptr || !makePins(*pins, component) || link == nullptr) {
        std::fprintf(stderr, "kerf-hal: no memory for pins or for the link to the console.\n");
        hal_exit(component);
        return 1;
    }
    *pins->timeout_s = kDefaultTimeout_s;
    *pins->holdOnLoss = 0;
    *pins->consoleLost = 1;
    letGo(*pins);
    hal_ready(component);
    link->magic.store(LinkMemory::kMagic, std::memory_order_release);

    std::uint64_t beat = 0;
    std::uint64_t consoleBeat = 0;
    double silent_s = 1e9;
    timespec next{};
    clock_gettime(CLOCK_MONOTONIC, &next);
    while (g_stop == 0) {
        next.tv_nsec += kPeriod_ns;
        if (next.tv_nsec >= 1'000'000'000) {
            next.tv_nsec -= 1'000'000'000;
            ++next.tv_sec;
        }
        clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &next, nullptr);
        *pins->heartbeat = *pins->heartbeat == 0 ? 1 : 0;
        silent_s += static_cast<double>(kPeriod_ns) * 1e-9;
        if (link->toControl.refresh()) {
            const ToControl wish = link->toControl.value();
            if (wish.beat != consoleBeat && wish.beat == wish.beatAgain) {
                consoleBeat = wish.beat;
                silent_s = 0.0;
                obey(*pins, wish);
            }
        }
        const bool lost = silent_s > *pins->timeout_s;
        if (lost && *pins->consoleLost == 0) {
            letGo(*pins);
        }
        *pins->consoleLost = lost ? 1 : 0;
        link->fromControl.publish(look(*pins, ++beat));
    }
    link->magic.store(0, std::memory_order_release);
    hal_exit(component);
    return 0;
}
