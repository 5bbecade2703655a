// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/machines/machine_module_loader.h"

#include <dlfcn.h>

#include <algorithm>
#include <cstring>
#include <filesystem>

namespace kerf {
namespace {

constexpr const char* kPrefix = "kerf-";
constexpr const char* kSuffix = ".so";
constexpr const char* kPackaged = "linuxcnc";

/// Empty: not to be found out.
std::filesystem::path programFolder() {
    std::error_code unreadable;
    const auto program = std::filesystem::read_symlink("/proc/self/exe", unreadable);
    return unreadable ? std::filesystem::path() : program.parent_path();
}

}  // namespace

std::vector<std::string> machineModules() {
    std::vector<std::string> names{kPackaged};
    std::error_code unreadable;
    for (const auto& entry : std::filesystem::directory_iterator(programFolder(), unreadable)) {
        const std::string file = entry.path().filename().string();
        if (file.starts_with(kPrefix) && file.ends_with(kSuffix)) {
            names.push_back(
                file.substr(std::strlen(kPrefix), file.size() - std::strlen(kPrefix) - std::strlen(kSuffix)));
        }
    }
    std::ranges::sort(names);
    names.erase(std::ranges::unique(names).begin(), names.end());
    return names;
}

Result<std::unique_ptr<MachinePort>> loadMachine(const std::string& name, const MachineDescription& described) {
    const auto folder = programFolder();
    const auto module = folder / (kPrefix + name + kSuffix);
    void* handle = folder.empty() ? nullptr : dlopen(module.c_str(), RTLD_NOW | RTLD_LOCAL);
    auto* make = handle != nullptr ? reinterpret_cast<MakeMachine*>(dlsym(handle, kMakeMachineSymbol)) : nullptr;
    if (make == nullptr) {
        return fail(
            KERF_TEXT("The module kerf-%1.so is not beside the program: this machine cannot be driven from here."),
            SentenceArg(name));
    }
    return std::unique_ptr<MachinePort>(make(described));
}

}  // namespace kerf
