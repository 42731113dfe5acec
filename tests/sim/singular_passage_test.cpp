// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Strides over the zero of a distance, along motions that are known on both sides.
#include "gudgeon/sim/singular_passage.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace gudgeon {
namespace {

constexpr double kPassageTolerance = 1e-9;
constexpr double kSingularTime = 1.3;

double find_closeness(double t) { return 1.0 / ((t - kSingularTime) * (t - kSingularTime)); }

std::vector<double> find_y(double t) { return {std::sin(2.0 * t), std::exp(-0.7 * t), 3.0 * t}; }
std::vector<double> find_slope(double t) { return {2.0 * std::cos(2.0 * t), -0.7 * std::exp(-0.7 * t), 3.0}; }

// Notes steps of the motion from `time` on, as long as the passage lets them be, until it sees the far side. Noise is
// added to every other value.
struct Approach {
  explicit Approach(double start, double noise = 0.0) : time(start) {
    for (int k = 0; k < 400 && !far_side; ++k) {
      std::vector<double> y = find_y(time);
      if (k % 2 == 1) y[1] += noise;
      passage.note(time, y, find_slope(time), find_closeness(time));
      far_side = passage.find_far_side();
      if (far_side) break;
      const double step = std::min(0.02, passage.find_longest_step());
      if (step < 1e-7) break;
      time += step;
    }
  }

  SingularPassage passage{3, kPassageTolerance};
  std::optional<double> far_side;
  double time;
};

TEST(SingularPassage, ContinuesASmoothMotion) {
  Approach approach(0.0);
  ASSERT_TRUE(approach.far_side);
  EXPECT_LT(approach.time, kSingularTime) << "does not step there";
  // The distance is linear here, so the far side lies as far behind as the near one before; its square root was taken.
  EXPECT_NEAR(*approach.far_side, 2.0 * kSingularTime - approach.time, 1e-9);
  for (const double share : {0.1, 0.5, 1.0}) {
    const double t = approach.time + share * (*approach.far_side - approach.time);
    std::vector<double> y(3);
    approach.passage.interpolate(t, y);
    for (std::size_t i = 0; i < y.size(); ++i)
      EXPECT_NEAR(y[i], find_y(t)[i], kPassageTolerance * std::max(1.0, std::abs(y[i])));
  }
}

TEST(SingularPassage, MeetsTheLastStep) {
  Approach approach(0.0);
  ASSERT_TRUE(approach.far_side);
  std::vector<double> y(3);
  approach.passage.interpolate(approach.time, y);
  EXPECT_EQ(y, find_y(approach.time)) << "Newton's form begins with the newest node";
}

TEST(SingularPassage, RefusesARoughMotion) {
  // Noise of 1e-5 is far above what the tolerance trusts, 1e-7, once it is extrapolated.
  EXPECT_FALSE(Approach(0.0, 1e-5).far_side);
}

TEST(SingularPassage, RefusesWithoutEnoughHistory) {
  SingularPassage passage(3, kPassageTolerance);
  EXPECT_FALSE(passage.find_far_side());
  for (int k = 0; k < 6; ++k) {
    // All nearer together than a third of the stride.
    const double t = kSingularTime - 0.05 + 0.001 * k;
    passage.note(t, find_y(t), find_slope(t), find_closeness(t));
    EXPECT_FALSE(passage.find_far_side()) << k;
  }
}

TEST(SingularPassage, ForgetsAtAChangeAndFarAway) {
  for (const bool far_away : {true, false}) {
    Approach approach(0.0);
    ASSERT_TRUE(approach.far_side);
    if (far_away) {
      approach.passage.note(1.29, find_y(1.29), find_slope(1.29), 4.9);
    } else {
      approach.passage.forget();
    }
    EXPECT_FALSE(approach.passage.find_far_side());
    EXPECT_EQ(approach.passage.find_longest_step(), std::numeric_limits<double>::infinity());
  }
}

TEST(SingularPassage, NotANumberIsNotNear) {
  Approach approach(0.0);
  ASSERT_TRUE(approach.far_side);
  approach.passage.note(1.29, find_y(1.29), find_slope(1.29), std::nan(""));
  EXPECT_FALSE(approach.passage.find_far_side());
}

TEST(SingularPassage, MovingAwayNeitherStridesNorShortensSteps) {
  SingularPassage passage(3, kPassageTolerance);
  for (int k = 1; k < 40; ++k) {
    const double t = kSingularTime + 0.01 * k;
    passage.note(t, find_y(t), find_slope(t), find_closeness(t));
    EXPECT_FALSE(passage.find_far_side());
    EXPECT_EQ(passage.find_longest_step(), std::numeric_limits<double>::infinity());
  }
}

TEST(SingularPassage, StepsShortenOnlyNearIt) {
  SingularPassage passage(3, kPassageTolerance);
  for (const double left : {0.42, 0.4, 0.25, 0.23}) {
    const double t = kSingularTime - left;
    passage.note(t, find_y(t), find_slope(t), find_closeness(t));
    EXPECT_EQ(passage.find_longest_step(), std::numeric_limits<double>::infinity()) << left;
  }
  const double t = kSingularTime - 0.2;
  passage.note(t, find_y(t), find_slope(t), find_closeness(t));
  EXPECT_NEAR(passage.find_longest_step(), 0.2 * 0.2, 1e-12);  // a fifth of the time left
}

}  // namespace
}  // namespace gudgeon
