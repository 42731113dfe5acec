// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Long signals made short: what must not be lost.
#include "gudgeon/report/html/reduced_signal.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace gudgeon {
namespace {

std::vector<double> make_signal(std::size_t n) {
  std::vector<double> values;
  for (std::size_t k = 0; k < n; ++k) values.push_back(std::sin(0.37 * static_cast<double>(k)));
  return values;
}

TEST(ReducedSignal, KeepsEveryPeak) {
  std::vector<double> values = make_signal(50'000);
  values[12'345] = 100.0;
  values[31'001] = -70.0;
  const std::vector<double> reduced = reduce_signal(values, {values.size(), 1000});
  EXPECT_EQ(std::ranges::count(reduced, 100.0), 1);
  EXPECT_EQ(std::ranges::count(reduced, -70.0), 1);
  EXPECT_EQ(reduced.size(), 2 * kReducedSpans + 1000);
}

TEST(ReducedSignal, EnvelopeIsThatOfEverySpan) {
  const std::vector<double> values = make_signal(7'000);
  const std::vector<double> reduced = reduce_signal(values, {values.size(), 0});
  // 7 samples a span: checked one by one against the plain definition.
  for (std::size_t k = 0; k < kReducedSpans; ++k) {
    const auto [least, greatest] = std::minmax_element(values.begin() + static_cast<std::ptrdiff_t>(7 * k),
                                                       values.begin() + static_cast<std::ptrdiff_t>(7 * k + 7));
    EXPECT_EQ(std::min(reduced[2 * k], reduced[2 * k + 1]), *least);
    EXPECT_EQ(std::max(reduced[2 * k], reduced[2 * k + 1]), *greatest);
    EXPECT_EQ(reduced[2 * k], *std::min(least, greatest)) << "what comes first stays first";
  }
}

TEST(ReducedSignal, EndIsSampleBySample) {
  const std::vector<double> values = make_signal(20'000);
  const std::vector<double> reduced = reduce_signal(values, {values.size(), 321});
  EXPECT_TRUE(std::equal(values.end() - 321, values.end(), reduced.end() - 321));
}

TEST(ReducedSignal, TimesBelongToTheirSpansAndNeverDecrease) {
  std::vector<double> times;
  for (int k = 0; k < 12'000; ++k) times.push_back(0.01 * k);
  const SignalCut cut{times.size(), 500};
  const std::vector<double> reduced = reduce_times(times, cut);
  EXPECT_EQ(reduced.size(), reduce_signal(times, cut).size());
  EXPECT_TRUE(std::ranges::is_sorted(reduced));
  EXPECT_EQ(reduced.front(), times.front());
  EXPECT_EQ(reduced.back(), times.back());
}

TEST(ReducedSignal, ShortSignalKeepsAllValues) {
  const std::vector<double> values{3.0, 1.0, 2.0};
  EXPECT_EQ(reduce_signal(values, {3, 3}), values);
  EXPECT_EQ(reduce_signal(values, {3, 10}), values);
  EXPECT_EQ(reduce_signal({}, {0, 10}), std::vector<double>{});
}

}  // namespace
}  // namespace gudgeon
