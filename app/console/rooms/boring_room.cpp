// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/rooms/boring_room.h"

#include <spdlog/spdlog.h>

#include <QFileInfo>
#include <algorithm>
#include <utility>

#include "app/console/simulator.h"
#include "engine/process/boring/boring_loop.h"
#include "ui/pages/boring/boring_page.h"

namespace kerf::console {
namespace {
constexpr const char* kPartTypeName = "Cylinder 50";
constexpr const char* kLotName = "1";
}  // namespace

ui::PageEntry BoringRoom::page() const {
    return ui::boringPageEntry();
}

bool BoringRoom::fits(const std::string& machineKind) const {
    return machineKind != "diamond-lathe" && machineKind != "replay";
}

std::unique_ptr<ProcessLoop> BoringRoom::makeLoop() {
    return std::make_unique<BoringLoop>();
}

void BoringRoom::open(const Context& context) {
    m_accepted = context.accepted;
    BoringLotRequest first;
    first.machineName = std::string(context.engine.capabilities().machineName.data());
    first.machineKind = context.options.machine;
    first.partTypeName = std::string(kPartTypeName);
    first.lotName = std::string(kLotName);
    first.lotSize = context.options.lotSize;
    first.author = context.nobody;
    StoredBoringService::Links links{context.writer, context.engine};
    links.rights = context.rights;
    links.records = &context.reader;
    links.gauge = [&reader = context.reader, simulator = context.simulator](
                      const ServicePart& part, const BoringRecipe& recipe,
                      double overhang_mm) -> std::optional<double> {
        if (simulator == nullptr) {
            return std::nullopt;
        }
        const Simulator::Bore bore{recipe.targetDiameter_mm, recipe.targetDeflection_mm, recipe.phi_deg};
        const Simulator::GaugedPart gauged{part.id, part.sequence, madeUpTo(reader, ProcessId::Boring, part.id),
                                           part.feed};
        return simulator->gaugeReading_mm(gauged, overhang_mm, bore);
    };
    m_lots = std::make_unique<StoredBoringLots>(links, context.reader, first, [this] { lotIsOpen(); });
    const std::string folder = QFileInfo(QString::fromStdString(context.databasePath)).absolutePath().toStdString();
    m_shopMemory = std::make_unique<ShopMemoryLink>(folder, context.databasePath, context.simulator != nullptr);
    m_lots->drawOnShop([this](const std::string& partType, StoredBoringLots::ShopLotsTold told) {
        m_shopMemory->ask(partType, std::move(told));
    });
    m_changes = m_lots->service().onChanged([this] { announceAccepted(); });
}

void BoringRoom::whenOpen(Opened then) {
    m_lots->start(std::move(then));
}

void BoringRoom::serve(ui::Services& services) {
    services.boringService = &m_lots->service();
    services.boringLots = m_lots.get();
}

void BoringRoom::poll() {
    m_lots->poll();
}

void BoringRoom::toolIsNew(const std::string& author) {
    m_lots->service().announceChange(BoringChange::Insert, author, [](const Result<void>&) {});
}

void BoringRoom::lotIsOpen() {
    const StoredBoringService& service = m_lots->service().stored();
    if (!service.restartFinding().empty()) {
        spdlog::warn("{}", service.restartFinding().english());
    }
    for (const BorePartView& part : service.view().parts) {
        for (const BoreMeasurementView& measurement : part.measurements) {
            m_lastAnnounced = std::max(m_lastAnnounced, measurement.id);
        }
    }
}

void BoringRoom::announceAccepted() {
    const BoringServiceView& view = m_lots->service().view();
    MeasurementId newest = m_lastAnnounced;
    for (const BorePartView& part : view.parts) {
        for (const BoreMeasurementView& measurement : part.measurements) {
            if (measurement.id > m_lastAnnounced) {
                newest = std::max(newest, measurement.id);
                const BoringSchedule& next = view.nextSchedule;
                m_accepted(
                    QString::asprintf("accepted %lld part %u depth %u diameter_mm %.17g next %u %.17g %.17g %.17g",
                                      static_cast<long long>(measurement.id), part.number, measurement.depth,
                                      measurement.diameter_mm, next.revision, next.lnC, next.alpha, next.beta));
            }
        }
    }
    m_lastAnnounced = newest;
}

}  // namespace kerf::console
