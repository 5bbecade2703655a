// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/desk/current_boring_desk.h"

#include <algorithm>

namespace kerf {

void CurrentBoringDesk::replace(std::unique_ptr<StoredBoringDesk> desk) {
    m_changes.reset();
    if (m_desk) {
        m_desk->retire();
        m_retired.push_back(std::move(m_desk));
    }
    m_desk = std::move(desk);
    m_changes = m_desk->onChanged([this] { m_listeners.notify(); });
}

void CurrentBoringDesk::poll() {
    std::erase_if(m_retired, [](const auto& desk) { return desk->idle(); });
    if (m_desk) {
        m_desk->poll();
    }
}

}  // namespace kerf
