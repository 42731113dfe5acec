// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Statistics against closed forms.
#include "gudgeon/results/statistics.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

namespace gudgeon {
namespace {

constexpr double kTwoPi = 2.0 * std::numbers::pi;

TEST(StatisticsAccumulator, SineOverWholeCyclesWithUnevenSteps) {
  StatisticsAccumulator accumulator({"x"});
  constexpr int kSteps = 40000;
  for (int i = 0; i <= kSteps; ++i) {
    const double s = static_cast<double>(i) / kSteps;
    const double t = 3.0 * (s + 0.05 * std::sin(kTwoPi * s));  // three cycles, steps between 0.7 and 1.3 of the mean
    const double x = 2.0 + 5.0 * std::sin(kTwoPi * t);
    accumulator.update(t, std::array{x});
  }
  const ChannelStatistics s = accumulator.summarize().front();
  EXPECT_EQ(s.channel, "x");
  // the trapezoid's error is h²/12 of the second derivative: about 1e-8 here
  EXPECT_NEAR(s.mean, 2.0, 1e-7);
  EXPECT_NEAR(s.rms, std::sqrt(4.0 + 12.5), 1e-7);
  EXPECT_NEAR(s.maximum, 7.0, 1e-6);
  EXPECT_NEAR(s.minimum, -3.0, 1e-6);
  EXPECT_NEAR(std::fmod(s.maximum_time, 1.0), 0.25, 1e-3);
  EXPECT_NEAR(std::fmod(s.minimum_time, 1.0), 0.75, 1e-3);
}

TEST(StatisticsAccumulator, WeighsByTimeAndNotByStep) {
  StatisticsAccumulator accumulator({"a", "b"});
  for (const double t : {0.0, 0.1, 0.2, 0.3, 1.0}) accumulator.update(t, std::array{t, -2.0 * t});
  const auto s = accumulator.summarize();
  EXPECT_NEAR(s[0].mean, 0.5, 1e-15);
  EXPECT_NEAR(s[1].mean, -1.0, 1e-15);
  EXPECT_EQ(s[1].peak(), -2.0);
  EXPECT_EQ(s[1].minimum_time, 1.0);
}

TEST(StatisticsAccumulator, JumpIsTwoUpdatesAtOneTime) {
  StatisticsAccumulator accumulator({"x"});
  accumulator.update(0.0, std::array{1.0});
  accumulator.update(1.0, std::array{1.0});
  accumulator.update(1.0, std::array{3.0});
  accumulator.update(2.0, std::array{3.0});
  EXPECT_EQ(accumulator.summarize()[0].mean, 2.0);
  EXPECT_EQ(accumulator.summarize()[0].rms, std::sqrt(5.0));
}

TEST(StatisticsAccumulator, ManyStepsLoseNothing) {
  StatisticsAccumulator accumulator({"x"});
  constexpr int kSteps = 3'000'000;
  for (int i = 0; i <= kSteps; ++i) accumulator.update(i * 0x1p-20, std::array{1e8 + 0.1});
  // plain summation is off by some 1e-11 here
  EXPECT_NEAR(accumulator.summarize()[0].mean / (1e8 + 0.1), 1.0, 3e-16);
}

TEST(StatisticsAccumulator, ResetForgets) {
  StatisticsAccumulator accumulator({"x"});
  accumulator.update(0.0, std::array{100.0});
  accumulator.update(1.0, std::array{100.0});
  accumulator.reset();
  EXPECT_TRUE(std::isnan(accumulator.summarize()[0].mean));
  accumulator.update(1.0, std::array{-2.0});
  EXPECT_EQ(accumulator.summarize()[0].mean, -2.0);
  EXPECT_EQ(accumulator.summarize()[0].rms, 2.0);
  accumulator.update(3.0, std::array{-2.0});
  const ChannelStatistics s = accumulator.summarize()[0];
  EXPECT_EQ(s.mean, -2.0);
  EXPECT_EQ(s.maximum, -2.0);
  EXPECT_EQ(s.maximum_time, 1.0);
}

TEST(StatisticsAccumulator, NanShowsInTheMeanAndSparesTheExtremes) {
  StatisticsAccumulator accumulator({"x"});
  accumulator.update(0.0, std::array{std::nan("")});
  accumulator.update(1.0, std::array{4.0});
  accumulator.update(2.0, std::array{std::nan("")});
  const ChannelStatistics s = accumulator.summarize()[0];
  EXPECT_TRUE(std::isnan(s.mean));
  EXPECT_TRUE(std::isnan(s.rms));
  EXPECT_EQ(s.minimum, 4.0);
  EXPECT_EQ(s.maximum, 4.0);
}

}  // namespace
}  // namespace gudgeon
