// SPDX-License-Identifier: GPL-3.0-or-later
// Before main: a test program changes into a folder of its own under the temporary folder, so that what it writes never
// lies about where it was started. The folder goes when the program ends well; KERF_SCRATCH names one that stays.
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string>

namespace {

namespace fs = std::filesystem;

class Scratch {
 public:
    Scratch() {
        std::error_code none;
        const std::string name = fs::read_symlink("/proc/self/exe", none).filename().string();
        if (const char* kept = std::getenv("KERF_SCRATCH"); kept != nullptr && *kept != '\0') {
            m_folder = fs::path(kept) / name;
        } else {
            m_folder = fs::temp_directory_path() / ("kerf-" + name + "-" + std::to_string(::getpid()));
            m_owner = ::getpid();
        }
        fs::create_directories(m_folder);
        fs::current_path(m_folder);
    }
    ~Scratch() {
        std::error_code none;
        if (m_owner == ::getpid()) {  // not in a child that was forked
            fs::current_path(fs::temp_directory_path(), none);
            fs::remove_all(m_folder, none);
        }
    }
    Scratch(const Scratch&) = delete;
    Scratch& operator=(const Scratch&) = delete;

 private:
    fs::path m_folder{};
    pid_t m_owner{-1};
};

const Scratch scratch;

}  // namespace
