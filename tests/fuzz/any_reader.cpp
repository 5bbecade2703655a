// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/fuzz/any_reader.h"

#include <sys/mman.h>
#include <unistd.h>

#include <span>
#include <sstream>
#include <stdexcept>
#include <string>

#include "app/files/dfq.h"
#include "app/files/labelled_table.h"
#include "app/files/milling_input.h"
#include "app/files/replay_file.h"
#include "app/files/table.h"
#include "app/files/tapping_drive_file.h"
#include "app/files/text_encoding.h"
#include "app/files/thermal_files.h"
#include "app/files/thermal_model_json.h"
#include "app/rehearsal/scenario.h"
#include "app/sensors/gauge_frames.h"
#include "app/sensors/sensor_file.h"
#include "engine/process/milling/recorded_angle.h"
#include "engine/process/tapping/tap_record.h"
#include "engine/process/tapping/tap_span.h"

namespace kerf::test {
namespace {

using files::BadInput;
using files::Table;

void require(bool holds, const char* what) {
    if (!holds) {
        throw std::logic_error(std::string("does not hold: ") + what);
    }
}

files::ReadOptions optionsOf(std::uint8_t byte) {
    constexpr char kSeparators[] = {0, ',', ';', '\t', '|', ' ', 0, 0};
    constexpr char kDecimals[] = {0, '.', ',', 0};
    files::ReadOptions options;
    options.separator = kSeparators[byte & 7U];
    options.decimal = kDecimals[byte >> 3U & 3U];
    if ((byte & 0x20U) != 0) options.names = {"t_s", "-", "f_n"};
    if ((byte & 0x40U) != 0) options.period_s = 0.001;
    if ((byte & 0x80U) != 0) options.encoding = files::Encoding::Cp949;
    return options;
}

void everyColumn(const Table& table) {
    for (std::size_t i = 0; i < table.names().size(); ++i) {
        require(files::isValidUtf8(table.names()[i]), "a name is UTF-8");
        try {
            const auto values = table.columnWithGaps(i, "mm");
            require(values.size() == table.rows(), "a column has every row");
            (void)table.column(table.names()[i]);
        } catch (const BadInput&) {  // in doubt, or text
        }
    }
}

void tapRecord(Table table) {
    table.dropRowsWithGaps({"t_s", "spindle_rev", "z_mm"});
    const std::span<const double> time_s(table.column("t_s"));
    const std::span<const double> spindle_rev(table.column("spindle_rev"));
    const std::span<const double> z_mm(table.column("z_mm"));
    const auto tap = tapping::findTap(spindle_rev, z_mm);
    require(tap.begin <= tap.end && tap.end <= table.rows(), "a tap lies in its record");
    const std::size_t length = tap.end - tap.begin;
    (void)tapping::checkRecord(time_s.subspan(tap.begin, length), spindle_rev.subspan(tap.begin, length),
                               z_mm.subspan(tap.begin, length), 1.25);
}

void recordedAngle(Table table) {
    table.dropRowsWithGaps({"t_s", "angle_rev"});
    const auto& time_s = table.column("t_s");
    for (std::size_t i = 1; i < time_s.size(); ++i) {
        if (!(time_s[i] > time_s[i - 1])) return;
    }
    (void)milling::checkAngle(time_s, table.column("angle_rev"));
}

/// For readers that take a name: a file that never touches a disk.
const std::string& asFile(std::string_view bytes) {
    static const int file = ::memfd_create("kerf_fuzz", MFD_CLOEXEC);
    static const std::string path = "/proc/self/fd/" + std::to_string(file);
    require(file >= 0 && ::ftruncate(file, 0) == 0, "a file in memory");
    require(::pwrite(file, bytes.data(), bytes.size(), 0) == static_cast<ssize_t>(bytes.size()), "a file in memory");
    return path;
}

void gaugeFrames(std::uint8_t option, std::string_view bytes) {
    sensors::Gauge gauge;
    constexpr sensors::GaugeProtocol kProtocols[] = {sensors::GaugeProtocol::Digimatic, sensors::GaugeProtocol::Mahr,
                                                     sensors::GaugeProtocol::Sylvac, sensors::GaugeProtocol::Pattern};
    gauge.protocol = kProtocols[option & 3U];
    gauge.pattern = "^([0-9]+) +([-+]?[0-9.]+)$";
    std::istringstream lines{std::string(bytes)};
    for (std::string line; std::getline(lines, line);) {
        if (const auto frame = sensors::parseGaugeFrame(gauge, line)) {
            require(frame->value == frame->value, "a reading is a number");
        }
    }
}

void readBy(std::uint8_t reader, std::uint8_t option, std::string_view bytes) {
    using headless::HistoryUse;
    switch (reader % kReaders) {
        case 0:
            return everyColumn(Table::parse(bytes, "f"));
        case 1:
            return everyColumn(Table::parse(bytes, "f", optionsOf(option)));
        case 2:
            (void)headless::historyOf(Table::parse(bytes, "f"), "f", {HistoryUse::Training, {}, false, {}, 0.0});
            return;
        case 3:
            (void)headless::historyOf(Table::parse(bytes, "f"), "f",
                                      {HistoryUse::Prediction, {"T00"}, (option & 1U) != 0, {}, 0.0});
            return;
        case 4:
            (void)formats::thermalModelFromJson(bytes);
            return;
        case 5:
            (void)headless::readDriveFile(asFile(bytes));
            return;
        case 6: {
            milling::CutCase cut;
            headless::readMillingPlant(asFile(bytes), cut);
            return;
        }
        case 7:
            (void)headless::readBlank(asFile(bytes));
            return;
        case 8:
            return tapRecord(Table::parse(bytes, "f"));
        case 9:
            return recordedAngle(Table::parse(bytes, "f"));
        case 10:
            (void)sensors::parseSensorFile(std::string(bytes));
            return;
        case 11:
            return gaugeFrames(option, bytes);
        case 12:
            (void)rehearsal::readScenario(std::string(bytes), "f", "");
            return;
        case 13:
            (void)headless::LabelledTable::read(asFile(bytes), optionsOf(option));
            return;
        case 14:
            (void)headless::readRecordedDay(asFile(bytes));
            return;
        default:
            if (auto file = dfq::read(bytes)) {
                (void)dfq::readValues(bytes, *file);
                (void)dfq::write(*file);
            }
            return;
    }
}

void requireSentence(std::string_view sentence) {
    require(!sentence.empty(), "a refusal says why");
    require(sentence.find('\n') == std::string_view::npos, "a refusal is one sentence");
    require(files::isValidUtf8(sentence), "a refusal is UTF-8");
}

}  // namespace

void readAnything(std::string_view input) {
    if (input.size() < 2) {
        return;
    }
    const std::string_view bytes = input.substr(2);
    try {
        readBy(static_cast<std::uint8_t>(input[0]), static_cast<std::uint8_t>(input[1]), bytes);
    } catch (const BadInput& why) {
        requireSentence(why.what());
    } catch (const sensors::SensorFileFault& why) {
        requireSentence(why.what());
    }
}

}  // namespace kerf::test
