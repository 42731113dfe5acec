// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Times contestants in turn, round after round, so that what disturbs a shared machine disturbs all of them alike, and
// compares them within each round.
#pragma once

#include <benchmark/benchmark.h>

#include <functional>
#include <string>
#include <vector>

namespace gudgeon::bench {

struct Contestant {
  std::string name;
  std::function<void(int)> run;  ///< does its work so many times
};

/// Median and quartiles.
struct Spread {
  double median = 0.0;
  double lower = 0.0;
  double upper = 0.0;
};

/// The spread of at least one value.
Spread find_spread(std::vector<double> values);

class PairedRounds {
 public:
  /// The first contestant is the one that ratios are to. A turn of each takes about this long [s], or one run of its
  /// work where that is longer.
  PairedRounds(std::vector<Contestant> contestants, double turn_time);

  /// One turn of each contestant; returns what it took [s].
  double run();

  [[nodiscard]] std::size_t size() const { return contestants_.size(); }
  [[nodiscard]] const std::string& name(std::size_t k) const { return contestants_[k].name; }
  /// Time of one piece of work [s].
  [[nodiscard]] Spread find_time(std::size_t k) const { return find_spread(times_[k]); }
  /// Time of contestant k over that of contestant `base`, taken round by round.
  [[nodiscard]] Spread find_ratio(std::size_t k, std::size_t base) const;

 private:
  double take_turn(std::size_t k);

  std::vector<Contestant> contestants_;
  std::vector<int> counts_;                 // pieces of work a turn
  std::vector<std::vector<double>> times_;  // times_[contestant][round]
};

}  // namespace gudgeon::bench
