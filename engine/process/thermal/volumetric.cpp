// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/process/thermal/volumetric.h"

#include <Eigen/Geometry>
#include <Eigen/LU>

namespace kerf::thermal {
namespace {

Eigen::Matrix3d skew(const Eigen::Vector3d& w) {
    Eigen::Matrix3d k;
    k << 0.0, -w.z(), w.y(), w.z(), 0.0, -w.x(), -w.y(), w.x(), 0.0;
    return k;
}

/// Visits the seven links from tool to work with their ideal translation and error.
template <class Visit>
void forEachLink(const VolumetricChain& chain, Visit&& visit) {
    constexpr std::array<int, 3> axisOfJoint{2, 1, 0};  // Z, Y, X
    for (std::size_t link = 0; link < 4; ++link) {
        visit(chain.shape_mm[link], chain.shapeError[link]);
        if (link < 3) {
            const int axis = axisOfJoint[link];
            visit(Eigen::Vector3d(Eigen::Vector3d::Unit(axis) * chain.position_mm[axis]), chain.jointError[link]);
        }
    }
}

}  // namespace

Eigen::Vector3d exactError_mm(const VolumetricChain& chain) noexcept {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    Eigen::Vector3d error = Eigen::Vector3d::Zero();
    forEachLink(chain, [&](const Eigen::Vector3d& ideal, const LinkError& link) {
        sum += ideal;
        const Eigen::Matrix3d turn = Eigen::Matrix3d::Identity() + skew(link.omega_rad);
        error = turn.inverse() * (error + link.omega_rad.cross(sum) - link.delta_mm);
    });
    return error;
}

Eigen::Vector3d firstOrderError_mm(const VolumetricChain& chain) noexcept {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    Eigen::Vector3d error = Eigen::Vector3d::Zero();
    forEachLink(chain, [&](const Eigen::Vector3d& ideal, const LinkError& link) {
        sum += ideal;
        error += link.omega_rad.cross(sum) - link.delta_mm;
    });
    return error;
}

Eigen::Matrix4d actualTransform(const VolumetricChain& chain) noexcept {
    Eigen::Matrix4d h = Eigen::Matrix4d::Identity();
    forEachLink(chain, [&](const Eigen::Vector3d& ideal, const LinkError& link) {
        Eigen::Matrix4d t = Eigen::Matrix4d::Identity();
        t.topLeftCorner<3, 3>() += skew(link.omega_rad);
        t.topRightCorner<3, 1>() = ideal + link.delta_mm;
        h *= t;
    });
    return h;
}

VolumetricChain ErrorElements::at(const Eigen::Vector3d& position_mm) const noexcept {
    VolumetricChain chain;
    chain.position_mm = position_mm;
    chain.shape_mm = shape_mm;
    chain.shapeError = shapeError;
    constexpr std::array<int, 3> axisOfJoint{2, 1, 0};
    for (std::size_t j = 0; j < 3; ++j) {
        const double travel_mm = position_mm[axisOfJoint[j]];
        chain.jointError[j].delta_mm = jointError[j].delta_mm + travel_mm * jointErrorPer_mm[j].delta_mm;
        chain.jointError[j].omega_rad = jointError[j].omega_rad + travel_mm * jointErrorPer_mm[j].omega_rad;
    }
    return chain;
}

}  // namespace kerf::thermal
