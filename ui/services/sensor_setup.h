// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "engine/core/result.h"

/// Which sensor file holds for this machine, and what answers on its network. Plain values.
namespace kerf {

/// Why a sensor file is refused, in its parts, as `kerf sensors check` says it in English.
struct SensorFileRefusal {
    std::string where{};                ///< the key; empty: the file itself
    const char* text{""};               ///< KERF_TEXT with %1 and on; empty: nothing is refused
    std::vector<std::string> values{};  ///< as they stand in the file
    [[nodiscard]] bool empty() const noexcept { return *text == '\0'; }
};

/// A sensor file in the data folder, as `kerf sensors check` judges it.
struct SensorFileView {
    std::string name{};  ///< "vmc-3.json"
    std::size_t modules{0}, channels{0}, gauges{0};
    SensorFileRefusal refused{};  ///< empty: it may be used
    bool chosen{false};           ///< for the next start
};

/// What answered at an address.
struct FoundUnitView {
    int unit{0};
    std::string identity{};   ///< as the module says it; may be empty
    std::string registers{};  ///< the first of each function: "4: 203 247 …; 3: 0 0 …"
};

struct SensorSetupView {
    std::uint64_t revision{0};
    std::string folder{};  ///< where files are looked for
    std::vector<SensorFileView> files{};
    std::string inUse{};        ///< file that this console reads; empty: none
    bool byCommandLine{false};  ///< it was named at the start, so a choice here has no say
    bool scanning{false};
    std::string scanned{};               ///< address that was asked last; empty: none yet
    std::vector<FoundUnitView> found{};  ///< at that address
    Sentence refused{};                  ///< why nothing could be asked there
    Sentence problem{};                  ///< of storing the choice
};

/// GUI thread.
class SensorSetup {
 public:
    SensorSetup() = default;
    SensorSetup(const SensorSetup&) = delete;
    SensorSetup& operator=(const SensorSetup&) = delete;
    virtual ~SensorSetup() = default;

    [[nodiscard]] virtual const SensorSetupView& view() const = 0;
    /// Looks through the folder again, elsewhere; `view().revision` rises.
    virtual void lookForFiles() = 0;
    /// From the next start of the console on; an empty name: none. Refused without the right, or for a file that
    /// `lookForFiles` has not found usable.
    [[nodiscard]] virtual Result<void> choose(const std::string& name, const std::string& author) = 0;
    /// Asks what answers at HOST or HOST:PORT; reads only, in a program of its own.
    [[nodiscard]] virtual Result<void> scan(const std::string& address, const std::string& author) = 0;
};

}  // namespace kerf
