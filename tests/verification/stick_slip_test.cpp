// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Stick and slip of a mass that is dragged through a spring over LuGre friction: Canudas de Wit et al. 1995, numbers
// from an independent integration. Here the law itself is integrated, by an integrator that is not the engine's.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <boost/numeric/odeint.hpp>
#include <cmath>
#include <vector>

#include "gudgeon/laws/friction/lugre.h"

namespace gudgeon {
namespace {

namespace odeint = boost::numeric::odeint;

// Mass 1 kg, spring 2 N/m, its end moving at 0.1 m/s; the published friction is a force, so the normal force is 1 N.
constexpr double kStiffness = 2.0;
constexpr double kDragSpeed = 0.1;
constexpr double kEnd = 25.0;

using MassState = std::array<double, 3>;  // x [m], v [m/s], z [m]

struct Slip {
  double begin;
  double end;
  double distance;
};

struct Motion {
  MassState end;
  double top_speed = 0.0;
  std::vector<Slip> slips;
};

Lugre make_dragged_friction() {
  Lugre law;
  law.static_coefficient = 1.5;
  law.kinetic_coefficient = 1.0;
  law.stribeck_speed = 1e-3;
  law.decay_exponent = 2.0;
  law.bristle_stiffness = 1e5;
  law.bristle_damping = std::sqrt(1e5);
  law.viscous_coefficient = 0.4;
  return law;
}

// A slip has begun at 1 cm/s and ended at 1 mm/s: the times of the reference are those.
void watch_slips(double t, const MassState& y, double t_before, const MassState& before, bool& slips, Motion& motion) {
  const double threshold = slips ? 1e-3 : 1e-2;
  if (slips == (y[1] > threshold)) return;
  slips = !slips;
  const double share = (threshold - before[1]) / (y[1] - before[1]);
  const double time = t_before + share * (t - t_before);
  const double x = before[0] + share * (y[0] - before[0]);
  if (slips) {
    motion.slips.push_back({time, 0.0, -x});
  } else {
    motion.slips.back().end = time;
    motion.slips.back().distance += x;
  }
}

// An explicit method will do: bristles at 0.37 m/s relax within 27 us, some 60 thousand steps in all.
Motion drag(const Lugre& law, double tolerance) {
  const auto slope = [&](const MassState& y, MassState& rate, double t) {
    const Friction friction = law({y[1], y[2]});
    rate = {y[1], kStiffness * (kDragSpeed * t - y[0]) - friction.coefficient, friction.bristle_rate};
  };
  auto stepper = odeint::make_controlled(tolerance, tolerance, odeint::runge_kutta_dopri5<MassState>());
  Motion motion{};
  MassState y{};
  double t = 0.0;
  double h = 1e-5;
  bool slips = false;
  while (t < kEnd) {
    h = std::min(h, kEnd - t);
    const MassState before = y;
    const double t_before = t;
    if (stepper.try_step(slope, y, t, h) != odeint::success) continue;
    motion.top_speed = std::max(motion.top_speed, y[1]);
    watch_slips(t, y, t_before, before, slips, motion);
  }
  motion.end = y;
  return motion;
}

TEST(StickSlip, MassDraggedOverLugreFriction) {
  const Motion motion = drag(make_dragged_friction(), 1e-13);
  EXPECT_NEAR(motion.end[0], 1.908839199, 1e-9);      // ten digits are given
  EXPECT_NEAR(motion.end[2], 1.181679546e-5, 1e-14);  // and here; 2e-15 is one unit of the last
  EXPECT_NEAR(motion.top_speed, 0.369816, 5e-7);      // half a unit of the last digit given
  ASSERT_EQ(motion.slips.size(), 3U);
  const std::array begins{7.458, 13.821, 20.183};
  const std::array ends{10.263, 16.626, 22.988};
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_NEAR(motion.slips[k].begin, begins[k], 5e-4);  // half a unit of the last digit given
    EXPECT_NEAR(motion.slips[k].end, ends[k], 1e-3);      // 16.62548 s comes out where 16.626 s is given
    EXPECT_NEAR(motion.slips[k].distance, 0.6361, 5e-5);
  }
}

TEST(StickSlip, TheReferenceIsConverged) {
  const Motion coarse = drag(make_dragged_friction(), 1e-10);
  const Motion fine = drag(make_dragged_friction(), 1e-12);
  EXPECT_NEAR(coarse.end[0], fine.end[0], 1e-7);
  EXPECT_NEAR(coarse.top_speed, fine.top_speed, 1e-7);
}

// Below its static friction the loaded mass stays where it is: the bristle holds without creep.
TEST(StickSlip, ALoadedMassAtRestDoesNotCreep) {
  Lugre law = make_dragged_friction();
  const double load = 0.5;  // comes on at once and overshoots to twice its size, below kinetic friction
  const double held = load / law.bristle_stiffness;
  const auto slope = [&](const MassState& y, MassState& rate, double) {
    const Friction friction = law({y[1], y[2]});
    rate = {y[1], load - friction.coefficient, friction.bristle_rate};
  };
  MassState y{0.0, 0.0, 0.0};
  auto stepper = odeint::make_controlled(1e-12, 1e-12, odeint::runge_kutta_dopri5<MassState>());
  // The load comes on at once; the bristle swings out within some 0.01 s, and 10 s more must not move it.
  odeint::integrate_adaptive(stepper, slope, y, 0.0, 1.0, 1e-6);
  const MassState settled = y;
  odeint::integrate_adaptive(stepper, slope, y, 1.0, 11.0, 1e-6);
  EXPECT_NEAR(y[2], held, 1e-12);
  EXPECT_NEAR(y[1], 0.0, 1e-11);         // an explicit method at its stability limit rings at some times its tolerance
  EXPECT_NEAR(y[0], settled[0], 1e-11);  // the integration's own drift at its tolerance
}

}  // namespace
}  // namespace gudgeon
