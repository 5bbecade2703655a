// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/shop_link.h"

#include <fmt/format.h>

#include <fstream>

#include "db/shop/outbox.h"
#include "engine/cycle/machine_alarms.h"

namespace kerf::console {
namespace {

const char* key(db::ShopTrouble trouble) {
    switch (trouble) {
        case db::ShopTrouble::None:
            return "none";
        case db::ShopTrouble::NotPrepared:
            return "not prepared";
        case db::ShopTrouble::NotAllowed:
            return "not allowed";
        case db::ShopTrouble::NewerConsole:
            return "newer console";
        case db::ShopTrouble::DataFile:
            return "data file";
        case db::ShopTrouble::Unreachable:
        case db::ShopTrouble::Interrupted:
            break;
    }
    return "unreachable";
}

ui::ShopView::Trouble viewed(db::ShopTrouble trouble) {
    using Shown = ui::ShopView::Trouble;
    switch (trouble) {
        case db::ShopTrouble::None:
            return Shown::None;
        case db::ShopTrouble::NotPrepared:
            return Shown::NotPrepared;
        case db::ShopTrouble::NotAllowed:
            return Shown::NotAllowed;
        case db::ShopTrouble::NewerConsole:
            return Shown::NewerConsole;
        case db::ShopTrouble::DataFile:
            return Shown::DataFile;
        case db::ShopTrouble::Unreachable:
        case db::ShopTrouble::Interrupted:
            break;
    }
    return Shown::Unreachable;
}

}  // namespace

ShopLink::ShopLink(const std::string& dataFolder, const std::string& dataFile, StoreWriter& writer) : m_writer(writer) {
    std::ifstream file(dataFolder + "/shop/database");
    std::string conninfo;
    if (!std::getline(file, conninfo) || conninfo.empty()) {
        return;
    }
    m_fault = db::conninfoFault(conninfo);
    if (m_fault.empty() && db::holdsPassword(conninfo)) {
        m_fault = "shop/database holds a password; use a certificate or a service";
    }
    if (m_fault.empty()) {
        m_sender = std::make_unique<db::ShopSender>(dataFile, conninfo);
    }
}

ShopLink::~ShopLink() = default;

void ShopLink::poll(std::int64_t now_ms) {
    if (!m_sender) {
        return;
    }
    const db::ShopState state = m_sender->state();
    if (state.trouble == db::ShopTrouble::None) {
        m_troubleSince_ms = -1;
        if (m_alarm) {
            m_writer.submit(ClearAlarm{machine_alarm::kShopOutOfReach}, {});
            m_alarm = false;
        }
        return;
    }
    if (m_troubleSince_ms < 0) {
        m_troubleSince_ms = now_ms;
    }
    if (!m_alarm && now_ms - m_troubleSince_ms >= kPatience_ms) {
        m_writer.submit(
            RaiseAlarm{machine_alarm::kShopOutOfReach, 3,
                       Sentence(KERF_TEXT("The shop has been out of reach for %1 min; %2 entries wait here."),
                                SentenceArg(static_cast<double>(now_ms - m_troubleSince_ms) / 60000.0, 0),
                                SentenceArg(static_cast<double>(state.unsent), 0))},
            {});
        m_alarm = true;
    }
}

std::optional<ui::ShopView> ShopLink::view() const {
    if (!m_sender) {
        return m_fault.empty() ? std::nullopt
                               : std::optional(ui::ShopView{ui::ShopView::Trouble::WrongSetting, m_fault, 0, 0, 0});
    }
    const db::ShopState state = m_sender->state();
    return ui::ShopView{viewed(state.trouble), state.detail, state.unsent, state.setAside, state.lastContact_utc_ms};
}

std::string ShopLink::json() const {
    if (!m_sender) {
        return {};
    }
    const db::ShopState state = m_sender->state();
    return fmt::format(R"({{"trouble":"{}","detail":{},"unsent":{},"set_aside":{},"contact_utc_ms":{}}})",
                       key(state.trouble), db::jsonText(state.detail), state.unsent, state.setAside,
                       state.lastContact_utc_ms);
}

}  // namespace kerf::console
