// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <array>

/// Volumetric error of a three-axis machine from its error elements, by homogeneous transforms.
///
///   H = T1 · J(Z) · T2 · J(Y) · T3 · J(X) · T4                      tool → work, four shape links, three joints
///   e = H_actual⁻¹·0 − H_ideal⁻¹·0                                  eq. 7: where the cutting point really is
///   e ≈ Σ_j (ω_j × S_j − δ_j)                                       eq. 8, first order in the errors
///
/// A shape link translates by d + δ; a joint link by its axis position along its axis, plus δ. Both turn by
/// R = I + [ω]×, ω = (γ about x, β about y, α about z). S_j: sum of the ideal translations from the tool to the END of
/// link j. Units mm and rad. Sign: e is the error of the cutting point in the work frame, positive along +x, +y, +z.
///
/// Source: Ahn & Chung (about 2000), eqs. 1-8. Deviations: the last three terms of each printed row of eq. 8 lost their
/// subscripts; they are the translational errors of the three joints. I + [ω]× is not orthogonal: the true inverse is
/// used. The exact error is computed link by link as e_j = (I + [ω_j]×)⁻¹(e_{j−1} + ω_j × S_j − δ_j), which is eq. 7
/// without the subtraction of two nearly equal positions; dropping the inverse gives eq. 8.
namespace kerf::thermal {

/// Errors of one link.
struct LinkError {
    Eigen::Vector3d delta_mm{Eigen::Vector3d::Zero()};   ///< translational errors
    Eigen::Vector3d omega_rad{Eigen::Vector3d::Zero()};  ///< γ, β, α
};

/// One machine at one axis position, with its errors there. Joints stand in the order of the chain: Z, Y, X.
struct VolumetricChain {
    Eigen::Vector3d position_mm{Eigen::Vector3d::Zero()};  ///< axis positions x, y, z
    std::array<Eigen::Vector3d, 4> shape_mm{Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero(),
                                            Eigen::Vector3d::Zero()};
    std::array<LinkError, 4> shapeError{};
    std::array<LinkError, 3> jointError{};  ///< of Z, Y, X
};

/// eq. 7. Pure; any finite input.
[[nodiscard]] Eigen::Vector3d exactError_mm(const VolumetricChain& chain) noexcept;
/// eq. 8.
[[nodiscard]] Eigen::Vector3d firstOrderError_mm(const VolumetricChain& chain) noexcept;
/// H with errors, for comparison and drawing.
[[nodiscard]] Eigen::Matrix4d actualTransform(const VolumetricChain& chain) noexcept;

/// Error elements of a machine over its work space: each element is a constant plus a part linear in the position of
/// its own axis (the paper's finding). Shape links have no axis; their elements are constants.
struct ErrorElements {
    std::array<Eigen::Vector3d, 4> shape_mm{Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero(),
                                            Eigen::Vector3d::Zero()};
    std::array<LinkError, 4> shapeError{};
    std::array<LinkError, 3> jointError{};        ///< at axis position 0, order Z, Y, X
    std::array<LinkError, 3> jointErrorPer_mm{};  ///< added per mm of axis travel

    [[nodiscard]] VolumetricChain at(const Eigen::Vector3d& position_mm) const noexcept;
};

}  // namespace kerf::thermal
