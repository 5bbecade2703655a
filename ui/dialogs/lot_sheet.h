// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

class QBoxLayout;

namespace kerf {
class LotService;
}

namespace kerf::ui {

struct PageContext;

/// Lots of a process that is not boring: which one the next parts are of; open one of the part type in force, go on
/// with an open one, leave it, or close it with a reason. Object names: lotTable, lotName, lotSize, lotTool, lotGauge,
/// lotReason, lotMessage; buttons lotOpen, lotChoose, lotLeave, lotClose.
void openLotSheet(const PageContext& context, LotService& lots);

/// A button for it (processLots) on the sheet that is open: a form's. Nothing, without lots.
void offerLotSheet(const PageContext& context, LotService* lots);

/// The lot the next parts are of, in words, at the end of a card's header (lotLine); empty without one.
void addLotLine(const PageContext& context, LotService* lots, QBoxLayout* header);

}  // namespace kerf::ui
