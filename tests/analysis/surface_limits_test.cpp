// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// What no bearing has is told, and nothing else.
#include "gudgeon/analysis/surface_limits.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "tests/results/synthetic_run.h"

namespace gudgeon {
namespace {

using testing::HasSubstr;

JointWear& find_wear(RunRecord& run) { return run.stages[1].wear.at(0); }

void set_penetration(RunRecord& run, double deepest) {
  run.stages[1].statistics.push_back({"A.penetration", -1e-4, 0.0, deepest, 0.5, 0.0, 0.0});
}

TEST(SurfaceLimits, AreNotMetByASoundRun) {
  RunRecord run = test::make_run();
  set_penetration(run, 14.9e-3);
  find_wear(run).journal_depth[3] = 0.49e-3;
  EXPECT_TRUE(find_limits_exceeded(run).empty());
}

TEST(SurfaceLimits, TellPenetrationBeyondTheRadius) {
  RunRecord run = test::make_run();
  set_penetration(run, 2.19);
  const auto exceeded = find_limits_exceeded(run);
  ASSERT_EQ(exceeded.size(), 1U);
  EXPECT_EQ(exceeded[0].limit, SurfaceLimit::penetration_radius);
  EXPECT_EQ(exceeded[0].reached, 2.19);
  EXPECT_EQ(exceeded[0].bound, 15e-3);
  EXPECT_THAT(describe(exceeded[0]), HasSubstr("stage 'no_wear', joint 'A': penetration of 2.19 m, beyond the "
                                               "bearing's radius of 15 mm"));
  // A slot has no radius; the pin in it has.
  find_wear(run).bearing_radius = std::numeric_limits<double>::infinity();
  find_wear(run).slot_length = 0.3;
  EXPECT_EQ(find_limits_exceeded(run).at(0).bound, 14.5e-3);
  EXPECT_THAT(describe(find_limits_exceeded(run).at(0)), HasSubstr("the journal's radius of 14.5 mm"));
}

TEST(SurfaceLimits, TellWearBeyondClearanceAndWall) {
  RunRecord run = test::make_run();
  find_wear(run).journal_depth[3] = 0.4e-3;
  find_wear(run).journal_depth_added[3] = 0.2e-3;  // both together count
  auto exceeded = find_limits_exceeded(run);
  ASSERT_EQ(exceeded.size(), 1U);
  EXPECT_EQ(exceeded[0].limit, SurfaceLimit::wear_clearance);
  EXPECT_THAT(describe(exceeded[0]), HasSubstr("journal worn 600 um deep, more than the clearance of 500 um"));
  find_wear(run).bearing_depth_added[9] = 16e-3;
  exceeded = find_limits_exceeded(run);
  ASSERT_EQ(exceeded.size(), 2U);
  EXPECT_EQ(exceeded[0].limit, SurfaceLimit::wear_radius);
  EXPECT_THAT(describe(exceeded[0]), HasSubstr("bearing worn 16 mm deep, beyond its radius of 15 mm"));
  EXPECT_THAT(describe(exceeded[1]), HasSubstr("bearing worn 16 mm deep, more than the clearance"));
}

}  // namespace
}  // namespace gudgeon
