// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/writer_thread.h"

#include <QFileInfo>
#include <QLockFile>
#include <QMetaObject>
#include <QStorageInfo>
#include <algorithm>
#include <chrono>
#include <future>
#include <vector>

#include "db/connection.h"
#include "db/head_file.h"
#include "db/outbox.h"
#include "db/statement.h"
#include "db/stores/store.h"
#include "db/waiting.h"

namespace kerf::db {
namespace {
constexpr std::size_t kPartsPerTransaction = 32;
constexpr qint64 kRoomWanted_bytes = 1'000'000;
constexpr int kDiskFull = 13;  // SQLite's own number
constexpr std::uint32_t kNoPageLimit = 0xFFFFFFFE;
/// Each table and index of an acceptance may need a page more; one free page of the file is no room for it.
constexpr const char* kAsMuchAsAnEntry = "INSERT INTO room_probe VALUES (zeroblob(50000))";

/// Errors that go away by themselves or by a person's hand: what failed is tried again. Others are the command's own.
bool passes(const Sentence& failure) {
    for (const int code : {5, 8, 10, 13, 14}) {  // busy, read-only, I/O, full, cannot open
        if (failure.english() == sentenceForCode(code).english()) {
            return true;
        }
    }
    return saysMissing(failure);
}

bool keptWhenRefused(const StoreCommand& command) {
    return std::holds_alternative<RaiseAlarm>(command) || std::holds_alternative<ClearAlarm>(command) ||
           std::holds_alternative<AddAudit>(command);
}

std::string outboxText(const StoreCommand& command) {
    if (const auto* alarm = std::get_if<RaiseAlarm>(&command)) {
        return waitingText(*alarm);
    }
    if (const auto* clear = std::get_if<ClearAlarm>(&command)) {
        return waitingText(*clear);
    }
    return waitingText(std::get<AddAudit>(command));
}

}  // namespace

/// The thread's own side: connection, store, what waits to be stored.
class WriterThread::Worker {
 public:
    Worker(WriterThread& owner, const std::string& path)
        : m_owner(owner),
          m_connection(path, Access::Write),
          m_store(m_connection.database()),
          m_presence(path),
          m_outbox(path),
          m_head(path) {
        for (const std::string& text : m_outbox.found()) {
            if (auto item = waitingOf(text)) {
                m_before.push_back(std::move(*item));
            }
        }
    }

    void run() {
        bool last = false;
        while (!last) {
            m_owner.m_wake.sleep(m_owner.m_options.ringPoll_ms);
            last = m_owner.m_stopping.load();  // read first: what was submitted before stop() is still done below
            watchFile();
            Job* next = nullptr;
            while (m_owner.m_jobs.tryPop(next)) {
                const std::unique_ptr<Job> job(next);
                carryOut(*job);
                storeWaiting(false);
            }
            storeWaiting(false);
        }
        storeWaiting(true);
        m_owner.m_unsaved.store(unsaved());
    }

 private:
    using Clock = std::chrono::steady_clock;

    /// The file is looked at before a write and after its commit: what went into a deleted file is not stored.
    template <class Write>
    auto written(const Write& write) -> decltype(write()) {
        applyPageLimit();
        if (const Sentence missing = m_presence.missing(); !missing.empty()) {
            return tl::unexpected(missing);
        }
        auto result = write();
        if (const Sentence missing = m_presence.missing(); result && !missing.empty()) {
            return tl::unexpected(missing);
        }
        if (result) {
            noteHead();
        }
        return result;
    }

    void carryOut(const Job& job) {
        if (job.keep && !m_commands.empty()) {  // in their order
            keep(job.command);
            return;
        }
        Result<Receipt> result = written([&] { return m_store.apply(job.command); });
        if (!result && passes(result.error())) {
            if (job.keep) {
                keep(job.command);
            }
            m_probing = true;  // nothing waits here by which it could be seen that there is room again
            failed(result.error());
        }
        m_owner.post(Answer{job.ticket, std::move(result)});
    }

    void keep(const StoreCommand& command) {
        m_commands.push_back(command);
        if (keptWhenRefused(command)) {
            (void)m_outbox.add(outboxText(command));
        }
    }

