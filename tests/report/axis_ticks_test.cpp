// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Round numbers along axes.
#include "gudgeon/report/plot/axis_ticks.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

namespace gudgeon {
namespace {

using ::testing::DoubleNear;
using ::testing::ElementsAre;
using ::testing::IsEmpty;

TEST(AxisTicks, AreRound) {
  EXPECT_THAT(find_ticks(0.0, 10.0, 5).places, ElementsAre(0.0, 2.0, 4.0, 6.0, 8.0, 10.0));
  const AxisTicks fine = find_ticks(-0.031, 0.012, 4);
  EXPECT_EQ(fine.decimals, 2);
  EXPECT_THAT(fine.places, ElementsAre(DoubleNear(-0.02, 1e-15), 0.0));
}

TEST(AxisTicks, EndsBelongToTheAxis) {
  const AxisTicks ticks = find_ticks(0.1, 0.3, 2);
  EXPECT_NEAR(ticks.places.front(), 0.1, 1e-15);
  EXPECT_NEAR(ticks.places.back(), 0.3, 1e-15);
}

TEST(AxisTicks, DegreesDivideTheTurn) {
  EXPECT_THAT(find_ticks(0.0, 360.0, 6, true).places, ElementsAre(0.0, 60.0, 120.0, 180.0, 240.0, 300.0, 360.0));
}

TEST(AxisTicks, NothingWithoutARange) {
  EXPECT_THAT(find_ticks(1.0, 1.0, 5).places, IsEmpty());
  EXPECT_THAT(find_ticks(0.0, std::numeric_limits<double>::infinity(), 5).places, IsEmpty());
}

TEST(AxisTicks, PrintATrueMinusButNoMinusZero) {
  EXPECT_EQ(print_tick(-0.25, 2), "−0.25");
  EXPECT_EQ(print_tick(-0.001, 1), "0.0");
}

}  // namespace
}  // namespace gudgeon
