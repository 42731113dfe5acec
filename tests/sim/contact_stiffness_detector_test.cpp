// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// When steps change over to the implicit ones and back.
#include "gudgeon/sim/contact_stiffness_detector.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

namespace gudgeon {
namespace {

constexpr double kStiff = 3.0;
constexpr double kSmooth = 0.5;

ContactRates decays(double rate) { return {rate, 0.0}; }

// Short explicit steps until implicit ones are called for.
int count_calls_until_change(ContactStiffnessDetector& detector) {
  int n = 1;
  while (!detector.note_explicit_step(kStiff) && n < 1000) ++n;
  return n;
}

TEST(ContactStiffnessDetector, AFewShortStepsInARowCallForImplicitOnes) {
  ContactStiffnessDetector detector;
  EXPECT_FALSE(detector.note_explicit_step(kStiff));
  EXPECT_FALSE(detector.note_explicit_step(kStiff));
  EXPECT_FALSE(detector.note_explicit_step(kSmooth)) << "not in a row";
  EXPECT_EQ(count_calls_until_change(detector), 3);
}

TEST(ContactStiffnessDetector, AChangeOfContactBeginsAnew) {
  ContactStiffnessDetector detector;
  detector.note_explicit_step(kStiff);
  detector.note_explicit_step(kStiff);
  detector.forget();
  EXPECT_EQ(count_calls_until_change(detector), 3);
}

TEST(ContactStiffnessDetector, GoesOnAsLongAsExplicitStepsWouldTakeMore) {
  ContactStiffnessDetector detector;
  count_calls_until_change(detector);
  // 14 evaluations for 50 us, where stability would hold explicit steps to 3 us.
  for (int k = 0; k < 100; ++k) ASSERT_FALSE(detector.note_implicit_step(5e-5, 14, decays(1e6), 2)) << k;
  // The rate falls: explicit steps could be 60 us long.
  EXPECT_TRUE(detector.note_implicit_step(5e-5, 14, decays(5e4), 2));
  EXPECT_EQ(count_calls_until_change(detector), 3) << "it has paid: no more patience than before";
}

TEST(ContactStiffnessDetector, WhereItDoesNotPayAtOnceMoreShortStepsAreWaitedFor) {
  ContactStiffnessDetector detector;
  int expected = 3;
  for (int trial = 0; trial < 10; ++trial) {
    EXPECT_EQ(count_calls_until_change(detector), expected);
    int n_steps = 1;
    while (!detector.note_implicit_step(4e-6, 14, decays(1e6), 2)) ASSERT_LT(++n_steps, 100);
    EXPECT_EQ(n_steps, 5) << "the time to grow";
    expected = expected < 48 ? 2 * expected : 48;
  }
}

// h |λ| of explicit steps beside a contact that swings at the edge of their stability; steps until a change.
int count_swinging_steps_until_change(ContactStiffnessDetector& detector) {
  constexpr double kStiffness[] = {4.2, 0.2, 3.1, 3.0, 0.3, 9.2, 1.4};
  int n = 1;
  while (!detector.note_explicit_step(kStiffness[n % 7]) && n < 10000) ++n;
  return n;
}

TEST(ContactStiffnessDetector, ShortStepsOnAverageCallForImplicitOnesAndForEverLongerTrials) {
  ContactStiffnessDetector detector;
  int n_steps_expected = 5;
  int n_explicit_before = 0;
  for (int trial = 0; trial < 5; ++trial) {
    const int n_explicit = count_swinging_steps_until_change(detector);
    EXPECT_GT(n_explicit, std::max(40, n_explicit_before)) << "no chance, and more patience each time";
    EXPECT_LT(n_explicit, 1000);
    n_explicit_before = n_explicit;
    int n_steps = 1;
    while (!detector.note_implicit_step(4e-6, 14, {0.0, 1e5}, 1)) ASSERT_LT(++n_steps, 100);
    EXPECT_EQ(n_steps, n_steps_expected);
    n_steps_expected *= 2;
  }
}

TEST(ContactStiffnessDetector, GoesOnCountingAfterAStepThatWasLost) {
  ContactStiffnessDetector detector;
  EXPECT_FALSE(detector.note_explicit_step(std::numeric_limits<double>::quiet_NaN()));
  EXPECT_LT(count_swinging_steps_until_change(detector), 1000);
}

TEST(ContactStiffnessDetector, SmoothStepsNeverCallForImplicitOnes) {
  ContactStiffnessDetector detector;
  for (int k = 0; k < 10000; ++k) ASSERT_FALSE(detector.note_explicit_step(k % 3 == 0 ? kStiff : kSmooth)) << k;
}

TEST(ContactStiffnessDetector, ManyContactsMakeImplicitStepsDearer) {
  ContactStiffnessDetector detector;
  const auto goes_on = [&](int n_pressing) {
    count_calls_until_change(detector);
    for (int k = 0; k < 20; ++k) {
      if (detector.note_implicit_step(1e-5, 14, decays(1e6), n_pressing)) return false;
    }
    return true;
  };
  EXPECT_TRUE(goes_on(2));
  EXPECT_FALSE(goes_on(3));
}

}  // namespace
}  // namespace gudgeon
