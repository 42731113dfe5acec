// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Kelvin-Voigt: a linear spring beside a linear damper.
#pragma once

#include <array>

#include "gudgeon/laws/normal/linear.h"

namespace gudgeon {

/// F = k δ + d δ̇
///
/// δ [m] penetration, δ̇ [m/s] its rate (> 0 approaching), k [N/m] stiffness, d [N s/m] damping, both of the contact as
/// a whole and not of its materials or radii. δ → 0: F → d δ̇₀, so the force starts with a step; d = 0: a spring. Never
/// pulls: the surfaces part where the sum reaches zero, before δ does. Holds as a plain bumper; metals do not contact
/// like this. Goldsmith 1960.
struct KelvinVoigt {
  double stiffness = kRequired;  ///< k [N/m]
  double damping = kRequired;    ///< d [N s/m]

  static constexpr bool kStepsAtOnset = true;
  static constexpr std::string_view kName = "kelvin_voigt";
  static constexpr std::string_view kFormula = "F = k δ + d δ̇";
  static constexpr std::array<Parameter<KelvinVoigt>, 2> kParameters{{
      {"stiffness", "k", kLinearStiffness, kPositive, "force over penetration", &KelvinVoigt::stiffness},
      {"damping", "d", kLinearDamping, kNotNegative, "force over the penetration's rate", &KelvinVoigt::damping},
  }};

  [[nodiscard]] double damping_factor() const { return 0.0; }

  NormalForce operator()(const NormalContact& contact) const noexcept {
    return eval_linear(contact, stiffness, damping);
  }
};
static_assert(NormalForceLaw<KelvinVoigt>);

}  // namespace gudgeon
