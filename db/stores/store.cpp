// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/stores/store.h"

#include "db/statement.h"

namespace kerf::db {

Result<Receipt> Store::apply(const StoreCommand& command) {
    return guarded([&] {
        Transaction transaction(m_database);
        const Receipt receipt = std::visit([this](const auto& each) { return run(each); }, command);
        transaction.commit();
        return receipt;
    });
}

}  // namespace kerf::db
