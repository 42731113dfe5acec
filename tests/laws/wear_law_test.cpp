// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Every wear law: nothing without load or slip, never negative, in proportion to the pressure; each law's values.
#include <gtest/gtest.h>

#include <cmath>

#include "gudgeon/laws/wear/any.h"
#include "tests/laws/sample_law.h"

namespace gudgeon {
namespace {

// Pressure, slip, friction, depth and distance of a joint at work.
constexpr WearContact kAtWork{2e7, 0.5, 0.15, 3e-6, 40.0};

// A law whose coefficients differ.
template <class Law>
Law make_wear() {
  auto law = make_sample_law<Law>();
  if constexpr (requires { law.initial_coefficient; }) law.initial_coefficient = 0.4;
  return law;
}

template <class Law>
class WearFamily : public testing::Test {
 protected:
  Law law = make_wear<Law>();
};
TYPED_TEST_SUITE(WearFamily, AlternativesOf<AnyWear>::Types);

TYPED_TEST(WearFamily, NeedsLoadAndSlip) {
  EXPECT_EQ(this->law({0.0, 0.3, 0.1, 1e-6, 2.0}), 0.0);
  EXPECT_EQ(this->law({2e7, 0.0, 0.1, 1e-6, 2.0}), 0.0);
}

TYPED_TEST(WearFamily, NeverAddsMaterialAndNeverFallsWithLoadOrSlip) {
  for (const double pressure : {1e3, 1e6, 4e8}) {
    for (const double speed : {1e-6, 1e-2, 3.0}) {
      for (const double worn : {0.0, 1e-7, 0.1, 1e3}) {
        const double rate = this->law({pressure, speed, 0.1, worn, worn});
        EXPECT_GE(rate, 0.0);
        EXPECT_DOUBLE_EQ(this->law({2.5 * pressure, speed, 0.1, worn, worn}), 2.5 * rate) << "proportional to pressure";
        EXPECT_DOUBLE_EQ(this->law({pressure, 2.5 * speed, 0.1, worn, worn}), 2.5 * rate);
      }
    }
  }
}

TYPED_TEST(WearFamily, WearsAtWorkUnlessItIsNothing) {
  EXPECT_EQ(this->law(kAtWork) > 0.0, (!std::is_same_v<TypeParam, NoWear>));
}

// Two surfaces that share a law's wear lose together what it says.
TYPED_TEST(WearFamily, SharesAddUp) {
  for (const double share : {0.0, 0.3, 1.0}) {
    const double one = this->law.share_of(share)(kAtWork);
    EXPECT_NEAR(one, share * this->law(kAtWork), 1e-15 * this->law(kAtWork));
    EXPECT_NEAR(one + this->law.share_of(1.0 - share)(kAtWork), this->law(kAtWork), 1e-15 * this->law(kAtWork));
  }
}

TYPED_TEST(WearFamily, HandsOnNaNUnlessItIsNothing) {
  const bool wears = !std::is_same_v<TypeParam, NoWear>;
  const double nan = std::nan("");
  EXPECT_EQ(std::isnan(this->law({nan, 0.5, 0.1})), wears);
  EXPECT_EQ(std::isnan(this->law({2e7, nan, 0.1})), wears);
  EXPECT_EQ(std::isnan(TypeParam{}({2e7, 0.5, 0.1})), wears) << "a coefficient that was never given";
}

TEST(Archard, IsLinearInPressureSlipAndCoefficient) {
  // 4e-14 1/Pa · 2e7 Pa · 0.5 m/s = 4e-7 m/s
  EXPECT_DOUBLE_EQ(Archard{4e-14}({2e7, 0.5}), 4e-7);
  EXPECT_DOUBLE_EQ(Archard{4e-14}({6e7, 0.5}), 12e-7);
  EXPECT_DOUBLE_EQ(Archard{4e-14}({2e7, 1.0}), 8e-7);
  EXPECT_DOUBLE_EQ(Archard{8e-14}({2e7, 0.5}), 8e-7);
  EXPECT_EQ(Archard{0.0}({2e7, 0.5}), 0.0);
}

TEST(ArchardHardness, IsArchardByHardness) {
  // 1e-4 · 2e7 Pa · 0.5 m/s / 2.5 GPa = 4e-7 m/s
  EXPECT_DOUBLE_EQ((ArchardHardness{1e-4, 2.5e9}({2e7, 0.5})), 4e-7);
  EXPECT_DOUBLE_EQ((ArchardHardness{1e-4, 5e9}({2e7, 0.5})), 2e-7) << "a harder surface wears less";
  EXPECT_DOUBLE_EQ((ArchardHardness{1e-4, 2.5e9}.share_of(0.25).hardness), 2.5e9);
}

TEST(RunningInDepth, GoesFromItsInitialToItsSteadyCoefficient) {
  const RunningInDepth law{9e-14, 4e-14, 2e-6};
  EXPECT_DOUBLE_EQ(law({2e7, 0.5}), 9e-7);
  EXPECT_NEAR(law({2e7, 0.5, 0.0, 2e-6}), (4.0 + 5.0 * std::exp(-1.0)) * 1e-7, 1e-21);
  EXPECT_DOUBLE_EQ(law({2e7, 0.5, 0.0, 2e-4}), 4e-7);
  EXPECT_DOUBLE_EQ(law({2e7, 0.5, 0.0, 0.0, 1e6}), 9e-7) << "whatever the distance";
  EXPECT_EQ(law.share_of(0.5).running_in_depth, 2e-6);
}

TEST(RunningInDistance, GoesFromItsInitialToItsSteadyCoefficient) {
  const RunningInDistance law{9e-14, 4e-14, 50.0};
  EXPECT_DOUBLE_EQ(law({2e7, 0.5}), 9e-7);
  EXPECT_NEAR(law({2e7, 0.5, 0.0, 0.0, 50.0}), (4.0 + 5.0 * std::exp(-1.0)) * 1e-7, 1e-21);
  EXPECT_DOUBLE_EQ(law({2e7, 0.5, 0.0, 0.0, 5000.0}), 4e-7);
  EXPECT_DOUBLE_EQ(law({2e7, 0.5, 0.0, 1.0, 0.0}), 9e-7) << "whatever the depth";
  // A surface may also run in to wear more.
  EXPECT_GT((RunningInDistance{4e-14, 9e-14, 50.0}({2e7, 0.5, 0.0, 0.0, 50.0})), 4e-7);
}

TEST(EnergyWear, IsProportionalToTheFrictionPower) {
  // 3e-13 m^3/J · 0.2 · 2e7 Pa · 0.5 m/s = 6e-7 m/s
  EXPECT_DOUBLE_EQ(EnergyWear{3e-13}({2e7, 0.5, 0.2}), 6e-7);
  EXPECT_DOUBLE_EQ(EnergyWear{3e-13}({2e7, 0.5, 0.4}), 12e-7);
  EXPECT_EQ(EnergyWear{3e-13}({2e7, 0.5, 0.0}), 0.0) << "no friction, no wear";
}

TEST(NoWear, IsNothing) { EXPECT_EQ(NoWear{}({1e9, 10.0}), 0.0); }

}  // namespace
}  // namespace gudgeon
