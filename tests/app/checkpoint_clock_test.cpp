// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// An interval after the last one, and later where writing takes long.
#include "gudgeon/app/checkpoint_clock.h"

#include <gtest/gtest.h>

namespace gudgeon {
namespace {

TEST(CheckpointClock, AsksAnIntervalAfterTheLast) {
  CheckpointClock clock;
  clock.tick(1e9);
  EXPECT_FALSE(clock.wanted()) << "the case has not begun";
  clock.begin(100.0, 60.0);
  clock.tick(159.9);
  EXPECT_FALSE(clock.wanted());
  clock.tick(160.0);
  EXPECT_TRUE(clock.wanted());
  clock.note_written(161.0, 161.5);
  EXPECT_FALSE(clock.wanted());
  clock.tick(221.4);
  EXPECT_FALSE(clock.wanted());
  clock.tick(221.5);
  EXPECT_TRUE(clock.wanted());
}

TEST(CheckpointClock, WritingTakesATenthOfTheTimeAtMost) {
  CheckpointClock clock;
  clock.begin(0.0, 0.1);
  clock.note_written(1.0, 3.0);
  clock.tick(20.9);
  EXPECT_FALSE(clock.wanted());
  clock.tick(21.0);
  EXPECT_TRUE(clock.wanted());
}

}  // namespace
}  // namespace gudgeon
