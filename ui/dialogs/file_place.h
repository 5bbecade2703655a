// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLineEdit>
#include <QString>

#include "ui/dialogs/sheet.h"

namespace kerf::ui {

/// That name, or name_2, name_3 … : what is written never takes the place of a file that is there.
[[nodiscard]] QString freeFileName(const QString& wanted);

/// One touch per folder (removable drives first) instead of a typed path: it replaces the folder of the name in `file`.
/// Object names: fileFolder0, fileFolder1 …
void addFolders(Sheet* sheet, const QStringList& folders, QLineEdit* file);

}  // namespace kerf::ui
