// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/shop_memory_link.h"

#include <spdlog/spdlog.h>
#include <sys/resource.h>

#include <fstream>

#include "app/service/boring/shop_memory.h"
#include "db/connection.h"
#include "db/shop/outbox.h"
#include "db/statement.h"

namespace kerf::console {
namespace {

constexpr db::PgConnection::Timeouts kPatience{5000, 20000};
using Lots = std::vector<BoringMemoryLot>;

Sentence sentenceOf(const db::PgFailure& failure) {
    switch (failure.kind()) {
        case db::PgFailure::Kind::NoRight:
            return Sentence(
                KERF_TEXT("The shop does not let this console read: this lot begins without other machines' lots."));
        case db::PgFailure::Kind::NoSchema:
            return Sentence(
                KERF_TEXT("There is no shop in the database: this lot begins without other machines' lots."));
        default:
            return Sentence(KERF_TEXT("The shop is out of reach: this lot begins without other machines' lots."));
    }
}

Result<Lots> lotsOf(const std::string& setting, const std::string& dataFile, const std::string& partType,
                    bool simulated, const db::Interrupt& interrupt) {
    std::ifstream file(setting);
    std::string conninfo;
    if (!std::getline(file, conninfo) || conninfo.empty()) {
        return fail(
            KERF_TEXT("The data folder names no shop to read (shop/memory): this lot begins without other "
                      "machines' lots."));
    }
    if (!db::conninfoFault(conninfo).empty() || db::holdsPassword(conninfo)) {
        return fail(
            KERF_TEXT("The connection in shop/memory cannot be used (no password may stand there): this lot "
                      "begins without other machines' lots."));
    }
    try {
        const std::string store =
            db::OutboxReader(db::Connection(dataFile, db::Access::Read).database()).identity().store;
        db::PgConnection server(conninfo, interrupt, kPatience);
        return askShopLots(server, partType, store, simulated);
    } catch (const db::PgFailure& failure) {
        spdlog::warn("shop, memory: {}", failure.what());
        return tl::unexpected(sentenceOf(failure));
    } catch (const db::SqlFailure& failure) {
        return tl::unexpected(failure.sentence());
    }
}

}  // namespace

ShopMemoryLink::ShopMemoryLink(const std::string& dataFolder, std::string dataFile, bool simulated)
    : m_setting(dataFolder + "/shop/memory"), m_dataFile(std::move(dataFile)), m_simulated(simulated) {}

void ShopMemoryLink::ask(const std::string& partType, StoredBoringLots::ShopLotsTold told) {
    auto lots = std::make_shared<Result<Lots>>();
    m_background.run(
        [this, partType, lots]() -> Result<void> {
            (void)::setpriority(PRIO_PROCESS, 0, 10);  // of this thread: whoever controls a machine goes first
            *lots = lotsOf(m_setting, m_dataFile, partType, m_simulated, m_interrupt);
            return {};
        },
        [lots, told = std::move(told)](const Result<void>&) { told(*lots); });
}

}  // namespace kerf::console
