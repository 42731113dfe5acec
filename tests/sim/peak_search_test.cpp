// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Extremes of signals with closed forms, known at few times.
#include "gudgeon/sim/peak_search.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <vector>

namespace gudgeon {
namespace {

using Signal = std::function<double(double)>;

// Takes signals at given times; what is measured between is kept.
struct Searched {
  explicit Searched(std::vector<Signal> all)
      : signals(std::move(all)), search(signals.size(), [this](double time, std::span<double> row) {
          fill(time, row);
          looks.push_back(time);
        }) {}

  void fill(double time, std::span<double> row) const {
    for (std::size_t k = 0; k < signals.size(); ++k) row[k] = signals[k](time);
  }
  void take(double time) {
    fill(time, search.next_row());
    search.take(time);
  }
  [[nodiscard]] double find_greatest(std::size_t signal) const {
    double greatest = -std::numeric_limits<double>::infinity();
    for (const double time : looks) greatest = std::max(greatest, signals[signal](time));
    return greatest;
  }

  std::vector<Signal> signals;
  std::vector<double> looks;
  PeakSearch search;
};

// A wave in points a quarter to 1.4 rad apart, wherever they fall: the peak is known to 4e-5, by a few looks.
TEST(PeakSearch, FindsThePeakOfAWaveBetweenItsPoints) {
  for (const double step : {0.25, 0.6, 1.0, 1.4}) {
    for (double start = 0.0; start < step; start += 0.11) {
      Searched wave({[](double t) { return 3.0 * std::sin(t); }});
      double greatest = -4.0;
      for (double t = start - 2.0 * step; t < std::numbers::pi + step; t += step) {
        wave.take(t);
        greatest = std::max(greatest, wave.signals[0](t));
      }
      EXPECT_GT(std::max(greatest, wave.find_greatest(0)), 3.0 * (1.0 - 4e-5)) << step << ' ' << start;
      EXPECT_LE(wave.looks.size(), 8U) << step << ' ' << start;
    }
  }
}

TEST(PeakSearch, FindsTroughsAndSkewedPeaks) {
  // −t² exp(−t): least −4/e² at 2; the parabola through coarse points is well beside it.
  Searched skewed({[](double t) { return -t * t * std::exp(-t); }});
  for (double t = 0.0; t < 8.0; t += 1.3) skewed.take(t);
  double least = 0.0;
  for (const double time : skewed.looks) least = std::min(least, skewed.signals[0](time));
  EXPECT_NEAR(least, -4.0 * std::exp(-2.0), 4e-5 * 4.0 * std::exp(-2.0));
  EXPECT_LE(skewed.looks.size(), 5U);
}

TEST(PeakSearch, LooksOnlyWhereAnExtremeWouldBeNew) {
  // Peaks that fall, then one that is higher; a line beside them never turns.
  Searched waves({[](double t) { return t < 40.0 ? std::exp(-0.05 * t) * std::cos(t) : 2.0 * std::cos(t); },
                  [](double t) { return t; }});
  for (double t = -1.0; t < 39.0; t += 0.5) waves.take(t);
  const auto n_first = waves.looks.size();
  EXPECT_GT(n_first, 0U);
  for (const double time : waves.looks) EXPECT_LT(time, 4.0) << "later ones are lower";
  for (double t = 41.0; t < 60.0; t += 0.5) waves.take(t);
  EXPECT_NEAR(waves.find_greatest(0), 2.0, 8e-5);
}

TEST(PeakSearch, ForgetsWhatCameBeforeForOneSignal) {
  const Signal falling = [](double t) { return std::exp(-0.1 * t) * std::pow(std::sin(t), 2); };
  Searched two({falling, falling});
  for (double t = 0.0; t < std::numbers::pi; t += 0.4) two.take(t);
  const auto n_first = two.looks.size();
  two.search.forget(1);
  for (double t = 3.2; t < 2.0 * std::numbers::pi; t += 0.4) two.take(t);
  ASSERT_GT(two.looks.size(), n_first) << "the second wave counts for the signal that was forgotten";
  EXPECT_GT(two.looks.back(), 4.0);
}

TEST(PeakSearch, DoesNotLookAcrossAnInterruption) {
  Searched wave({[](double t) { return std::sin(t); }});
  wave.take(1.0);
  wave.take(1.5);
  wave.search.interrupt();
  wave.take(2.0);
  wave.take(2.5);
  EXPECT_TRUE(wave.looks.empty());
}

TEST(PeakSearch, LooksWhereItIsTold) {
  // Nothing at both ends, a bump between.
  Searched bump({[](double t) { return std::max(0.0, 1.0 - std::pow(t - 0.45, 2) / 0.09); }});
  bump.take(0.0);
  bump.take(1.0);
  EXPECT_TRUE(bump.looks.empty());
  bump.search.look_between(0.327, 0);
  EXPECT_NEAR(bump.find_greatest(0), 1.0, 4e-5);
}

TEST(PeakSearch, PassesOverWhatIsNoNumber) {
  Searched odd({[](double t) { return t > 0.9 && t < 2.1 ? std::nan("") : std::sin(t); }, [](double) { return 7.0; }});
  for (double t = 0.0; t < 4.0; t += 0.5) odd.take(t);
  EXPECT_TRUE(odd.looks.empty());
}

}  // namespace
}  // namespace gudgeon
