// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace kerf {

/// A recipe that is kept whole while its parts are changed one by one: a change of one part begins from what was asked
/// for last, also while that is still on its way to the disk, so none takes back the other.
template <class Values>
class AskedRecipe {
 public:
    [[nodiscard]] const Values& from(const Values& inForce) const noexcept { return m_open > 0 ? m_asked : inForce; }
    void ask(const Values& values) {
        m_asked = values;
        ++m_open;
    }
    /// Taken or refused.
    void answered() noexcept { --m_open; }
    /// One is on its way to the disk.
    [[nodiscard]] bool open() const noexcept { return m_open > 0; }

 private:
    Values m_asked{};
    int m_open{0};
};

}  // namespace kerf
