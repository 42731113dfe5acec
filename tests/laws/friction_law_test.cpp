// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Every friction law: odd in the slip, against it, bounded, continuous; and the limits of those without a bristle.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

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

// A law whose static and kinetic friction differ, and with some viscous friction.
template <class Law>
Law make_friction() {
  auto law = make_sample_law<Law>();
  if constexpr (requires { law.static_coefficient; }) law.static_coefficient = 0.2;
  if constexpr (requires { law.bristle_damping; }) law.bristle_damping = 3.0;
  return law;
}

// Deflections to try a bristle with: those it can have; none for a law without.
template <class Law>
std::vector<double> find_deflections(const Law& law) {
  if constexpr (Law::kHasBristle) {
    const double largest = find_bound(law, 0.0) / law.bristle_stiffness;
    return {-largest, -0.3 * largest, 0.0, 0.5 * largest, largest};
  }
  return {0.0};
}

template <class Law>
class FrictionFamily : public testing::Test {
 protected:
  Law law = make_friction<Law>();
};
TYPED_TEST_SUITE(FrictionFamily, AlternativesOf<AnyFriction>::Types);

TYPED_TEST(FrictionFamily, IsNothingAtRest) {
  EXPECT_EQ(this->law({0.0}).coefficient, 0.0);
  EXPECT_EQ(this->law({0.0}).bristle_rate, 0.0);
}

TYPED_TEST(FrictionFamily, IsOdd) {
  for (const double speed : kSpeeds) {
    for (const double deflection : find_deflections(this->law)) {
      const Friction forth = this->law({speed, deflection});
      const Friction back = this->law({-speed, -deflection});
      EXPECT_EQ(back.coefficient, -forth.coefficient) << speed << ' ' << deflection;
      EXPECT_EQ(back.bristle_rate, -forth.bristle_rate) << speed << ' ' << deflection;
    }
  }
}

TYPED_TEST(FrictionFamily, WithoutBristleHasTheSlipsSign) {
  if (this->law.kHasBristle) return;
  for (const double speed : kSpeeds) {
    EXPECT_GE(this->law({speed}).coefficient, 0.0) << speed;
    EXPECT_LE(this->law({-speed}).coefficient, 0.0) << speed;
    EXPECT_EQ(this->law({speed}).bristle_rate, 0.0);
  }
}

TYPED_TEST(FrictionFamily, WithoutBristleIsBoundedByItsCoefficients) {
  if (this->law.kHasBristle) return;
  if constexpr (requires { this->law.viscous_coefficient; }) this->law.viscous_coefficient = 0.3;
  for (const double speed : kSpeeds) {
    EXPECT_LE(this->law({speed}).coefficient, find_bound(this->law, speed) * (1.0 + 1e-15))
        << speed;  // rounding of a product
  }
}

// Finer and finer steps of the slip change friction less and less, also over a law's corners.
TYPED_TEST(FrictionFamily, IsContinuous) {
  for (const double step : {1e-6, 1e-8}) {
    double largest = 0.0;
    for (double speed = -5e-3; speed < 5e-3; speed += 0.731e-5) {
      const double change = this->law({speed + step}).coefficient - this->law({speed}).coefficient;
      largest = std::max(largest, std::abs(change));
    }
    // The steepest law here rises by 0.2 over a transition speed of 0.1 mm/s.
    EXPECT_LE(largest, 2.1e3 * step);
  }
}

