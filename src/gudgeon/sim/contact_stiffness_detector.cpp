// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Counting and comparing.
#include "gudgeon/sim/contact_stiffness_detector.h"

#include <algorithm>

#include "gudgeon/sim/tsitouras.h"

namespace gudgeon {

namespace {

// The explicit pair is stable up to 3.5 for decays and, with some damping, up to 2 for swings; a controlled step is
// held a little below.
constexpr double kShort = 2.0;
constexpr double kStable = 3.0;
constexpr double kStableSwing = 2.0;
// Short on average, which decays that accuracy follows are not for long; steps that the mean is taken over, and the
// most of h |λ| that counts in it.
constexpr double kShortOnAverage = 1.9;
constexpr int kMeanOf = 48;
constexpr double kMostStiffness = 4.0;
constexpr double kExplicitCost = Tsitouras::kStages - 1;  // evaluations
// An explicit step that accuracy holds is longer than an implicit one by about this.
constexpr double kLonger = 1.3;
// Solving for contact forces makes an evaluation dearer by about this: for systems of up to four equations, whose size
// is known to the compiler, and for larger ones.
constexpr double kImplicitCost = 1.2;
constexpr double kImplicitCostOfMany = 2.5;
constexpr int kMany = 3;  // contacts
// Implicit steps start short and grow; so many are given the time to. Where contacts swing, more are each time that it
// was not enough: what explicit steps have stirred up at the edge of their stability must die down first.
constexpr int kTrial = 5;
constexpr int kMostPatience = 48;

}  // namespace

bool ContactStiffnessDetector::note_explicit_step(double stiffness) {
  ++n_explicit_;
  n_short_ = stiffness > kShort ? n_short_ + 1 : 0;
  mean_ += (std::min(kMostStiffness, stiffness) - mean_) / kMeanOf;  // in this order NaN counts as the most
  const int more = patience_ / kLeastShort;
  const bool short_on_average = mean_ > kShortOnAverage && n_explicit_ >= kMeanOf * more;
  if (n_short_ < patience_ && !short_on_average) return false;
  trial_ = short_on_average ? kTrial * more : kTrial;
  n_implicit_ = 0;
  forget();
  return true;
}

bool ContactStiffnessDetector::note_implicit_step(double h, long n_evaluations, const ContactRates& rates,
                                                  int n_pressing) {
  ++n_implicit_;
  const double dearer = n_pressing < kMany ? kImplicitCost : kImplicitCostOfMany;
  const double implicit_cost = dearer * static_cast<double>(n_evaluations) / h;
  const double explicit_cost =
      kExplicitCost * std::max({rates.decay / kStable, rates.swing / kStableSwing, 1.0 / (kLonger * h)});
  if (explicit_cost >= implicit_cost || n_implicit_ < trial_) return false;
  patience_ = n_implicit_ == trial_ ? std::min(2 * patience_, kMostPatience) : kLeastShort;
  return true;
}

void ContactStiffnessDetector::forget() {
  n_short_ = 0;
  n_explicit_ = 0;
  mean_ = 0.0;
}

}  // namespace gudgeon
