// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Which driver counts the cycles, and how long a cycle lasts.
#include "gudgeon/model/cycle_time.h"

#include <gtest/gtest.h>

#include <numbers>

namespace gudgeon {
namespace {

Mechanism make_driven() {
  Mechanism mechanism;
  mechanism.drivers = {{"ram", DrivenSlide{"guide"}, 0.0, 1.0},
                       {"held", DrivenAngle{"a"}, 0.0, 0.0},
                       {"slow", DrivenAngle{"b"}, 0.0, -1.0},
                       {"fast", DrivenAngle{"c"}, 0.0, 4.0}};
  return mechanism;
}

TEST(CycleTime, IsOneTurnOfTheNamedDriver) {
  Study study;
  study.cycle_driver = "fast";
  study.cycle_time = 7.0;
  EXPECT_DOUBLE_EQ(find_cycle_time(make_driven(), study), std::numbers::pi / 2.0);
}

TEST(CycleTime, TakesTheFirstDriverThatTurns) {
  ASSERT_NE(find_cycle_driver(make_driven(), {}), nullptr);
  const Mechanism mechanism = make_driven();
  EXPECT_EQ(find_cycle_driver(mechanism, {})->name, "slow");
  EXPECT_DOUBLE_EQ(find_cycle_time(mechanism, {}), 2.0 * std::numbers::pi);
}

TEST(CycleTime, IsTheGivenTimeOrTheDefault) {
  Study study;
  EXPECT_EQ(find_cycle_time({}, study), kDefaultCycleTime);
  study.cycle_time = 0.25;
  EXPECT_EQ(find_cycle_time(make_driven(), study), 0.25);
  EXPECT_EQ(find_cycle_driver(make_driven(), study), nullptr);
}

TEST(CycleTime, HasNoDriverWhenTheNamedOneIsNone) {
  const Mechanism mechanism = make_driven();
  Study study;
  study.cycle_driver = "ram";
  EXPECT_EQ(find_cycle_driver(mechanism, study), nullptr);
  study.cycle_driver = "nobody";
  EXPECT_EQ(find_cycle_driver(mechanism, study), nullptr);
}

}  // namespace
}  // namespace gudgeon
