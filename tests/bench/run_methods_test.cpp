// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Methods whose times are compared must come to the same motion.
#include <gtest/gtest.h>

#include "bench/run_cases.h"

namespace gudgeon {
namespace {

TEST(RunMethods, AgreeOverTheShortHorizon) {
  int n_compared = 0;
  for (const bench::RunCase& at : bench::make_run_cases()) {
    if (at.name != "slider_crank" && at.name != "slider_crank_friction" && at.name != "n_four_bar_2") continue;
    const std::vector<bench::Method> methods = bench::make_methods(at);
    const bench::Outcome reference = methods.front().run(1e-10, at.short_horizon);
    ASSERT_EQ(reference.samples.size(), bench::kMilestones * at.probes.size());
    // The fourth turn of a four-bar's posts is not yet reached and slider-cranks have had a few impacts: local errors
    // of 1e-8 have grown by less than a thousand.
    for (const bench::Method& method : methods) {
      const bench::Outcome outcome = method.run(1e-8, at.short_horizon);
      EXPECT_LT(bench::find_error(outcome, reference), 1e-5) << at.name << " by " << method.name;
      if (outcome.residual) {
        EXPECT_LT(*outcome.residual, 1e-2) << at.name << " by " << method.name;
      }
      ++n_compared;
    }
  }
  EXPECT_GE(n_compared, 13);
}

TEST(RunMethods, LooserIsWorseAndCheaper) {
  const bench::RunCase at = bench::make_run_cases().front();
  for (const bench::Method& method : bench::make_methods(at)) {
    const bench::Outcome reference = bench::make_methods(at).front().run(1e-11, at.short_horizon);
    const bench::Outcome loose = method.run(1e-4, at.short_horizon);
    const bench::Outcome tight = method.run(1e-9, at.short_horizon);
    EXPECT_GT(bench::find_error(loose, reference), bench::find_error(tight, reference)) << method.name;
    EXPECT_LT(loose.evaluations, tight.evaluations) << method.name;
  }
}

}  // namespace
}  // namespace gudgeon
