// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace kerf {

/// Somebody wants to know of changes; destroying it ends that, also after what it listens to is gone.
class Subscription {
 public:
    Subscription() = default;
    Subscription(const Subscription&) = delete;
    Subscription& operator=(const Subscription&) = delete;
    virtual ~Subscription() = default;
};

}  // namespace kerf
