// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Where a mechanism stays at rest, what holds it there, and how it moves when disturbed.
#pragma once

#include <string>
#include <vector>

#include "gudgeon/system/assembly.h"
#include "gudgeon/system/reactions.h"

namespace gudgeon {

/// One way to move about an equilibrium, y ~ exp(λ t).
struct EquilibriumMode {
  enum class Kind { stable, neutral, unstable };
  Kind kind = Kind::stable;
  double frequency = 0.0;      ///< |Im λ|/2π [Hz]; zero when it does not swing
  double damping_ratio = 0.0;  ///< −Re λ/|λ| [1]
  double growth_rate = 0.0;    ///< Re λ [1/s]
  std::string most_moved;      ///< the body or guide that moves most in it
};

struct Equilibrium {
  Mechanism mechanism;  ///< with ideal joints, its drivers held where they start
  std::vector<BodyPose> poses;
  std::vector<double> efforts;           ///< one a driver [N m, N]
  std::vector<JointReaction> reactions;  ///< one a joint
  double potential_energy = 0.0;         ///< [J] of gravity, constant loads and springs
  double residual = 0.0;                 ///< largest acceleration left, angles [rad/s^2] or shares of the size
  int iterations = 0;
  std::vector<EquilibriumMode> modes;  ///< unstable ones first, then by frequency

  [[nodiscard]] bool is_stable() const;
};

/// The equilibrium that Newton's method finds from the start position, all rates zero, variable loads as they are at
/// t = 0. Throws ModelError as assemble() does, NumericalError (E-NUM-011) when none is found.
Equilibrium find_equilibrium(const Mechanism& mechanism);

/// That equilibrium and the others that Newton's method finds from a walk of one turn each way along every degree of
/// freedom, those of least potential energy first; of neighbours that are alike, as where nothing brings a body back,
/// one. With several degrees of freedom there may be more. Throws as find_equilibrium() does, when there is none.
std::vector<Equilibrium> find_equilibria(const Mechanism& mechanism);

}  // namespace gudgeon
