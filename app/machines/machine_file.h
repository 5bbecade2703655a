// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <stdexcept>
#include <string>

#include "engine/port/machine_description.h"

/// The machine file: JSON, read whole and checked whole, unknown keys refused by name. docs/linuxcnc.md has every key.
namespace kerf {

/// One sentence that begins with the key.
struct MachineFileFault : std::runtime_error {
    using std::runtime_error::runtime_error;
};

struct MachineFile {
    std::string machine{};  ///< "linuxcnc", "simulator", "diamond-lathe"
    MachineDescription description{};
};

/// @throws MachineFileFault
[[nodiscard]] MachineFile parseMachineFile(const std::string& text);
/// The same of a file, whose name stands before the sentence. `machine`: the kind that was asked for beside it; empty:
/// whichever the file is for.
[[nodiscard]] MachineFile readMachineFile(const std::string& path, const std::string& machine = {});
/// All that is in force, defaults included, as the file would say it.
[[nodiscard]] nlohmann::ordered_json machineFileJson(const MachineFile& file);

}  // namespace kerf
