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
    QString source{};   ///< where the law is published; empty: nowhere, or it is our own
};

/// All of them, those of single buttons first, in the language of the program.
[[nodiscard]] std::vector<HelpText> helpTexts();
/// Those about single buttons and figures; a key may begin or end with * (any name that ends or begins so).
[[nodiscard]] std::vector<HelpText> buttonTexts();
/// The paragraph of this name; null: there is none.
[[nodiscard]] const HelpText* findHelp(const std::vector<HelpText>& texts, const QString& name);

}  // namespace kerf::ui
