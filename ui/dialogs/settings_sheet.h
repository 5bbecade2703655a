// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace kerf::ui {

class Look;
class SheetHost;

/// Language, units, theme, size. Every choice acts at once, so that it can be judged on the page itself.
void openSettings(Look& look, SheetHost& host);

}  // namespace kerf::ui
