// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/machines/machine_module_loader.h"

#include <dlfcn.h>

#include <filesystem>

namespace kerf {

Result<std::unique_ptr<MachinePort>> loadMachine(const std::string& name, const MachineDescription& described) {
    std::error_code unreadable;
    const auto program = std::filesystem::read_symlink("/proc/self/exe", unreadable);
    const auto module = program.parent_path() / ("kerf-" + name + ".so");
    void* handle = unreadable ? nullptr : dlopen(module.c_str(), RTLD_NOW | RTLD_LOCAL);
    auto* make = handle != nullptr ? reinterpret_cast<MakeMachine*>(dlsym(handle, kMakeMachineSymbol)) : nullptr;
    if (make == nullptr) {
        return fail(
            KERF_TEXT("The module kerf-%1.so is not beside the program: this machine cannot be driven from here."),
            SentenceArg(name));
    }
    return std::unique_ptr<MachinePort>(make(described));
}

}  // namespace kerf
