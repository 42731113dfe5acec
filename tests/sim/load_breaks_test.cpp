// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Short forces and jumps of loads, against momentum, energy and closed forms.
#include "gudgeon/sim/load_breaks.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "gudgeon/io/model_reader.h"
#include "gudgeon/sim/run_study.h"

namespace gudgeon {
namespace {

using testing::HasSubstr;

StageRecord run_model(const ModelFile& model) {
  EXPECT_FALSE(model.diagnostics.has_errors()) << render(model.diagnostics, model.source);
  if (model.diagnostics.has_errors()) return {};
  return run_study(model.mechanism, model.study).back();
}

StageRecord run_case(const std::string& name) {
  StageRecord stage = run_model(read_model(GUDGEON_SOURCE_DIR "/tests/cases/" + name + ".toml"));
  EXPECT_EQ(stage.status, StageStatus::finished) << stage.message;
  return stage;
}

double last(const StageRecord& stage, const std::string& channel) { return find_values(stage, channel)->back(); }

// A block of 2 kg on a straight guide, with what is added to it.
std::string make_block(const std::string& rest) {
  return R"(
name = "block"
gravity = [0, 0]
[bodies.frame]
points = { O = [0, 0] }
[bodies.block]
mass = "2 kg"
inertia = 0
points = { C = [0, 0] }
[joints.G]
type = "prismatic"
between = ["frame.O", "block.C"]
direction = 0
)" + rest +
         R"(
[study]
cycle_time = "1 s"
cycles = 1
)";
}

StageRecord run_block(const std::string& rest) { return run_model(read_model_text("block.toml", make_block(rest))); }

std::string make_force(const std::string& name, const std::string& x) {
  return "[loads." + name + "]\npoint = \"block.C\"\nforce = [\"" + x + "\", 0]\n";
}

TEST(LoadBreaks, ShortPushGivesItsMomentum) {
  EXPECT_NEAR(last(run_case("short_push"), "block.x_velocity"), 4.0, 1e-8);
}

TEST(LoadBreaks, ShortZoneTakesItsWork) {
  EXPECT_NEAR(last(run_case("force_zone"), "block.x_velocity"), std::sqrt(1.0 - 2.0 * 200.0 * 0.003 / 2.0), 1e-8);
}

TEST(LoadBreaks, EveryCutOfAPressTakesItsWork) { EXPECT_NEAR(run_case("press_cut").energy.load_work, -180.0, 1e-5); }

TEST(LoadBreaks, DryFrictionByFormulaComesToRestAndStays) {
  const StageRecord stage = run_case("dry_friction_formula");
  EXPECT_NEAR(last(stage, "block.x"), 0.2, 1e-8);
  EXPECT_NEAR(last(stage, "block.x_velocity"), 0.0, 1e-12);
  EXPECT_NEAR(stage.energy.load_work, -1.0, 1e-8);
  EXPECT_LT(stage.solver.accepted_steps, 1000);
}

TEST(LoadBreaks, AreMetWhereAllIsDriven) {
  const StageRecord stage = run_block(make_force("push", "t > 0.5034 && t < 0.5114 ? 1000 : 0") +
                                      make_force("zone", "block.x > 0.1 && block.x < 0.103 ? -200 : 0") +
                                      "[drivers.motor]\nslide = \"G\"\nspeed = \"1 m/s\"\n");
  EXPECT_NEAR(stage.energy.load_work, 1000.0 * 0.008 - 200.0 * 0.003, 1e-8);
  EXPECT_NEAR(stage.energy.driver_work, -stage.energy.load_work, 1e-8);
}

// √v falls by 1.25 a second; beyond rest the piece of abs that was held has no root.
TEST(LoadBreaks, FormulasWithoutAValueBeyondTheirPieceGoOn) {
  const StageRecord stage = run_block("[joints.G.start]\nspeed = \"1 m/s\"\n" +
                                      make_force("drag", "-5*abs(block.x_velocity)^0.5*sign(block.x_velocity)"));
  EXPECT_EQ(stage.status, StageStatus::finished) << stage.message;
  EXPECT_NEAR(last(stage, "block.x"), 0.8 / 3.0, 1e-5);
  EXPECT_NEAR(last(stage, "block.x_velocity"), 0.0, 1e-5);
}

