// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <stdexcept>
#include <string>
#include <string_view>

/// Files are read whole and written whole.
namespace kerf::files {

/// Bad input: one sentence with file, line, column and what was expected. The headless program prints it and exits
/// with 3.
class BadInput : public std::runtime_error {
 public:
    using std::runtime_error::runtime_error;
};

inline constexpr std::size_t kLargestFile = std::size_t{192} << 20U;  ///< bytes; a table takes about four times that

/// Whole content of a file. @throws BadInput when it cannot be read or is larger than kLargestFile
[[nodiscard]] std::string readFile(const std::string& path);

/// Replaces the file last: the text goes into a new file beside it, onto the disk, and then takes its name. When
/// anything fails, what was there stays as it was. A device or a pipe is written to directly.
/// @throws BadInput with the system's reason
void writeFile(const std::string& path, std::string_view text);

/// Both names lead to the same file; false when one does not exist.
[[nodiscard]] bool sameFile(const std::string& one, const std::string& other) noexcept;

/// Standard output, checked. @throws BadInput when it did not take everything (a full disk, a closed pipe)
void writeOut(std::string_view text);
/// What other means have printed. @throws BadInput
void finishOut();

}  // namespace kerf::files
