// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace kerf::ui {

class Look;
class OperatorSession;
class SheetHost;

/// On a real machine where no process engineer is known: name and PIN of the first one. He gives everybody else's role.
void askFirstEngineer(Look& look, SheetHost& host, OperatorSession& session);

}  // namespace kerf::ui
