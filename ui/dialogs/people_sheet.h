// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace kerf::ui {

class Look;
class OperatorSession;
class SheetHost;

/// Who is known at this machine, with role and PIN, and when nobody is there any more. For a process engineer. Over
/// whatever is open, which comes back as it was.
///
/// Object names: person0… (the rows' names), personOperator0…, personSetter0…, personEngineer0…, personPin0…,
/// signOffNever, signOff5, signOff15, signOff60, sheetSafe.
void openPeople(Look& look, SheetHost& host, OperatorSession& session);

}  // namespace kerf::ui
