// SPDX-License-Identifier: GPL-3.0-or-later
// A file of diameters: all of them or none.
#include "app/service/boring/bore_import.h"
#include "app/service/boring/boring_service.h"

namespace kerf {

BoreImportPlan StoredBoringService::planImport(const ReadBores& read) const {
    return planBores(m_records, read);
}

StoredBoringService::Rows StoredBoringService::rowsOf(const ReadBores& read, const std::string& author,
                                                      bool confirmed) const {
    if (const auto may = permitted(m_links.rights, author, Deed::BoringDiameter); !may) {
        return tl::unexpected(may.error());
    }
    const BoreImportPlan plan = planBores(m_records, read);
    if (plan.refused) {
        return tl::unexpected(plan.refused->reason);
    }
    if (!plan.questions.empty() && !confirmed) {
        return tl::unexpected(plan.questions.front().reason);
    }
    if (plan.rows.empty()) {
        return fail(KERF_TEXT("The file holds no diameter that is not stored already."));
    }
    return importRows(m_records, plan, read.file, author);
}

void StoredBoringService::importBores(const ReadBores& read, const std::string& author, bool confirmed, Done done) {
    queue({[this, read, author, confirmed] { return rowsOf(read, author, confirmed); }, std::move(done)});
}

}  // namespace kerf
