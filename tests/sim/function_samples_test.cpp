// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Formulas and curves as they are drawn: where they are sampled, and that jumps stand upright.
#include "gudgeon/sim/function_samples.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "gudgeon/io/model_reader.h"

namespace gudgeon {
namespace {

std::vector<FunctionSamples> sample_model(const std::string& rest) {
  const ModelFile model = read_model_text("arm.toml", R"(
name = "arm"
[bodies.frame]
points = { O = [0, 0] }
[bodies.arm]
mass = "2 kg"
inertia = "0.1 kg m^2"
points = { O = [0, 0], A = ["0.3 m", 0] }
start = { angle = "90 deg" }
[joints.O]
type = "revolute"
between = ["frame.O", "arm.O"]
[study]
cycle_time = "2 s"
cycles = 3
)" + rest);
  EXPECT_FALSE(model.diagnostics.has_errors()) << render(model.diagnostics, model.source);
  return sample_functions(model.mechanism, model.study, assemble(model.mechanism));
}

TEST(FunctionSamples, ShowAFormulaOfTheTimeOverTheStudy) {
  const auto samples = sample_model("[loads.push]\npoint = \"arm.A\"\nforce = [\"t > 1.2345 ? 7 : 2\", 0]\n");
  ASSERT_EQ(samples.size(), 1U);
  const FunctionSamples& push = samples.front();
  EXPECT_EQ(push.id, "loads.push.force.0");
  EXPECT_EQ(push.over, "t");
  EXPECT_EQ(push.others, "");
  EXPECT_EQ(push.arguments.front(), 0.0);
  EXPECT_EQ(push.arguments.back(), 6.0);
  const auto jump = std::ranges::find(push.values, 7.0) - push.values.begin();
  EXPECT_NEAR(push.arguments[static_cast<std::size_t>(jump)], 1.2345, 1e-12);
  EXPECT_NEAR(push.arguments[static_cast<std::size_t>(jump) - 1], 1.2345, 1e-12);
}

TEST(FunctionSamples, ShowAFormulaOfTheStateOverEachChannelFromTheStart) {
  const auto samples = sample_model("[loads.drag]\nbody = \"arm\"\ntorque = \"-3*arm.angle_rate + sin(arm.angle)\"\n");
  ASSERT_EQ(samples.size(), 6U);
  constexpr double kReach = std::numbers::pi;  // half a turn, and a turn a cycle of 2 s
  constexpr double kStart = 0.5 * std::numbers::pi;
  for (const FunctionSamples& one : samples) {
    const bool is_rate = one.over == "arm.angle_rate";
    const double shift = one.others == "at the start" ? 0.0 : one.others == "below it" ? -0.5 * kReach : 0.5 * kReach;
    EXPECT_NEAR(one.arguments.front(), (is_rate ? 0.0 : kStart) - kReach, 1e-12);
    EXPECT_NEAR(one.arguments.back(), (is_rate ? 0.0 : kStart) + kReach, 1e-12);
    const double rate = is_rate ? kReach : shift;
    const double angle = kStart + (is_rate ? shift : kReach);
    EXPECT_NEAR(one.values.back(), -3.0 * rate + std::sin(angle), 1e-12) << one.over << " " << one.others;
  }
}

TEST(FunctionSamples, ShowAMotionWithItsAcceleration) {
  const auto samples = sample_model(
      "[drivers.motor]\nbody = \"arm\"\nmotion = { arguments = [0, 2, 4, 6], values = [1.5707963267948966, "
      "5.570796326794897, 17.570796326794897, 37.5707963267949] }\n");
  ASSERT_EQ(samples.size(), 2U);
  EXPECT_EQ(samples[0].point_arguments.size(), 4U);
  EXPECT_EQ(samples[1].id, "drivers.motor.motion.acceleration");
  EXPECT_EQ(samples[1].unit, "rad/s^2");
  for (std::size_t k = 0; k < samples[1].values.size(); ++k) {
    const double t = samples[1].arguments[k];
    // A spline through a parabola is one.
    if (t > 0.0 && t < 6.0) {
      EXPECT_NEAR(samples[1].values[k], 2.0, 1e-9);
    }
  }
}

}  // namespace
}  // namespace gudgeon