TYPED_TEST(FrictionFamily, HandsOnNaNUnlessItIsNothing) {
  const bool rubs = find_bound(this->law, 1.0) > 0.0;
  const double nan = std::nan("");
  EXPECT_EQ(std::isnan(this->law({nan}).coefficient) || std::isnan(this->law({nan}).bristle_rate), rubs);
  EXPECT_EQ(std::isnan(this->law({0.1, nan}).coefficient), this->law.kHasBristle);
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

TEST(CoulombRamp, IsMadeOfStraightLines) {
  const CoulombRamp law{.kinetic_coefficient = 0.3, .dead_speed = 1e-3, .full_speed = 5e-3};
  EXPECT_EQ(law({0.9e-3}).coefficient, 0.0);
  EXPECT_EQ(law({1e-3}).coefficient, 0.0);
  EXPECT_NEAR(law({2e-3}).coefficient, 0.075, 1e-16);
  EXPECT_NEAR(law({-4e-3}).coefficient, -0.225, 1e-16);
  EXPECT_EQ(law({5e-3}).coefficient, 0.3);
  EXPECT_EQ(law({-7.0}).coefficient, -0.3);
  EXPECT_TRUE(law.find_conflict().empty());
  EXPECT_FALSE((CoulombRamp{0.3, 1e-3, 1e-3}.find_conflict().empty()));
}

TEST(Threlfall, HasItsLimits) {
  const Threlfall law{.kinetic_coefficient = 0.3, .transition_speed = 2e-3};
  EXPECT_DOUBLE_EQ(law({2e-3}).coefficient, 0.3 * (1.0 - std::exp(-3.0)));
  EXPECT_NEAR(law({-2e-3}).coefficient, -0.285, 1e-4) << "the 95 % of the literature";
  EXPECT_DOUBLE_EQ(law({1.0}).coefficient, 0.3);
  EXPECT_NEAR(law({2e-12}).coefficient, 0.9e-9, 1e-17);  // 3 μ_k v/v_t; the next term is 1.5e-9 of it
}

TEST(BengisuAkay, RisesToStaticFrictionAndDecaysToKinetic) {
  const BengisuAkay law{0.25, 0.15, 2e-3, 400.0};
  EXPECT_DOUBLE_EQ(law({1e-3}).coefficient, 0.25 * 0.75);
  EXPECT_DOUBLE_EQ(law({2e-3}).coefficient, 0.25);
  EXPECT_DOUBLE_EQ(law({-2e-3}).coefficient, -0.25);
  EXPECT_DOUBLE_EQ(law({4.5e-3}).coefficient, 0.15 + 0.10 * std::exp(-1.0));
  EXPECT_DOUBLE_EQ(law({1.0}).coefficient, 0.15);
  EXPECT_NEAR(law({2e-12}).coefficient, 0.5e-9, 1e-18);  // 2 μ_s v/v_t, less 5e-10 of it
  // Flat at the peak from below; its slope beyond is −ξ (μ_s − μ_k).
  EXPECT_NEAR((law({2e-3}).coefficient - law({2e-3 - 1e-8}).coefficient) / 1e-8, 0.0, 1e-3);
  EXPECT_NEAR((law({2e-3 + 1e-8}).coefficient - law({2e-3}).coefficient) / 1e-8, -40.0, 1e-3);
}

TEST(StribeckSmooth, FollowsTheRationalStribeckCurve) {
  const StribeckSmooth law{0.25, 0.15, 1e-2, 0.4, 1e-5};
  EXPECT_NEAR(law({1e-2}).coefficient, 0.20 + 0.004, 1e-15);
  EXPECT_NEAR(law({-3e-2}).coefficient, -0.16 - 0.012, 1e-15);
  EXPECT_NEAR(law({1e-13}).coefficient, 0.25e-8 + 0.4e-13, 1e-18);  // (μ_s/v_t + σ₂) v
  EXPECT_NEAR(law({50.0}).coefficient, 0.15 + 20.0, 1e-7);
  EXPECT_DOUBLE_EQ(law({1e-5}).coefficient, (0.15 + 0.1 / (1.0 + 1e-6)) * std::tanh(1.0) + 4e-6);
}

TEST(BrownMcPhee, PeaksAtTheTransitionSpeed) {
  const BrownMcPhee law{0.25, 0.15, 0.0, 2e-3};
  EXPECT_DOUBLE_EQ(law({2e-3}).coefficient, 0.15 * std::tanh(4.0) + 0.10);
  EXPECT_NEAR(law({2e-3}).coefficient, 0.25, 7e-4 * 0.15 + 1e-6);
  EXPECT_NEAR(law({1e-3}).coefficient, 0.15 * std::tanh(2.0) + 0.10 * 0.5 / (0.8125 * 0.8125), 1e-16);
  EXPECT_NEAR(law({2e-12}).coefficient, (0.6 + 1.6 / 9.0) * 1e-9, 1e-18);
  EXPECT_NEAR(law({2.0}).coefficient, 0.15 + 0.10 * 16.0 * 1e-9, 1e-14);  // 16 (μ_s − μ_k)/x³
  double largest = 0.0;
  for (double speed = 0.0; speed < 1e-2; speed += 1e-6) largest = std::max(largest, law({speed}).coefficient);
  EXPECT_LE(largest, 0.25);
  EXPECT_GT(largest, 0.2498);
  BrownMcPhee viscous = law;
  viscous.viscous_coefficient = 0.4;
  EXPECT_DOUBLE_EQ(viscous({-3e-3}).coefficient, law({-3e-3}).coefficient - 1.2e-3);
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
