// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/files/output.h"

#include <cstdio>

namespace kerf::headless {

void CsvOutput::flush() {
    std::fwrite(m_text.data(), 1, m_text.size(), stdout);
    std::fflush(stdout);
    m_text.clear();
}

void printJson(const nlohmann::ordered_json& document) {
    const std::string text = document.dump(2) + "\n";
    std::fwrite(text.data(), 1, text.size(), stdout);
    std::fflush(stdout);
}

}  // namespace kerf::headless
