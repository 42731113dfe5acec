// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// A linear spring and a linear damper that press only, the shape of two laws.
#pragma once

#include "gudgeon/laws/normal/normal.h"

namespace gudgeon {

inline constexpr Dimension kLinearStiffness{0, 1, -2, 0};  ///< [N/m]
inline constexpr Dimension kLinearDamping{0, 1, -1, 0};    ///< [N s/m]

/// F = k δ + d δ̇ for δ > 0, never pulling, and U = k δ²/2.
inline NormalForce eval_linear(const NormalContact& contact, double stiffness, double damping) noexcept {
  if (contact.penetration <= 0.0) return {};
  const double elastic = stiffness * contact.penetration;
  return {never_pulling(elastic, damping * contact.penetration_rate), elastic, 0.5 * elastic * contact.penetration};
}

}  // namespace gudgeon
