// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// The speeds that friction laws change over, and their steepest slopes, in closed form.
#include <gtest/gtest.h>

#include "gudgeon/system/contact_force.h"

namespace gudgeon {
namespace {

TEST(FrictionSlope, LeastSpeedIsThatOfTheLaw) {
  EXPECT_EQ(find_slip_scale(Frictionless{}), 1.0);
  EXPECT_EQ(find_slip_scale(CoulombSmooth{0.3, 2e-7}), 2e-7);
  EXPECT_EQ(find_slip_scale(CoulombRamp{0.3, 0.0, 4e-3}), 4e-3) << "a dead speed of zero is none";
  EXPECT_EQ(find_slip_scale(LugreSteady{0.15, 0.1, 1e-3, 2.0, 0.0, 1e-4}), 1e-4);
}

// Six digits of differences; slopes do not depend on what units of time are about.
TEST(FrictionSlope, SteepestWhereTheLawTurnsFastest) {
  for (const double speed : {1e-8, 1e-3, 10.0}) {
    EXPECT_NEAR(find_steepest_friction(CoulombSmooth{0.3, speed}) * speed, 0.3, 1e-5);
    EXPECT_NEAR(find_steepest_friction(CoulombRamp{0.3, 0.2 * speed, speed}) * speed, 0.3 / 0.8, 1e-4);
    EXPECT_NEAR(find_steepest_friction(LugreSteady{0.15, 0.1, 10.0 * speed, 2.0, 0.0, speed}) * speed, 0.15, 1e-4);
  }
  EXPECT_EQ(find_steepest_friction(Frictionless{}), 0.0);
}

}  // namespace
}  // namespace gudgeon
