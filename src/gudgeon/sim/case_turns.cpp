// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// One lock, held for moments only.
#include "gudgeon/sim/case_turns.h"

#include <algorithm>
#include <limits>

namespace gudgeon {

namespace {

constexpr double kNotWaiting = std::numeric_limits<double>::infinity();

}  // namespace

CaseTurns::CaseTurns(int n_cases, int n_turns)
    : n_turns_(n_turns), n_free_(n_turns), n_left_(n_cases), progress_(n_cases, kNotWaiting) {}

void CaseTurns::wait(int index, double progress) {
  std::unique_lock lock(mutex_);
  progress_[index] = progress;
  changed_.wait(lock, [&] { return n_free_ > 0 && find_next() == index; });
  progress_[index] = kNotWaiting;
  --n_free_;
  changed_.notify_all();  // another turn may be free for the next one
}

void CaseTurns::pass(int index, double progress) {
  {
    const std::lock_guard lock(mutex_);
    if (n_left_ >= 2 * n_turns_) return;
    const int next = find_next();
    if (next < 0 || progress_[next] >= progress) return;
    ++n_free_;
    changed_.notify_all();
  }
  wait(index, progress);
}

void CaseTurns::end() {
  const std::lock_guard lock(mutex_);
  ++n_free_;
  --n_left_;
  changed_.notify_all();
}

// The waiting case that is least advanced, the first of several; -1 when none waits.
int CaseTurns::find_next() const {
  const auto least = std::ranges::min_element(progress_);
  return least == progress_.end() || *least == kNotWaiting ? -1 : static_cast<int>(least - progress_.begin());
}

}  // namespace gudgeon
