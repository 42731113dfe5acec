// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Rounds and what they say.
#include "bench/paired_rounds.h"

#include <algorithm>

namespace gudgeon::bench {

Spread find_spread(std::vector<double> values) {
  std::ranges::sort(values);
  const auto at = [&](double share) {
    const double place = share * static_cast<double>(values.size() - 1);
    const auto below = static_cast<std::size_t>(place);
    const auto above = std::min(below + 1, values.size() - 1);
    return values[below] + (place - static_cast<double>(below)) * (values[above] - values[below]);
  };
  return {at(0.5), at(0.25), at(0.75)};
}

PairedRounds::PairedRounds(std::vector<Contestant> contestants, double turn_time)
    : contestants_(std::move(contestants)), counts_(contestants_.size(), 1), times_(contestants_.size()) {
  // The first run warms caches up; the count is doubled until a turn is long enough.
  for (std::size_t k = 0; k < contestants_.size(); ++k) {
    contestants_[k].run(1);
    for (;;) {
      const double taken = contestants_[k].run(counts_[k]);
      if (taken >= 0.5 * turn_time) break;
      counts_[k] *= 2;
    }
  }
}

double PairedRounds::take_turn(std::size_t k) {
  const double taken = contestants_[k].run(counts_[k]);
  times_[k].push_back(taken / counts_[k]);
  return taken;
}

double PairedRounds::run() {
  double taken = 0.0;
  for (std::size_t k = 0; k < contestants_.size(); ++k) taken += take_turn(k);
  return taken;
}

std::optional<std::size_t> PairedRounds::find(std::string_view name) const {
  for (std::size_t k = 0; k < contestants_.size(); ++k) {
    if (contestants_[k].name == name) return k;
  }
  return std::nullopt;
}

Spread PairedRounds::find_ratio(std::size_t k, std::size_t base) const {
  std::vector<double> ratios;
  for (std::size_t round = 0; round < times_[k].size(); ++round)
    ratios.push_back(times_[k][round] / times_[base][round]);
  return find_spread(std::move(ratios));
}

}  // namespace gudgeon::bench
