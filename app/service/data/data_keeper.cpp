// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/service/data/data_keeper.h"

#include "db/restore.h"

namespace kerf {

void DataKeeper::restore(const std::string& backup, const std::string& author, const std::string& reason, Done done) {
    if (const auto may = permitted(m_links.rights, author, Deed::DataRestore, reason); !may) {
        done(may);
        return;
    }
    m_links.onWorker([path = m_links.databasePath,
                      request = db::RestoreRequest{backup, author, reason}] { return db::layReady(path, request); },
                     std::move(done));
}

void DataKeeper::removePerson(const std::string& name, const std::string& author, Done done) {
    if (const auto may = permitted(m_links.rights, author, Deed::PersonRemove); !may) {
        done(may);
        return;
    }
    if (name == author) {
        done(fail(KERF_TEXT("Nobody takes himself off the list: somebody else has to.")));
        return;
    }
    m_links.writer.submit(RemoveAccount{name, author}, [done = std::move(done)](const Result<Receipt>& stored) {
        done(stored ? Result<void>() : Result<void>(tl::unexpected(stored.error())));
    });
}

}  // namespace kerf
