// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json.hpp>

#include "tests/support/kerf_program.h"

namespace kerf::test {

/// What a run of the headless program has said in JSON. A header of its own: the reader takes long to compile.
[[nodiscard]] inline nlohmann::json document(const KerfRun& run) {
    return nlohmann::json::parse(run.out.toStdString());
}

}  // namespace kerf::test
