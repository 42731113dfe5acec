// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Whether a step is better taken explicitly or implicitly in its contact forces.
#pragma once

#include "gudgeon/base/state_archive.h"
#include "gudgeon/system/contact_response.h"

namespace gudgeon {

/// Both kinds of step start from the state alone, so a change costs next to nothing and is made as soon as it pays:
/// what counts is evaluations a second of motion. Explicit steps that stability holds short call for implicit ones, a
/// few in a row or, where a contact swings and h |λ| jumps from step to step, many on average. Implicit steps go on
/// until explicit ones, by the fastest rates there are, would take fewer evaluations. Where that is so at once, the
/// next call needs twice as many short steps; where contacts swing the implicit ones are then given twice the time.
class ContactStiffnessDetector {
 public:
  /// An explicit step with h |λ| = stiffness [1]: whether the next one is to be implicit.
  bool note_explicit_step(double stiffness);
  /// An implicit step of length h [s] that took so many evaluations, with the fastest rates at its end, where so many
  /// contacts press: whether the next one is to be explicit.
  bool note_implicit_step(double h, long n_evaluations, const ContactRates& rates, int n_pressing);
  /// A contact changes: what was counted says nothing about the motion behind it.
  void forget();

  void transfer(StateArchive& archive) { archive(n_short_, n_explicit_, mean_, n_implicit_, trial_, patience_); }

 private:
  static constexpr int kLeastShort = 3;

  int n_short_ = 0;             // explicit steps in a row
  int n_explicit_ = 0;          // since the change
  double mean_ = 0.0;           // h |λ| of explicit steps, the last ones weighing most
  int n_implicit_ = 0;          // steps since the change
  int trial_ = 0;               // implicit steps before they are judged
  int patience_ = kLeastShort;  // short steps that call for a change
};

}  // namespace gudgeon
