// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// The friction laws with a bristle: held like a spring, yielding to their steady friction, and dissipating.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "gudgeon/laws/friction/any.h"

namespace gudgeon {
namespace {

Lugre make_lugre() {
  Lugre law;
  law.static_coefficient = 0.15;
  law.kinetic_coefficient = 0.10;
  law.bristle_damping = 2.0;
  law.viscous_coefficient = 1.0;  // σ₁ (μ_s − μ_k)/μ_k: just enough
  return law;
}

/// A bristle and the work that its friction took [m per normal force], moved at given slip speeds.
template <class Law>
struct Bristle {
  Law law;
  double deflection = 0.0;
  double work = 0.0;

  // Runge-Kutta of order 4 over constant speed, fifty steps a relaxation, so that its error does not show.
  void slip(double speed, double distance) {
    const int n = 1 + static_cast<int>(50.0 * distance * law.bristle_stiffness / law.kinetic_coefficient);
    const double h = distance / (std::abs(speed) * n);
    for (int k = 0; k < n; ++k) {
      const Friction a = law({speed, deflection});
      const Friction b = law({speed, deflection + 0.5 * h * a.bristle_rate});
      const Friction c = law({speed, deflection + 0.5 * h * b.bristle_rate});
      const Friction d = law({speed, deflection + h * c.bristle_rate});
      deflection += h / 6.0 * (a.bristle_rate + 2.0 * (b.bristle_rate + c.bristle_rate) + d.bristle_rate);
      work += h / 6.0 * speed * (a.coefficient + 2.0 * (b.coefficient + c.coefficient) + d.coefficient);
    }
  }
  [[nodiscard]] double stored() const { return 0.5 * law.bristle_stiffness * deflection * deflection; }
};

/// The work that any motion at random speeds, to and fro, takes beyond what the bristle stores; the least of all times.
template <class Law>
double find_least_dissipation(const Law& law, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  Bristle<Law> bristle{law};
  double least = 0.0;
  for (int k = 0; k < 400; ++k) {
    const double speed = std::pow(10.0, -6.0 + 7.0 * unit(random)) * (unit(random) < 0.5 ? -1.0 : 1.0);
    const double before = bristle.work - bristle.stored();
    bristle.slip(speed, 3.0 * unit(random) * 0.15 / law.bristle_stiffness);
    least = std::min(least, bristle.work - bristle.stored() - before);
  }
  return least;
}

// A slip that goes slowly, then fast, round and round, once the bristle repeats itself.
double find_loop_work(const Lugre& law, double slow, double fast) {
  Bristle<Lugre> bristle{law};
  double work = 0.0;
  for (int turn = 0; turn < 4; ++turn) {
    const double before = bristle.work;
    for (const double direction : {1.0, -1.0}) {
      bristle.slip(direction * slow, 8.0 * 0.15 / law.bristle_stiffness);
      bristle.slip(direction * fast, 8.0 * 0.15 / law.bristle_stiffness);
    }
    work = bristle.work - before;
  }
  return work;
}

TEST(Dahl, HoldsLikeASpringBeforeItSlips) {
  const Dahl law{0.2, 1e5, 1.0};
  EXPECT_DOUBLE_EQ(law({0.3, 0.0}).bristle_rate, 0.3);
  EXPECT_DOUBLE_EQ(law({-0.3, 0.0}).bristle_rate, -0.3);
  EXPECT_DOUBLE_EQ(law({0.0, 1e-6}).coefficient, 0.1);
  EXPECT_EQ(law({0.0, 1e-6}).bristle_rate, 0.0) << "no creep";
}

TEST(Dahl, YieldsAtKineticFriction) {
  for (const double exponent : {0.5, 1.0, 2.0}) {
    const Dahl law{0.25, 65536.0, exponent};  // their quotient is exact
    const double limit = 0.25 / 65536.0;
    EXPECT_EQ(law({0.3, limit}).bristle_rate, 0.0);
    EXPECT_EQ(law({-0.3, -limit}).bristle_rate, 0.0);
    // Half-way: 0.5^i when it bends further, 1.5^i when it springs back.
    EXPECT_NEAR(law({0.3, 0.5 * limit}).bristle_rate, 0.3 * std::pow(0.5, exponent), 1e-15);
    EXPECT_NEAR(law({-0.3, 0.5 * limit}).bristle_rate, -0.3 * std::pow(1.5, exponent), 1e-15);
    // Pushed beyond its limit it comes back.
    EXPECT_LT(law({0.3, 1.1 * limit}).bristle_rate, 0.0);
  }
}

// dz/ds = 1 − σ₀ z/μ_k for i = 1 and (1 − σ₀ z/μ_k)² for i = 2, whatever the speed.
TEST(Dahl, FollowsItsClosedFormOverTheSlip) {
  const double scale = 0.2 / 1e5;
  for (const double speed : {1e-6, 0.2, 30.0}) {
    Bristle<Dahl> linear{Dahl{0.2, 1e5, 1.0}};
    linear.slip(speed, 1.7 * scale);
    EXPECT_NEAR(linear.deflection / scale, 1.0 - std::exp(-1.7), 1e-9);  // steps of a fiftieth, order 4
    Bristle<Dahl> square{Dahl{0.2, 1e5, 2.0}};
    square.slip(-speed, 1.7 * scale);
    EXPECT_NEAR(square.deflection / scale, -1.7 / 2.7, 1e-8);
  }
}

TEST(Dahl, AlwaysDissipates) {
  for (const double exponent : {1.0, 1.5, 3.0}) {
    // The work of one slip is some 1e-7 m; what is missing is the integration's.
    EXPECT_GE(find_least_dissipation(Dahl{0.15, 1e5, exponent}, 3), -1e-14) << exponent;
  }
}

TEST(Lugre, HoldsLikeADampedSpringBeforeItSlips) {
  const Lugre law = make_lugre();
  const Friction friction = law({1e-9, 1e-7});
  EXPECT_NEAR(friction.coefficient, 1e5 * 1e-7 + 2.0 * friction.bristle_rate + 1.0 * 1e-9, 1e-16);
  EXPECT_NEAR(friction.bristle_rate, 1e-9 * (1.0 - 1e5 * 1e-7 / 0.15), 1e-20);
  EXPECT_EQ(law({0.0, 1e-6}).bristle_rate, 0.0) << "no creep";
  EXPECT_DOUBLE_EQ(law({0.0, 1e-6}).coefficient, 0.1);
}

// In steady slip it is lugre_steady, where the latter's tanh has come to 1.
TEST(Lugre, IsLugreSteadyInTheSteadyState) {
  for (const double exponent : {0.7, 2.0}) {
    Lugre law = make_lugre();
    law.decay_exponent = exponent;
    LugreSteady steady{0.15, 0.10, 1e-3, exponent, 1.0, 1e-6};
    for (const double speed : {3e-5, 4e-4, 1e-3, 2e-3, 0.1, 5.0}) {
      for (const double sign : {1.0, -1.0}) {
        const double deflection = law.find_relaxation(sign * speed).steady_deflection;
        const Friction friction = law({sign * speed, deflection});
        EXPECT_NEAR(friction.bristle_rate, 0.0, 4e-16 * speed);
        EXPECT_DOUBLE_EQ(friction.coefficient, steady({sign * speed}).coefficient) << sign * speed;
      }
    }
  }
}

TEST(Lugre, RelaxesExponentiallyAtConstantSpeed) {
  const Lugre law = make_lugre();
  for (const double speed : {2e-4, -1e-3, 0.5}) {
    const auto [rate, steady_deflection] = law.find_relaxation(speed);
    EXPECT_DOUBLE_EQ(steady_deflection, speed / rate);
    Bristle<Lugre> bristle{law, 4e-7};
    const double time = 1.3 / rate;
    bristle.slip(speed, std::abs(speed) * time);
    const double expected = steady_deflection + (4e-7 - steady_deflection) * std::exp(-rate * time);
    EXPECT_NEAR(bristle.deflection / expected, 1.0, 1e-8) << speed;  // steps of a fiftieth, order 4
  }
  EXPECT_EQ(law.find_relaxation(0.0).rate, 0.0);
}

// Energy that was never put in cannot come out: with σ₂ at the bound, for any slip.
TEST(Lugre, DissipatesWithEnoughViscousFriction) {
  for (const unsigned seed : {1U, 2U, 3U}) EXPECT_GE(find_least_dissipation(make_lugre(), seed), -1e-14) << seed;
  for (const double fast : {0.01, 0.3, 3.0, 30.0}) EXPECT_GT(find_loop_work(make_lugre(), 1e-5, fast), 0.0) << fast;
}

// Below the bound it need not: a bristle bent in slow slip gives way at once in fast slip and pushes by σ₁ ż.
TEST(Lugre, CanPushWithTooLittleViscousFriction) {
  Lugre law = make_lugre();
  law.viscous_coefficient = 0.0;
  EXPECT_GT(find_loop_work(law, 1e-5, 0.01), 0.0);
  EXPECT_LT(find_loop_work(law, 1e-5, 30.0), 0.0);
  EXPECT_LT(find_least_dissipation(law, 1), -1e-9);
}

// Without damping and with one level of friction it is Dahl's.
TEST(Lugre, ContainsDahl) {
  Lugre law;
  law.static_coefficient = law.kinetic_coefficient = 0.2;
  const Dahl dahl{0.2, 1e5, 1.0};
  for (const double speed : {-3.0, -1e-4, 1e-7, 0.5}) {
    for (const double deflection : {-2e-6, 0.0, 7e-7}) {
      EXPECT_DOUBLE_EQ(law({speed, deflection}).coefficient, dahl({speed, deflection}).coefficient);
      EXPECT_NEAR(law({speed, deflection}).bristle_rate, dahl({speed, deflection}).bristle_rate,
                  4e-16 * std::abs(speed));
    }
  }
}

}  // namespace
}  // namespace gudgeon
