// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Errors against the ideal mechanism.
#include "gudgeon/analysis/ideal_comparison.h"

#include <gtest/gtest.h>

#include "gudgeon/base/diagnostics.h"
#include "tests/results/synthetic_run.h"

namespace gudgeon {
namespace {

TEST(IdealComparison, ConstantLag) {
  const RunRecord run = test::make_run();
  const IdealError error = find_ideal_error(run.stages[1], run.stages[0], "slider.x");
  EXPECT_NEAR(error.largest, 2e-4, 1e-15);
  EXPECT_NEAR(error.rms, 2e-4, 1e-15);
  EXPECT_EQ(find_ideal_error(run.stages[1], run.stages[0], "slider.x_velocity").largest, 0.0);
}

TEST(IdealComparison, FindsTheSignedPeakAndItsTime) {
  RunRecord run = test::make_run();
  run.stages[1].values[1][42] -= 3.0;
  const IdealError error = find_ideal_error(run.stages[1], run.stages[0], "slider.x_velocity");
  EXPECT_DOUBLE_EQ(error.largest, -3.0);
  EXPECT_DOUBLE_EQ(error.largest_time, 0.42);
  EXPECT_NEAR(error.rms, 3.0 * std::sqrt(0.01 / 2.0), 1e-12);
}

TEST(IdealComparison, StoppedStageIsComparedAsFarAsItCame) {
  RunRecord run = test::make_run();
  run.stages[1].time.resize(50);
  for (auto& values : run.stages[1].values) values.resize(50);
  EXPECT_EQ(find_error_series(run.stages[1], run.stages[0], "slider.x").size(), 50u);
  EXPECT_THROW(find_error_series(run.stages[0], run.stages[1], "slider.x"), NumericalError);
}

TEST(IdealComparison, RefusesOtherTimesAndMissingChannels) {
  RunRecord run = test::make_run();
  EXPECT_THROW(find_ideal_error(run.stages[1], run.stages[0], "A.normal_force"), NumericalError);
  run.stages[1].time[7] += 1e-12;
  EXPECT_NO_THROW(find_ideal_error(run.stages[1], run.stages[0], "slider.x"));
  run.stages[1].time[7] += 1e-6;
  EXPECT_THROW(find_ideal_error(run.stages[1], run.stages[0], "slider.x"), NumericalError);
  run.stages[2].values[0].clear();
  EXPECT_THROW(find_ideal_error(run.stages[2], run.stages[0], "slider.x"), NumericalError);
}

}  // namespace
}  // namespace gudgeon
