// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// How long a step has to be so that a change within it falls onto its end.
#pragma once

namespace gudgeon {

/// A quantity that rises through zero at the change, as it is at the end of a step.
struct WatchedValue {
  double value = 0.0;
  double rate = 0.0;  ///< [1/s]
};

/// Newton's method on the length of a step, kept inside a bracket: whoever owns it tries the length that it asks for
/// and tells what the quantity is there. What begins above zero and falls is not past the change before it has turned.
class EventSearch {
 public:
  /// Where the step is to end: a hair before the quantity is zero, or a hair past it.
  enum class Side { before, past };

  /// The longest step, the one at which the change is expected, and the quantity at the step's start and at the end of
  /// the longest one.
  EventSearch(Side side, double longest, double expected, WatchedValue start, WatchedValue end);

  /// The length to try [s].
  [[nodiscard]] double length() const { return h_; }
  /// What a step of that length ends with, and how far off zero is near enough. False when the search is over.
  bool note(WatchedValue end, double window);
  /// The end was not finite.
  bool note_failure();

  enum class Outcome {
    found,       ///< a step of length() ends at the change
    none,        ///< the quantity does not come above zero where it was expected to
    impossible,  ///< it is above zero from the first moment on, though it begins by moving away: too long a step
  };
  [[nodiscard]] Outcome outcome() const { return outcome_; }
  /// Whether the last length that was tried is length().
  [[nodiscard]] bool is_current() const { return is_current_; }

 private:
  bool go_on(double proposal);
  bool is_past(const WatchedValue& end, double target) const;
  bool settle();

  Side side_;
  double longest_;
  double expected_;
  WatchedValue start_;
  double h_;
  double before_ = 0.0;  // the longest step known to end before the change, and what it ends with
  WatchedValue at_before_;
  double past_;  // the shortest known to end past it, or past a top that lies below it
  WatchedValue at_past_;
  bool passed_;           // a step was seen that ends past the change
  bool has_top_ = false;  // at past_ the quantity falls, without having been above zero
  Outcome outcome_ = Outcome::none;
  bool is_current_ = true;
  int n_tries_ = 0;
};

}  // namespace gudgeon
