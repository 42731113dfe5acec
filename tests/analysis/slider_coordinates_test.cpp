// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Sliders found from the record.
#include "gudgeon/analysis/slider_coordinates.h"

#include <gtest/gtest.h>

#include "tests/results/synthetic_run.h"

namespace gudgeon {
namespace {

TEST(SliderCoordinates, SliderMovesWithoutTurning) {
  StageRecord stage = test::make_run().stages[0];
  stage.channels.push_back({"crank.x_acceleration", "ẍ", "m/s^2", ""});
  stage.values.emplace_back(test::kSamples, 3.0);
  stage.channels.push_back({"frame.x_acceleration", "ẍ", "m/s^2", ""});
  stage.values.emplace_back(test::kSamples, 0.0);
  EXPECT_EQ(find_slider_coordinates(stage), std::vector<std::string>{"slider.x"});
}

TEST(SliderCoordinates, StatisticsAreEnough) {
  StageRecord stage = test::make_run().stages[0];
  stage.time.clear();
  for (auto& values : stage.values) values.clear();
  EXPECT_EQ(find_slider_coordinates(stage), std::vector<std::string>{"slider.x"});
}

}  // namespace
}  // namespace gudgeon
