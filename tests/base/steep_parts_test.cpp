// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
#include "gudgeon/base/steep_parts.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace gudgeon {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

TEST(SteepParts, AreArgumentsBasesAndDenominators) {
  EXPECT_THAT(list_steep_parts("1e6*exp(-((t - 0.5)/w)^2)"), ElementsAre("-((t - 0.5)/w)^2", "w"));
  EXPECT_THAT(list_steep_parts("1/(1 + u^2) + 2/-cosh(v)^3"), ElementsAre("(1 + u^2)", "-cosh(v)", "v"));
  EXPECT_THAT(list_steep_parts("sin(pi*t)^1000"), ElementsAre("sin(pi*t)"));
  EXPECT_THAT(list_steep_parts("2*t^-2 + x^2^n"), ElementsAre("t", "x"));
  EXPECT_THAT(list_steep_parts("atan2(y, max(x, 1))*pow((t - 1), 8)"), ElementsAre("y", "max(x, 1)", "(t - 1)"));
}

TEST(SteepParts, AreNotWavesPolynomialsAndPieces) {
  EXPECT_THAT(list_steep_parts("-kp*(arm.angle - 0.3*sin(2*pi*t)) - kd*arm.angle_rate/0.5"), IsEmpty());
  EXPECT_THAT(list_steep_parts("3*(t - 1)^2 + (t > 1 ? abs(x) : min(x, 2))"), IsEmpty());
}

}  // namespace
}  // namespace gudgeon
