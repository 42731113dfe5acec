// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Long signals made short: least and greatest value of each of many short spans, and every sample at the end.
#pragma once

#include <cstddef>
#include <vector>

namespace gudgeon {

/// Spans that the part before the full samples is cut into where there is room; each leaves two values, more than a
/// screen has columns.
inline constexpr std::size_t kReducedSpans = 1000;

/// Where a signal is cut.
struct SignalCut {
  std::size_t n_samples = 0;  ///< of the signal
  std::size_t n_full = 0;     ///< the last ones, which stay as they are
  std::size_t n_spans = kReducedSpans;
};

/// Least and greatest value of each span, in the order they occur, then the full samples. No peak is lost.
std::vector<double> reduce_signal(const std::vector<double>& values, const SignalCut& cut);
/// The times that belong to them: of the span's first and middle sample. A peak is shown within its span.
std::vector<double> reduce_times(const std::vector<double>& times, const SignalCut& cut);

}  // namespace gudgeon
