// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// The names that formulas may use, and what they stand for.
#include "gudgeon/model/channel_names.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

namespace gudgeon {
namespace {

using enum StateChannel::Quantity;

Mechanism make_slider() {
  Mechanism mechanism;
  mechanism.bodies.resize(2);
  mechanism.bodies[0].name = kFrameName;
  mechanism.bodies[0].points = {{"O", {1.0, 2.0}}};
  mechanism.bodies[1] = {"piston", 1.0, 1.0, {0.1, 0.2}, {{"B", {0.3, 0.4}}}, {}};
  mechanism.joints = {{"A", Revolute{}}, {"guide", Prismatic{}}, {"slot", PrismaticClearance{}}, {"pin", PinInSlot{}}};
  return mechanism;
}

TEST(ChannelNames, AreThoseOfBodiesPointsAndSlides) {
  std::vector<std::string> names;
  for (const StateChannel& channel : list_state_channels(make_slider())) names.push_back(channel.name);
  EXPECT_THAT(names, testing::ElementsAre("t", "frame.O.x", "frame.O.y", "frame.O.x_velocity", "frame.O.y_velocity",
                                          "piston.x", "piston.y", "piston.angle", "piston.x_velocity",
                                          "piston.y_velocity", "piston.angle_rate", "piston.B.x", "piston.B.y",
                                          "piston.B.x_velocity", "piston.B.y_velocity", "guide.displacement",
                                          "guide.speed", "slot.displacement", "slot.speed"));
}

TEST(ChannelNames, HaveTheirDimension) {
  for (const StateChannel& channel : list_state_channels(make_slider())) {
    EXPECT_TRUE(find_channel_dimension(channel.name).has_value()) << channel.name;
  }
  EXPECT_EQ(find_channel_dimension("t"), dimension::kTime);
  EXPECT_EQ(find_channel_dimension("piston.B.y_velocity"), dimension::kSpeed);
  EXPECT_EQ(find_channel_dimension("crank.angle_rate"), dimension::kAngularSpeed);
  EXPECT_EQ(find_channel_dimension("A.normal_force"), std::nullopt);
}

TEST(ChannelNames, SayWhatTheyStandFor) {
  const auto channels = list_state_channels(make_slider());
  const auto find = [&](const char* name) { return *std::ranges::find(channels, name, &StateChannel::name); };
  EXPECT_EQ(find("t").quantity, time);
  EXPECT_EQ(find("piston.y_velocity").quantity, y_velocity);
  EXPECT_EQ(find("piston.y_velocity").body, 1);
  EXPECT_EQ(find("piston.x").local.y, 0.2);
  EXPECT_EQ(find("piston.B.y").local.x, 0.3);
  EXPECT_EQ(find("frame.O.x").body, 0);
  EXPECT_EQ(find("slot.speed").joint, 2);
  EXPECT_EQ(find("slot.speed").quantity, speed);
  EXPECT_EQ(find("piston.angle").joint, -1);
}

}  // namespace
}  // namespace gudgeon