    void watchFile() {
        const Sentence missing = m_presence.missing();
        if (const bool there = missing.empty(); there != m_fileThere) {
            m_fileThere = there;
            m_logEmptied = false;
            if (!there) {
                failed(missing);
            } else {
                m_retryAt = Clock::now();
            }
        }
        if (!m_fileThere && !m_logEmptied) {
            emptyLog();
        }
    }

    /// What was accepted before may stand in the log alone, and only what has it open still reaches it, or the file:
    /// it goes from one into the other, wherever they are now.
    void emptyLog() {
        try {
            Statement statement(m_connection.database(), "PRAGMA wal_checkpoint(TRUNCATE)");
            m_logEmptied = statement.run().next() && statement.integer(0) == 0;
        } catch (const SqlFailure& failure) {
            qCWarning(kerfDb, "checkpoint: %s", failure.what());
            m_logEmptied = true;  // there is no more to be done
        }
    }

    void takeParts() {
        PartRecord record;
        while (m_owner.m_parts != nullptr && m_waiting.size() < m_owner.m_options.mostWaiting &&
               m_owner.m_parts->tryPop(record)) {
            m_waiting.push_back({record, utcNow_ms(), {}});
            if (m_failing) {
                m_safe += m_outbox.add(waitingText(m_waiting.back())) ? 1 : 0;
            }
        }
        m_owner.m_partsWaiting.store(m_failing ? m_waiting.size() : 0);
    }

    void storeWaiting(bool last) {
        takeParts();
        const bool nothing = m_waiting.empty() && m_commands.empty() && m_before.empty();
        if ((nothing && !(m_failing && m_fileThere)) || (!last && m_failing && Clock::now() < m_retryAt)) {
            return;
        }
        if (storeBefore() && storeParts(last) && storeCommands() && m_fileThere && (!m_probing || probe())) {
            succeeded();
        }
    }

    /// What the last run left in the outbox; some of it may have been stored just before it ended.
    bool storeBefore() {
        while (!m_before.empty()) {
            const auto stored = written([&] { return m_store.addWaiting(m_before.front()); });
            if (!stored && passes(stored.error())) {
                failed(stored.error());
                return false;
            }
            m_before.pop_front();
        }
        return true;
    }

    bool storeParts(bool last) {
        while (!m_waiting.empty()) {
            const std::size_t count = std::min(m_waiting.size(), kPartsPerTransaction);
            const std::vector<FinishedPart> batch(m_waiting.begin(),
                                                  m_waiting.begin() + static_cast<std::ptrdiff_t>(count));
            const auto stored = written([&] { return m_store.addParts(std::span<const FinishedPart>(batch)); });
            if (!stored) {
                failed(stored.error());
                return false;
            }
            m_waiting.erase(m_waiting.begin(), m_waiting.begin() + static_cast<std::ptrdiff_t>(count));
            for (const StoredPart& part : *stored) {
                m_owner.post(part);
            }
            m_owner.m_partsStored.fetch_add(stored->size());
            m_owner.m_partsStored.notify_all();
            if (last) {
                takeParts();  // the last ones, however many
            }
        }
        return true;
    }

    bool storeCommands() {
        while (!m_commands.empty()) {
            const auto done = written([&] { return m_store.apply(m_commands.front()); });
            if (!done && passes(done.error())) {
                failed(done.error());
                return false;
            }
            m_commands.pop_front();
        }
        return true;
    }

    /// An entry was refused that its author still has: is there room for it by now?
    bool probe() {
        const QStorageInfo disk(QFileInfo(QString::fromStdString(m_owner.m_path)).absolutePath());
        if (disk.isValid() && disk.bytesAvailable() < kRoomWanted_bytes) {
            failed(sentenceForCode(kDiskFull));
            return false;
        }
        const Result<void> wrote = written([&] {
            return guarded([&] {
                Transaction transaction(m_connection.database());
                execute(m_connection.database(), QStringLiteral("CREATE TABLE room_probe (x)"));
                execute(m_connection.database(), QString::fromLatin1(kAsMuchAsAnEntry));
                execute(m_connection.database(), QStringLiteral("DROP TABLE room_probe"));
                transaction.commit();
            });
        });
        if (!wrote) {
            failed(wrote.error());
        }
        m_probing = !wrote;
        return wrote.has_value();
    }

