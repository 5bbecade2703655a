// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <atomic>
#include <cstdint>
#include <deque>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <variant>
#include <vector>

#include "db/api/store_writer.h"
#include "db/data_file.h"
#include "db/wake.h"
#include "engine/core/listeners.h"
#include "engine/core/spsc_ring.h"

namespace kerf::db {

/// The only writer of a data file: one thread with its own connection. It goes on while the caller's thread stands
/// still.
///
///   caller → writer   bounded queue of commands; full: refused with a sentence, nothing waits. Commands nobody asks
///   about
///                     (alarms, entries of the audit log) wait on the caller's side instead and are never dropped
///   engine → writer   ring of PartRecord, looked at after every command and at least every `ringPoll_ms`
///   writer → caller   results, handed over by one queued event at a time
///
/// Finished parts, alarms and audit entries that cannot be stored are kept, written into the outbox beside the data
/// file (db/outbox.h), and tried again every `retry_ms`; meanwhile the engine is told to begin no part of its own.
/// Beyond `mostWaiting` parts the ring is not emptied further. Commands go on being tried; one that is refused for lack
/// of room makes the store a failing one, too, until there is room again. A data file that was deleted
/// or replaced under its name is a store that fails, said at once. The object belongs to the caller's thread, which
/// needs an event loop for the callbacks.
class WriterThread final : public QObject, public StoreWriter {
    Q_OBJECT
 public:
    struct Options {
        std::size_t queueCapacity{256};
        int ringPoll_ms{20};
        int retry_ms{1000};
        std::size_t mostWaiting{256};              ///< parts of the engine
        DataFile* taken{nullptr};                  ///< the file is locked already; null: start() locks it
        std::atomic<bool>* partsRefused{nullptr};  ///< told while finished parts cannot be stored; outlives the writer
    };

    /// `parts` may be null (no engine); otherwise it must outlive the writer, whose thread is its only consumer.
    /// The file must have been brought up to date by prepareDatabase().
    WriterThread(std::string path, SpscRing<PartRecord>* parts, Options options);
    WriterThread(std::string path, SpscRing<PartRecord>* parts) : WriterThread(std::move(path), parts, Options{}) {}
    ~WriterThread() override;

    /// Blocks until the thread has its connection or knows why not. Nothing is written before.
    [[nodiscard]] Result<void> start();
    /// Runs what was submitted, takes over the ring, ends the thread, then delivers what is left. Blocks. Returns the
    /// number of finished parts that are neither stored nor safe in the outbox (0 unless the disk has failed).
    std::size_t stop();
    /// Finished parts that wait because the store does not take them. Any thread.
    [[nodiscard]] std::size_t partsWaiting() const noexcept { return m_partsWaiting.load(); }

    void submit(StoreCommand command, Done done) override;
    [[nodiscard]] const Sentence& problem() const override { return m_problem; }
    [[nodiscard]] std::unique_ptr<Subscription> onProblemChanged(std::function<void()> changed) override;
    [[nodiscard]] std::unique_ptr<Subscription> onPartStored(std::function<void(const StoredPart&)> stored) override;

    /// Finished parts of the engine stored so far; any thread may read it or wait for it to change.
    [[nodiscard]] const std::atomic<std::uint64_t>& partsStored() const noexcept { return m_partsStored; }
    /// Lets SQLite use at most this many pages, as a full disk would; 0: no limit. For tests. Any time after start().
    void limitPages(std::uint32_t pages) { m_pageLimit.store(pages); }

 private:
    struct Job {
        std::uint64_t ticket{0};
        StoreCommand command{};
        bool keep{false};  ///< nobody is told: try again until it is stored
    };
    struct Answer {
        std::uint64_t ticket{0};
        Result<Receipt> result{};
    };
    using Outcome = std::variant<Answer, StoredPart, Sentence>;
    class Worker;

    [[nodiscard]] bool handOver(std::unique_ptr<Job>& job);
    void handOverKept();
    void post(Outcome outcome);  // writer thread
    void deliver();              // caller's thread

    const std::string m_path;
    SpscRing<PartRecord>* const m_parts;
    const Options m_options;

    SpscRing<Job*> m_jobs;  ///< owned by the ring while inside
    Wake m_wake;
    std::atomic<bool> m_stopping{false};
    std::mutex m_outcomesLock;  ///< held for a push or a swap only; submit() does not take it
    std::vector<Outcome> m_outcomes;
    std::atomic<std::uint64_t> m_partsStored{0};
    std::atomic<std::uint32_t> m_pageLimit{0};
    std::thread m_thread;
    std::atomic<std::size_t> m_unsaved{0};

    std::atomic<std::size_t> m_partsWaiting{0};
    std::deque<std::unique_ptr<Job>> m_kept;  ///< wait for room in the queue
    std::uint64_t m_lastTicket{0};
    std::map<std::uint64_t, Done> m_waiting;
    Sentence m_problem{};
    Listeners<> m_problemListeners{};
    Listeners<StoredPart> m_partListeners{};
};

}  // namespace kerf::db
