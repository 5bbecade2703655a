// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <utility>

#include "engine/core/subscription.h"

namespace kerf {

/// Who wants to be told. A subscription ends with its handle, which may outlive this object. One thread.
template <class... Args>
class Listeners {
 public:
    using Call = std::function<void(Args...)>;

    [[nodiscard]] std::unique_ptr<Subscription> add(Call call) {
        const std::uint64_t number = ++m_calls->last;
        m_calls->byNumber[number] = std::move(call);
        return std::make_unique<Handle>(m_calls, number);
    }
    void tell(const Args&... args) const {
        const auto calls = m_calls;  // a listener may end this object, its own or another subscription
        const auto now = calls->byNumber;
        for (const auto& [number, call] : now) {
            if (calls->byNumber.contains(number)) {
                call(args...);
            }
        }
    }

 private:
    struct Calls {
        std::uint64_t last{0};
        std::map<std::uint64_t, Call> byNumber{};
    };
    class Handle final : public Subscription {
     public:
        Handle(const std::shared_ptr<Calls>& calls, std::uint64_t number) : m_calls(calls), m_number(number) {}
        ~Handle() override {
            if (const auto calls = m_calls.lock()) {
                calls->byNumber.erase(m_number);
            }
        }

     private:
        std::weak_ptr<Calls> m_calls;
        std::uint64_t m_number;
    };
    std::shared_ptr<Calls> m_calls{std::make_shared<Calls>()};
};

}  // namespace kerf
