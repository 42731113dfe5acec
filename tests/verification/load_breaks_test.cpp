// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Loads that jump, bend or follow points, at default tolerances: momentum, work and way by hand.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "gudgeon/io/model_reader.h"
#include "gudgeon/sim/run_study.h"
#include "tests/verification/book/recorder.h"

namespace gudgeon {
namespace {

StageRecord run_load_case(const std::string& name) {
  const ModelFile model = read_model(GUDGEON_SOURCE_DIR "/tests/cases/" + name + ".toml");
  EXPECT_FALSE(model.diagnostics.has_errors()) << render(model.diagnostics, model.source);
  StageRecord stage = run_study(model.mechanism, model.study).back();
  EXPECT_EQ(stage.status, StageStatus::finished) << name << ": " << stage.message;
  return stage;
}

TEST(LoadBreaks, GiveTheirMomentumAndWork) {
  book::Recorder recorder(
      {"Loads and drivers", "Loads that jump, bend or follow points", "momentum, work and energy by hand",
       "Pushes, zones and cuts that are short against steps, dry friction as a formula, and a punch "
       "by points, at the default tolerance 1e-6.",
       "steps end where a load changes its piece, to 1e-11 of a cycle; between, forces are smooth"});
  const auto last = [](const StageRecord& stage, const char* channel) { return find_values(stage, channel)->back(); };
  recorder.verify("1 kN for 8 ms on 2 kg [m/s]", 4.0, last(run_load_case("short_push"), "block.x_velocity"), 1e-8);
  recorder.verify("behind 3 mm of 200 N [m/s]", std::sqrt(1.0 - 2.0 * 200.0 * 0.003 / 2.0),
                  last(run_load_case("force_zone"), "block.x_velocity"), 1e-8);
  recorder.verify("three cuts of 3 mm at 20 kN [J]", -180.0, run_load_case("press_cut").energy.load_work, 1e-5);
  const StageRecord rubbed = run_load_case("dry_friction_formula");
  recorder.verify("rest under -5 sign(v) at [m]", 0.2, last(rubbed, "block.x"), 1e-8);
  recorder.verify("and speed there [m/s]", 0.0, last(rubbed, "block.x_velocity"), 1e-12);
  recorder.verify("punch by points [J]", -118.0, run_load_case("curve_overshoot").energy.load_work, 1e-6);
}

}  // namespace
}  // namespace gudgeon
