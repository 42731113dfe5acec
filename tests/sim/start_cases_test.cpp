// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Runs from starts that touch, move within the play, close by it, or end at a singular loop.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "gudgeon/io/model_reader.h"
#include "gudgeon/sim/run_study.h"

namespace gudgeon {
namespace {

using testing::HasSubstr;
using testing::Not;

ModelFile read_start_case(const std::string& name) {
  ModelFile model = read_model(std::string(GUDGEON_SOURCE_DIR) + "/tests/cases/" + name + ".toml");
  EXPECT_FALSE(model.diagnostics.has_errors()) << render(model.diagnostics, model.source);
  return model;
}

TEST(StartCasesRun, ABallThatStartsWithinItsPlayFliesToTheWall) {
  ModelFile model = read_start_case("start_in_the_play");
  model.study.cycles = 1;
  model.study.compare_ideal = true;
  const auto stages = run_study(model.mechanism, model.study);
  ASSERT_EQ(stages.size(), 1U) << "no ideal mechanism starts so";
  EXPECT_EQ(stages[0].status, StageStatus::finished) << stages[0].message;
  ASSERT_FALSE(stages[0].events.empty());
  // The first time at which 18 mm/s t − 1 mm sin(10 t) = 2 mm.
  double low = 0.1;
  double high = 0.2;
  for (int k = 0; k < 60; ++k) {
    const double t = 0.5 * (low + high);
    (0.018 * t - 0.001 * std::sin(10.0 * t) < 0.002 ? low : high) = t;
  }
  EXPECT_NEAR(stages[0].events[0].onset_time, low, 1e-9);
}

TEST(StartCasesRun, ABlockThatRestsOnItsGuideStaysThere) {
  ModelFile model = read_start_case("rests_exactly_on_surface");
  const auto stages = run_study(model.mechanism, model.study);
  ASSERT_EQ(stages.size(), 1U);
  EXPECT_EQ(stages[0].status, StageStatus::finished) << stages[0].message;
  // Two corners of 2 mm share the weight: F = K δ^1.5 each, K = 4/(3π · 2σ) √R, σ = (1 − ν²)/(π E).
  const double sigma = (1.0 - 0.3 * 0.3) / (std::numbers::pi * 207e9);
  const double stiffness = 4.0 / (3.0 * std::numbers::pi * 2.0 * sigma) * std::sqrt(2e-3);
  const double depth = std::pow(9.66096405704976 / stiffness, 2.0 / 3.0);
  const std::vector<double>& y = *find_values(stages[0], "block.y");
  for (const double at : y) EXPECT_NEAR(at, -0.05e-3 - depth, 1.01 * depth) << "sinks in, and settles";
  EXPECT_NEAR(y.back(), -0.05e-3 - depth, 0.01 * depth) << "friction's moment moves a tenth from corner to corner";
}

TEST(StartCasesRun, WhatClosesByItsClearanceRuns) {
  ModelFile model = read_start_case("pitch_error_within_clearance");
  model.study.cycle_time = 0.3;  // short of the change point at 180°
  model.study.cycle_driver.clear();
  const auto stages = run_study(model.mechanism, model.study);
  ASSERT_EQ(stages.size(), 1U) << "there is no ideal mechanism";
  EXPECT_EQ(stages[0].name, "no_wear");
  EXPECT_EQ(stages[0].status, StageStatus::finished) << stages[0].message;
}

TEST(StartCasesRun, ASingularLoopIsNamedBesideAContact) {
  ModelFile model = read_start_case("singular_loop_with_clearance");
  model.study.compare_ideal = false;
  const auto stages = run_study(model.mechanism, model.study);
  ASSERT_EQ(stages.size(), 1U);
  ASSERT_EQ(stages[0].status, StageStatus::failed);
  EXPECT_THAT(stages[0].message, HasSubstr("nearest to a singular position: the loop closed by joint 'P3'"));
  EXPECT_THAT(stages[0].message, Not(HasSubstr("stiffest contact")));
}

TEST(StartCasesRun, APointMassOnAPinIsAPendulum) {
  const ModelFile model = read_start_case("point_mass_on_pin");
  const auto stages = run_study(model.mechanism, model.study);
  ASSERT_EQ(stages.size(), 1U);
  ASSERT_EQ(stages[0].status, StageStatus::finished) << stages[0].message;
  // ½ I θ̇² = −g S sin θ from rest on the level, S = m₁ c + m₂ L.
  const double inertia = 0.01 + 0.01 + 0.08;
  const double moment = 9.81 * 0.5;
  const std::vector<double>& angle = *find_values(stages[0], "bar.angle");
  const std::vector<double>& rate = *find_values(stages[0], "bar.angle_rate");
  for (std::size_t k = 0; k < angle.size(); ++k) {
    EXPECT_NEAR(0.5 * inertia * rate[k] * rate[k], -moment * std::sin(angle[k]), 1e-4);
  }
  EXPECT_LT(*std::ranges::min_element(angle), -3.1);
  for (const double a : *find_values(stages[0], "payload.angle")) EXPECT_EQ(a, 0.0);
}

}  // namespace
}  // namespace gudgeon
