// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Sums of windows without differences, which would leave rounding where nothing was.
#include "gudgeon/geometry/moving_mean.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace gudgeon {

namespace {

constexpr int kPasses = 3;
constexpr double kGreatestShare = 1.0 / 3.0;

// The values with so many more at either end, as what follows there.
void pad(const std::vector<double>& values, std::size_t n_more, bool is_round, std::vector<double>& padded) {
  padded.clear();
  const auto begin = values.begin();
  const auto end = values.end();
  const auto more = static_cast<std::ptrdiff_t>(n_more);
  if (is_round) {
    padded.insert(padded.end(), end - more, end);
    padded.insert(padded.end(), begin, end);
    padded.insert(padded.end(), begin, begin + more);
  } else {
    padded.insert(padded.end(), std::make_reverse_iterator(begin + more), std::make_reverse_iterator(begin));
    padded.insert(padded.end(), begin, end);
    padded.insert(padded.end(), values.rbegin(), values.rbegin() + more);
  }
}

// The sums of all windows of so many values: each is the tail of one block of that length and the head of the next.
void sum_windows(const std::vector<double>& values, std::size_t length, std::vector<double>& sums) {
  sums.resize(values.size() - length + 1);
  std::vector<double> tails(length);
  for (std::size_t block = 0; block < sums.size(); block += length) {
    double tail = 0.0;
    for (std::size_t k = length; k-- > 0;) tails[k] = tail += values[block + k];
    sums[block] = tails[0];
    double head = 0.0;
    const std::size_t n = std::min(length, sums.size() - block);
    for (std::size_t k = 1; k < n; ++k) sums[block + k] = tails[k] + (head += values[block + length + k - 1]);
  }
}

}  // namespace

void smooth_by_moving_means(std::vector<double>& values, double width, bool is_round) {
  const double all = static_cast<double>(values.size());
  width = std::min(width, kGreatestShare * all);
  if (!(width > 1.0)) return;
  const auto half = static_cast<std::size_t>(0.5 * (width - 1.0));  // whole cells to either side
  const double rest = 0.5 * (width - 1.0) - static_cast<double>(half);
  std::vector<double> padded;
  padded.reserve(values.size() + 2 * (half + 1));
  std::vector<double> inner;
  for (int pass = 0; pass < kPasses; ++pass) {
    pad(values, half + 1, is_round, padded);
    sum_windows(padded, 2 * half + 1, inner);
    for (std::size_t k = 0; k < values.size(); ++k) {
      values[k] = (inner[k + 1] + rest * (padded[k] + padded[k + 2 * half + 2])) / width;
    }
  }
}

}  // namespace gudgeon
