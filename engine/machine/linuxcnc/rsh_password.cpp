// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/machine/linuxcnc/rsh_password.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cctype>

namespace kerf::linuxcnc {
namespace {

bool word(const std::string& text) {
    return !text.empty() && std::ranges::none_of(text, [](unsigned char c) { return std::isspace(c) != 0; });
}

}  // namespace

Result<RshPassword> readRshPassword(const std::string& file) {
    RshPassword password;
    if (file.empty()) {
        return password;
    }
    const int descriptor = ::open(file.c_str(), O_RDONLY | O_CLOEXEC);
    struct stat status {};
    if (descriptor < 0 || ::fstat(descriptor, &status) != 0) {
        if (descriptor >= 0) {
            ::close(descriptor);
        }
        return fail(KERF_TEXT("The file with the passwords of linuxcncrsh cannot be read."));
    }
    std::array<char, 512> text{};
    const ssize_t got = ::read(descriptor, text.data(), text.size());
    ::close(descriptor);
    if ((status.st_mode & 077U) != 0) {
        return fail(KERF_TEXT("Others may read the file with the passwords of linuxcncrsh: give it mode 0600."));
    }
    const std::string all(text.data(), got > 0 ? static_cast<std::size_t>(got) : 0);
    const std::size_t first = all.find('\n');
    password.connect = all.substr(0, first);
    const std::string rest = first == std::string::npos ? std::string() : all.substr(first + 1);
    password.enable = rest.substr(0, rest.find('\n'));
    if (!word(password.connect) || !word(password.enable)) {
        return fail(KERF_TEXT("The file with the passwords of linuxcncrsh needs two lines: connect and enable."));
    }
    return password;
}

}  // namespace kerf::linuxcnc
