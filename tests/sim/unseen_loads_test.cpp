// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Narrow loads without a break, against their impulse and work in closed form.
#include "gudgeon/sim/unseen_loads.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

#include "gudgeon/io/model_reader.h"
#include "gudgeon/sim/run_study.h"

namespace gudgeon {
namespace {

const double kGauss = std::sqrt(std::numbers::pi);  // ∫ exp(−u²) du

// A block of 2 kg on a straight guide under one force along it; a study of one second.
StageRecord run_pushed(const std::string& formula, const std::string& rest = "",
                       Integrator integrator = Integrator::automatic) {
  ModelFile model = read_model_text("block.toml", R"(
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
[study]
cycle_time = "1 s"
cycles = 1
[loads.push]
point = "block.C"
force = [")" + formula + "\", 0]\n" + rest);
  EXPECT_FALSE(model.diagnostics.has_errors()) << render(model.diagnostics, model.source);
  if (model.diagnostics.has_errors()) return {};
  model.study.integrator = integrator;
  StageRecord stage = run_study(model.mechanism, model.study).back();
  EXPECT_EQ(stage.status, StageStatus::finished) << stage.message;
  return stage;
}

double find_end_speed(const StageRecord& stage) { return find_values(stage, "block.x_velocity")->back(); }

const std::string kMoves = "[joints.G.start]\nspeed = \"1 m/s\"\n";
const std::string kDriven = "[drivers.motor]\nslide = \"G\"\nspeed = \"1 m/s\"\n";

class PulseWidth : public testing::TestWithParam<double> {
 protected:
  [[nodiscard]] static std::string over(const std::string& argument, double height) {
    return fmt::format("{}*exp(-(({} - 0.5037)/{})^2)", height / GetParam(), argument, GetParam());
  }
};

TEST_P(PulseWidth, GivesABodyAtRestItsImpulse) {
  EXPECT_NEAR(find_end_speed(run_pushed(over("t", 1.0))), kGauss / 2.0, 2e-6);
}

TEST_P(PulseWidth, GivesItsImpulseToStiffSteps) {
  EXPECT_NEAR(find_end_speed(run_pushed(over("t", 1.0), "", Integrator::stiff)), kGauss / 2.0, 2e-6);
}

TEST_P(PulseWidth, TakesItsWorkOverAWay) {
  EXPECT_NEAR(find_end_speed(run_pushed(over("block.x", -0.1), kMoves)), std::sqrt(1.0 - 0.1 * kGauss), 2e-6);
}

TEST_P(PulseWidth, IsBorneByADriver) {
  for (const char* argument : {"t", "block.x"}) {
    const StageRecord stage = run_pushed(over(argument, 1.0), kDriven);
    EXPECT_NEAR(stage.energy.load_work, kGauss, 5e-6);
    EXPECT_NEAR(stage.energy.driver_work, -kGauss, 5e-6);
  }
}

TEST_P(PulseWidth, CostsLittle) { EXPECT_LT(run_pushed(over("t", 1.0)).solver.evaluations, 2000); }

INSTANTIATE_TEST_SUITE_P(UnseenLoads, PulseWidth, testing::Values(1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-8));

struct Pulse {
  const char* formula;
  double impulse;
};

class PulseShape : public testing::TestWithParam<Pulse> {};

TEST_P(PulseShape, GivesItsImpulse) {
  EXPECT_NEAR(find_end_speed(run_pushed(GetParam().formula)), GetParam().impulse / 2.0, 5e-6) << GetParam().formula;
}

INSTANTIATE_TEST_SUITE_P(
    UnseenLoads, PulseShape,
    testing::Values(
        // [atan u]
        Pulse{"1e4/(1 + ((t - 0.5037)/1e-4)^2)", std::atan(0.4963e4) + std::atan(0.5037e4)},
        Pulse{"1e5/cosh((t - 0.5037)/1e-5)", std::numbers::pi},
        Pulse{"1e5*(tanh((t - 0.5037)/1e-6) - tanh((t - 0.50371)/1e-6))", 2.0},
        // ∫ sin^2n(pi t) = (2n)!/(2^n n!)², here with n = 5e5
        Pulse{"1000*sin(pi*t)^1000000",
              1000.0 * std::exp(std::lgamma(1e6 + 1.0) - 2.0 * std::lgamma(5e5 + 1.0) - 1e6 * std::numbers::ln2)},
        Pulse{"5e3*exp(-pow((t - 0.3)/1e-4, 2)) + 1e4*exp(-(t - 0.3004)*(t - 0.3004)*1e8)", 1.5 * kGauss},
        // twenty, each on its own
        Pulse{"1e3*exp(-((mod(t, 0.05) - 0.02)/1e-5)^2)", 0.2 * kGauss},
        // a small one on a steady pull
        Pulse{"10 + 1*exp(-((t - 0.5037)/1e-3)^2)", 10.0 + 1e-3 * kGauss}));

// Two lobes, no impulse: a shift of ∫∫ F/m.
TEST(UnseenLoads, LobesWithoutImpulseShift) {
  const StageRecord stage = run_pushed("1e6*(t - 0.5037)/1e-3*exp(-((t - 0.5037)/1e-3)^2)");
  EXPECT_NEAR(find_values(stage, "block.x")->back(), -0.5 * 1e6 * 1e-6 * kGauss / 2.0, 1e-5);
}

// A gust that overtakes the block: at 1 m/s against 3 m/s the way over it takes half the time.
TEST(UnseenLoads, PeakThatMovesIsMet) {
  const StageRecord stage = run_pushed("exp(-((block.x + 1 - 3*t)/1e-4)^2)", kMoves);
  EXPECT_NEAR(find_end_speed(stage), 1.0 + 1e-4 * kGauss / 2.0 / 2.0, 1e-7);
}

// What has no narrow part runs as if nobody looked; what turns gently, too.
TEST(UnseenLoads, GentleLoadsKeepTheirSteps) {
  const StageRecord stage = run_pushed("-8*block.x + exp(-2*t) + 1/(1 + t^2)", kMoves);
  EXPECT_LT(stage.solver.accepted_steps, 80);
  EXPECT_LT(stage.solver.rejected_steps, 5);
}

}  // namespace
}  // namespace gudgeon
