// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Depths, places and ranges of wear.
#include "gudgeon/analysis/wear_summary.h"

#include <gtest/gtest.h>

#include "gudgeon/base/diagnostics.h"
#include "gudgeon/results/cells.h"
#include "tests/results/synthetic_run.h"

namespace gudgeon {
namespace {

void expect_ranges(std::vector<double> depth, std::vector<AngleRange> expected) {
  const std::vector<AngleRange> found = find_worn_ranges(depth);
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t k = 0; k < found.size(); ++k) {
    EXPECT_DOUBLE_EQ(found[k].begin, expected[k].begin);
    EXPECT_DOUBLE_EQ(found[k].end, expected[k].end);
  }
}

TEST(WornRanges, StandAtTheEdgesOfTheirCells) {
  expect_ranges({0, 0, 5, 5, 0, 0, 0, 1, 0, 0}, {{72, 144}, {252, 288}});
  expect_ranges({5, 0, 0, 0, 0, 0, 0, 0, 0, 0}, {{0, 36}});
  expect_ranges({0, 0, 0, 0, 0, 0, 0, 0, 0, 5}, {{324, 360}});
}

TEST(WornRanges, GoOnAcrossZero) {
  expect_ranges({5, 5, 0, 0, 0, 0, 0, 0, 0, 5}, {{324, 432}});
  expect_ranges({5, 0, 0, 0, 5, 0, 0, 0, 5, 5}, {{144, 180}, {288, 396}});
  expect_ranges({5, 0, 5, 5, 5, 5, 5, 5, 5, 5}, {{72, 396}});
}

TEST(WornRanges, WholeCircleAndNothing) {
  expect_ranges({3, 3, 3, 3}, {{0, 360}});
  expect_ranges({0, 0, 0, 0}, {});
  expect_ranges({}, {});
}

TEST(WornRanges, LeaveOutWhatIsShallow) {
  expect_ranges({10, 1.0, 1.01, 0, 0.99, 0, 0, 0, 0, 0}, {{0, 36}, {72, 108}});
}

TEST(WearSummary, AddsUpOverTheStages) {
  const RunRecord run = test::make_run();
  EXPECT_TRUE(summarize_wear(run, 0).empty());
  const JointWearSummary first = summarize_wear(run, 1).front();
  const JointWearSummary second = summarize_wear(run, 2).front();
  EXPECT_EQ(first.joint, "A");
  EXPECT_DOUBLE_EQ(first.added.depth, 4e-6);
  EXPECT_DOUBLE_EQ(first.accumulated.depth, 4e-6);
  EXPECT_DOUBLE_EQ(second.added.depth, 6e-6);
  EXPECT_DOUBLE_EQ(second.accumulated.depth, 10e-6);
  EXPECT_DOUBLE_EQ(second.added.angle, find_cell_angle(97, 100));
  EXPECT_DOUBLE_EQ(second.bearing.depth, 3e-6);
  EXPECT_DOUBLE_EQ(first.mean_depth_added, 4e-6 * (1.0 + 9 * 0.5) / 100);
  ASSERT_EQ(second.worn.size(), 1u);
  EXPECT_DOUBLE_EQ(second.worn[0].begin, 342.0);
  EXPECT_DOUBLE_EQ(second.worn[0].end, 378.0);
  EXPECT_EQ(first.removed_volume, first.archard_volume);
}

TEST(WearSummary, UnwornSurfaceCountsInTheBearingsOwnDepth) {
  RunRecord run = test::make_run();
  run.stages[2].wear[0].bearing_depth.assign(test::kCells, 1e-6);
  EXPECT_DOUBLE_EQ(summarize_wear(run, 2)[0].bearing.depth, 4e-6);
}

TEST(WearSummary, StageThatFailedBeforeWearing) {
  RunRecord run = test::make_run();
  run.stages[2].wear[0].total_depth_added.clear();
  const JointWearSummary summary = summarize_wear(run, 2).front();
  EXPECT_EQ(summary.added.depth, 0.0);
  EXPECT_DOUBLE_EQ(summary.accumulated.depth, 4e-6);
}

TEST(WearSummary, RefusesToAddDifferentCells) {
  RunRecord run = test::make_run();
  run.stages[2].wear[0].total_depth_added.resize(50);
  EXPECT_THROW(summarize_wear(run, 2), NumericalError);
}

TEST(WornSides, StandAtTheEdgesOfTheirCellsOnEitherSide) {
  // Ten cells of 10 mm a side.
  std::vector<double> depth(20, 0.0);
  depth[2] = depth[3] = 5.0;
  depth[9] = depth[10] = 4.0;  // the end of the left side, the beginning of the right one
  depth[14] = 0.4;             // shallow
  const std::vector<SideRange> found = find_worn_sides(depth, 0.1);
  ASSERT_EQ(found.size(), 3U);
  const SideRange expected[] = {{0, -0.03, -0.01}, {0, 0.04, 0.05}, {1, -0.05, -0.04}};
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_EQ(found[k].side, expected[k].side);
    EXPECT_NEAR(found[k].begin, expected[k].begin, 1e-15);
    EXPECT_NEAR(found[k].end, expected[k].end, 1e-15);
  }
  EXPECT_TRUE(find_worn_sides(std::vector<double>(20, 0.0), 0.1).empty());
  EXPECT_TRUE(find_worn_sides({}, 0.1).empty());
}

TEST(WearSummary, TellsTheSideAndPlaceOfASlot) {
  RunRecord run = test::make_run();
  JointWear& wear = run.stages[1].wear[0];
  wear.slot_length = 0.2;
  wear.clearance = 1e-4;
  for (auto* depths : {&wear.bearing_depth, &wear.bearing_depth_added, &wear.total_depth_added})
    depths->assign(100, 0.0);
  wear.total_depth_added[70] = wear.bearing_depth_added[70] = 5e-6;  // the right side's cell 20 of 50
  const JointWearSummary summary = summarize_wear(run, 1).front();
  EXPECT_TRUE(summary.is_slot);
  EXPECT_EQ(summary.added.surface, 1U);
  EXPECT_NEAR(summary.added.position, find_cell_position(20, 50, 0.2), 1e-15);
  EXPECT_NEAR(summary.added.position, -0.018, 1e-15);
  EXPECT_DOUBLE_EQ(summary.added.depth, 5e-6);
  EXPECT_DOUBLE_EQ(summary.clearance_share, 0.05);
  EXPECT_TRUE(summary.worn.empty());
  ASSERT_EQ(summary.worn_sides.size(), 1U);
  EXPECT_EQ(summary.worn_sides[0].side, 1U);
}

}  // namespace
}  // namespace gudgeon
