// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Min-max reduction.
#include "gudgeon/report/html/reduced_signal.h"

#include <algorithm>

namespace gudgeon {

namespace {

/// Calls visit(first, last) for every span of samples before the full ones.
template <class Visit>
void for_each_span(const SignalCut& cut, Visit visit) {
  const std::size_t n_head = cut.n_samples - std::min(cut.n_full, cut.n_samples);
  const std::size_t n_spans = std::min(cut.n_spans, n_head);
  for (std::size_t k = 0; k < n_spans; ++k) visit(k * n_head / n_spans, (k + 1) * n_head / n_spans);
}

}  // namespace

std::vector<double> reduce_signal(const std::vector<double>& values, const SignalCut& cut) {
  std::vector<double> reduced;
  for_each_span(cut, [&](std::size_t first, std::size_t last) {
    const auto from = values.begin() + static_cast<std::ptrdiff_t>(first);
    const auto [least, greatest] = std::minmax_element(from, values.begin() + static_cast<std::ptrdiff_t>(last));
    reduced.push_back(*std::min(least, greatest));
    reduced.push_back(*std::max(least, greatest));
  });
  reduced.insert(reduced.end(), values.end() - static_cast<std::ptrdiff_t>(std::min(cut.n_full, values.size())),
                 values.end());
  return reduced;
}

std::vector<double> reduce_times(const std::vector<double>& times, const SignalCut& cut) {
  std::vector<double> reduced;
  for_each_span(cut, [&](std::size_t first, std::size_t last) {
    const double middle = times[(first + last) / 2];
    reduced.push_back(times[first]);
    // A span of a single sample: its greatest value is its least.
    reduced.push_back(last - first > 1 ? middle : times[first]);
  });
  reduced.insert(reduced.end(), times.end() - static_cast<std::ptrdiff_t>(std::min(cut.n_full, times.size())),
                 times.end());
  return reduced;
}

}  // namespace gudgeon
