// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace kerf::linuxcnc {

/// What a bridge that was killed has left in HAL: its component, which HAL keeps and takes no other of that name
/// beside, and its pins with their links. Only kerf-hal uses this, on its way up; it asks `halcmd`.
class HalSuccessor {
 public:
    /// When `component` belongs to a process that has died: notes its pins and clears it away. Before hal_init() of the
    /// same name; true when there was one.
    [[nodiscard]] bool takePlaceOf(const std::string& component);
    /// After hal_init().
    void settle() noexcept;
    /// Links the pins that have the same names, as they were, and sets those that a person had set. What stands on a
    /// signal stays: nothing moves.
    void linkAgain() const;

 private:
    struct Pin {
        std::string name{};
        std::string value{};
        std::string signal{};  ///< empty: it was linked to none
        bool input{false};
    };
    std::vector<Pin> m_pins{};
    int m_helper{-1};
};

}  // namespace kerf::linuxcnc
