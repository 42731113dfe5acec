// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// The last two steps of a motion as polynomials, whichever stepper took them.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "gudgeon/base/state_archive.h"
#include "gudgeon/sim/motion_equations.h"

namespace gudgeon {

/// Three accepted states in a row with their slopes, and the contact modes of the two steps between them. Allocates
/// nothing after construction.
class StepHistory {
 public:
  static constexpr int kStates = 3;

  explicit StepHistory(const MotionEquations& equations);

  /// Starts again: steps before are not looked back to.
  void clear() { n_states_ = 0; }
  /// The end of a step taken with these contact modes; slope as far as coordinates, rates and bristles go.
  void note(double time, const std::vector<double>& y, const std::vector<double>& slope,
            const std::vector<ContactMode>& contact_modes);

  [[nodiscard]] int n_states() const { return n_states_; }
  /// [s] of a state, 0 the newest.
  [[nodiscard]] double time(int age) const { return at(age).time; }
  [[nodiscard]] const std::vector<double>& state(int age) const { return at(age).y; }
  /// Of the newest step.
  [[nodiscard]] const std::vector<ContactMode>& contact_modes() const { return at(0).contact_modes; }
  /// Contact modes of the step that a time between the oldest and the newest state lies in.
  [[nodiscard]] const std::vector<ContactMode>& find_contact_modes(double time) const;
  /// Coordinates by the polynomial of degree 5 through values, rates and accelerations at both ends of the step, rates
  /// and bristles by that of degree 3 through values and slopes.
  void interpolate(double time, double* y) const noexcept;

  void transfer(StateArchive& archive) { archive(entries_, newest_, n_states_); }

 private:
  struct Entry {
    void transfer(StateArchive& archive) { archive(time, y, slope, contact_modes); }

    double time = 0.0;  // [s]
    std::vector<double> y;
    std::vector<double> slope;
    std::vector<ContactMode> contact_modes;  // of the step that ends here
  };
  [[nodiscard]] const Entry& at(int age) const { return entries_[(newest_ + kStates - age) % kStates]; }
  [[nodiscard]] int find_end(double time) const { return n_states_ > 2 && time <= at(1).time ? 1 : 0; }

  std::size_t n_free_;
  std::size_t n_wanted_;
  std::array<Entry, kStates> entries_;
  int newest_ = 0;
  int n_states_ = 0;
};

}  // namespace gudgeon
