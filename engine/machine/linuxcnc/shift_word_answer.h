// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "engine/process/thermal/compensation.h"

namespace kerf::linuxcnc {

/// The paper's dialogue over digital bits: the control asks for an axis (start bit and axis), the word answers with
/// that axis' whole shift and the living bit. Without a request the last answer stands.
class ShiftWordAnswer {
 public:
    [[nodiscard]] std::uint16_t answer(std::uint8_t requestWord, const std::array<double, 3>& shift_um) noexcept {
        const auto request = thermal::decodeRequestWord(requestWord);
        if (request && request->start) {
            const double whole_um =
                std::clamp(std::round(shift_um[request->axis]), static_cast<double>(thermal::kMinWordShift_um),
                           static_cast<double>(thermal::kMaxWordShift_um));
            m_word.axis = request->axis;
            m_word.shift_um = static_cast<std::int16_t>(whole_um);
        }
        m_word.alive = true;
        return thermal::encodeShiftWord(m_word).value_or(0);
    }

 private:
    thermal::ShiftWord m_word{};
};

}  // namespace kerf::linuxcnc
