// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <vector>

namespace kerf::ui {

/// One paragraph of help. `key`: the object name of what is explained, or "page:" and the page's key.
struct HelpText {
    const char* key{""};
    QString title{};
    QString words{};
    QString formula{};  ///< empty: there is none
};

/// All of them, in the language of the program.
[[nodiscard]] std::vector<HelpText> helpTexts();

}  // namespace kerf::ui
