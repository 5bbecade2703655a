// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/service/boring/current_boring_service.h"

#include <algorithm>

namespace kerf {

void CurrentBoringService::replace(std::unique_ptr<StoredBoringService> service) {
    m_changes.reset();
    if (m_service) {
        m_service->retire();
        m_retired.push_back(std::move(m_service));
    }
    m_service = std::move(service);
    m_changes = m_service->onChanged([this] { m_listeners.tell(); });
}

void CurrentBoringService::poll() {
    std::erase_if(m_retired, [](const auto& service) { return service->idle(); });
    if (m_service) {
        m_service->poll();
    }
}

}  // namespace kerf
