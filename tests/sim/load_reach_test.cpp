// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// What loads could do over the size of a mechanism, and that it is what rounding is judged by where nothing moves.
#include "gudgeon/sim/load_reach.h"

#include <gtest/gtest.h>

#include <cmath>

#include "gudgeon/analysis/energy_audit.h"
#include "gudgeon/sim/run_study.h"
#include "tests/oracle/mechanism_parts.h"

namespace gudgeon {
namespace {

// Two bars on the frame, pinned to one another: a triangle. It weighs 2 w and is pushed to and fro.
Mechanism make_truss(double length, double force) {
  const Vec2 top{0.7 * length, 0.4 * length};
  Mechanism mechanism = oracle::make_empty("truss", {0.0, -force}, {{"left", {0, 0}}, {"right", {1.3 * length, 0}}});
  const double left = std::atan2(top.y, top.x);
  const Vec2 down = top - Vec2{1.3 * length, 0.0};
  mechanism.bodies.push_back(oracle::make_slender("first", norm(top), 1.0, oracle::start_at(left)));
  mechanism.bodies.push_back(
      oracle::make_slender("second", norm(down), 1.0, oracle::start_at(std::atan2(down.y, down.x))));
  oracle::add_revolute(mechanism, "left", {kFrameName, "left"}, {"first", "a"});
  oracle::add_revolute(mechanism, "right", {kFrameName, "right"}, {"second", "a"});
  oracle::add_revolute(mechanism, "top", {"first", "b"}, {"second", "b"});
  const Expression push{"a*(1 + sin(w*t))", {{"a", 3.0 * force}, {"w", 70.0}}};
  mechanism.loads.push_back({"push", VariableForce{{"first", "b"}, push, 0.5 * force, kFrameName}});
  mechanism.loads.push_back({"twist", ConstantTorque{"second", -0.2 * force * length}});
  return mechanism;
}

TEST(LoadReach, IsTheLargestOfLoadsAndWeightsOverTheLength) {
  for (const auto& [length, force] : {std::pair{0.5, 10.0}, {0.5e-6, 1e-5}, {200.0, 3e7}}) {
    Study study;
    study.cycle_time = 0.1;
    study.cycles = 1;
    study.outputs_per_cycle = 10;
    study.relative_tolerance = 1e-9;
    study.absolute_tolerance = 1e-12;
    const auto stages = run_study(make_truss(length, force), study, {});
    ASSERT_EQ(stages.size(), 1U);
    ASSERT_EQ(stages[0].status, StageStatus::finished) << stages[0].message;
    const EnergyBalance& balance = stages[0].energy;
    const double longest = std::hypot(0.7, 0.4) * length;
    const double expected = (2.0 * force + std::hypot(6.0, 0.5) * force) * longest + 0.2 * force * length;
    EXPECT_NEAR(balance.load_reach, expected, 2e-3 * expected) << "the sine is met to within its steps";
    EXPECT_LE(balance.load_reach, expected * (1.0 + 1e-12));
    EXPECT_TRUE(check_energy(balance).balanced) << length << " m: " << balance.residual() << " J";
    EXPECT_LT(balance.exchanged, 1e-10 * expected) << "nothing moves";
  }
}

}  // namespace
}  // namespace gudgeon
