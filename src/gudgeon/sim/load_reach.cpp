// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Weights once, loads state by state.
#include "gudgeon/sim/load_reach.h"

#include <algorithm>
#include <cmath>

#include "gudgeon/system/characteristic_length.h"

namespace gudgeon {

LoadReach::LoadReach(const Mechanism& mechanism)
    : length_(find_characteristic_length(mechanism)), weights_(0.0), largest_(0.0) {
  for (std::size_t b = 1; b < mechanism.bodies.size(); ++b) {
    weights_ += mechanism.bodies[b].mass * norm(mechanism.gravity) * length_;
  }
  largest_ = weights_;
}

void LoadReach::note(const Workspace& workspace) noexcept {
  double reach = weights_;
  for (const LoadEffect& effect : workspace.loads.effects) {
    reach += norm(effect.force) * length_ + std::abs(effect.torque);
  }
  if (std::isfinite(reach)) largest_ = std::max(largest_, reach);
}

}  // namespace gudgeon
