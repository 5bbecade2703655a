// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>

#include "app/service/rights.h"
#include "db/api/store_writer.h"

namespace kerf {

/// What is done to the data as a whole and to the list of people. GUI thread, but for the copying.
class DataKeeper {
 public:
    using Done = std::function<void(const Result<void>&)>;
    /// Work that blocks, then its end on the caller's thread.
    using OnWorker = std::function<void(std::function<Result<void>()>, Done)>;

    struct Links {
        StoreWriter& writer;
        std::string databasePath{};
        OnWorker onWorker{};
        Rights rights{};
    };
    explicit DataKeeper(Links links) : m_links(std::move(links)) {}

    /// Checks a backup and lays it ready: it takes the data file's place at the next start (db/restore.h).
    void restore(const std::string& backup, const std::string& author, const std::string& reason, Done done);
    /// Off the list of people; what they have done keeps their name.
    void removePerson(const std::string& name, const std::string& author, Done done);

 private:
    Links m_links;
};

}  // namespace kerf
