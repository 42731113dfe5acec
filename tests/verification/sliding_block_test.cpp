// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// A block on a level floor slides to rest under each friction law: v̇ = −g μ(v). Time and distance down to a lower speed
// are compared with closed forms, t = ∫ dv/(g μ) and x = ∫ v dv/(g μ), worked out from the formula on paper; where
// there is none, with a quadrature of the formula written out here. The law is integrated by Boost's Dormand-Prince
// stepper.
#include <gtest/gtest.h>

#include <array>
#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <boost/numeric/odeint.hpp>
#include <cmath>

#include "gudgeon/laws/friction/any.h"

namespace gudgeon {
namespace {

namespace odeint = boost::numeric::odeint;

constexpr double kGravity = 9.81;
constexpr double kMuS = 0.25;
constexpr double kMuK = 0.15;

// Local errors of 1e-13 add up to some 1e-11 over the steps of a slide.
constexpr double kShare = 1e-9;

struct Slide {
  double time = 0.0;
  double distance = 0.0;
};

/// Time and distance from one speed down to another. Speed is the independent variable: t and x are integrated over it,
/// so that the slide ends exactly where it should.
template <class Law>
Slide slide(const Law& law, double from, double to) {
  using Pair = std::array<double, 2>;
  const auto slope = [&](const Pair&, Pair& rate, double lost) {
    const double v = from - lost;
    const double deceleration = kGravity * law({v}).coefficient;
    rate = {1.0 / deceleration, v / deceleration};
  };
  Pair y{};
  auto stepper = odeint::make_controlled(1e-13, 1e-13, odeint::runge_kutta_dopri5<Pair>());
  odeint::integrate_adaptive(stepper, slope, y, 0.0, from - to, 1e-3 * (from - to));
  return {y[0], y[1]};
}

/// The speed left after a time, integrated over time as an engine does.
template <class Law>
double find_speed(const Law& law, double from, double time) {
  using One = std::array<double, 1>;
  const auto slope = [&](const One& v, One& rate, double) { rate = {-kGravity * law({v[0]}).coefficient}; };
  One v{from};
  auto stepper = odeint::make_controlled(1e-14, 1e-13, odeint::runge_kutta_dopri5<One>());
  odeint::integrate_adaptive(stepper, slope, v, 0.0, time, 1e-4 * time);
  return v[0];
}

void expect_slide(const Slide& ours, const Slide& exact) {
  EXPECT_NEAR(ours.time / exact.time, 1.0, kShare);
  EXPECT_NEAR(ours.distance / exact.distance, 1.0, kShare);
}

TEST(SlidingBlock, FrictionlessKeepsItsSpeed) { EXPECT_EQ(find_speed(Frictionless{}, 0.7, 3.0), 0.7); }

// sinh(v/v_t) falls exponentially.
TEST(SlidingBlock, CoulombSmooth) {
  const CoulombSmooth law{kMuK, 0.05};
  const auto exact = [](double t) {
    return 0.05 * std::asinh(std::sinh(0.4 / 0.05) * std::exp(-kMuK * kGravity * t / 0.05));
  };
  // Down to 0.1 mm/s; slower ones come near the integration's absolute tolerance.
  for (const double t : {0.1, 0.25, 0.3, 0.4}) EXPECT_NEAR(find_speed(law, 0.4, t) / exact(t), 1.0, kShare) << t;
}

// Uniformly slowed down to v₁, exponentially towards v₀ from there.
TEST(SlidingBlock, CoulombRamp) {
  const CoulombRamp law{kMuK, 0.02, 0.1};
  const double a = kMuK * kGravity;
  expect_slide(slide(law, 0.5, 0.1), {0.4 / a, (0.25 - 0.01) / (2.0 * a)});
  const double relaxation = 0.08 / a;
  const double t = 1.5 * relaxation;
  const double v = 0.02 + 0.08 * std::exp(-1.5);
  expect_slide(slide(law, 0.1, v), {t, 0.02 * t + relaxation * (0.1 - v)});
  EXPECT_NEAR(find_speed(law, 0.5, 0.4 / a + t) / v, 1.0, 1e-7);  // the corner costs a step some of its order
  EXPECT_EQ(find_speed(law, 0.019, 5.0), 0.019) << "below v₀ nothing holds it";
}

// exp(3 v/v_t) − 1 falls exponentially.
TEST(SlidingBlock, Threlfall) {
  const Threlfall law{kMuK, 0.1};
  const double k = 3.0 / 0.1;
  const auto exact = [&](double t) { return std::log1p(std::expm1(k * 0.4) * std::exp(-k * kMuK * kGravity * t)) / k; };
  // Down to 0.1 mm/s; slower ones come near the integration's absolute tolerance.
  for (const double t : {0.1, 0.25, 0.3, 0.4}) EXPECT_NEAR(find_speed(law, 0.4, t) / exact(t), 1.0, kShare) << t;
}

// Beyond v_t p = exp(ξ (v − v_t)) obeys ṗ = −ξ g (μ_k p + μ_s − μ_k); below, with u = v/v_t,
// ∫ du/(u (2 − u)) = ½ ln(u/(2 − u)) and ∫ u du/(u (2 − u)) = −ln(2 − u).
TEST(SlidingBlock, BengisuAkay) {
  constexpr double kPeak = 0.05;
  constexpr double kRate = 12.0;
  const BengisuAkay law{kMuS, kMuK, kPeak, kRate};
  const auto ln = [](double v) { return std::log(kMuK * std::exp(kRate * (v - kPeak)) + kMuS - kMuK); };
  EXPECT_NEAR(slide(law, 0.4, kPeak).time / ((ln(0.4) - ln(kPeak)) / (kRate * kGravity * kMuK)), 1.0, kShare);
  const auto ln_time = [](double u) { return 0.5 * std::log(u / (2.0 - u)); };
  const auto ln_distance = [](double u) { return -std::log(2.0 - u); };
  const double scale = kPeak / (kMuS * kGravity);
  expect_slide(slide(law, kPeak, 0.1 * kPeak),
               {scale * (ln_time(1.0) - ln_time(0.1)), scale * kPeak * (ln_distance(1.0) - ln_distance(0.1))});
}

// Where tanh is 1: with q = v², x = ½ ∫ (v_s² + q) dq/(μ_k q + μ_s v_s²)/g.
TEST(SlidingBlock, StribeckSmooth) {
  constexpr double kStribeck = 0.1;
  const StribeckSmooth law{kMuS, kMuK, kStribeck, 0.0, 1e-4};
  const double s2 = kStribeck * kStribeck;
  const auto distance = [&](double v) {
    return 0.5 / (kGravity * kMuK) * (v * v + s2 * (1.0 - kMuS / kMuK) * std::log(kMuK * v * v + kMuS * s2));
  };
  // t = ∫ (v_s² + v²) dv/(μ_k v² + μ_s v_s²)/g
  const double root = kStribeck * std::sqrt(kMuS / kMuK);
  const auto time = [&](double v) { return (v + (s2 - root * root) / root * std::atan(v / root)) / (kGravity * kMuK); };
  expect_slide(slide(law, 0.5, 0.01), {time(0.5) - time(0.01), distance(0.5) - distance(0.01)});
}

// Where tanh is 1 and γ = 2: with p = exp(v²/v_s²), x = v_s²/(2 g) ∫ dp/(μ_k p + μ_s − μ_k).
TEST(SlidingBlock, LugreSteady) {
  constexpr double kStribeck = 0.1;
  const LugreSteady law{kMuS, kMuK, kStribeck, 2.0, 0.0, 1e-4};
  const double s2 = kStribeck * kStribeck;
  const auto distance = [&](double v) {
    return s2 / (2.0 * kGravity * kMuK) * std::log(kMuK * std::exp(v * v / s2) + kMuS - kMuK);
  };
  EXPECT_NEAR(slide(law, 0.5, 0.01).distance / (distance(0.5) - distance(0.01)), 1.0, kShare);
}

// Viscous friction alone beside a constant: v + μ_k/σ₂ falls exponentially.
TEST(SlidingBlock, ViscousPartOfLugreSteady) {
  const LugreSteady law{kMuK, kMuK, 0.1, 2.0, 0.3, 1e-4};
  const double offset = kMuK / 0.3;
  const double t = std::log((0.5 + offset) / (0.01 + offset)) / (kGravity * 0.3);
  expect_slide(slide(law, 0.5, 0.01), {t, (0.5 - 0.01) / (kGravity * 0.3) - offset * t});
}

// No closed form: the formula of laws.md, integrated by Gauss and Kronrod.
TEST(SlidingBlock, BrownMcPhee) {
  constexpr double kPeak = 0.08;
  constexpr double kViscous = 0.2;
  const BrownMcPhee law{kMuS, kMuK, kViscous, kPeak};
  const auto deceleration = [](double v) {
    const double r = v / kPeak;
    const double bump = r / std::pow(0.25 * r * r + 0.75, 2.0);
    return kGravity * (kMuK * std::tanh(4.0 * r) + (kMuS - kMuK) * bump + kViscous * v);
  };
  using Rule = boost::math::quadrature::gauss_kronrod<double, 61>;
  const double time = Rule::integrate([&](double v) { return 1.0 / deceleration(v); }, 0.005, 0.5, 15, 1e-13);
  const double distance = Rule::integrate([&](double v) { return v / deceleration(v); }, 0.005, 0.5, 15, 1e-13);
  expect_slide(slide(law, 0.5, 0.005), {time, distance});
}

// Over the slip x a bristle of i = 1 that starts straight has μ = μ_k (1 − exp(−σ₀ x/μ_k)), so that
// v² = v₀² − 2 g [μ_k x − μ_k²/σ₀ (1 − exp(−σ₀ x/μ_k))]. LuGre with one level and no damping is the same.
template <class Law>
void expect_bristle_slide(const Law& law, double stiffness) {
  using Block = std::array<double, 3>;  // x, v, z
  const auto slope = [&](const Block& y, Block& rate, double) {
    const Friction friction = law({y[1], y[2]});
    rate = {y[1], -kGravity * friction.coefficient, friction.bristle_rate};
  };
  Block y{0.0, 0.5, 0.0};
  auto stepper = odeint::make_controlled(1e-14, 1e-13, odeint::runge_kutta_dopri5<Block>());
  double t = 0.0;
  double h = 1e-6;
  int n_steps = 0;
  // Down to where bristle and block begin to swing.
  while (y[1] > 0.05) {
    if (stepper.try_step(slope, y, t, h) != odeint::success) continue;
    ++n_steps;
    const double yielded = -std::expm1(-stiffness * y[0] / kMuK);
    EXPECT_NEAR(y[2], kMuK / stiffness * yielded, 1e-9 * kMuK / stiffness);
    const double energy = 0.25 - 2.0 * kGravity * (kMuK * y[0] - kMuK * kMuK / stiffness * yielded);
    ASSERT_NEAR(y[1] * y[1], energy, 1e-10);
  }
  EXPECT_GT(n_steps, 100);
  // And it comes to rest, held: the block ends within the bristles' reach of where rigid friction would stop it.
  odeint::integrate_adaptive(stepper, slope, y, t, t + 1.0, h);
  EXPECT_NEAR(y[0], 0.25 / (2.0 * kGravity * kMuK), 3.0 * kMuK / stiffness);
  EXPECT_LE(std::abs(y[1]), 0.01);
}

TEST(SlidingBlock, Dahl) { expect_bristle_slide(Dahl{kMuK, 1e4, 1.0}, 1e4); }

TEST(SlidingBlock, LugreOfOneLevel) {
  Lugre law;
  law.static_coefficient = law.kinetic_coefficient = kMuK;
  law.bristle_stiffness = 1e4;
  expect_bristle_slide(law, 1e4);
}

}  // namespace
}  // namespace gudgeon
