// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLabel>

namespace kerf::ui {

/// What a text is; the style sheet gives size and colour.
enum class TextRole { Body, Dim, Small, Title, CardNumber };

/// A label of one of the roles. `wrap` labels grow in height instead of being cut.
[[nodiscard]] QLabel* makeLabel(TextRole role, QWidget* parent = nullptr, bool wrap = false);
void setTextRole(QLabel* label, TextRole role);

/// A thin separating line.
[[nodiscard]] QFrame* makeRule(Qt::Orientation orientation, QWidget* parent = nullptr);

}  // namespace kerf::ui
