// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/machine/memory_link.h"
#include "engine/machine/sensors/sensor_memory.h"
#include "engine/port/machine_port.h"

namespace kerf {

/// Any machine with the temperatures, and the spindle speed, of the reading process beside its own signals.
///
/// The cycle reads shared memory without waiting. A channel's reading is Good only while the reading process says so
/// and lives: silent for kSilence_ns, every channel is stale and `temperatures` is null, as long as it stays so. The
/// same while no channel at all is good, and until each has been asked once. A stamp is machine time: now less the age.
/// Everything else passes through unchanged.
class SensorPort final : public MachinePort {
 public:
    static constexpr std::int64_t kSilence_ns = 1'000'000'000;

    struct Params {
        std::string memoryName{};
        std::vector<std::uint16_t> temperatures{};  ///< channel in the reading process's frame of each temperature
        std::optional<std::uint16_t> speed{};       ///< takes the place of the machine's own spindle speed
    };
    /// `machine` outlives the port.
    SensorPort(MachinePort& machine, Params params);
    ~SensorPort() override;

    void onlyRead() noexcept override { m_machine.onlyRead(); }
    [[nodiscard]] Result<void> endOtherClaim() override { return m_machine.endOtherClaim(); }
    [[nodiscard]] Result<void> connect() override;
    void disconnect() noexcept override;
    [[nodiscard]] const Capabilities& capabilities() const noexcept override {
        return m_capabilities[m_current.load(std::memory_order_acquire)];
    }
    void read(std::int64_t now_ns, MachineInputs& inputs) noexcept override;
    void write(const MachineOutputs& outputs) noexcept override { m_machine.write(outputs); }

 private:
    static constexpr std::size_t kMachinesSeen = 9;

    void adoptCapabilities() noexcept;
    [[nodiscard]] bool takeFrame() noexcept;

    MachinePort& m_machine;
    Params m_params;
    std::array<Capabilities, kMachinesSeen> m_capabilities{};
    std::atomic<std::size_t> m_current{0};
    const Capabilities* m_adopted{nullptr};
    std::unique_ptr<MemoryLink<sensors::SensorMemory>> m_link;
    sensors::SensorFrame m_seen{};
    TemperatureFrame m_frame{};
};

}  // namespace kerf
