// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Every wear law: nothing without load or slip, never negative; Archard's values.
#include <gtest/gtest.h>

#include <cmath>

#include "gudgeon/laws/wear/any.h"
#include "tests/laws/sample_law.h"

namespace gudgeon {
namespace {

template <class Law>
class WearFamily : public testing::Test {
 protected:
  Law law = make_sample_law<Law>();
};
TYPED_TEST_SUITE(WearFamily, AlternativesOf<AnyWear>::Types);

TYPED_TEST(WearFamily, NeedsLoadAndSlip) {
  EXPECT_EQ(this->law({0.0, 0.3}), 0.0);
  EXPECT_EQ(this->law({2e7, 0.0}), 0.0);
}

TYPED_TEST(WearFamily, NeverAddsMaterialAndNeverFallsWithLoadOrSlip) {
  for (const double pressure : {1e3, 1e6, 4e8}) {
    for (const double speed : {1e-6, 1e-2, 3.0}) {
      EXPECT_GE(this->law({pressure, speed}), 0.0);
      EXPECT_GE(this->law({2.0 * pressure, speed}), this->law({pressure, speed}));
      EXPECT_GE(this->law({pressure, 2.0 * speed}), this->law({pressure, speed}));
    }
  }
}

TEST(Archard, IsLinearInPressureSlipAndCoefficient) {
  // 4e-14 1/Pa · 2e7 Pa · 0.5 m/s = 4e-7 m/s
  EXPECT_DOUBLE_EQ(Archard{4e-14}({2e7, 0.5}), 4e-7);
  EXPECT_DOUBLE_EQ(Archard{4e-14}({6e7, 0.5}), 12e-7);
  EXPECT_DOUBLE_EQ(Archard{4e-14}({2e7, 1.0}), 8e-7);
  EXPECT_DOUBLE_EQ(Archard{8e-14}({2e7, 0.5}), 8e-7);
  EXPECT_EQ(Archard{0.0}({2e7, 0.5}), 0.0);
}

TEST(Archard, HandsOnNaN) {
  EXPECT_TRUE(std::isnan(Archard{4e-14}({std::nan(""), 0.5})));
  EXPECT_TRUE(std::isnan(Archard{}({2e7, 0.5}))) << "a coefficient that was never given";
}

TEST(NoWear, IsNothing) { EXPECT_EQ(NoWear{}({1e9, 10.0}), 0.0); }

}  // namespace
}  // namespace gudgeon
