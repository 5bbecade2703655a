// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdio>
#include <cstdlib>
#include <string>

#include "engine/machine/linuxcnc/ini_file.h"

namespace kerf::linuxcnc {

/// The ini file LinuxCNC runs with, whole: it tells the programs it loads which one. Empty: none, or not readable.
[[nodiscard]] inline std::string iniText() {
    const char* name = std::getenv("INI_FILE_NAME");
    std::string text;
    if (std::FILE* file = name != nullptr ? std::fopen(name, "r") : nullptr; file != nullptr) {
        char block[4096];
        for (std::size_t got = 0; (got = std::fread(block, 1, sizeof block, file)) > 0;) {
            text.append(block, got);
        }
        std::fclose(file);
    }
    return text;
}

}  // namespace kerf::linuxcnc
