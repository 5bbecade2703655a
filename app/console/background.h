// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QThread>
#include <functional>
#include <memory>
#include <vector>

#include "engine/core/result.h"

namespace kerf::console {

/// Slow work with files beside the screen: a report, a backup. Each piece on a thread of its own; the end is waited
/// for before the console goes. GUI thread.
class Background {
 public:
    using Work = std::function<Result<void>()>;
    using Done = std::function<void(const Result<void>&)>;

    Background() = default;
    Background(const Background&) = delete;
    Background& operator=(const Background&) = delete;
    ~Background() {
        for (const auto& thread : m_threads) {
            thread->wait();
        }
    }

    /// `work` on its thread, then `done` on this one.
    void run(Work work, Done done) {
        std::erase_if(m_threads, [](const auto& thread) { return thread->isFinished(); });
        auto result = std::make_shared<Result<void>>();
        std::unique_ptr<QThread> thread(QThread::create([work = std::move(work), result] { *result = work(); }));
        QObject::connect(thread.get(), &QThread::finished, &m_here,
                         [result, done = std::move(done)] { done(*result); });
        thread->start();
        m_threads.push_back(std::move(thread));
    }

 private:
    QObject m_here;
    std::vector<std::unique_ptr<QThread>> m_threads;
};

}  // namespace kerf::console
