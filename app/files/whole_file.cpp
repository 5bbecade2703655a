// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/files/whole_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <vector>

#include "app/files/text_encoding.h"

namespace kerf::files {
namespace {

[[noreturn]] void refuse(const std::string& path, int error) {
    throw BadInput(fmt::format("{}: cannot be written: {}; what was there is unchanged.", utf8Of(path),
                               std::strerror(error)));  // NOLINT(concurrency-mt-unsafe): read once, at once
}

/// 0, or errno of the write that failed.
int writeAll(int file, std::string_view text) {
    while (!text.empty()) {
        const ssize_t done = ::write(file, text.data(), text.size());
        if (done < 0) {
            if (errno == EINTR) {
                continue;
            }
            return errno;
        }
        text.remove_prefix(static_cast<std::size_t>(done));
    }
    return 0;
}

void writeToDevice(const std::string& path, std::string_view text) {
    const int file = ::open(path.c_str(), O_WRONLY | O_CLOEXEC);
    if (file < 0) {
        refuse(path, errno);
    }
    const int error = writeAll(file, text);
    ::close(file);
    if (error != 0) {
        refuse(path, error);
    }
}

}  // namespace

std::string readFile(const std::string& path) {
    std::error_code error;
    if (std::filesystem::is_directory(path, error)) {
        throw BadInput(fmt::format("{}: cannot be read; expected an existing file.", utf8Of(path)));
    }
    std::ifstream file(path, std::ios::binary);
    if (!file) {
        throw BadInput(fmt::format("{}: cannot be read; expected an existing file.", utf8Of(path)));
    }
    std::string text;
    std::vector<char> piece(std::size_t{1} << 18U);
    while (file.read(piece.data(), static_cast<std::streamsize>(piece.size())) || file.gcount() > 0) {
        text.append(piece.data(), static_cast<std::size_t>(file.gcount()));
        if (text.size() > kLargestFile) {
            throw BadInput(fmt::format("{}: larger than {} MB; split the record.", utf8Of(path), kLargestFile >> 20U));
        }
    }
    if (file.bad()) {
        throw BadInput(fmt::format("{}: cannot be read to its end; expected a whole file.", utf8Of(path)));
    }
    return text;
}

void writeFile(const std::string& path, std::string_view text) {
    std::error_code error;
    const auto status = std::filesystem::status(path, error);
    if (std::filesystem::is_directory(status)) {
        refuse(path, EISDIR);
    }
    if (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status)) {
        return writeToDevice(path, text);
    }
    // A link stays a link: the file it leads to is replaced.
    std::string target = path;
    if (std::filesystem::exists(status)) {
        target = std::filesystem::canonical(path, error).string();
        if (error) {
            refuse(path, error.value());
        }
        if (::access(target.c_str(), W_OK) != 0) {
            refuse(path, errno);  // a file somebody has protected is not replaced by way of its folder
        }
    }
    std::string partial = target + ".XXXXXX";
    const int file = ::mkostemp(partial.data(), O_CLOEXEC);
    if (file < 0) {
        refuse(path, errno);
    }
    struct stat before {};
    const bool replaces = ::stat(target.c_str(), &before) == 0;
    const mode_t mask = ::umask(0);
    ::umask(mask);
    int failed = ::fchmod(file, replaces ? before.st_mode & 0777U : 0666U & ~mask) == 0 ? 0 : errno;
    if (failed == 0) failed = writeAll(file, text);
    if (failed == 0 && ::fsync(file) != 0) failed = errno;
    if (::close(file) != 0 && failed == 0) failed = errno;
    if (failed == 0 && std::rename(partial.c_str(), target.c_str()) != 0) failed = errno;
    if (failed != 0) {
        ::unlink(partial.c_str());
        refuse(path, failed);
    }
}

bool sameFile(const std::string& one, const std::string& other) noexcept {
    std::error_code error;
    return std::filesystem::equivalent(one, other, error) && !error;
}

void writeOut(std::string_view text) {
    std::fwrite(text.data(), 1, text.size(), stdout);
    finishOut();
}

void finishOut() {
    errno = 0;
    if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0) {
        const int error = errno != 0 ? errno : EIO;
        std::clearerr(stdout);
        throw BadInput(fmt::format("standard output: not everything could be written: {}; what is there is not whole.",
                                   std::strerror(error)));  // NOLINT(concurrency-mt-unsafe)
    }
}

}  // namespace kerf::files
