// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
#include "gudgeon/model/name_index.h"

#include <gtest/gtest.h>

namespace gudgeon {
namespace {

Mechanism make_mechanism() {
  Mechanism mechanism;
  mechanism.bodies.resize(4);
  mechanism.bodies[0] = {kFrameName, 0.0, 0.0, {}, {{"A", {1.0, 2.0}}, {"B", {3.0, 4.0}}}, {}};
  mechanism.bodies[1].name = "crank";
  mechanism.bodies[1].points = {{"A", {5.0, 6.0}}, {"A", {7.0, 8.0}}};
  mechanism.bodies[2].name = "rod";
  mechanism.bodies[3].name = "crank";
  mechanism.joints = {{"pin", Revolute{{"frame", "A"}, {"crank", "A"}}, {}}};
  return mechanism;
}

TEST(NameIndex, FindsTheFirstOfAName) {
  const Mechanism mechanism = make_mechanism();
  const NameIndex names(mechanism);
  EXPECT_EQ(names.find_body("frame"), 0);
  EXPECT_EQ(names.find_body("crank"), 1);
  EXPECT_EQ(names.find_body("rod"), 2);
  EXPECT_EQ(names.find_joint("pin"), 0);
  EXPECT_EQ(names.find_point(0, "B"), &mechanism.bodies[0].points[1]);
  EXPECT_EQ(names.find_point(1, "A"), &mechanism.bodies[1].points[0]);
}

TEST(NameIndex, SaysWhatIsNotThere) {
  const Mechanism mechanism = make_mechanism();
  const NameIndex names(mechanism);
  EXPECT_EQ(names.find_body("pin"), -1);
  EXPECT_EQ(names.find_joint("crank"), -1);
  EXPECT_EQ(names.find_point(1, "B"), nullptr);
  EXPECT_EQ(names.find_point(2, "A"), nullptr);
}

}  // namespace
}  // namespace gudgeon
