// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Every normal force law: no contact no force, continuous, never pulls, dissipates; and values by hand.
#include <gtest/gtest.h>

#include <array>
#include <limits>

#include "gudgeon/laws/normal/any.h"
#include "tests/laws/sample_law.h"

namespace gudgeon {
namespace {

constexpr double kStiffness = 9.664e10;
constexpr double kOnset = 0.05;
constexpr std::array kPenetrations{1e-9, 1e-7, 3e-6, 2e-5, 4e-4};
constexpr std::array kRates{-0.3, -0.05, -0.01, -1e-4, 0.0, 1e-4, 0.02, 0.05, 0.4};

template <class Law>
class NormalForceFamily : public testing::Test {
 protected:
  [[nodiscard]] NormalForce eval(double penetration, double rate) const {
    return law({penetration, rate, kOnset, kStiffness, law.damping_factor()});
  }
  Law law = make_sample_law<Law>();
};
TYPED_TEST_SUITE(NormalForceFamily, AlternativesOf<AnyNormalForce>::Types);

TYPED_TEST(NormalForceFamily, HasNoForceWithoutPenetration) {
  for (const double penetration : {0.0, -0.0, -1e-12, -3e-4}) {
    for (const double rate : kRates) {
      const NormalForce force = this->eval(penetration, rate);
      EXPECT_EQ(force.force, 0.0);
      EXPECT_EQ(force.elastic_force, 0.0);
      EXPECT_EQ(force.elastic_energy, 0.0);
    }
  }
}

TYPED_TEST(NormalForceFamily, StartsAndGoesOnWithoutAStep) {
  for (const double rate : kRates) {
    const double full = this->eval(1e-5, rate).force;
    // At a millionth of a penetration a force that grows at least linearly is at most a millionth.
    EXPECT_LE(this->eval(1e-11, rate).force, 1.000001e-6 * full);
    for (const double penetration : kPenetrations) {
      const double below = this->eval(penetration * (1.0 - 1e-9), rate).force;
      const double above = this->eval(penetration * (1.0 + 1e-9), rate).force;
      // Relative slope of a power below 3 and of a rate below 10 times the onset speed.
      EXPECT_NEAR(above, below, 1e-8 * this->eval(penetration, std::abs(rate)).force);
    }
  }
}

TYPED_TEST(NormalForceFamily, NeverPulls) {
  for (const double penetration : kPenetrations) {
    for (const double rate : {-1e3, -10.0, -1.0, -0.1}) EXPECT_GE(this->eval(penetration, rate).force, 0.0);
  }
}

TYPED_TEST(NormalForceFamily, Dissipates) {
  for (const double penetration : kPenetrations) {
    for (const double rate : kRates) {
      const NormalForce force = this->eval(penetration, rate);
      if (rate >= 0.0) {
        EXPECT_GE(force.force, force.elastic_force);
      }
      if (rate <= 0.0) {
        EXPECT_LE(force.force, force.elastic_force);
      }
      EXPECT_EQ(force.elastic_force, this->eval(penetration, 0.0).elastic_force) << "the elastic part feels no rate";
    }
    EXPECT_EQ(this->eval(penetration, 0.0).force, this->eval(penetration, 0.0).elastic_force);
  }
}

TYPED_TEST(NormalForceFamily, StoresTheWorkOfItsElasticForce) {
  for (const double penetration : kPenetrations) {
    const double step = 1e-5 * penetration;
    const double slope =
        (this->eval(penetration + step, 0.0).elastic_energy - this->eval(penetration - step, 0.0).elastic_energy) /
        (2.0 * step);
    const double force = this->eval(penetration, 0.0).elastic_force;
    EXPECT_NEAR(slope, force, 1e-9 * force);  // step squared, and rounding over the step
  }
}

TYPED_TEST(NormalForceFamily, GrowsWithPenetrationAtRest) {
  double before = 0.0;
  for (const double penetration : kPenetrations) {
    const double force = this->eval(penetration, 0.0).force;
    EXPECT_GT(force, before);
    before = force;
  }
}

TYPED_TEST(NormalForceFamily, HandsOnNaN) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(std::isnan(this->eval(nan, 0.01).force));
  EXPECT_TRUE(std::isnan(this->eval(nan, 0.01).elastic_energy));
  EXPECT_TRUE(std::isnan(this->law({1e-5, 0.01, kOnset, nan, this->law.damping_factor()}).force));
}

TEST(Hertz, HasItsValue) {
  // 1e6 · 0.04^1.5 = 8000 N, times 0.04/2.5 = 128 J.
  const NormalForce force = Hertz{}({0.04, -7.0, 0.1, 1e6});
  EXPECT_DOUBLE_EQ(force.force, 8000.0);
  EXPECT_DOUBLE_EQ(force.elastic_force, 8000.0);
  EXPECT_DOUBLE_EQ(force.elastic_energy, 128.0);
}

TEST(Hertz, UsesItsExponent) {
  // 2e5 · 0.1² = 2000 N, times 0.1/3 J; and a linear spring of 500 N/m.
  EXPECT_DOUBLE_EQ(Hertz{2.0}({0.1, 0.0, 0.1, 2e5}).force, 2000.0);
  EXPECT_DOUBLE_EQ(Hertz{2.0}({0.1, 0.0, 0.1, 2e5}).elastic_energy, 200.0 / 3.0);
  EXPECT_DOUBLE_EQ(Hertz{1.0}({0.1, 0.0, 0.1, 500.0}).force, 50.0);
  EXPECT_DOUBLE_EQ(Hertz{1.0}({0.1, 0.0, 0.1, 500.0}).elastic_energy, 2.5);
  // Just beside the shortcut for 1.5: the exponent's change times ln δ.
  EXPECT_NEAR(Hertz{1.5 + 1e-12}({0.04, 0.0, 0.1, 1e6}).force, 8000.0, 1e-7);
}

TEST(LankaraniNikravesh, HasItsValue) {
  // χ = 0.75 (1 − 0.25) = 0.5625; δ̇/δ̇₀ = 2 and −1: 8000 (1 ± …).
  const LankaraniNikravesh law{.restitution = 0.5, .exponent = 1.5};
  EXPECT_DOUBLE_EQ(law({0.04, 0.2, 0.1, 1e6, law.damping_factor()}).force, 8000.0 * 2.125);
  EXPECT_DOUBLE_EQ(law({0.04, -0.1, 0.1, 1e6, law.damping_factor()}).force, 8000.0 * 0.4375);
  EXPECT_DOUBLE_EQ(law({0.04, -0.1, 0.1, 1e6, law.damping_factor()}).elastic_force, 8000.0);
  EXPECT_EQ(law({0.04, -0.2, 0.1, 1e6, law.damping_factor()}).force, 0.0) << "1 − 1.125 would pull";
}

TEST(LankaraniNikravesh, OfFullRestitutionIsHertz) {
  const LankaraniNikravesh law{.restitution = 1.0, .exponent = 1.5};
  for (const double rate : kRates) {
    EXPECT_EQ(law({2e-5, rate, kOnset, kStiffness, law.damping_factor()}).force,
              Hertz{}({2e-5, rate, kOnset, kStiffness}).force);
  }
}

TEST(LankaraniNikravesh, HandsOnANaNRate) {
  EXPECT_TRUE(std::isnan(LankaraniNikravesh{}({1e-5, std::numeric_limits<double>::quiet_NaN(), kOnset, 1e9}).force));
}

}  // namespace
}  // namespace gudgeon
