// SPDX-License-Identifier: GPL-3.0-or-later
// kerf-hal: the HAL component between LinuxCNC and the console. Load it with `loadusr -W kerf-hal`.
//
// Its pins exist as long as LinuxCNC runs, whether or not a console is there. When the console's beat stops for longer
// than kerf.timeout it lets go by itself, and never becomes faster (feed_keeper.h): feed-scale falls to the lowest of
// the last one, of what the console has said for this case and of the planned one of the program (none: the feed is
// held), or the feed is held when kerf.hold-on-loss is set; a feed hold and stops stay, offsets and gains too; the
// digital word loses its living bit; kerf.console-lost tells the control. When the program has ended, an operator's own
// one runs at its own feed. HAL does the same with kerf.loss-scale and kerf.hold-if-gone when this component itself
// comes late or has died.
#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <time.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <new>
#include <optional>
#include <string>

#include "engine/machine/linuxcnc/control_commands.h"
#include "engine/machine/linuxcnc/feed_keeper.h"
#include "engine/machine/linuxcnc/hal_pins.h"
#include "engine/machine/linuxcnc/hal_successor.h"
#include "engine/machine/linuxcnc/ini_text.h"
#include "engine/machine/linuxcnc/period_clock.h"

namespace {

using kerf::linuxcnc::FeedKeeper;
using kerf::linuxcnc::Fitted;
using kerf::linuxcnc::FromControl;
using kerf::linuxcnc::KeptStops;
using kerf::linuxcnc::LinkMemory;
using kerf::linuxcnc::Pins;
using kerf::linuxcnc::ServoPeriod;
using kerf::linuxcnc::ToControl;

constexpr std::int64_t kPeriod_ns = 1'000'000;
constexpr double kDefaultTimeout_s = 0.06;  // console and control together must settle within 100 ms
constexpr double kDefaultBandwidth_perS = 400.0;
constexpr int kSamplerKey = 0x48534130;  // of HAL's sampler.0
constexpr unsigned kAliveBit = 15;
constexpr std::uint64_t kRoundsPerTemperatures = 100;

volatile std::sig_atomic_t g_stop = 0;
void onSignal(int /*signal*/) {
    g_stop = 1;
}

std::int64_t monotonic_ns() {
    timespec now{};
    clock_gettime(CLOCK_MONOTONIC, &now);
    return static_cast<std::int64_t>(now.tv_sec) * 1'000'000'000 + now.tv_nsec;
}

LinkMemory* openLink() {
    (void)shm_unlink(kerf::linuxcnc::kLinkName);  // a console that holds the last bridge's memory finds this one
    const int file = shm_open(kerf::linuxcnc::kLinkName, O_RDWR | O_CREAT | O_EXCL, 0600);
    if (file < 0 || ftruncate(file, sizeof(LinkMemory)) != 0) {
        return nullptr;
    }
    void* block = mmap(nullptr, sizeof(LinkMemory), PROT_READ | PROT_WRITE, MAP_SHARED, file, 0);
    close(file);
    return block == MAP_FAILED ? nullptr : new (block) LinkMemory();
}

/// Null: stops do not outlive this component; the console keeps them as well.
KeptStops* openStops() {
    const int file = shm_open(kerf::linuxcnc::kStopsName, O_RDWR | O_CREAT, 0600);
    if (file < 0 || ftruncate(file, sizeof(KeptStops)) != 0) {
        return nullptr;
    }
    void* block = mmap(nullptr, sizeof(KeptStops), PROT_READ | PROT_WRITE, MAP_SHARED, file, 0);
    close(file);
    return block == MAP_FAILED ? nullptr : static_cast<KeptStops*>(block);
}

/// motion.adaptive-feed is clipped to 1 before 2.10.
bool adaptiveFeedMayRise() {
    const char* version = std::getenv("LINUXCNCVERSION");
    int major = 0;
    int minor = 0;
    return version != nullptr && std::sscanf(version, "%d.%d", &major, &minor) == 2 &&
           (major > 2 || (major == 2 && minor >= 10));
}

/// HAL's sampler, read without waiting: spindle, Z, its command, lateness, cutting, finished, and on controls with a
/// kerf.hal of today the force and its fault.
class Sampler {
 public:
    explicit Sampler(int component, double period_s) : m_clock(period_s) {
        char kinds[] = "fffsbbfb";
        char without[] = "fffsbb";
        m_hasForce = hal_stream_attach(&m_stream, component, kSamplerKey, kinds) == 0;
        m_attached = m_hasForce || hal_stream_attach(&m_stream, component, kSamplerKey, without) == 0;
    }
    [[nodiscard]] bool attached() const { return m_attached; }
    [[nodiscard]] bool hasForce() const { return m_hasForce; }
    /// Hands every period to the link; returns how many there were.
    std::uint64_t drainInto(LinkMemory& link, std::int64_t now_ns) {
        hal_stream_data values[8] = {};
        unsigned number = 0;
        std::uint64_t count = 0;
        while (m_attached && hal_stream_readable(&m_stream) && hal_stream_read(&m_stream, values, &number) == 0) {
            ServoPeriod period;
            period.number = number;
            period.spindle_rev = values[0].f;
            period.z_mm = values[1].f;
            period.zCommand_mm = values[2].f;
            period.late_ns = values[3].s;
            period.cutting = values[4].b;
            period.finished = values[5].b;
            period.stamp_ns = m_clock.next(number, period.late_ns, now_ns);
            if (m_hasForce) {
                period.force = values[6].f;
                period.forceFault = values[7].b;
            }
            link.servo.push(period);
            ++count;
        }
        m_clock.drained(now_ns);
        return count;
    }

