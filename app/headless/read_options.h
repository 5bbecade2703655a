// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "app/files/table_layout.h"

namespace CLI {
class App;
}
namespace kerf::files {
class Table;
}

/// What every command that reads a table offers: how to say what the file does not.
namespace kerf::headless {

/// --separator, --decimal, --encoding, --dates, --columns, --period-s, --accept-implausible. The options live as long
/// as the command.
[[nodiscard]] std::shared_ptr<files::ReadOptions> addReadOptions(CLI::App& command);

/// On stderr, once the command has its result: what was found out rather than known.
void tell(const std::vector<std::string>& notes);
void tellNotes(const files::Table& table);

}  // namespace kerf::headless
