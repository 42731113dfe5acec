// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Stays in contact from onset to separation.
#include "gudgeon/sim/contact_history.h"

#include <gtest/gtest.h>

namespace gudgeon {
namespace {

TEST(ContactHistory, KeepsOnsetPeakAndDuration) {
  ContactHistory history(2, 0.0);
  history.begin(1, {1, 2.0, 0.0, 0.3, -0.7, 0.0, 0.0, 0});
  history.watch(1, 5.0);
  history.watch(1, 9.0);
  history.watch(1, 4.0);
  EXPECT_TRUE(history.events().empty()) << "not before it has ended";
  history.end(1, 2.25);
  ASSERT_EQ(history.events().size(), 1U);
  const ContactEvent& event = history.events()[0];
  EXPECT_EQ(event.joint, 1);
  EXPECT_EQ(event.onset_time, 2.0);
  EXPECT_EQ(event.duration, 0.25);
  EXPECT_EQ(event.onset_speed, 0.3);
  EXPECT_EQ(event.angle, -0.7);
  EXPECT_EQ(event.peak_force, 9.0);
}

TEST(ContactHistory, JointsDoNotMixAndStandInTheOrderOfTheirEnd) {
  ContactHistory history(2, 0.0);
  history.begin(0, {0, 1.0, 0.0, 0.1, 0.0, 0.0, 0.0, 0});
  history.begin(1, {1, 1.5, 0.0, 0.2, 0.0, 0.0, 0.0, 0});
  history.watch(0, 7.0);
  history.watch(1, 3.0);
  history.end(1, 2.0);
  history.end(0, 3.0);
  ASSERT_EQ(history.events().size(), 2U);
  EXPECT_EQ(history.events()[0].joint, 1);
  EXPECT_EQ(history.events()[0].peak_force, 3.0);
  EXPECT_EQ(history.events()[1].joint, 0);
  EXPECT_EQ(history.events()[1].peak_force, 7.0);
}

TEST(ContactHistory, EveryContactBeginsAnew) {
  ContactHistory history(1, 0.0);
  history.begin(0, {0, 1.0, 0.0, 0.1, 0.4, 0.0, 0.0, 0});
  history.watch(0, 7.0);
  history.end(0, 1.5);
  history.begin(0, {0, 2.0, 0.0, 0.2, 0.5, 0.0, 0.0, 0});
  history.watch(0, 1.0);
  history.end(0, 2.5);
  ASSERT_EQ(history.events().size(), 2U);
  EXPECT_EQ(history.events()[1].peak_force, 1.0);
  EXPECT_EQ(history.events()[1].onset_speed, 0.2);
}

TEST(ContactHistory, LeavesOutWhatBeganTooEarly) {
  ContactHistory history(1, 4.0);
  history.begin(0, {0, 3.9, 0.0, 0.1, 0.0, 0.0, 0.0, 0});
  history.end(0, 5.0);
  EXPECT_TRUE(history.events().empty());
  history.begin(0, {0, 4.0, 0.0, 0.1, 0.0, 0.0, 0.0, 0});
  history.end(0, 5.5);
  ASSERT_EQ(history.events().size(), 1U);
  EXPECT_EQ(history.events()[0].onset_time, 4.0);
}

}  // namespace
}  // namespace gudgeon
