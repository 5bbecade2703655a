// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <string_view>

#include "engine/core/result.h"

/// JSON from outside: bounded before it is built, so that neither size, depth nor a number's magnitude can stop a
/// program.
namespace kerf::files {

inline constexpr int kDeepestJson = 64;
inline constexpr double kLargestJsonNumber = 1e60;

/// The document, or one sentence: no JSON at byte %1, nested deeper than kDeepestJson, a key twice in one object, or a
/// number beyond ±kLargestJsonNumber (from there on the models' polynomials leave what a double holds).
[[nodiscard]] Result<nlohmann::json> parseJson(const std::string& text);
/// A key that stands twice in one object of this JSON: nobody can say which value is meant.
[[nodiscard]] std::optional<std::string> doubledKey(const std::string& text);
/// The same of a file. @throws headless::BadInput: the file, what is wrong, and what was `expected` ("an object with
/// …").
[[nodiscard]] nlohmann::json readJsonFile(const std::string& path, std::string_view expected);

}  // namespace kerf::files
