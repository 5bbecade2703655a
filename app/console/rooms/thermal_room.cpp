// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/rooms/thermal_room.h"

#include <spdlog/spdlog.h>

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QSaveFile>
#include <nlohmann/json.hpp>

#include "engine/process/thermal/thermal_loop.h"
#include "ui/pages/thermal/thermal_page.h"

namespace kerf::console {
namespace {

using nlohmann::json;

std::string memoryText(const SimulatedThermal::Memory& memory) {
    return json{{"temp_degC", memory.plant.temp_degC},     {"reference_degC", memory.plant.reference_degC},
                {"couple_degC", memory.plant.couple_degC}, {"time_s", memory.plant.time_s},
                {"wander_K", memory.plant.wander_K},       {"work_offset_um", memory.workOffset_um}}
        .dump();
}

/// Empty: no such file, or not one of ours; the machine then starts cold.
std::optional<SimulatedThermal::Memory> memoryFrom(const QString& file) {
    QFile in(file);
    if (!in.open(QIODevice::ReadOnly)) {
        return std::nullopt;
    }
    const json body = json::parse(in.readAll().toStdString(), nullptr, false);
    SimulatedThermal::Memory memory;
    try {
        body.at("temp_degC").get_to(memory.plant.temp_degC);
        body.at("reference_degC").get_to(memory.plant.reference_degC);
        body.at("couple_degC").get_to(memory.plant.couple_degC);
        body.at("time_s").get_to(memory.plant.time_s);
        body.at("wander_K").get_to(memory.plant.wander_K);
        body.at("work_offset_um").get_to(memory.workOffset_um);
    } catch (const json::exception& complaint) {
        spdlog::warn("{}: {}", file.toStdString(), complaint.what());
        return std::nullopt;
    }
    return memory;
}

}  // namespace

ui::PageEntry ThermalRoom::page() const {
    return ui::thermalPageEntry();
}

/// On a real machine temperatures come with a sensor file; without one the loop says that there are none.
bool ThermalRoom::fits(const std::string&) const {
    return true;
}

std::unique_ptr<SimulatedProcess> ThermalRoom::makePlant(const Options& options) {
    m_machineSeed =
        options.machine == "diamond-lathe" ? SimulatedThermal::kDiamondLathe : SimulatedThermal::kMachiningCentre;
    auto plant = std::make_unique<SimulatedThermal>(
        SimulatedThermal::Params{m_machineSeed, options.seed, options.machineSeed,
                                 thermal::seasonOf(options.season).value_or(thermal::Season::None)});
    m_plant = plant.get();
    return plant;
}

std::unique_ptr<ProcessLoop> ThermalRoom::makeLoop() {
    return std::make_unique<ThermalLoop>(*m_exchange);
}

void ThermalRoom::open(const Context& context) {
    const QDir folder = QFileInfo(QString::fromStdString(context.databasePath)).absoluteDir();
    folder.mkpath(QStringLiteral("thermal"));
    QString machine = QString::fromStdString(context.options.machine);
    if (m_plant != nullptr && context.options.machineSeed != 0) {  // another machine remembers something else
        machine += QStringLiteral("-%1").arg(context.options.machineSeed);
    }
    m_memoryFile = folder.filePath(QStringLiteral("thermal/%1.json").arg(machine)).toStdString();
    if (m_plant != nullptr) {
        if (const auto memory = memoryFrom(QString::fromStdString(m_memoryFile))) {
            m_plant->resume(*memory);
        }
    }
    StoredThermalService::Links links{context.engine, context.writer, *m_exchange};
    links.rights = context.rights;
    links.dayFolder = folder.filePath(QStringLiteral("thermal")).toStdString();
    links.machineSeed = m_machineSeed;
    links.hardSeed = context.options.machineSeed;
    links.sensors = context.temperatures;
    m_service = std::make_unique<StoredThermalService>(links, context.reader, context.reader);
}

void ThermalRoom::serve(ui::Services& services) {
    services.thermalService = m_service.get();
}

void ThermalRoom::poll() {
    if (m_service) {
        m_service->poll();
    }
    if (m_plant == nullptr) {
        return;
    }
    if (const auto memory = m_plant->newMemory()) {
        QSaveFile out(QString::fromStdString(m_memoryFile));
        if (out.open(QIODevice::WriteOnly)) {
            out.write(QByteArray::fromStdString(memoryText(*memory)));
            (void)out.commit();
        }
    }
}

}  // namespace kerf::console
