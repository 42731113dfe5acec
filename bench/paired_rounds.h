// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Times contestants in turn, round after round, so that what disturbs a shared machine disturbs all of them alike, and
// compares them within each round. Times are processor times.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "bench/cpu_clock.h"

namespace gudgeon::bench {

struct Contestant {
  std::string name;
  std::function<double(int)> run;  ///< does its work so many times; what that took [s]
};

/// A contestant whose work is nothing but what is to be timed: work() is called again and again.
template <class Work>
Contestant make_contestant(std::string name, Work work) {
  return {std::move(name), [work = std::move(work)](int n) mutable {
            const double start = read_cpu_clock();
            for (int i = 0; i < n; ++i) work();
            return read_cpu_clock() - start;
          }};
}

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

  /// The contestant of that name.
  [[nodiscard]] std::optional<std::size_t> find(std::string_view name) const;
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
