// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/process/milling/waviness.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace kerf::milling {
namespace {

constexpr int kFiner = 4;           // points of the fine profile per grid distance
constexpr double kSlack_mm = 1e-9;  // a grid point on the edge belongs to the scan

/// The wall between revolutions, constant beyond the first and the last.
class Profile {
 public:
    Profile(std::span<const double> x_mm, std::span<const double> y_mm) : m_x_mm(x_mm), m_y_mm(y_mm) {}
    [[nodiscard]] double at(double x_mm) const {
        const auto next = std::ranges::upper_bound(m_x_mm, x_mm);
        if (next == m_x_mm.begin()) {
            return m_y_mm.front();
        }
        if (next == m_x_mm.end()) {
            return m_y_mm.back();
        }
        const auto j = static_cast<std::size_t>(next - m_x_mm.begin());
        return m_y_mm[j - 1] + (m_y_mm[j] - m_y_mm[j - 1]) * (x_mm - m_x_mm[j - 1]) / (m_x_mm[j] - m_x_mm[j - 1]);
    }

 private:
    std::span<const double> m_x_mm;
    std::span<const double> m_y_mm;
};

struct Extent {
    double low{1e300};
    double high{-1e300};
    void add(double v) {
        low = std::min(low, v);
        high = std::max(high, v);
    }
    [[nodiscard]] double width() const { return high - low; }
};

}  // namespace

std::optional<Waviness> wallWaviness(std::span<const double> x_mm, std::span<const double> deflectionY_mm,
                                     const WallScan& scan) {
    const double to_mm = scan.length_mm - scan.beforeExit_mm;
    if (x_mm.size() < 2 || x_mm.size() != deflectionY_mm.size() || x_mm.back() < to_mm ||
        to_mm < scan.from_mm + scan.grid_mm) {
        return std::nullopt;
    }
    const Profile wall(x_mm, deflectionY_mm);
    const double fine_mm = scan.grid_mm / kFiner;
    const int half = std::max(1, static_cast<int>(std::lround(scan.spot_mm / fine_mm))) / 2;
    const int count = std::max(1, static_cast<int>(std::lround(scan.spot_mm / fine_mm)));
    const int points = static_cast<int>(std::floor((to_mm - scan.from_mm + kSlack_mm) / fine_mm)) + 1;
    // Running sums of the profile from half a spot before the scan to half a spot after; a spot that hangs over the
    // edge of the blank sees only the wall inside it.
    std::vector<double> sum{0.0};
    const int first = -std::min(half, static_cast<int>(std::floor((scan.from_mm + kSlack_mm) / fine_mm)));
    const int last =
        points + std::min(count - half, static_cast<int>(std::floor((scan.beforeExit_mm + kSlack_mm) / fine_mm)));
    for (int i = first; i < last; ++i) {
        sum.push_back(sum.back() + wall.at(scan.from_mm + i * fine_mm));
    }
    Extent raw;
    Extent spot;
    double mean_mm = 0.0;
    for (int i = 0; i < points; ++i) {
        if (i % kFiner == 0) {
            raw.add(wall.at(scan.from_mm + i * fine_mm));
        }
        const int low = std::max(i - half, first);
        const int high = std::min(i - half + count, last);
        const double seen_mm =
            (sum[static_cast<std::size_t>(high - first)] - sum[static_cast<std::size_t>(low - first)]) / (high - low);
        spot.add(seen_mm);
        mean_mm += seen_mm / points;
    }
    return Waviness{spot.width() * 1e3, raw.width() * 1e3, mean_mm * 1e3};
}

}  // namespace kerf::milling
