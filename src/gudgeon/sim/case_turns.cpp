// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// One lock, held for moments only.
#include "gudgeon/sim/case_turns.h"

#include <algorithm>

namespace gudgeon {

CaseTurns::CaseTurns(int n_cases, int n_turns)
    : n_turns_(n_turns), n_free_(n_turns), n_left_(n_cases), cases_(n_cases) {}

void CaseTurns::wait(int index) {
  std::unique_lock lock(mutex_);
  wait_for_turn(index, lock);
}

void CaseTurns::pass(int index, double progress) {
  std::unique_lock lock(mutex_);
  cases_[index].progress = progress;
  if (n_left_ >= 2 * n_turns_) return;
  const int next = find_next();
  if (next < 0 || cases_[next].progress >= progress || !would_be_last(next)) return;
  ++n_free_;
  wait_for_turn(index, lock);
}

void CaseTurns::end(int index) {
  const std::lock_guard lock(mutex_);
  cases_[index].progress = 1.0;
  ++n_free_;
  --n_left_;
  changed_.notify_all();
}

int CaseTurns::count_waiting() {
  const std::lock_guard lock(mutex_);
  return static_cast<int>(std::ranges::count(cases_, true, &Case::waits));
}

void CaseTurns::wait_for_turn(int index, std::unique_lock<std::mutex>& lock) {
  cases_[index].waits = true;
  changed_.notify_all();  // who waits first may have changed
  changed_.wait(lock, [&] { return n_free_ > 0 && find_next() == index; });
  cases_[index].waits = false;
  --n_free_;
  changed_.notify_all();  // another turn may be free for the next one
}

// The waiting case that is least advanced, the first of several; -1 when none waits.
int CaseTurns::find_next() const {
  int next = -1;
  for (int k = 0; k < static_cast<int>(cases_.size()); ++k) {
    if (cases_[k].waits && (next < 0 || cases_[k].progress < cases_[next].progress)) next = k;
  }
  return next;
}

// Whether what is left of a case takes longer than all that is left, shared evenly; cases count as equally long.
bool CaseTurns::would_be_last(int index) const {
  double left = 0.0;
  for (const Case& one : cases_) left += 1.0 - one.progress;
  return (1.0 - cases_[index].progress) * n_turns_ > left;
}

}  // namespace gudgeon
