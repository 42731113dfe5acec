// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Runs that go nowhere are told from those that are slow.
#include "gudgeon/sim/run_pace.h"

#include <gtest/gtest.h>

namespace gudgeon {
namespace {

// Notes steps of six evaluations until the pace is found wanting; how many evaluations that took, or the most.
std::int64_t find_stop(double cycle_time, double step, std::int64_t most) {
  RunPace pace(cycle_time);
  for (std::int64_t k = 1; 6 * k < most; ++k) {
    if (!pace.note(static_cast<double>(k) * step, 6 * k, k)) return 6 * k;
  }
  return most;
}

TEST(RunPace, StopsStepsThatWouldTakeADayACycle) {
  const std::int64_t stop = find_stop(1.0, 1e-11, 100'000'000);
  EXPECT_NEAR(static_cast<double>(stop), 2.0 * RunPace::kWindow, 20.0);
}

TEST(RunPace, LetsCostlyContactsGoOn) { EXPECT_EQ(find_stop(1.0, 1e-9, 30'000'000), 30'000'000); }

TEST(RunPace, FollowsTheTimeScale) {
  EXPECT_EQ(find_stop(1e-3, 1e-12, 10'000'000), 10'000'000);
  EXPECT_LT(find_stop(1e3, 1e-8, 10'000'000), 10'000'000);
}

}  // namespace
}  // namespace gudgeon
