// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Which cases compute now, when there are more of them than processors.
#pragma once

#include <condition_variable>
#include <mutex>
#include <vector>

namespace gudgeon {

/// Cases begin in their order, n_turns at a time, and go on to their end: so results come as early as they can. Once
/// fewer than two cases a turn are left, one that waits goes on instead of one that is further, as soon as it would
/// else be the last to end: five equal cases on two processors take two and a half times as long as one, not three
/// times. Each case has a thread of its own, of which 2 n_turns − 1 are enough. What is computed does not depend on it.
class CaseTurns {
 public:
  CaseTurns(int n_cases, int n_turns);

  /// Blocks until the case may begin; it must not have a turn.
  void wait(int index);
  /// From a case that has a turn: lets another go on instead when it is time for that, and returns when this one may
  /// go on. progress is the share of the case that is done.
  void pass(int index, double progress);
  /// Gives the turn back for good.
  void end(int index);

  [[nodiscard]] int count_waiting();

 private:
  struct Case {
    double progress = 0.0;
    bool waits = false;
  };
  void wait_for_turn(int index, std::unique_lock<std::mutex>& lock);
  [[nodiscard]] int find_next() const;
  [[nodiscard]] bool would_be_last(int index) const;

  std::mutex mutex_;
  std::condition_variable changed_;
  const int n_turns_;
  int n_free_;  // turns that nobody has
  int n_left_;  // cases that have not ended
  std::vector<Case> cases_;
};

}  // namespace gudgeon
