// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>

#include "engine/api/boring_desk.h"

namespace kerf {

/// Who wants to know that a desk's view is another one. A subscription ends with its handle, also after the desk is
/// gone.
class DeskListeners {
 public:
    [[nodiscard]] std::unique_ptr<BoringDesk::Subscription> add(std::function<void()> changed) {
        const std::uint64_t key = ++m_calls->last;
        m_calls->byKey[key] = std::move(changed);
        return std::make_unique<Handle>(m_calls, key);
    }
    void notify() {
        const auto calls = m_calls;
        const auto now = calls->byKey;  // a listener may end its own or another subscription
        for (const auto& [key, call] : now) {
            if (calls->byKey.contains(key)) {
                call();
            }
        }
    }

 private:
    struct Calls {
        std::uint64_t last{0};
        std::map<std::uint64_t, std::function<void()>> byKey{};
    };
    class Handle final : public BoringDesk::Subscription {
     public:
        Handle(const std::shared_ptr<Calls>& calls, std::uint64_t key) : m_calls(calls), m_key(key) {}
        ~Handle() override {
            if (const auto calls = m_calls.lock()) {
                calls->byKey.erase(m_key);
            }
        }

     private:
        std::weak_ptr<Calls> m_calls;
        std::uint64_t m_key;
    };

    std::shared_ptr<Calls> m_calls{std::make_shared<Calls>()};
};

}  // namespace kerf
