// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Every normal force law: no contact no force, continuous, never pulls, dissipates; and values by hand.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "gudgeon/laws/normal/any.h"
#include "tests/laws/sample_law.h"

namespace gudgeon {
namespace {

constexpr double kStiffness = 9.664e10;
constexpr double kOnset = 0.05;
constexpr std::array kPenetrations{1e-9, 1e-7, 3e-6, 2e-5, 4e-4};
constexpr std::array kRates{-0.3, -0.05, -0.01, -1e-4, 0.0, 1e-4, 0.02, 0.05, 0.4};

double find_relative_radius(const NormalContact& contact) {
  return contact.bearing_radius * contact.journal_radius / (contact.bearing_radius - contact.journal_radius);
}

template <class Law>
class NormalForceFamily : public testing::Test {
 protected:
  [[nodiscard]] NormalContact make_contact(double penetration, double rate) const {
    return {penetration, rate, kOnset, kStiffness, law.damping_factor(), 15e-3, 14e-3, 20e-3, 1.1e11};
  }
  [[nodiscard]] NormalForce eval(double penetration, double rate) const { return law(make_contact(penetration, rate)); }
  /// Damped linearly: the force starts with a step, and materials and radii do not matter.
  static constexpr bool kIsLinear = std::same_as<Law, KelvinVoigt> || std::same_as<Law, Anagnostopoulos>;
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
    if (!this->kIsLinear) {
      EXPECT_LE(this->eval(1e-11, rate).force, 1.000001e-6 * full);
    }
    EXPECT_LE(this->eval(1e-11, rate).elastic_force, 1.000001e-6 * this->eval(1e-5, rate).elastic_force);
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
  EXPECT_TRUE(std::isnan(this->eval(1e-5, nan).force) || this->law.damping_factor() == 0.0);
  NormalContact contact = this->make_contact(1e-5, 0.01);
  contact.stiffness = contact.contact_modulus = nan;
  EXPECT_NE(std::isnan(this->law(contact).force), this->kIsLinear);
}

TYPED_TEST(NormalForceFamily, DissipatesOverAClosedCycle) {
  // In and out again along δ = δ₁ (1 − cos φ)/2.
  constexpr int kSteps = 400;
  constexpr double kDepth = 5e-5;
  double work = 0.0;
  for (int i = 0; i < kSteps; ++i) {
    const double phase = 2.0 * std::numbers::pi * (i + 0.5) / kSteps;
    const double slope = 0.5 * kDepth * std::sin(phase);
    work += this->eval(0.5 * kDepth * (1.0 - std::cos(phase)), kOnset * std::sin(phase)).force * slope;
  }
  work *= 2.0 * std::numbers::pi / kSteps;
  const double stored = this->eval(kDepth, 0.0).elastic_energy;
  const bool damped = this->eval(kDepth, kOnset).force > this->eval(kDepth, 0.0).force;
  if (damped) {
    EXPECT_GT(work, 1e-3 * stored);
  } else {
    EXPECT_NEAR(work, 0.0, 1e-12 * stored);  // equal and opposite to rounding
  }
}

TYPED_TEST(NormalForceFamily, TellsHowItsEnergyDependsOnTheRadii) {
  constexpr double kStep = 1e-6;
  for (const double penetration : kPenetrations) {
    const NormalContact contact = this->make_contact(penetration, 0.0);
    const auto energy_at = [&](double bearing_radius, double journal_radius) {
      NormalContact moved = contact;
      moved.bearing_radius = bearing_radius;
      moved.journal_radius = journal_radius;
      moved.stiffness *= std::sqrt(find_relative_radius(moved) / find_relative_radius(contact));
      return this->law(moved).elastic_energy;
    };
    const NormalForce force = this->law(contact);
    const double r_i = contact.bearing_radius;
    const double r_j = contact.journal_radius;
    const double step = kStep * (r_i - r_j);
    const double by_bearing = (energy_at(r_i + step, r_j) - energy_at(r_i - step, r_j)) / (2.0 * step);
    const double by_journal = (energy_at(r_i, r_j + step) - energy_at(r_i, r_j - step)) / (2.0 * step);
    // ln R_r = ln R_i + ln R_j − ln ΔR
    const double radius = force.energy_by_radius;
    const double clearance = force.energy_by_clearance - radius;
    const double tolerance = 1e-8 * force.elastic_energy / (r_i - r_j);  // rounding over the step, 1e-16/1e-6
    EXPECT_NEAR(by_bearing, radius / r_i + clearance / (r_i - r_j), tolerance) << penetration;
    EXPECT_NEAR(by_journal, radius / r_j - clearance / (r_i - r_j), tolerance) << penetration;
  }
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

TEST(KelvinVoigt, HasItsValue) {
  const KelvinVoigt law{.stiffness = 2e5, .damping = 300.0};
  EXPECT_DOUBLE_EQ(law({0.01, 2.0, 0.1, 1.0}).force, 2600.0);
  EXPECT_DOUBLE_EQ(law({0.01, 2.0, 0.1, 1.0}).elastic_energy, 10.0);
  EXPECT_EQ(law({0.01, -7.0, 0.1, 1.0}).force, 0.0) << "2000 − 2100 would pull";
}

TEST(Anagnostopoulos, HasItsValue) {
  // ln e = −π: ξ = 1/√2; 2ξ√(k m) = √2 · 1000.
  const Anagnostopoulos law{.stiffness = 5e5, .effective_mass = 2.0, .restitution = std::exp(-std::numbers::pi)};
  EXPECT_NEAR(law.damping_ratio(), std::numbers::sqrt2 / 2.0, 1e-15);
  EXPECT_NEAR(law({0.01, 1.0, 0.1, 1.0}).force, 5000.0 + 1000.0 * std::numbers::sqrt2, 1e-11);
  EXPECT_NEAR(law.delivered_restitution(), std::exp(-0.5 * std::numbers::pi), 1e-15);
  EXPECT_EQ((Anagnostopoulos{1e5, 1.0, 1.0}.delivered_restitution()), 1.0);
}

TEST(LankaraniNikravesh, HandsOnANaNRate) {
  EXPECT_TRUE(std::isnan(LankaraniNikravesh{}({1e-5, std::numeric_limits<double>::quiet_NaN(), kOnset, 1e9}).force));
}

}  // namespace
}  // namespace gudgeon
