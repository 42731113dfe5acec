// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// One state of a mechanism for every form of its equations.
#pragma once

#include <vector>

#include "gudgeon/sim/motion_equations.h"
#include "gudgeon/system/poses.h"

namespace gudgeon::oracle {

struct SameState {
  Assembly assembly;  ///< poses of all bodies, frame first
  std::vector<ContactMode> contact_modes;
};

/// The start of the mechanism, every contact open.
SameState make_free_start(const Mechanism& mechanism);
/// The start with every journal some micrometres deep in its bearing, moving further in, in contact.
SameState make_pressed_start(const Mechanism& mechanism);

/// The compiled engine at such a state.
struct EngineAt {
  EngineAt(const Mechanism& mechanism, const SameState& at);

  System system;
  MotionEquations equations;
  std::vector<double> y;
  std::vector<double> slope;
};

}  // namespace gudgeon::oracle
