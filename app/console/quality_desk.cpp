// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/quality_desk.h"

#include <QDateTime>

#include "app/console/lot_report.h"
#include "db/readers/database_reader.h"
#include "ui/theme/look.h"

namespace kerf::console {
namespace {

constexpr const char* kItself = "Kerf";
constexpr int kPollsBetweenLooks = 5;  // of the console's 200 ms

}  // namespace

QualityDesk::QualityDesk(Links links) : m_links(std::move(links)) {
    StoredQualityService::Links service{
        m_links.writer, m_links.reader, m_links.reader, m_links.reader, m_links.databasePath, {}, {}, m_links.rights};
    service.background = [this](Background::Work work, Background::Done done) {
        m_links.background.run(std::move(work), std::move(done));
    };
    service.makeReport = [this]() -> StoredQualityService::Report {
        return [units = m_links.look.units(), specOf = m_links.specOf](const QualityLot& lot, const LotPapers& papers,
                                                                       const std::string& file) {
            return writeLotReport(lot, papers, units, specOf, QString::fromStdString(file));
        };
    };
    service.recipe = m_links.recipe;
    service.revised = m_links.revised;
    m_service = std::make_unique<StoredQualityService>(std::move(service));
}

void QualityDesk::start(BoringService* bores) {
    QualityWatch::Links links;
    links.databasePath = m_links.databasePath;
    links.background = [this](Background::Work work, Background::Done done) {
        m_links.background.run(std::move(work), std::move(done));
    };
    links.raise = m_links.raise;
    links.files = [this] {
        const DfqFiles files = m_service->dfqFiles();
        return std::pair(files.folder, files.pattern);
    };
    m_watch = std::make_unique<QualityWatch>(std::move(links));
    if (bores != nullptr) {
        m_bores = bores->onChanged([this] { m_changed = true; });
    }
}

// A part that ends was made under what its process works by: stored when that changes, before the part can be.
void QualityDesk::followRecipes() {
    for (const ProcessId process : m_links.processes) {
        const RecipeHeld held = m_links.recipe ? m_links.recipe(process) : RecipeHeld{};
        if (held.kept || held.partType.empty()) {
            continue;
        }
        const auto [told, fresh] = m_partTypes.try_emplace(process);
        if (fresh) {
            const auto rows = m_links.reader.roomRecords(process, kPartTypeRecord, {}, 1);
            told->second = rows && !rows->empty() ? rows->front().subject : std::string();
        }
        if (told->second != held.partType) {
            told->second = held.partType;
            m_links.writer.submit(AddRoomRecord{process, kPartTypeRecord, held.partType, "{}", kItself, "chosen"}, {});
        }
    }
}

void QualityDesk::poll() {
    followRecipes();
    if (m_watch == nullptr || ++m_polls % kPollsBetweenLooks != 0 || m_watch->busy()) {
        return;
    }
    m_watch->tellOverdue(m_service->gauges(), QDateTime::currentMSecsSinceEpoch());
    lookAtNewest();
}

// A bore's values come after its part, so that boring is looked at whenever its service has changed; the figures of the
// other processes come with the part.
void QualityDesk::lookAtNewest() {
    std::vector<LotId> lots;
    PartQuery query;
    query.limit = 1;
    const auto newest = m_links.reader.parts(query);
    const PartId id = newest && !newest->empty() ? newest->front().id : 0;
    if (m_newest != id) {
        for (const ProcessDescriptor* process : processes()) {
            if (!process->partResults.empty()) {
                lots.push_back(partsWithoutLot(process->id));
            }
        }
        m_changed = true;
    }
    if (std::exchange(m_changed, false)) {
        if (const auto lot = m_links.reader.activeLot(ProcessId::Boring); lot && *lot) {
            lots.push_back(**lot);
        }
    }
    m_newest = id;
    m_watch->look(std::move(lots));
}

}  // namespace kerf::console
