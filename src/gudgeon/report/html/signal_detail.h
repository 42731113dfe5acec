// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// How much of a case's signals a page has room for.
#pragma once

#include <cstddef>
#include <span>

#include "gudgeon/report/figures/figure.h"
#include "gudgeon/results/run_record.h"

namespace gudgeon {

struct SignalDetail {
  double full_cycles = 0.0;  ///< at the end of every stage, sample by sample
  std::size_t n_spans = 0;   ///< of what came before, each with its least and greatest value
  bool has_samples = true;   ///< false: only what is no recorded signal, such as worn surfaces
};

/// The most that fits into so many bytes; has samples however few they are.
SignalDetail find_signal_detail(const RunRecord& run, std::size_t bytes);

/// Bytes of figures that recorded signals have no part in, on the page; at most.
std::size_t find_fixed_size(std::span<const Figure> figures);

/// More would be slow to draw as an orbit and no easier to read.
inline constexpr double kMostFullCycles = 20.0;

}  // namespace gudgeon
