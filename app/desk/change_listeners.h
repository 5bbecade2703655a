// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>

namespace kerf {

/// Who wants to know of a desk's changes. A subscription ends with its handle, which may outlive the desk.
template <class Subscription>
class ChangeListeners {
 public:
    [[nodiscard]] std::unique_ptr<Subscription> add(std::function<void()> changed) {
        const std::uint64_t key = ++m_calls->last;
        m_calls->map[key] = std::move(changed);
        return std::make_unique<Handle>(m_calls, key);
    }
    void tell() const {
        const auto calls = m_calls->map;  // a listener may end its own or another subscription
        for (const auto& [key, call] : calls) {
            if (m_calls->map.contains(key)) {
                call();
            }
        }
    }

 private:
    struct Calls {
        std::uint64_t last{0};
        std::map<std::uint64_t, std::function<void()>> map{};
    };
    class Handle final : public Subscription {
     public:
        Handle(const std::shared_ptr<Calls>& calls, std::uint64_t key) : m_calls(calls), m_key(key) {}
        ~Handle() override {
            if (const auto calls = m_calls.lock()) {
                calls->map.erase(m_key);
            }
        }

     private:
        std::weak_ptr<Calls> m_calls;
        std::uint64_t m_key;
    };
    std::shared_ptr<Calls> m_calls{std::make_shared<Calls>()};
};

}  // namespace kerf
