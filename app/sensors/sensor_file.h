// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

/// The sensor file of a machine: which modules there are, which register or pin is which channel, which gauges hang on
/// which serial line. JSON; docs/sensors.md has every key. Read whole and checked whole; unknown keys are refused.
namespace kerf::sensors {

enum class Transport : std::uint8_t { Tcp, Rtu, Hal };
enum class Parity : std::uint8_t { None, Even, Odd };
enum class RegisterType : std::uint8_t { Int16, Uint16, Int32, Uint32, Float32 };
enum class WordOrder : std::uint8_t { Big, Little };  ///< Big: the high word comes first
enum class Quantity : std::uint8_t { Temperature, Speed, Force };

[[nodiscard]] constexpr int registersOf(RegisterType type) noexcept {
    return type == RegisterType::Int16 || type == RegisterType::Uint16 ? 1 : 2;
}

struct Module {
    std::string name{};
    Transport transport{Transport::Tcp};
    std::string host{};  ///< tcp
    int port{502};
    std::string device{};  ///< rtu
    int baud{19200};
    Parity parity{Parity::None};
    int stopBits{1};
    int unit{1};
    int period_ms{1000};
    int timeout_ms{300};
};

/// A register that tells whether a channel may be believed.
struct StatusRegister {
    int function{4};  ///< 1 … 4; discrete inputs (2) and coils (1) count as 0 and 1
    int address{0};
    std::vector<std::int64_t> bad{};
};

struct Channel {
    std::string name{};
    Quantity quantity{Quantity::Temperature};
    std::size_t module{0};  ///< index in SensorFile::modules
    int function{4};
    int address{0};  ///< as it goes over the wire, from 0
    RegisterType type{RegisterType::Int16};
    WordOrder words{WordOrder::Big};
    double scale{1.0};  ///< value = scale · register + offset, in the channel's unit
    double offset{0.0};
    std::vector<double> invalid{};  ///< register values that are no measurement
    std::optional<StatusRegister> status{};
    std::string place{};
    int pin{0};  ///< hal: N of kerf.temperature-N
};

enum class GaugeProtocol : std::uint8_t { Digimatic, Mahr, Sylvac, Pattern };

struct Gauge {
    std::string name{};  ///< identity, as in the register of gauges
    std::string device{};
    int baud{9600};
    Parity parity{Parity::None};
    GaugeProtocol protocol{GaugeProtocol::Digimatic};
    std::string pattern{};  ///< Pattern: regular expression; group 1 the value, group 2 the channel if there is one
    bool inch{false};       ///< unit of values that carry none
    std::string ask{};      ///< sent to ask for a reading; Sylvac: "?"
    std::vector<std::pair<std::string, int>> depths{};  ///< channel → number of the measured depth, from 1
};

struct SensorFile {
    std::vector<Module> modules{};
    std::vector<Channel> channels{};
    std::vector<Gauge> gauges{};
    std::vector<std::string> warnings{};  ///< allowed, but looks like a slip
    std::uint64_t fingerprint{0};         ///< of the text
};

/// "channels[3].adress: unknown key; expected name, quantity, …"; and the same in its parts, to be said in another
/// language.
class SensorFileFault : public std::runtime_error {
 public:
    /// `text`: a KERF_TEXT with %1 and on for `values`.
    SensorFileFault(std::string where, const char* text, std::vector<std::string> values = {});
    /// The same, with the file's name in front.
    SensorFileFault(const std::string& file, const SensorFileFault& fault);

    [[nodiscard]] const std::string& where() const noexcept { return m_where; }  ///< the key, or the file; may be empty
    [[nodiscard]] const char* text() const noexcept { return m_text; }
    [[nodiscard]] const std::vector<std::string>& values() const noexcept { return m_values; }

 private:
    std::string m_where;
    const char* m_text;
    std::vector<std::string> m_values;
};

/// @throws SensorFileFault with the key and one sentence
[[nodiscard]] SensorFile parseSensorFile(const std::string& text);
/// As parseSensorFile, with the file's name in front. @throws SensorFileFault
[[nodiscard]] SensorFile readSensorFile(const std::string& path);

/// Channels of one quantity in the order of the file: indices into SensorFile::channels.
[[nodiscard]] std::vector<std::size_t> channelsOf(const SensorFile& file, Quantity quantity);

inline constexpr std::size_t kMostChannels = 96;  ///< of all quantities
inline constexpr std::size_t kMostTemperatures = 64;
inline constexpr int kMostHalTemperatures = 64;

}  // namespace kerf::sensors