TEST(LoadBreaks, AreMetByEitherIntegratorWhereAllIsDriven) {
  for (const Integrator integrator : {Integrator::automatic, Integrator::stiff}) {
    ModelFile model =
        read_model_text("block.toml", make_block(make_force("push", "t > 0.5034 && t < 0.5114 ? 1000 : 0") +
                                                 "[drivers.motor]\nslide = \"G\"\nspeed = \"1 m/s\"\n"));
    model.study.integrator = integrator;
    EXPECT_NEAR(run_model(model).energy.load_work, 1000.0 * 0.008, 1e-8);
  }
}

// v = ∫ (20 t − 5)/2 dt from where 20 t is 5.
TEST(LoadBreaks, BlockThatSticksSlipsWhereThePullExceedsFriction) {
  const StageRecord stage = run_block(make_force("rub", "-5*sign(block.x_velocity)") + make_force("pull", "20*t"));
  EXPECT_NEAR(last(stage, "block.x_velocity"), (10.0 * (1.0 - 0.0625) - 5.0 * 0.75) / 2.0, 1e-6);
}

// What is looked at between steps, where the bob turns, must hold the block too.
TEST(LoadBreaks, BlockThatSticksHasNoAccelerationBetweenSteps) {
  const StageRecord stage =
      run_block(make_force("rub", "-5*sign(block.x_velocity)") + make_force("pull", "4*sin(3*t)") +
                "[bodies.bob]\nmass = \"1 kg\"\ninertia = 0\npoints = { C = [0, 0] }\n"
                "[joints.H]\ntype = \"prismatic\"\nbetween = [\"frame.O\", \"bob.C\"]\ndirection = \"90 deg\"\n"
                "start = { speed = \"1 m/s\" }\n[loads.swing]\npoint = \"bob.C\"\nforce = [0, \"-100*bob.y\"]\n");
  EXPECT_NEAR(find_statistics(stage, "bob.y_acceleration")->minimum, -10.0, 1e-3);
  EXPECT_NEAR(find_statistics(stage, "block.x_acceleration")->minimum, 0.0, 1e-9);
  EXPECT_NEAR(find_statistics(stage, "block.x_acceleration")->maximum, 0.0, 1e-9);
}

TEST(LoadBreaks, TwoConditionsOnOneSpeedHoldTogether) {
  const StageRecord stage = run_block(make_force("rub", "block.x_velocity > 0 ? -5 : block.x_velocity < 0 ? 5 : 0") +
                                      make_force("pull", "t > 0.5 ? 20*t : 0"));
  EXPECT_NEAR(last(stage, "block.x_velocity"), (10.0 * 0.75 - 5.0 * 0.5) / 2.0, 1e-6);
}

// It comes into the zone at 10 mm/s, a hair before it would turn by itself, and is out again after 0.4 us: the turn
// comes 1 ms earlier than without the zone, and so does the return.
TEST(LoadBreaks, ZoneTouchedAtATurningPointIsSeen) {
  const StageRecord stage = run_block(make_force("field", "-20 + 0*t") + "[joints.G.start]\nspeed = \"5 m/s\"\n" +
                                      make_force("zone", "block.x > 1.249995 ? -1e5 : 0"));
  EXPECT_NEAR(find_statistics(stage, "block.x_acceleration")->minimum, -(1e5 + 20.0) / 2.0, 1e-6);
  const double window = 1e-11;  // [s] to which each end of the zone is found
  const double in_zone = 2.0 * 0.01 / (0.5 * (1e5 + 20.0));
  EXPECT_NEAR(last(stage, "block.x_velocity"), -0.01 - 10.0 * (1.0 - (0.5 - 1e-3) - in_zone), 2.0 * window * 5e4);
}

}  // namespace
}  // namespace gudgeon
