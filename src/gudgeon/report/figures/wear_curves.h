// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Curves of worn surfaces, for one case's figures and for those that compare cases.
#pragma once

#include <span>
#include <string>

#include "gudgeon/report/figures/figure.h"
#include "gudgeon/report/figures/wear_states.h"

namespace gudgeon {

/// One joint's surfaces and the curve that stands for them in a legend.
struct WornSurfaces {
  std::string name;
  std::string group;
  int color = 0;
  int n_alike = 1;  ///< how many states or cases are drawn over each other
  const JointWear* wear = nullptr;
  WearState state = {};
};

/// Depth of bearing and journal together over the bearing's surface; empty curves when nothing is worn.
Figure make_depth_figure(std::span<const WornSurfaces> surfaces);
/// Place of one side's worn surface across itself, with its unworn place: a rebuilt surface, unrolled.
Figure make_unrolled_figure(std::span<const WornSurfaces> surfaces, bool of_bearing);
/// Round surfaces as they lie in the plane, the depth exaggerated; empty when there is no round one.
Figure make_outline_figure(std::span<const WornSurfaces> surfaces);

}  // namespace gudgeon
