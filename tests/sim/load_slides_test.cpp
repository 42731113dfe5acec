// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Dry friction given by formulas, at several places at once, against closed forms.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "gudgeon/io/model_reader.h"
#include "gudgeon/sim/run_study.h"

namespace gudgeon {
namespace {

using testing::AllOf;
using testing::HasSubstr;

// Two blocks of 2 kg, each on its own straight guide along x.
StageRecord run_blocks(const std::string& speed_of_a, const std::string& speed_of_b, const std::string& loads) {
  std::string text = R"(
name = "two_blocks"
gravity = [0, 0]
[bodies.frame]
points = { O = [0, 0] }
[study]
cycle_time = "1 s"
cycles = 1
)";
  for (const auto& [name, speed] : {std::pair{"a", speed_of_a}, {"b", speed_of_b}}) {
    text += std::string("[bodies.") + name + "]\nmass = \"2 kg\"\ninertia = 0\npoints = { C = [0, 0] }\n[joints.G" +
            name + "]\ntype = \"prismatic\"\nbetween = [\"frame.O\", \"" + name +
            ".C\"]\ndirection = 0\nstart = { speed = \"" + speed + " m/s\" }\n";
  }
  const ModelFile model = read_model_text("blocks.toml", text + loads);
  EXPECT_FALSE(model.diagnostics.has_errors()) << render(model.diagnostics, model.source);
  if (model.diagnostics.has_errors()) return {};
  return run_study(model.mechanism, model.study).back();
}

std::string make_push(const std::string& name, const std::string& body, const std::string& x) {
  return "[loads." + name + "]\npoint = \"" + body + ".C\"\nforce = [\"" + x + "\", 0]\n";
}

const std::string kFloor =
    make_push("floor_a", "a", "-5*sign(a.x_velocity)") + make_push("floor_b", "b", "-5*sign(b.x_velocity)");

double end_value(const StageRecord& stage, const std::string& channel) { return find_values(stage, channel)->back(); }

TEST(LoadSlides, BlocksStickEachForItself) {
  const StageRecord stage = run_blocks("1", "0.5", kFloor);
  ASSERT_EQ(stage.status, StageStatus::finished) << stage.message;
  EXPECT_NEAR(end_value(stage, "a.x"), 0.2, 1e-8);
  EXPECT_NEAR(end_value(stage, "b.x"), 0.05, 1e-8);
  EXPECT_NEAR(end_value(stage, "a.x_velocity"), 0.0, 1e-12);
  EXPECT_NEAR(end_value(stage, "b.x_velocity"), 0.0, 1e-12);
  EXPECT_LT(stage.solver.accepted_steps, 1000);
}

// What comes to rest at one instant is not held together: a pull on one that its own friction bears moves neither.
TEST(LoadSlides, BlocksThatStickAtOneInstantAreHeldApart) {
  const StageRecord stage = run_blocks("1", "1", kFloor + make_push("pull", "b", "t > 0.6 ? 3 : 0"));
  ASSERT_EQ(stage.status, StageStatus::finished) << stage.message;
  EXPECT_NEAR(end_value(stage, "a.x"), 0.2, 1e-8);
  EXPECT_NEAR(end_value(stage, "b.x"), 0.2, 1e-8);
}

TEST(LoadSlides, OneSlipsWhileTheOtherSticks) {
  const StageRecord stage = run_blocks("1", "1", kFloor + make_push("pull", "b", "t > 0.5 ? 20*(t - 0.5) : 0"));
  ASSERT_EQ(stage.status, StageStatus::finished) << stage.message;
  EXPECT_NEAR(end_value(stage, "a.x"), 0.2, 1e-8);
  EXPECT_NEAR(end_value(stage, "b.x_velocity"), 10.0 * 0.25 * 0.25 / 2.0, 1e-6);
}

// A block on a block, 3 N between them and 5 N to the floor. They are equally fast after 1/5.5 s, slow down together to
// rest at 0.4 s, and are drawn off together from 0.75 s on.
TEST(LoadSlides, StackSticksWithinAndToTheFloor) {
  const StageRecord stage = run_blocks("1", "0",
                                       make_push("floor", "a", "-5*sign(a.x_velocity)") +
                                           make_push("on_b", "b", "-3*sign(b.x_velocity - a.x_velocity)") +
                                           make_push("on_a", "a", "-3*sign(a.x_velocity - b.x_velocity)") +
                                           make_push("pull", "a", "t > 0.5 ? 20*(t - 0.5) : 0"));
  ASSERT_EQ(stage.status, StageStatus::finished) << stage.message;
  const double meet = 1.0 / 5.5;
  const double common = 1.5 * meet;
  const double way = common * common / 2.5;
  const double drawn = 5.0 * std::pow(0.25, 3) / 6.0;
  EXPECT_NEAR(end_value(stage, "a.x"), 0.5 * (1.0 + common) * meet + way + drawn, 1e-7);
  EXPECT_NEAR(end_value(stage, "b.x"), 0.5 * common * meet + way + drawn, 1e-7);
  EXPECT_NEAR(end_value(stage, "a.x_velocity"), 10.0 * 0.0625 / 4.0, 1e-6);
  EXPECT_NEAR(end_value(stage, "b.x_velocity"), 10.0 * 0.0625 / 4.0, 1e-6);
}

// One load brakes from the start, the other is put on while the block stands.
TEST(LoadSlides, SecondBrakeOnAStandingBlockHoldsToo) {
  const StageRecord stage = run_blocks("1", "1",
                                       kFloor + make_push("brake", "a", "t > 0.5 ? -4*sign(a.x_velocity) : 0") +
                                           make_push("pull", "a", "t > 0.6 ? 20*(t - 0.6) : 0"));
  ASSERT_EQ(stage.status, StageStatus::finished) << stage.message;
  EXPECT_NEAR(end_value(stage, "a.x"), 0.2, 1e-8);
  EXPECT_NEAR(end_value(stage, "b.x"), 0.2, 1e-8);
}

// A pole on a cart, and one force that both speeds turn over: it cannot hold the two still.
TEST(LoadSlides, TwoPlacesOfOneFormulaAreNamed) {
  const ModelFile model = read_model_text("cart.toml", R"toml(
name = "cart"
gravity = [0, "-9.81 m/s^2"]
[bodies.frame]
points = { O = [0, 0] }
[bodies.cart]
mass = "2 kg"
inertia = 0
points = { C = [0, 0] }
[bodies.pole]
mass = "1 kg"
inertia = "0.001 kg m^2"
center_of_mass = ["0.1 m", 0]
points = { A = [0, 0] }
start = { angle = "100 deg" }
[joints.G]
type = "prismatic"
between = ["frame.O", "cart.C"]
direction = 0
[joints.A]
type = "revolute"
between = ["cart.C", "pole.A"]
[loads.both]
point = "cart.C"
force = ["1 - 5*sign(cart.x_velocity) - 5*sign(pole.angle_rate)", 0]
[study]
cycle_time = "1 s"
cycles = 1
)toml");
  ASSERT_FALSE(model.diagnostics.has_errors()) << render(model.diagnostics, model.source);
  const StageRecord stage = run_study(model.mechanism, model.study).back();
  EXPECT_THAT(stage.message, AllOf(HasSubstr("E-NUM-006"), HasSubstr("load 'both' at \"sign(cart.x_velocity)\""),
                                   HasSubstr("load 'both' at \"sign(pole.angle_rate)\"")));
}

}  // namespace
}  // namespace gudgeon
