// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/files/output.h"

#include "app/files/whole_file.h"

namespace kerf::headless {

void CsvOutput::flush() {
    files::writeOut(m_text);
    m_text.clear();
}

void printJson(const nlohmann::ordered_json& document) {
    // A name of unknown encoding never ends in an exception.
    files::writeOut(document.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n");
}

}  // namespace kerf::headless
