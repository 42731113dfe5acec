// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "gudgeon/model/channel_names.h"

namespace gudgeon {
namespace {

Mechanism make_crank() {
  Mechanism mechanism;
  mechanism.bodies.resize(2);
  mechanism.bodies[0].name = kFrameName;
  mechanism.bodies[1].name = "crank";
  mechanism.bodies[1].points = {{"A", {1.0, 2.0}}};
  return mechanism;
}

TEST(ChannelIndex, KnowsEveryStateChannelByItsName) {
  const Mechanism mechanism = make_crank();
  const ChannelIndex index(mechanism);
  const auto listed = list_state_channels(mechanism);
  ASSERT_EQ(index.channels().size(), listed.size());
  for (std::size_t k = 0; k < listed.size(); ++k) {
    EXPECT_EQ(index.names()[k], listed[k].name);
    EXPECT_EQ(index.find(listed[k].name), static_cast<int>(k));
  }
  EXPECT_EQ(index.find("crank"), -1);
  EXPECT_EQ(index.find("crank.A.z"), -1);
}

TEST(ChannelIndex, FindsWordsOfAFormulaNotPartsOfThem) {
  const ChannelIndex index(make_crank());
  const std::vector<int> found = index.find_in_formula("2e3*crank.A.x_velocity - t*crank.angle + sqrt(t) + crank.A.x2");
  ASSERT_EQ(found.size(), 3u) << "crank.A.x is only the beginning of a word";
  EXPECT_EQ(index.names()[found[0]], "t") << "in their own order, each once";
  EXPECT_EQ(index.names()[found[1]], "crank.angle");
  EXPECT_EQ(index.names()[found[2]], "crank.A.x_velocity");
  EXPECT_TRUE(index.find_in_formula("1 + pi").empty());
}

}  // namespace
}  // namespace gudgeon
