// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// The family of damping forms: how much of an impact's energy a contact keeps, for any elastic force.
#pragma once

#include <concepts>

#include "gudgeon/laws/law.h"

namespace gudgeon {

/// Gives χ of F = F_el (1 + χ δ̇/δ̇₀). It may be costly and is found once, before a run.
template <class Damping>
concept DampingForm = LawValue<Damping> && requires(const Damping damping) {
  { damping.damping_factor() } -> std::same_as<double>;
};

/// A restitution of 0 would need a damping without end.
inline constexpr ParameterRange kRestitutionRange{0.0, 1.0, true, false};

}  // namespace gudgeon
