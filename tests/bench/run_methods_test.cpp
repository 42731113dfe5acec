// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Methods whose times are compared must come to the same motion.
#include <gtest/gtest.h>

#include "bench/run_cases.h"

namespace gudgeon {
namespace {

void expect_agreement(const std::string& name, double tolerance, double error) {
  int n_compared = 0;
  for (const bench::RunCase& at : bench::make_run_cases()) {
    if (at.name != name) continue;
    const std::vector<bench::Method> methods = bench::make_methods(at);
    const bench::Outcome reference = methods.front().run(1e-10, at.short_horizon);
    ASSERT_EQ(reference.samples.size(), bench::kMilestones * at.probes.size());
    for (const bench::Method& method : methods) {
      const bench::Outcome outcome = method.run(tolerance, at.short_horizon);
      EXPECT_LT(bench::find_error(outcome, reference), error) << name << " by " << method.name;
      EXPECT_LT(outcome.residual.value_or(0.0), 1e-2) << name << " by " << method.name;
      ++n_compared;
    }
  }
  EXPECT_EQ(n_compared, 5) << name;
}

// A few impacts make a thousand of each local error.
TEST(RunMethods, AgreeOnImpacts) {
  expect_agreement("slider_crank", 1e-8, 1e-5);
  expect_agreement("slider_crank_friction", 1e-8, 1e-5);
}

// Multistep formulas lose a few digits at each singular position, and tighter tolerances do not bring the textbook form
// past it.
TEST(RunMethods, AgreeOverSingularPositions) { expect_agreement("n_four_bar_2", 1e-6, 1e-3); }

TEST(RunMethods, LooserIsWorse) {
  const bench::RunCase at = bench::make_run_cases().front();
  const std::vector<bench::Method> methods = bench::make_methods(at);
  const bench::Outcome reference = methods.front().run(1e-11, at.short_horizon);
  for (const bench::Method& method : methods) {
    EXPECT_GT(bench::find_error(method.run(1e-4, at.short_horizon), reference),
              bench::find_error(method.run(1e-9, at.short_horizon), reference))
        << method.name;
  }
}

}  // namespace
}  // namespace gudgeon
