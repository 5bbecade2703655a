// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/machine/linuxcnc/hal_successor.h"

#include <unistd.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <sstream>

#include "engine/machine/linuxcnc/hal_pins.h"

namespace kerf::linuxcnc {
namespace {

std::string answerOf(const std::string& command) {
    std::string text;
    if (std::FILE* pipe = ::popen((command + " 2>/dev/null").c_str(), "r"); pipe != nullptr) {
        std::array<char, 4096> block{};
        for (std::size_t got = 0; (got = std::fread(block.data(), 1, block.size(), pipe)) > 0;) {
            text.append(block.data(), got);
        }
        (void)::pclose(pipe);
    }
    return text;
}

/// The process is gone, waits to be reaped, or its number was given out again to another program.
bool dead(const std::string& process, const std::string& program) {
    std::FILE* file = std::fopen(("/proc/" + process + "/stat").c_str(), "r");
    if (file == nullptr) {
        return true;
    }
    std::array<char, 512> text{};
    const std::size_t got = std::fread(text.data(), 1, text.size() - 1, file);
    std::fclose(file);
    const char* name = std::strchr(text.data(), '(');
    const char* end = std::strrchr(text.data(), ')');
    if (got == 0 || name == nullptr || end == nullptr || end[1] == '\0') {
        return true;
    }
    return end[2] == 'Z' || std::string(name + 1, end) != program;
}

}  // namespace

bool HalSuccessor::takePlaceOf(const std::string& component) {
    // Lines of halcmd: "57 User kerf-hal 19033 ready", "kerf-hal float OUT 1 kerf.feed-scale ==> kerf-feed-wanted".
    std::istringstream components(answerOf("halcmd -s show comp " + component));
    std::string line;
    int id = -1;
    while (std::getline(components, line)) {
        std::istringstream words(line);
        std::string number;
        std::string type;
        std::string name;
        std::string process;
        if (words >> number >> type >> name >> process && name == component && dead(process, component)) {
            id = std::atoi(number.c_str());
        }
    }
    if (id <= 0) {
        return false;
    }
    std::istringstream pins(answerOf("halcmd -s show pin"));
    while (std::getline(pins, line)) {
        std::istringstream words(line);
        std::string owner;
        std::string type;
        std::string direction;
        std::string arrow;
        Pin pin;
        if (words >> owner >> type >> direction >> pin.value >> pin.name && owner == component) {
            words >> arrow >> pin.signal;
            pin.input = direction == "IN";
            m_pins.push_back(pin);
        }
    }
    // HAL counts how often a process has come and lets go of its memory with the last leave: one helper goes in the
    // place of the dead component, the other stays until ours is there.
    const std::string own = std::to_string(::getpid());
    m_helper = hal_init(("kerf-hal-again-" + own).c_str());
    const int kept = hal_init(("kerf-hal-anew-" + own).c_str());
    const bool gone = m_helper > 0 && kept > 0 && hal_exit(id) == 0;
    if (kept > 0) {
        (void)hal_ready(kept);
    }
    return gone;
}

void HalSuccessor::settle() noexcept {
    if (m_helper > 0) {
        (void)hal_exit(m_helper);
        m_helper = -1;
    }
}

void HalSuccessor::linkAgain() const {
    std::FILE* settings = nullptr;
    for (const Pin& pin : m_pins) {
        if (!pin.signal.empty()) {
            (void)hal_link(pin.name.c_str(), pin.signal.c_str());
            continue;
        }
        if (pin.input && settings == nullptr) {
            settings = ::popen("halcmd -k -f /dev/stdin >/dev/null 2>&1", "w");
        }
        if (pin.input && settings != nullptr) {
            std::fprintf(settings, "setp %s %s\n", pin.name.c_str(), pin.value.c_str());
        }
    }
    if (settings != nullptr) {
        (void)::pclose(settings);
    }
}

}  // namespace kerf::linuxcnc
