// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/sensor_choice.h"

#include <spdlog/spdlog.h>

#include <QCoreApplication>
#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "app/sensors/modbus_scan.h"
#include "app/sensors/sensor_file.h"

namespace kerf::console {
namespace {

constexpr std::size_t kMostFiles = 50;
constexpr std::size_t kRegistersShown = 8;

SensorFileView judged(const std::filesystem::path& path) {
    SensorFileView view;
    view.name = path.filename().string();
    try {
        const sensors::SensorFile file = sensors::readSensorFile(path.string());
        view.modules = file.modules.size();
        view.channels = file.channels.size();
        view.gauges = file.gauges.size();
    } catch (const sensors::SensorFileFault& fault) {
        view.refused = {fault.where() == path.string() ? std::string() : fault.where(),  // its name stands beside it
                        fault.text(), fault.values()};
    }
    return view;
}

std::vector<SensorFileView> filesIn(const std::string& folder) {
    std::vector<std::filesystem::path> paths;
    std::error_code unreadable;
    for (const auto& entry : std::filesystem::directory_iterator(folder, unreadable)) {
        if (entry.path().extension() == ".json" && entry.is_regular_file(unreadable)) {
            paths.push_back(entry.path());
        }
    }
    std::ranges::sort(paths);
    paths.resize(std::min(paths.size(), kMostFiles));
    std::vector<SensorFileView> files;
    std::ranges::transform(paths, std::back_inserter(files), judged);
    return files;
}

FoundUnitView unitFrom(const nlohmann::json& unit) {
    FoundUnitView view;
    view.unit = unit.at("unit").get<int>();
    view.identity = unit.at("identity").is_string() ? unit.at("identity").get<std::string>() : std::string{};
    int last = 0;
    for (const auto& block : unit.at("answers")) {
        const int function = block.at("function").get<int>();
        if (function == last) {
            continue;  // the first registers are enough to know a module by
        }
        last = function;
        view.registers += (view.registers.empty() ? "" : "; ") + std::to_string(function) + ":";
        const auto& registers = block.at("registers");
        for (std::size_t i = 0; i < std::min(registers.size(), kRegistersShown); ++i) {
            view.registers += ' ' + std::to_string(registers[i].get<int>());
        }
    }
    return view;
}

constexpr const char* kNotAsked = KERF_TEXT("it could not be asked; the log says why.");

/// What the program that asks has said on its way out, in words that a page can translate.
Sentence refusalOf(const QString& said) {
    for (const char* known : {sensors::kNoConnection, sensors::kNoAddress}) {
        if (said.endsWith(QLatin1String(known))) {
            return Sentence(known);
        }
    }
    return Sentence(kNotAsked);
}

}  // namespace

SensorChoice::SensorChoice(Links links) : m_links(std::move(links)) {
    m_view.folder = m_links.folder;
    m_view.inUse = m_links.inUse;
    m_view.byCommandLine = m_links.byCommandLine;
    connect(&m_scan, &QProcess::finished, this,
            [this](int code, QProcess::ExitStatus status) { scanEnded(status == QProcess::NormalExit && code == 0); });
    connect(&m_scan, &QProcess::errorOccurred, this, [this](QProcess::ProcessError error) {
        if (error == QProcess::FailedToStart) {
            scanEnded(false);
        }
    });
}

SensorChoice::~SensorChoice() {
    m_scan.disconnect(this);
    m_scan.kill();
    m_scan.waitForFinished();
}

void SensorChoice::lookForFiles() {
    auto files = std::make_shared<std::vector<SensorFileView>>();
    m_background.run(
        [files, folder = m_links.folder]() -> Result<void> {
            *files = filesIn(folder);
            return {};
        },
        [this, files](const Result<void>&) { takeFiles(std::move(*files)); });
}

void SensorChoice::takeFiles(std::vector<SensorFileView> files) {
    m_view.files.swap(files);
    for (SensorFileView& file : m_view.files) {
        file.chosen = file.name == m_links.chosen;
    }
    ++m_view.revision;
}

Result<void> SensorChoice::choose(const std::string& name, const std::string& author) {
    if (auto may = permitted(m_links.rights, author, Deed::SensorPlace); !may) {
        return may;
    }
    const auto file = std::ranges::find(m_view.files, name, &SensorFileView::name);
    if (!name.empty() && (file == m_view.files.end() || !file->refused.empty())) {
        return fail(KERF_TEXT("That sensor file cannot be used."));
    }
    const auto answered = [this, name, alive = std::weak_ptr(m_alive)](const Result<Receipt>& stored) {
        if (alive.expired()) {
            return;
        }
        m_view.problem = stored ? Sentence{} : stored.error();
        if (stored) {
            m_links.chosen = name;
        }
        takeFiles(m_view.files);
    };
    m_links.writer.submit(ChangeSetting{kSetting, name, author, {}}, answered);
    return {};
}

Result<void> SensorChoice::scan(const std::string& address, const std::string& author) {
    if (auto may = permitted(m_links.rights, author, Deed::SensorPlace); !may) {
        return may;
    }
    if (m_view.scanning || address.empty()) {
        return fail(KERF_TEXT("One address is asked after the other."));
    }
    m_view.scanning = true;
    m_view.scanned = address;
    m_view.found.clear();
    m_view.refused = {};
    ++m_view.revision;
    m_scan.start(QCoreApplication::applicationDirPath() + QStringLiteral("/kerf"),
                 {QStringLiteral("sensors"), QStringLiteral("scan"),
                  QStringLiteral("--modbus=") + QString::fromStdString(address)});
    return {};
}

void SensorChoice::scanEnded(bool wellEnded) {
    m_view.scanning = false;
    ++m_view.revision;
    const nlohmann::json answer =
        wellEnded ? nlohmann::json::parse(m_scan.readAllStandardOutput().toStdString(), nullptr, false)
                  : nlohmann::json();
    if (!answer.is_object()) {
        const QString said = QString::fromUtf8(m_scan.readAllStandardError()).trimmed();
        m_view.refused = refusalOf(said);
        if (m_view.refused.text == kNotAsked) {
            spdlog::error("sensors scan: {} {}", m_scan.errorString().toStdString(), said.toStdString());
        }
        return;
    }
    for (const auto& unit : answer.at("units")) {
        m_view.found.push_back(unitFrom(unit));
    }
}

}  // namespace kerf::console
