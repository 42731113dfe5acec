// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Runs that have to go through, from the model files of tests/cases.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "gudgeon/io/model_reader.h"
#include "gudgeon/sim/run_study.h"

namespace gudgeon {
namespace {

std::vector<StageRecord> run_case(const std::string& name, const std::vector<Override>& overrides = {}) {
  const ModelFile model = read_model(std::string(GUDGEON_SOURCE_DIR) + "/tests/cases/" + name + ".toml", {}, overrides);
  EXPECT_FALSE(model.diagnostics.has_errors()) << name;
  auto stages = run_study(model.mechanism, model.study);
  for (const StageRecord& stage : stages) EXPECT_EQ(stage.status, StageStatus::finished) << name << stage.message;
  return stages;
}

TEST(StoppedCases, BristlesAndADampedContactAtALooseTolerance) {
  const auto stages = run_case("damped_bristles_loose", {{"study.compare_ideal", "false"}});
  EXPECT_GT(stages.back().solver.onsets, 100);
}

TEST(StoppedCases, LightlyLoadedContactsOnWornSurfaces) {
  const auto stages = run_case("light_worn_contacts");
  ASSERT_EQ(stages.size(), 3U);
  EXPECT_GT(stages.back().solver.onsets, 10);
}

// The crank's angle comes to one value as the tolerance does; what is left at 1e-10 is its own error.
TEST(StoppedCases, AChangePointIsPassedAtEveryTolerance) {
  constexpr double kAngle = 112.8366278;  // [rad] after 3 s, to the digits that 1e-12 and 1e-13 share
  for (const auto& [tolerance, error] : {std::pair{"1e-10", 1e-6}, {"1e-11", 3e-7}, {"1e-12", 1e-7}, {"1e-13", 1e-7}}) {
    const auto stages = run_case("change_point_tight", {{"study.relative_tolerance", tolerance}});
    ASSERT_EQ(stages.size(), 1U);
    EXPECT_NEAR(find_values(stages[0], "crank.angle")->back(), kAngle, error) << tolerance;
    EXPECT_NEAR(stages[0].energy.residual(), 0.0, 1e-8 * stages[0].energy.exchanged) << tolerance;
  }
}

}  // namespace
}  // namespace gudgeon
