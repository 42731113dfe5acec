// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// What damping changes of small motions, and what it does not.
#include "gudgeon/system/equilibrium_modes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "gudgeon/system/equilibrium.h"
#include "tests/oracle/mechanism_parts.h"

namespace gudgeon {
namespace {

/// A slender bar of 1 m and 2 kg on a pivot, with gravity along −y.
Mechanism make_hinged_bar(double angle) {
  Mechanism mechanism = oracle::make_empty("bars", {0.0, -9.81}, {{"pivot", {0.0, 0.0}}});
  mechanism.bodies.push_back(oracle::make_slender("bar", 1.0, 2.0, oracle::start_at(angle)));
  oracle::add_revolute(mechanism, "pivot", {kFrameName, "pivot"}, {"bar", "a"});
  return mechanism;
}

TEST(EquilibriumModes, HardDampingBetweenTwoBarsLeavesTheirSwing) {
  // The damper makes one bar of two; how they fold comes back slowly: damping d against the stiffness k of the weights.
  Mechanism mechanism = make_hinged_bar(-1.2);
  mechanism.bodies.push_back(oracle::make_slender("tail", 1.0, 2.0, oracle::start_at(-1.2)));
  oracle::add_revolute(mechanism, "hinge", {"bar", "b"}, {"tail", "a"});
  mechanism.loads.push_back({"damper", TorsionSpring{"bar", "tail", 0.0, 2e5, 0.0}});
  const Equilibrium found = find_equilibrium(mechanism);
  ASSERT_EQ(found.modes.size(), 3u);
  for (const EquilibriumMode& mode : found.modes) EXPECT_EQ(mode.kind, EquilibriumMode::Kind::stable);
  // A slender bar of 2 m: ω² = 3 g/(2 L); what the damper gives by is (stiffness/(d ω))² of it.
  EXPECT_NEAR(found.modes[2].frequency, std::sqrt(0.75 * 9.81) / (2.0 * std::numbers::pi), 1e-8);
  EXPECT_TRUE(found.is_stable());
}

TEST(EquilibriumModes, ADampedBarThatNothingBringsBackIsNeutral) {
  Mechanism mechanism = make_hinged_bar(0.4);
  mechanism.gravity = {};
  mechanism.loads.push_back({"damper", TorsionSpring{"bar", kFrameName, 0.0, 3.0, 0.0}});
  const Equilibrium found = find_equilibrium(mechanism);
  ASSERT_EQ(found.modes.size(), 2u);
  EXPECT_EQ(std::ranges::count(found.modes, EquilibriumMode::Kind::neutral, &EquilibriumMode::kind), 1);
  // λ = −d/I with I = m L²/3
  const auto stops = std::ranges::find(found.modes, EquilibriumMode::Kind::stable, &EquilibriumMode::kind);
  ASSERT_NE(stops, found.modes.end());
  EXPECT_NEAR(stops->growth_rate, -3.0 / (2.0 / 3.0), 1e-8);
}

}  // namespace
}  // namespace gudgeon
