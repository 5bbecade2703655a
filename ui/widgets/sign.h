// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QRectF>

#include "engine/core/process.h"
#include "ui/theme/look.h"

class QPainter;

namespace kerf::ui {

/// A state as a shape: told apart without colour.
enum class Sign {
    None,
    Off,          ///< dash
    Advising,     ///< ring
    Up,           ///< disc in grey: works, nothing to see
    Controlling,  ///< disc, acting
    Limited,      ///< disc under a bar, acting and limit
    Held,         ///< two bars
    Alarm1,       ///< octagon (also: faulted)
    Alarm2,       ///< triangle
    Alarm3,       ///< diamond
};

[[nodiscard]] Sign signOf(LoopState state);
[[nodiscard]] Sign signOfAlarm(int priority);
/// Draw the sign into a square box.
void paintSign(QPainter& painter, const QRectF& box, Sign sign, const Look& look);

}  // namespace kerf::ui
