// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Depths, places and ranges of wear.
#include "gudgeon/analysis/wear_summary.h"

#include <gtest/gtest.h>

#include "gudgeon/base/diagnostics.h"
#include "gudgeon/results/regions.h"
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

TEST(WornRanges, StandAtTheEdgesOfTheirRegions) {
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
  EXPECT_DOUBLE_EQ(second.added.angle, find_region_angle(97, 100));
  EXPECT_DOUBLE_EQ(second.bearing.depth, 3e-6);
  EXPECT_DOUBLE_EQ(first.mean_depth_added, 4e-6 * (1.0 + 9 * 0.5) / 100);
  ASSERT_EQ(second.worn.size(), 1u);
  EXPECT_DOUBLE_EQ(second.worn[0].begin, 342.0);
  EXPECT_DOUBLE_EQ(second.worn[0].end, 378.0);
  EXPECT_EQ(first.removed_volume, first.archard_volume);
}

TEST(WearSummary, UnwornSurfaceCountsInTheBearingsOwnDepth) {
  RunRecord run = test::make_run();
  run.stages[2].wear[0].bearing_depth.assign(test::kRegions, 1e-6);
  EXPECT_DOUBLE_EQ(summarize_wear(run, 2)[0].bearing.depth, 4e-6);
}

TEST(WearSummary, StageThatFailedBeforeWearing) {
  RunRecord run = test::make_run();
  run.stages[2].wear[0].total_depth_added.clear();
  const JointWearSummary summary = summarize_wear(run, 2).front();
  EXPECT_EQ(summary.added.depth, 0.0);
  EXPECT_DOUBLE_EQ(summary.accumulated.depth, 4e-6);
}

TEST(WearSummary, RefusesToAddDifferentRegions) {
  RunRecord run = test::make_run();
  run.stages[2].wear[0].total_depth_added.resize(50);
  EXPECT_THROW(summarize_wear(run, 2), NumericalError);
}

}  // namespace
}  // namespace gudgeon
