// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <optional>
#include <string>
#include <utility>

#include "app/files/dfq.h"
#include "app/files/dfq_field.h"

namespace kerf::dfq {

/// What a reader finds on its way through a file: what was odd and read all the same, and the first thing that cannot
/// be read.
class Findings : public FieldFindings {
 protected:
    explicit Findings(File& file) : m_file(file) {}

    void odd(std::size_t line, std::string text) {
        constexpr std::size_t kMostOddities = 1000;  // of a file of rubbish there is no end of them
        const bool oncePerFile = line == 0;
        const auto same = [&](const Oddity& other) { return other.line == line && other.text == text; };
        if (oncePerFile && std::ranges::any_of(m_file.oddities, same)) {
            return;
        }
        if (m_file.oddities.size() < kMostOddities) {
            m_file.oddities.push_back({line, std::move(text)});
        } else if (m_file.oddities.size() == kMostOddities) {
            m_file.oddities.push_back({line, "and more of them"});
        }
    }
    void oddOfFile(std::string text) override { odd(0, std::move(text)); }
    void oddHere(std::string text) override { odd(m_line, std::move(text)); }
    /// Told once, with the line where it was seen first.
    void oddOnce(std::string text) override {
        if (!std::ranges::any_of(m_file.oddities, [&](const Oddity& other) { return other.text == text; })) {
            odd(m_line, std::move(text));
        }
    }
    void bad(std::string field, std::string text) override {
        if (!m_problem) {
            m_problem = Problem{m_line, std::move(field), std::move(text)};
        }
    }

    File& m_file;
    std::size_t m_line{0};
    std::optional<Problem> m_problem{};
};

}  // namespace kerf::dfq
