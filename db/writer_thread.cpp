// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/writer_thread.h"

#include <QLockFile>
#include <QMetaObject>
#include <chrono>
#include <future>
#include <vector>

#include "db/connection.h"
#include "db/statement.h"
#include "db/stores/store.h"

namespace kerf::db {
namespace {
constexpr std::size_t kPartsPerTransaction = 32;
constexpr std::uint32_t kNoPageLimit = 0xFFFFFFFE;
}  // namespace

/// The thread's own side: connection, store, the parts that wait to be stored.
class WriterThread::Worker {
 public:
    Worker(WriterThread& owner, const std::string& path)
        : m_owner(owner), m_connection(path, Access::Write), m_store(m_connection.database()) {}

    void run() {
        bool last = false;
        while (!last) {
            m_owner.m_wake.sleep(m_owner.m_options.ringPoll_ms);
            last = m_owner.m_stopping.load();  // read first: what was submitted before stop() is still done below
            Job* next = nullptr;
            while (m_owner.m_jobs.tryPop(next)) {
                const std::unique_ptr<Job> job(next);
                applyPageLimit();
                m_owner.post(Answer{job->ticket, m_store.apply(job->command)});
                storeParts(false);
            }
            storeParts(false);
        }
        std::size_t before = 0;
        do {  // the last ones, however many
            before = m_waiting.size();
            storeParts(true);
        } while (m_waiting.empty() && before > 0);
        SpscRing<PartRecord>* ring = m_owner.m_parts;
        m_owner.m_unsaved.store(m_waiting.size() + (ring != nullptr ? ring->approximateSize() : 0));
    }

 private:
    using Clock = std::chrono::steady_clock;

    void storeParts(bool last) {
        if (m_owner.m_parts != nullptr) {
            PartRecord record;
            while (m_waiting.size() < kPartsPerTransaction && m_owner.m_parts->tryPop(record)) {
                m_waiting.push_back(record);
            }
        }
        if (m_waiting.empty() || (!last && m_failing && Clock::now() < m_retryAt)) {
            return;
        }
        applyPageLimit();
        const Result<std::vector<StoredPart>> stored = m_store.addParts(m_waiting);
        if (!stored) {
            m_retryAt = Clock::now() + std::chrono::milliseconds(m_owner.m_options.retry_ms);
            if (!m_failing) {
                m_failing = true;
                m_owner.post(stored.error());
            }
            return;
        }
        m_waiting.clear();
        if (m_failing) {
            m_failing = false;
            m_owner.post(Sentence());
        }
        for (const StoredPart& part : *stored) {
            m_owner.post(part);
        }
        m_owner.m_partsStored.fetch_add(stored->size());
        m_owner.m_partsStored.notify_all();
    }

    void applyPageLimit() {
        const std::uint32_t wanted = m_owner.m_pageLimit.load();
        if (wanted != m_pageLimit) {
            m_pageLimit = wanted;
            execute(m_connection.database(),
                    QStringLiteral("PRAGMA max_page_count = %1").arg(wanted == 0 ? kNoPageLimit : wanted));
        }
    }

    WriterThread& m_owner;
    Connection m_connection;
    Store m_store;
    std::vector<PartRecord> m_waiting;
    bool m_failing{false};
    Clock::time_point m_retryAt{};
    std::uint32_t m_pageLimit{0};
};

WriterThread::WriterThread(std::string path, SpscRing<PartRecord>* parts, Options options)
    : m_path(std::move(path)), m_parts(parts), m_options(options), m_jobs(options.queueCapacity) {}

WriterThread::~WriterThread() {
    m_waiting.clear();  // whoever is gone by now is not called any more
    m_problemListeners = {};
    m_partListeners = {};
    stop();
}

Result<void> WriterThread::start() {
    std::promise<Result<void>> started;
    std::future<Result<void>> answer = started.get_future();
    m_thread = std::thread([this, promise = std::move(started)]() mutable {
        QLockFile lock(QString::fromStdString(m_path) + QStringLiteral(".lock"));
        lock.setStaleLockTime(0);  // stale only when its process is gone
        if (!lock.tryLock(0)) {
            promise.set_value(
                lock.error() == QLockFile::LockFailedError
                    ? Result<void>(fail(KERF_TEXT("Another Kerf is already working with this data file.")))
                    : Result<void>(tl::unexpected<Sentence>(sentenceForCode(8))));
            return;
        }
        std::unique_ptr<Worker> worker;
        const Result<void> opened = guarded([&] { worker = std::make_unique<Worker>(*this, m_path); });
        promise.set_value(opened);
        if (worker) {
            worker->run();
        }
    });
    const Result<void> result = answer.get();
    if (!result) {
        m_thread.join();
    }
    return result;
}

std::size_t WriterThread::stop() {
    if (m_thread.joinable()) {
        m_stopping.store(true);
        m_wake.wake();
        m_thread.join();
        deliver();
    }
    return m_unsaved.load();
}

void WriterThread::submit(StoreCommand command, Done done) {
    auto job = std::make_unique<Job>();
    job->ticket = ++m_lastTicket;
    job->command = std::move(command);
    const std::uint64_t ticket = job->ticket;
    if (m_thread.joinable() && m_jobs.tryPush(job.get())) {
        (void)job.release();
        m_wake.wake();
        if (done) {
            m_waiting.emplace(ticket, std::move(done));
        }
        return;
    }
    if (done) {
        // Refused, but answered later like every other command.
        m_waiting.emplace(ticket, std::move(done));
        QMetaObject::invokeMethod(
            this,
            [this, ticket] {
                if (const auto found = m_waiting.find(ticket); found != m_waiting.end()) {
                    const Done waiting = std::move(found->second);
                    m_waiting.erase(found);
                    waiting(fail(KERF_TEXT("Too many entries are waiting to be stored; try again in a moment.")));
                }
            },
            Qt::QueuedConnection);
    }
}

std::unique_ptr<Subscription> WriterThread::onProblemChanged(std::function<void()> changed) {
    return m_problemListeners.add(std::move(changed));
}

std::unique_ptr<Subscription> WriterThread::onPartStored(std::function<void(const StoredPart&)> stored) {
    return m_partListeners.add(std::move(stored));
}

void WriterThread::post(Outcome outcome) {
    bool first = false;
    {
        const std::lock_guard lock(m_outcomesLock);
        first = m_outcomes.empty();
        m_outcomes.push_back(std::move(outcome));
    }
    if (first) {  // one event at a time, however long the caller's thread stands still
        QMetaObject::invokeMethod(
            this, [this] { deliver(); }, Qt::QueuedConnection);
    }
}

void WriterThread::deliver() {
    std::vector<Outcome> outcomes;
    {
        const std::lock_guard lock(m_outcomesLock);
        outcomes.swap(m_outcomes);
    }
    for (const Outcome& outcome : outcomes) {
        if (const auto* answer = std::get_if<Answer>(&outcome)) {
            if (const auto found = m_waiting.find(answer->ticket); found != m_waiting.end()) {
                const Done done = std::move(found->second);
                m_waiting.erase(found);
                done(answer->result);
            }
        } else if (const auto* part = std::get_if<StoredPart>(&outcome)) {
            m_partListeners.tell(*part);
        } else {
            m_problem = std::get<Sentence>(outcome);
            m_problemListeners.tell();
        }
    }
}

}  // namespace kerf::db
