// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Counting and comparing.
#include "gudgeon/sim/implicit_watch.h"

#include <algorithm>

#include "gudgeon/sim/tsitouras.h"

namespace gudgeon {

namespace {

// The explicit pair is stable up to 3.5 for decays; a controlled step is held a little below.
constexpr double kShort = 2.0;
constexpr double kStable = 3.0;
constexpr double kExplicitCost = Tsitouras::kStages - 1;  // evaluations
// An explicit step that accuracy holds is longer than an implicit one by about this.
constexpr double kLonger = 1.3;
// Solving for contact forces makes an evaluation dearer by about this.
constexpr double kImplicitCost = 1.2;
// Implicit steps start short and grow; so many are given the time to.
constexpr int kTrial = 5;
constexpr int kMostPatience = 48;

}  // namespace

bool ImplicitWatch::note_explicit_step(double stiffness) {
  n_short_ = stiffness > kShort ? n_short_ + 1 : 0;
  if (n_short_ < patience_) return false;
  n_short_ = 0;
  n_implicit_ = 0;
  return true;
}

bool ImplicitWatch::note_implicit_step(double h, long n_evaluations, double fastest_rate) {
  ++n_implicit_;
  const double implicit_cost = kImplicitCost * static_cast<double>(n_evaluations) / h;
  const double explicit_cost = kExplicitCost * std::max(fastest_rate / kStable, 1.0 / (kLonger * h));
  if (explicit_cost >= implicit_cost || n_implicit_ < kTrial) return false;
  patience_ = n_implicit_ == kTrial ? std::min(2 * patience_, kMostPatience) : kLeastShort;
  return true;
}

void ImplicitWatch::forget() { n_short_ = 0; }

}  // namespace gudgeon