 private:
    hal_stream_t m_stream{};
    kerf::linuxcnc::PeriodClock m_clock;
    bool m_hasForce{false};
    bool m_attached{false};
};

/// Where the signal stands that this pin is linked to; null: to none.
const volatile void* signalOf(const char* pin) {
    hal_type_t type{};
    hal_data_u* value = nullptr;
    bool connected = false;
    return hal_get_pin_value_by_name(pin, &type, &value, &connected) == 0 && connected ? value : nullptr;
}

class Bridge {
 public:
    Bridge(Pins& pins, LinkMemory& link, KeptStops* kept, int component,
           const kerf::linuxcnc::ControlCommands& commands)
        : m_pins(pins), m_link(link), m_kept(kept), m_component(component), m_commands(commands) {
        if (kept != nullptr && kept->magic == KeptStops::kMagic) {
            m_stops = kept->stops;
        }
        m_fitted.servoPeriod_s = kerf::linuxcnc::servoPeriodOf_s(kerf::linuxcnc::iniText());
        *pins.timeout_s = kDefaultTimeout_s;
        *pins.driveBandwidth = kDefaultBandwidth_perS;
        *pins.consoleLost = true;
        *pins.maxFeedOverride = 1.0;
        *pins.feedScale = 1.0;
        *pins.lossScale = 1.0;
    }

    void round(std::int64_t now_ns, std::int64_t passed_ns) {
        watchOffsets();
        const bool told = m_link.toControl.refresh();
        const ToControl wish = m_link.toControl.value();  // a copy: the console's side is another process
        if (told && wish.beat == wish.beatAgain) {
            keep(wish.stops);
        }
        feed(passed_ns, told ? &wish : nullptr);
        *m_pins.heartbeat = !*m_pins.heartbeat;  // after it: HAL gives again what we want from here on
        if (m_feed.obeyed() && m_mayScale) {
            obey(wish);
        } else if (m_feed.lost()) {
            *m_pins.word[kAliveBit] = false;
            *m_pins.forceReset = false;
        }
        *m_pins.consoleLost = m_feed.lost();
        if (m_beat % 1000 == 0) {
            findFitted();
        }
        if (m_beat % kRoundsPerTemperatures == 0) {
            m_link.temperatures.push(lookAtTemperatures());
        }
        if (m_sampler) {
            m_servoPeriods += m_sampler->drainInto(m_link, now_ns);
        }
        m_link.fromControl.push(look());
    }

 private:
    /// Pins are linked while the HAL files are read, which goes on after this component is ready.
    void findFitted() {
        if (!m_sampler && ++m_samplerTries <= 10) {
            Sampler sampler(m_component, m_fitted.servoPeriod_s);
            if (sampler.attached()) {
                m_sampler = sampler;
            }
        }
        m_fitted.externalOffsets = *m_pins.offsetRatio > 0.0 && m_pins.offsetCounts[2].linked();
        m_fitted.originShift = m_pins.originShift[2].linked();
        m_fitted.servoGains = m_pins.pGain.linked();
        m_fitted.servoRecord = m_sampler.has_value();
        // A force that is not sampled would be 0 for ever, and nothing would tell it from air.
        m_fitted.forceLinked = m_pins.force.linked();
        m_fitted.force = m_sampler && m_sampler->hasForce() && m_pins.force.linkedTo(signalOf("sampler.0.pin.6"));
        m_fitted.forceReset = m_pins.forceReset.linked();
        m_fitted.forceBandwidth_Hz = *m_pins.forceBandwidth;
        m_fitted.lossScale = m_pins.lossScale.linked();
        m_fitted.shiftWord = m_pins.word[kAliveBit].linked();
        m_fitted.simulator = *m_pins.simulator;
        m_fitted.programDeclared = m_pins.programProcess.linked();
        m_fitted.units = m_units;
        m_fitted.maxFeedScale = m_mayRise ? std::max(1.0, static_cast<double>(*m_pins.maxFeedOverride)) : 1.0;
    }

