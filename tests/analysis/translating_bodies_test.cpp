// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Sliders found from the record.
#include "gudgeon/analysis/translating_bodies.h"

#include <gtest/gtest.h>

#include "tests/results/synthetic_run.h"

namespace gudgeon {
namespace {

TEST(TranslatingBodies, SliderMovesWithoutTurning) {
  StageRecord stage = test::make_run().stages[0];
  stage.channels.push_back({"crank.x_acceleration", "ẍ", "m/s^2", ""});
  stage.values.emplace_back(test::kSamples, 3.0);
  stage.channels.push_back({"frame.x_acceleration", "ẍ", "m/s^2", ""});
  stage.values.emplace_back(test::kSamples, 0.0);
  EXPECT_EQ(find_translating_bodies(stage), std::vector<std::string>{"slider"});
  EXPECT_EQ(find_moving_axes(stage, "slider"), std::vector<std::string>{"x"});
}

TEST(TranslatingBodies, StatisticsAreEnough) {
  StageRecord stage = test::make_run().stages[0];
  stage.time.clear();
  for (auto& values : stage.values) values.clear();
  EXPECT_EQ(find_translating_bodies(stage), std::vector<std::string>{"slider"});
}

}  // namespace
}  // namespace gudgeon
