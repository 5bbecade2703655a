// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

#include "app/files/dfq.h"

/// One K0… field of a value: checked, and brought to the form that is written.
namespace kerf::dfq {

/// Who is told what was odd, and what cannot be.
class FieldFindings {
 public:
    FieldFindings() = default;
    FieldFindings(const FieldFindings&) = delete;
    FieldFindings& operator=(const FieldFindings&) = delete;
    virtual ~FieldFindings() = default;
    virtual void oddOfFile(std::string text) = 0;  ///< once, of the file as a whole
    virtual void oddHere(std::string text) = 0;    ///< with the line
    virtual void oddOnce(std::string text) = 0;    ///< with the line where it was seen first
    virtual void bad(std::string field, std::string text) = 0;
};

class FieldReader {
 public:
    /// `file`: for the unit of a characteristic (K2142).
    FieldReader(FieldFindings& findings, const File& file, SlashDates slashes)
        : m_findings(findings), m_file(file), m_slashes(slashes) {}

    /// Understands `text` into the value and makes it canonical; false: it cannot be, and that was told.
    [[nodiscard]] bool take(Value& value, int key, std::string& text);
    /// It failed at a date that only stands with its day first.
    [[nodiscard]] bool wantsDayFirst() const noexcept { return m_dayFirst; }
    /// It met a date that stands with its month first only, or one that would be another day with its day first. What
    /// the format writes (slashes up to the clock: M/d/yyyy/HH:mm:ss) and what has AM or PM has its month first.
    [[nodiscard]] bool sawMonthFirst() const noexcept { return m_monthFirst; }
    [[nodiscard]] bool sawEither() const noexcept { return m_either; }

 private:
    bool takeNumber(Value& value, int key, std::string& text);
    bool takeAttribute(Value& value, std::string& text);
    bool takeTime(Value& value, std::string& text);
    void judgeOrder(const Time& time, std::string_view local, const std::string& text);
    void takeEvents(Value& value, std::string& text);

    FieldFindings& m_findings;
    const File& m_file;
    SlashDates m_slashes;
    bool m_dayFirst{false}, m_monthFirst{false}, m_either{false};
};

/// Why a date is refused that may be two days.
[[nodiscard]] std::string eitherOrder(std::string_view text);
/// "K0001"; "place 3" of an unnamed one.
[[nodiscard]] std::string keyName(int key);

}  // namespace kerf::dfq
