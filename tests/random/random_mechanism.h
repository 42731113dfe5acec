// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Mechanisms by chance: every seed is another one, the same at every call.
//
// Bodies are first thrown into the plane, joints then put where they find them, so that whatever is drawn closes at its
// start, however it is connected. Sizes are those of machines: 0.1 to 0.5 m, 0.1 to 3 kg.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "gudgeon/model/mechanism.h"
#include "gudgeon/model/study.h"

namespace gudgeon::random {

enum class Family {
  trees,       ///< open chains of pins, guides, welds and pins in slots, thrown about
  loops,       ///< closed by pins, guides and slots, moving under loads
  driven,      ///< the same with a pin or a guide driven uniformly, to and fro, or along a curve
  redundant,   ///< with constraints that say what others say already
  loads,       ///< springs, dampers, bushings, formulas and curves of time, position and speed
  curves,      ///< loads that are curves through points over positions, some with steps
  steps,       ///< forces that jump at one instant
  clearances,  ///< journals in bearings, pins and blocks in slots with play, some wearing
};

/// "trees" …
const char* name_family(Family family);

/// A load whose work depends on where it has moved its place only, not on when.
struct CurveLoad {
  SampledCurve curve;  ///< over that channel, which it pushes along
  Anchor point;        ///< of a coordinate of a point; else the body alone counts
};

struct RandomModel {
  Mechanism mechanism;
  Study study;  ///< one short cycle
  /// Where a formula jumps [s]; 0 where none does. Before and after it, loads are those of these mechanisms.
  double jump_time = 0.0;
  Mechanism before;
  Mechanism after;
  std::vector<CurveLoad> curves;  ///< all that do the works of loads, if there are any
  bool can_move = true;           ///< the driver is not against constraints
};

RandomModel make_model(Family family, std::uint64_t seed);

}  // namespace gudgeon::random
