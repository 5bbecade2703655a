// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

namespace kerf::ui {

class Look;
class OperatorSession;
class SheetHost;

/// Ask who is at the machine: one touch on a known name, or type a new one (a badge reader types it, too).
/// `then` runs after a name was chosen; not when the sheet was closed.
void chooseOperator(Look& look, SheetHost& host, OperatorSession& session, std::function<void()> then = {});

}  // namespace kerf::ui