    /// LinuxCNC zeroes its external offsets when the machine is switched on, and counts on from where the counts stand.
    /// What the console still asks for belongs to the time before: it must first see the zero. A bridge that is started
    /// anew on a machine that is on finds the zero below what stands there.
    void watchOffsets() {
        const bool on = *m_pins.machineOn;
        const bool zeroed = on && m_wasOff;
        m_wasOff = !on && m_pins.machineOn.linked();
        for (std::size_t i = 0; i < 3; ++i) {
            const bool linked = m_pins.offsetCounts[i].linked() && m_pins.offsetActual[i].linked();
            if (zeroed || (linked && !m_zeroKnown[i])) {
                const double applied_um = zeroed ? 0.0 : *m_pins.offsetActual[i] * 1000.0;
                m_zeroCounts[i] = *m_pins.offsetCounts[i] - static_cast<std::int32_t>(std::lround(applied_um));
                m_zeroKnown[i] = linked;
                ++m_offsetEpoch;
            }
        }
    }

    [[nodiscard]] kerf::linuxcnc::HalTemperatures lookAtTemperatures() const {
        kerf::linuxcnc::HalTemperatures seen;
        seen.beat = m_beat;
        for (std::size_t i = 0; i < seen.temp_degC.size(); ++i) {
            seen.temp_degC[i] = *m_pins.temperature[i];
            seen.linked |= std::uint64_t{m_pins.temperature[i].linked() ? 1U : 0U} << i;
            seen.fault |= std::uint64_t{*m_pins.temperatureFault[i] ? 1U : 0U} << i;
        }
        return seen;
    }

    FromControl look() {
        FromControl seen;
        seen.beat = ++m_beat;
        seen.servoPeriods = m_servoPeriods;
        for (std::size_t i = 0; i < 3; ++i) {
            seen.position_mm[i] = *m_pins.position[i];
            seen.externalOffset_mm[i] = *m_pins.offsetActual[i];
            seen.originShift_um[i] = *m_pins.originShift[i];
        }
        seen.offsetEpoch = m_offsetEpoch;
        seen.originKnown = *m_pins.originKnown;
        seen.currentVelocity_mmPerS = *m_pins.currentVelocity;
        seen.requestedVelocity_mmPerS = *m_pins.requestedVelocity;
        seen.spindleSpeed_rps = *m_pins.spindleSpeed;
        seen.spindleAngle_rev = *m_pins.spindleRevs;
        seen.feedOverride = *m_pins.feedOverride;
        seen.appliedFeedScale = *m_pins.feedScale;
        seen.gains = {*m_pins.pGain, *m_pins.ff1, *m_pins.ff2};
        seen.driveBandwidth_perS = *m_pins.driveBandwidth;
        seen.fitted = m_fitted;
        seen.commandsReady = m_commands.ready();
        seen.machineOn = *m_pins.machineOn;
        seen.emergencyStop = *m_pins.emergencyStop;
        seen.programRunning = *m_pins.programRunning;
        seen.programPaused = *m_pins.programPaused;
        seen.cutting = *m_pins.cutting;
        const double declared = *m_pins.programProcess;
        seen.declared = declared >= 1.0 && declared < 1e6 ? static_cast<std::uint32_t>(declared + 0.5) : 0;
        seen.finished = *m_pins.finished;
        seen.onSoftLimit = *m_pins.softLimit;
        seen.consoleLost = *m_pins.consoleLost;
        seen.stops = m_stops;
        seen.plannedScale = m_feed.plannedScale();
        seen.feedEpoch = m_feed.epoch();
        for (std::size_t i = 0; i < m_pins.requestWord.size(); ++i) {
            seen.requestWord |= static_cast<std::uint8_t>(*m_pins.requestWord[i] ? 1U << i : 0U);
        }
        return seen;
    }

    /// The pins are read first: linked later, or by a bridge that is started anew, they show what stands there.
    void feed(std::int64_t passed_ns, const ToControl* wish) {
        FeedKeeper::Round round;
        round.passed_ns = passed_ns;
        round.timeout_s = *m_pins.timeout_s;
        round.running = *m_pins.programRunning || *m_pins.programPaused;  // halui: a paused one does not run
        round.holdOnLoss = *m_pins.holdOnLoss;
        round.stopHolds = kerf::anyStopOf(m_stops, kerf::StopKind::FeedHold);
        round.mayScale = m_mayScale;
        const FeedKeeper::Pins standing{*m_pins.feedScale, *m_pins.lossScale, *m_pins.feedHold, *m_pins.holdIfGone};
        const FeedKeeper::Pins pins = m_feed.next(round, wish, standing);
        *m_pins.lossScale = pins.lossScale;
        *m_pins.feedScale = pins.scale;
        *m_pins.feedHold = pins.hold;
        *m_pins.holdIfGone = pins.holdIfGone;
    }

