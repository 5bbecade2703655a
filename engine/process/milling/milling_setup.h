// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>

#include "engine/process/milling/cut_record.h"
#include "engine/process/milling/feed_controller.h"
#include "engine/process/milling/milling_fields.h"

/// From the plain values of engine/api to what the room works with. All functions may run in the cycle.
namespace kerf::milling {

/// Every number of the setup that a person can change, in the order of the sheet.
[[nodiscard]] std::span<const MillingField> setupFields() noexcept;

/// Sentence for the operator; empty when the loop can work with it.
[[nodiscard]] std::optional<Sentence> whyUnusable(const MillingSetup& setup) noexcept;
[[nodiscard]] std::optional<Sentence> whyUnusable(const MillingBlank& blank) noexcept;

/// @pre !whyUnusable(setup)
[[nodiscard]] FeedController::Params controllerParams(const MillingSetup& setup) noexcept;
[[nodiscard]] CutRecord::Params recordParams(const MillingSetup& setup) noexcept;
[[nodiscard]] InversionModel inversionModel(const MillingSetup& setup, const StiffnessEstimate& stiffness) noexcept;
/// @pre !whyUnusable(blank). Air before and after; an empty profile for an empty blank.
[[nodiscard]] BlankProfile profileOf(const MillingBlank& blank) noexcept;

/// Factor by which the gain of the loop may grow before it oscillates, at the estimated stiffness; 0 when unknown.
///
/// With the tangent plant F(i+1) = a1 F(i) + b u(i) of linearForm(), u in mm/s:
///   pi     z = −1 of (z−1)(z−a1) + g k0 b (z−α): g < 2(1+a1)/(k0 b (1+α)); and g < (1+a1)/(k0 b α)
///   model  pole a1(1 − g s), s the share of deadbeat when backing off: g < (1+a1)/(a1 s)
[[nodiscard]] double gainMargin(const MillingSetup& setup, MillingLaw law, const StiffnessEstimate& stiffness,
                                double revolution_s) noexcept;

}  // namespace kerf::milling
