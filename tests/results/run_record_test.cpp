// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// What follows from the numbers of a record.
#include "gudgeon/results/run_record.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace gudgeon {
namespace {

TEST(JointWear, DepthsAfterAStageAreThoseBeforeAndThoseAdded) {
  JointWear wear;
  wear.bearing_depth = {1.0, 2.0, 0.0};
  wear.bearing_depth_added = {0.5, 0.0, 4.0};
  wear.journal_depth = {8.0};
  wear.journal_depth_added = {0.25};
  EXPECT_THAT(wear.bearing_depth_after(), testing::ElementsAre(1.5, 2.0, 4.0));
  EXPECT_THAT(wear.journal_depth_after(), testing::ElementsAre(8.25));
}

}  // namespace
}  // namespace gudgeon
