// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Every friction law: odd in the slip, against it, bounded; and each law's limits.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "gudgeon/laws/friction/any.h"
#include "tests/laws/sample_law.h"

namespace gudgeon {
namespace {

constexpr std::array kSpeeds{1e-12, 1e-6, 1e-4, 7e-4, 1e-3, 3e-3, 0.1, 2.0, 50.0};

// Largest coefficient that a law can reach at a slip speed, from whichever parameters it has.
template <class Law>
double find_bound(const Law& law, double speed) {
  double bound = 0.0;
  if constexpr (requires { law.kinetic_coefficient; }) bound = law.kinetic_coefficient;
  if constexpr (requires { law.static_coefficient; }) bound = std::max(bound, law.static_coefficient);
  if constexpr (requires { law.viscous_coefficient; }) bound += law.viscous_coefficient * speed;
  return bound;
}

template <class Law>
class FrictionFamily : public testing::Test {
 protected:
  Law law = make_sample_law<Law>();
};
TYPED_TEST_SUITE(FrictionFamily, AlternativesOf<AnyFriction>::Types);

TYPED_TEST(FrictionFamily, IsOddInTheSlip) {
  EXPECT_EQ(this->law({0.0}).coefficient, 0.0);
  for (const double speed : kSpeeds)
    EXPECT_EQ(this->law({-speed}).coefficient, -this->law({speed}).coefficient) << speed;
}

TYPED_TEST(FrictionFamily, HasTheSlipsSign) {
  for (const double speed : kSpeeds) {
    EXPECT_GE(this->law({speed}).coefficient, 0.0) << speed;
    EXPECT_LE(this->law({-speed}).coefficient, 0.0) << speed;
  }
}

TYPED_TEST(FrictionFamily, IsBoundedByItsCoefficients) {
  if constexpr (requires { this->law.viscous_coefficient; }) this->law.viscous_coefficient = 0.3;
  for (const double speed : kSpeeds) {
    EXPECT_LE(this->law({speed}).coefficient, find_bound(this->law, speed) * (1.0 + 1e-15))
        << speed;  // rounding of a product
  }
}

TYPED_TEST(FrictionFamily, HandsOnNaNUnlessItIsNothing) {
  const bool rubs = find_bound(this->law, 1.0) > 0.0;
  EXPECT_EQ(std::isnan(this->law({std::nan("")}).coefficient), rubs);
}

TEST(Frictionless, IsNothingAtAnySpeed) {
  for (const double speed : kSpeeds) EXPECT_EQ(Frictionless{}({speed}).coefficient, 0.0);
}

TEST(CoulombSmooth, HasItsLimits) {
  const CoulombSmooth law{.kinetic_coefficient = 0.3, .transition_speed = 2e-3};
  EXPECT_DOUBLE_EQ(law({2e-3}).coefficient, 0.3 * std::tanh(1.0));
  EXPECT_DOUBLE_EQ(law({5.0}).coefficient, 0.3);
  EXPECT_DOUBLE_EQ(law({-5.0}).coefficient, -0.3);
  EXPECT_NEAR(law({1e-9}).coefficient, 0.3 * 1e-9 / 2e-3, 1e-19);  // tanh x = x − x³/3, x = 5e-7
}

LugreSteady make_paper_friction() {
  LugreSteady law;
  law.static_coefficient = 0.15;
  law.kinetic_coefficient = 0.10;
  return law;
}

TEST(LugreSteady, FollowsTheStribeckCurve) {
  const LugreSteady law = make_paper_friction();  // v_s = 1 mm/s, γ = 2, v_t = 0.1 mm/s
  // Ten transition speeds away tanh differs from 1 by 4e-9.
  EXPECT_NEAR(law({1e-3}).coefficient, 0.10 + 0.05 * std::exp(-1.0), 1e-9);
  EXPECT_NEAR(law({2e-3}).coefficient, 0.10 + 0.05 * std::exp(-4.0), 1e-9);
  EXPECT_NEAR(law({-2e-3}).coefficient, -0.10 - 0.05 * std::exp(-4.0), 1e-9);
  EXPECT_DOUBLE_EQ(law({1.0}).coefficient, 0.10);
  EXPECT_NEAR(law({1e-10}).coefficient, 0.15e-6, 1e-15);  // μ_s v/v_t
  EXPECT_DOUBLE_EQ(law({5e-4}).coefficient, (0.10 + 0.05 * std::exp(-0.25)) * std::tanh(5.0));
}

TEST(LugreSteady, UsesItsDecayExponent) {
  LugreSteady law = make_paper_friction();
  law.decay_exponent = 0.5;
  EXPECT_NEAR(law({4e-3}).coefficient, 0.10 + 0.05 * std::exp(-2.0), 1e-15);
  EXPECT_NEAR(law({-4e-3}).coefficient, -law({4e-3}).coefficient, 0.0);
  // Just beside the shortcut for 2: the exponent's change hardly shows.
  law.decay_exponent = 2.0 + 1e-12;
  EXPECT_NEAR(law({1.5e-3}).coefficient, make_paper_friction()({1.5e-3}).coefficient, 1e-12);
}

TEST(LugreSteady, AddsViscousFriction) {
  LugreSteady law = make_paper_friction();
  law.viscous_coefficient = 0.4;
  EXPECT_DOUBLE_EQ(law({3.0}).coefficient, 0.10 + 1.2);
  EXPECT_DOUBLE_EQ(law({-3.0}).coefficient, -0.10 - 1.2);
}

}  // namespace
}  // namespace gudgeon