    void failed(const Sentence& why) {
        m_retryAt = Clock::now() + std::chrono::milliseconds(m_owner.m_options.retry_ms);
        if (m_failing) {
            return;
        }
        m_failing = true;
        for (const FinishedPart& part : m_waiting) {
            m_safe += m_outbox.add(waitingText(part)) ? 1 : 0;
        }
        m_owner.m_partsWaiting.store(m_waiting.size());
        if (m_owner.m_options.partsRefused != nullptr) {
            m_owner.m_options.partsRefused->store(true);
        }
        m_owner.post(why);
    }

    void succeeded() {
        m_outbox.clear();
        m_safe = 0;
        if (!m_failing) {
            return;
        }
        m_failing = false;
        m_owner.m_partsWaiting.store(0);
        if (m_owner.m_options.partsRefused != nullptr) {
            m_owner.m_options.partsRefused->store(false);
        }
        m_owner.post(Sentence());
    }

    [[nodiscard]] std::size_t unsaved() {
        const std::size_t kept = std::min(m_safe, m_waiting.size());
        const SpscRing<PartRecord>* ring = m_owner.m_parts;
        return m_waiting.size() - kept + (ring != nullptr ? ring->approximateSize() : 0);
    }

    void noteHead() {
        try {
            m_head.write(headOf(m_connection.database()));
        } catch (const SqlFailure& failure) {
            qCWarning(kerfDb, "head: %s", failure.what());
        }
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
    FilePresence m_presence;
    Outbox m_outbox;
    HeadFile m_head;
    std::deque<Waiting> m_before;
    std::deque<FinishedPart> m_waiting;
    std::deque<StoreCommand> m_commands;
    std::size_t m_safe{0};  ///< of m_waiting, from its front: in the outbox too
    bool m_fileThere{true};
    bool m_logEmptied{false};
    bool m_failing{false};
    bool m_probing{false};  ///< a command was refused since it was last seen that there is room
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
        std::unique_ptr<QLockFile> lock;
        if (m_options.taken == nullptr) {
            auto taken = lockDataFile(m_path);
            if (!taken) {
                promise.set_value(tl::unexpected(taken.error()));
                return;
            }
            lock = std::move(*taken);
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
        while (!m_kept.empty()) {
            handOverKept();
            m_wake.wake();
            std::this_thread::sleep_for(std::chrono::milliseconds(1));  // the thread empties its queue without us
        }
        m_stopping.store(true);
        m_wake.wake();
        m_thread.join();
        deliver();
    }
    return m_unsaved.load();
}

bool WriterThread::handOver(std::unique_ptr<Job>& job) {
    if (!m_thread.joinable() || !m_jobs.tryPush(job.get())) {
        return false;
    }
    (void)job.release();
    m_wake.wake();
    return true;
}

void WriterThread::handOverKept() {
    while (!m_kept.empty() && handOver(m_kept.front())) {
        m_kept.pop_front();
    }
}

void WriterThread::submit(StoreCommand command, Done done) {
    auto job = std::make_unique<Job>();
    job->ticket = ++m_lastTicket;
    job->keep = !done;
    if (auto* alarm = std::get_if<RaiseAlarm>(&command); alarm != nullptr && alarm->utc_ms == 0) {
        alarm->utc_ms = utcNow_ms();
    }
    if (auto* clear = std::get_if<ClearAlarm>(&command); clear != nullptr && clear->utc_ms == 0) {
        clear->utc_ms = utcNow_ms();
    }
    job->command = std::move(command);
    const std::uint64_t ticket = job->ticket;
    handOverKept();
    if (job->keep) {
        if (!m_kept.empty() || !handOver(job)) {
            m_kept.push_back(std::move(job));  // deliver() hands it over
        }
        return;
    }
    if (handOver(job)) {
        m_waiting.emplace(ticket, std::move(done));
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
    handOverKept();
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