    void obey(const ToControl& wish) {
        for (std::size_t i = 0; i < 3 && wish.offsetEpoch == m_offsetEpoch; ++i) {
            if (std::isfinite(wish.externalOffset_um[i])) {
                *m_pins.offsetCounts[i] =
                    m_zeroCounts[i] + static_cast<std::int32_t>(std::lround(wish.externalOffset_um[i]));
            }
        }
        const double sum = wish.gains.pGain_perS + wish.gains.ff1 + wish.gains.ff2_s;
        if (wish.gainsRevision != 0 && wish.gainsRevision != m_gainsRevision && std::isfinite(sum) &&
            !*m_pins.cutting) {
            m_gainsRevision = wish.gainsRevision;
            *m_pins.pGain = wish.gains.pGain_perS;
            *m_pins.ff1 = wish.gains.ff1;
            *m_pins.ff2 = wish.gains.ff2_s;
        }
        *m_pins.forceReset = wish.forceReset;
        for (std::size_t i = 0; i < m_pins.word.size(); ++i) {
            *m_pins.word[i] = ((wish.shiftWord >> i) & 1U) != 0;
        }
    }

    void keep(const kerf::StopSlots& told) {
        const kerf::StopSlots before = m_stops;
        for (std::size_t i = 0; i < m_stops.size(); ++i) {
            m_stops[i] = kerf::joined(m_stops[i], told[i]);
        }
        if (m_kept != nullptr && m_stops != before) {
            m_kept->magic = 0;
            m_kept->stops = m_stops;
            m_kept->magic = KeptStops::kMagic;
        }
    }

    Pins& m_pins;
    LinkMemory& m_link;
    KeptStops* m_kept;
    int m_component;
    kerf::StopSlots m_stops{};
    const kerf::linuxcnc::ControlCommands& m_commands;
    std::optional<Sampler> m_sampler{};
    int m_samplerTries{0};
    Fitted m_fitted{};
    kerf::linuxcnc::MachineUnits m_units{kerf::linuxcnc::unitsOf(kerf::linuxcnc::iniText())};
    bool m_mayScale{m_units == kerf::linuxcnc::MachineUnits::Millimetre};
    bool m_mayRise{adaptiveFeedMayRise()};
    std::uint64_t m_beat{0};
    std::uint64_t m_servoPeriods{0};
    std::uint32_t m_gainsRevision{0};
    std::uint32_t m_offsetEpoch{1};
    std::array<std::int32_t, 3> m_zeroCounts{};
    std::array<bool, 3> m_zeroKnown{};
    bool m_wasOff{false};  ///< seen, not only unknown
    /// Epochs of two bridges differ: a console that still follows on the last one is not obeyed.
    FeedKeeper m_feed{static_cast<std::uint32_t>(monotonic_ns() >> 10) | 1U};
};

}  // namespace

int main() {
    std::signal(SIGTERM, onSignal);
    std::signal(SIGINT, onSignal);
    kerf::linuxcnc::HalSuccessor successor;
    const bool succeeds = successor.takePlaceOf("kerf-hal");
    const int component = hal_init("kerf-hal");
    successor.settle();
    if (component < 0) {
        std::fprintf(stderr, "kerf-hal: HAL does not take the component (code %d); is one already loaded?\n",
                     component);
        return 1;
    }
    Pins pins;
    LinkMemory* link = openLink();
    if (!pins.make(component) || link == nullptr) {
        std::fprintf(stderr, "kerf-hal: no memory for pins or for the link to the console.\n");
        hal_exit(component);
        return 1;
    }
    const kerf::linuxcnc::ControlCommands commands(*link);
    Bridge bridge(pins, *link, openStops(), component, commands);
    if (succeeds) {
        successor.linkAgain();
    }
    hal_ready(component);
    link->magic.store(LinkMemory::kMagic, std::memory_order_release);

    std::int64_t next_ns = monotonic_ns();
    std::int64_t last_ns = next_ns;
    while (g_stop == 0) {
        next_ns = std::max(next_ns + kPeriod_ns, last_ns);  // a missed round is not made up for
        const timespec next{next_ns / 1'000'000'000, next_ns % 1'000'000'000};
        clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &next, nullptr);
        const std::int64_t now_ns = monotonic_ns();
        bridge.round(now_ns, now_ns - last_ns);
        last_ns = now_ns;
    }
    link->magic.store(0, std::memory_order_release);
    (void)shm_unlink(kerf::linuxcnc::kLinkName);
    hal_exit(component);
    return 0;
}
