// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// When steps change over to the implicit ones and back.
#include "gudgeon/sim/implicit_watch.h"

#include <gtest/gtest.h>

namespace gudgeon {
namespace {

constexpr double kStiff = 3.0;
constexpr double kSmooth = 0.5;

// Short explicit steps until implicit ones are called for.
int count_calls_until_change(ImplicitWatch& watch) {
  int n = 1;
  while (!watch.note_explicit_step(kStiff) && n < 1000) ++n;
  return n;
}

TEST(ImplicitWatch, AFewShortStepsInARowCallForImplicitOnes) {
  ImplicitWatch watch;
  EXPECT_FALSE(watch.note_explicit_step(kStiff));
  EXPECT_FALSE(watch.note_explicit_step(kStiff));
  EXPECT_FALSE(watch.note_explicit_step(kSmooth)) << "not in a row";
  EXPECT_EQ(count_calls_until_change(watch), 3);
}

TEST(ImplicitWatch, AChangeOfContactBeginsAnew) {
  ImplicitWatch watch;
  watch.note_explicit_step(kStiff);
  watch.note_explicit_step(kStiff);
  watch.forget();
  EXPECT_EQ(count_calls_until_change(watch), 3);
}

TEST(ImplicitWatch, GoesOnAsLongAsExplicitStepsWouldTakeMore) {
  ImplicitWatch watch;
  count_calls_until_change(watch);
  // 14 evaluations for 50 us, where stability would hold explicit steps to 3 us.
  for (int k = 0; k < 100; ++k) ASSERT_FALSE(watch.note_implicit_step(5e-5, 14, 1e6)) << k;
  // The rate falls: explicit steps could be 60 us long.
  EXPECT_TRUE(watch.note_implicit_step(5e-5, 14, 5e4));
  EXPECT_EQ(count_calls_until_change(watch), 3) << "it has paid: no more patience than before";
}

TEST(ImplicitWatch, WhereItDoesNotPayAtOnceMoreShortStepsAreWaitedFor) {
  ImplicitWatch watch;
  int expected = 3;
  for (int trial = 0; trial < 10; ++trial) {
    EXPECT_EQ(count_calls_until_change(watch), expected);
    int n_steps = 1;
    while (!watch.note_implicit_step(4e-6, 14, 1e6)) ASSERT_LT(++n_steps, 100);
    EXPECT_EQ(n_steps, 5) << "the time to grow";
    expected = expected < 48 ? 2 * expected : 48;
  }
}

}  // namespace
}  // namespace gudgeon
