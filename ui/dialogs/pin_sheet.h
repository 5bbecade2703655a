// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <functional>

namespace kerf::ui {

class Look;
class SheetHost;

/// Ask for a PIN on the keypad. `take` says whether it is accepted; then the sheet closes and `then` runs, else it
/// stays and shows `refusal`, or why no PIN is looked at now.
///
/// Object names: pinField, pinKeypad, pinMessage, sheetSafe.
void askPin(Look& look, SheetHost& host, const QString& title, const QString& text, const QString& refusal,
            std::function<bool(const QString& pin)> take, std::function<void()> then = {},
            std::function<QString()> whyNotYet = {});

}  // namespace kerf::ui
