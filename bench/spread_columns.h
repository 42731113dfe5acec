// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// A spread as three columns of a benchmark's CSV.
#pragma once

#include <benchmark/benchmark.h>

#include <cmath>
#include <optional>
#include <string>

#include "bench/paired_rounds.h"

namespace gudgeon::bench {

/// Median, first and third quartile; without a value not a number, because a CSV has the same columns in every row.
inline void put_spread(benchmark::State& bench, const std::string& name, const std::optional<Spread>& spread) {
  const Spread value = spread.value_or(Spread{std::nan(""), std::nan(""), std::nan("")});
  bench.counters[name] = value.median;
  bench.counters[name + ".q1"] = value.lower;
  bench.counters[name + ".q3"] = value.upper;
}

}  // namespace gudgeon::bench
