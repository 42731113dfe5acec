// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Whether a step is better taken explicitly or implicitly in its contact forces.
#pragma once

namespace gudgeon {

/// Both kinds of step start from the state alone, so a change costs nothing and is made as soon as it pays: what counts
/// is evaluations a second of motion. Explicit steps that stability holds short call for implicit ones; these go on
/// until explicit ones, by the fastest rate there is, would take fewer evaluations. Where that is so at once, the next
/// call needs twice as many short steps.
class ImplicitWatch {
 public:
  /// An explicit step with h |λ| = stiffness [1]: whether the next one is to be implicit.
  bool note_explicit_step(double stiffness);
  /// An implicit step of length h [s] that took so many evaluations, with the fastest rate |λ| [1/s] at its end:
  /// whether the next one is to be explicit.
  bool note_implicit_step(double h, long n_evaluations, double fastest_rate);
  /// A contact changes: what was counted says nothing about the motion behind it.
  void forget();

 private:
  static constexpr int kLeastShort = 3;

  int n_short_ = 0;             // explicit steps in a row
  int n_implicit_ = 0;          // steps since the change
  int patience_ = kLeastShort;  // short steps that call for a change
};

}  // namespace gudgeon
