// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Counting and judging.
#include "gudgeon/sim/stiffness_detector.h"

#include <algorithm>

#include "gudgeon/sim/tsitouras.h"

namespace gudgeon {

namespace {

// The pair is stable up to 3.5 for decays, and next to stable up to 1 for swings; a controlled step keeps a little off.
// Where accuracy holds the step it is below 1 at any tolerance in use.
constexpr double kStiff = 1.5;
// So many smooth steps on end void the stiff ones before (Hairer & Wanner 1996, IV.2).
constexpr int kMostSmooth = 6;
// The stiff integrator starts at order 1 and has its full order after some 40 steps.
constexpr int kTrial = 50;
// An implicit step solves linear equations beside its evaluations, which takes about as long again.
constexpr double kStiffCost = 2.0;

}  // namespace

bool StiffnessDetector::note_explicit_step(double h, double stiffness) {
  if (stiffness > kStiff) {
    ++n_stiff_;
    n_smooth_ = 0;
    stiff_time_ += h;
  } else if (++n_smooth_ == kMostSmooth) {
    n_stiff_ = 0;
    stiff_time_ = 0.0;
  }
  if (n_stiff_ < patience_) return false;
  stake_ = n_stiff_ * (Tsitouras::kStages - 1);
  explicit_cost_ = stake_ / stiff_time_;
  n_stiff_ = 0;
  stiff_time_ = 0.0;
  return true;
}

bool StiffnessDetector::note_stiff_step(double h, std::int64_t n_evaluations) {
  ++n_tried_;
  trial_time_ += h;
  trial_cost_ += kStiffCost * static_cast<double>(n_evaluations);
  if (n_tried_ % kTrial != 0) return false;
  const bool pays = trial_cost_ <= explicit_cost_ * trial_time_;
  if (!pays && trial_cost_ < stake_) return false;  // time to settle
  judge();
  return !pays;
}

void StiffnessDetector::forget() {
  n_stiff_ = n_smooth_ = 0;
  stiff_time_ = 0.0;
  if (n_tried_ > 0) judge();
}

void StiffnessDetector::judge() {
  const bool pays = trial_cost_ <= explicit_cost_ * trial_time_;
  patience_ = pays ? std::max(patience_ / 2, kLeastStiff) : std::min(2 * patience_, kMostStiff);
  n_tried_ = 0;
  trial_time_ = trial_cost_ = 0.0;
}

}  // namespace gudgeon
