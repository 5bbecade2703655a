// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/shop/shop_sender.h"

#include <sys/resource.h>

#include <algorithm>
#include <random>

#include "db/statement.h"

namespace kerf::db {
namespace {
constexpr int kIdle_ms = 1000;
constexpr int kGreetAfter = 20;  ///< quiet rounds; a shop that has gone is noticed then at the latest
constexpr int kFirstWait_ms = 1000;
constexpr int kLongestWait_ms = 60000;
/// A backlog of weeks is sent in the pauses of everything else: a breath after each batch.
constexpr int kBreath_ms = 20;

/// What the outbox holds, looked up while the server is out of reach; nothing when the file cannot be read.
std::optional<std::int64_t> newestHere(const std::string& dataFile) {
    try {
        const Connection file(dataFile, Access::Read);
        const OutboxReader outbox(file.database());
        return outbox.newestSeq(ShopStream::Rows) + outbox.newestSeq(ShopStream::Traces);
    } catch (const SqlFailure&) {
        return std::nullopt;
    }
}
}  // namespace

void runShopSender(const std::string& dataFile, const std::string& conninfo, const Interrupt& interrupt,
                   const std::function<void(const ShopState&)>& told) {
    // Only spreads consoles that lost the same server at the same time; nothing that is stored depends on it.
    std::minstd_rand jitter(std::random_device{}());
    ShopState state;
    std::int64_t acknowledged = 0;
    int wait_ms = kFirstWait_ms;
    ShopPush push(dataFile, conninfo, interrupt);
    while (!interrupt.triggered()) {
        const std::int64_t setAsideBefore = state.setAside - push.progress().setAside;
        try {
            push.connect();
            for (int quiet = 0;;) {
                const bool more = push.step();
                quiet = more ? 0 : quiet + 1;
                if (quiet == kGreetAfter) {
                    push.greet();
                    quiet = 0;
                }
                const ShopProgress& progress = push.progress();
                acknowledged = progress.streams[0].last + progress.streams[1].last;
                state.trouble = ShopTrouble::None;
                state.detail.clear();
                state.unsent = progress.unsent();
                state.setAside = setAsideBefore + progress.setAside;
                state.newEpoch = progress.newEpoch;
                if (quiet <= 1) {
                    state.lastContact_utc_ms = utcNow_ms();
                }
                wait_ms = kFirstWait_ms;
                told(state);
                if (interrupt.wait(more ? kBreath_ms : kIdle_ms)) {
                    return;
                }
            }
        } catch (const ShopFailure& failure) {
            state.trouble = failure.trouble();
            state.detail = failure.what();
        }
        if (interrupt.triggered()) {
            return;
        }
        state.unsent =
            std::max<std::int64_t>(newestHere(dataFile).value_or(acknowledged + state.unsent) - acknowledged, 0);
        told(state);
        // Between half of it and all of it, so that two hundred consoles do not knock at the same moment.
        const int spread_ms = static_cast<int>(jitter() % static_cast<unsigned>(wait_ms / 2 + 1));
        interrupt.wait(wait_ms / 2 + spread_ms);
        wait_ms = std::min(wait_ms * 2, kLongestWait_ms);
    }
}

ShopSender::ShopSender(std::string dataFile, std::string conninfo) {
    m_thread = std::thread([this, file = std::move(dataFile), server = std::move(conninfo)] {
        // Linux: a nice value belongs to the thread. Whoever controls a machine goes first.
        (void)::setpriority(PRIO_PROCESS, 0, 10);
        runShopSender(file, server, m_interrupt, [this](const ShopState& state) {
            const std::lock_guard lock(m_lock);
            m_state = state;
        });
    });
}

ShopSender::~ShopSender() {
    m_interrupt.trigger();
    m_thread.join();
}

ShopState ShopSender::state() const {
    const std::lock_guard lock(m_lock);
    return m_state;
}

}  // namespace kerf::db
