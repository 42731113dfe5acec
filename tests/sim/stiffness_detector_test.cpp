// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// When the integrators change over.
#include "gudgeon/sim/stiffness_detector.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace gudgeon {
namespace {

constexpr double kHeldStep = 1e-4;  // [s], six evaluations each

// Stiff explicit steps until the stiff integrator is called for.
int count_stiff_steps(StiffnessDetector& detector) {
  int n = 1;
  while (!detector.note_explicit_step(kHeldStep, 3.0)) ++n;
  return n;
}

TEST(StiffnessDetector, CallsAfterStiffStepsInARow) {
  StiffnessDetector detector;
  EXPECT_EQ(count_stiff_steps(detector), 15);
}

TEST(StiffnessDetector, AccurateStepsVoidTheStiffOnesBefore) {
  StiffnessDetector detector;
  for (int k = 0; k < 14; ++k) EXPECT_FALSE(detector.note_explicit_step(kHeldStep, 3.0));
  for (int k = 0; k < 6; ++k) EXPECT_FALSE(detector.note_explicit_step(kHeldStep, 0.5));
  EXPECT_EQ(count_stiff_steps(detector), 15);
  // Five do not.
  for (int k = 0; k < 14; ++k) EXPECT_FALSE(detector.note_explicit_step(kHeldStep, 3.0));
  for (int k = 0; k < 5; ++k) EXPECT_FALSE(detector.note_explicit_step(kHeldStep, 0.5));
  EXPECT_TRUE(detector.note_explicit_step(kHeldStep, 3.0));
}

TEST(StiffnessDetector, StaysWithWhatPays) {
  StiffnessDetector detector;
  count_stiff_steps(detector);
  // Four evaluations that count as eight, over a hundred explicit steps.
  for (int k = 0; k < 1000; ++k) EXPECT_FALSE(detector.note_stiff_step(100.0 * kHeldStep, 4)) << k;
  detector.forget();
  EXPECT_EQ(count_stiff_steps(detector), 15);
}

TEST(StiffnessDetector, GivesUpWhatDoesNotPayAndWaitsLonger) {
  StiffnessDetector detector;
  int waited = count_stiff_steps(detector);
  for (int round = 0; round < 12; ++round) {
    int n = 1;
    while (!detector.note_stiff_step(0.1 * kHeldStep, 4)) ++n;
    // It has taken no more than the steps before it, to the next fifty.
    EXPECT_LE(n * 8, 6 * waited + 50 * 8);
    const int now = count_stiff_steps(detector);
    EXPECT_EQ(now, std::min(2 * waited, 15 << 10));
    waited = now;
  }
}

TEST(StiffnessDetector, AStintCutShortCountsToo) {
  StiffnessDetector detector;
  count_stiff_steps(detector);
  detector.note_stiff_step(0.1 * kHeldStep, 4);
  detector.forget();
  EXPECT_EQ(count_stiff_steps(detector), 30);
  // One that pays makes up for one that did not.
  detector.note_stiff_step(100.0 * kHeldStep, 4);
  detector.forget();
  EXPECT_EQ(count_stiff_steps(detector), 15);
}

}  // namespace
}  // namespace gudgeon
