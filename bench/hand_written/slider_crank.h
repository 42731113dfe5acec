// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// The slider-crank of Flores and Ambrosio written out by hand in its two minimal coordinates.
#pragma once

#include <cmath>
#include <numbers>
#include <span>
#include <vector>

#include "bench/hand_written/journal.h"
#include "bench/textbook/maximal_form.h"

namespace gudgeon::hand_written {

/// y = [rod's angle θ, slider's x | their rates]; the crank is driven, the rod carries the bearing. Data of
/// oracle::make_slider_crank_clearance(), with friction μ tanh(v/v_t) when μ is given.
class SliderCrank {
 public:
  explicit SliderCrank(double friction_coefficient) : contact_modes(1), friction_(friction_coefficient) {}

  [[nodiscard]] std::size_t n_states() const { return 4; }
  [[nodiscard]] std::size_t size() const { return 4; }

  void eval(double t, const double* y, double* slope) const noexcept {
    const Pin pin = find_pin(t, y);
    const JournalForce at = find_journal_force(
        {pin.offset, pin.velocity, y[2], 0.0}, contact_modes[0], {kJournalRadius, kClearance, kStiffness, kDamping},
        [this](double slip) { return friction_ == 0.0 ? 0.0 : friction_ * std::tanh(slip / 1e-3); });
    // m (l/2) u⊥·r w² u₁ is what the crank pin's acceleration does.
    const double inertial = 0.5 * kRodMass * kRod * kCrank * kSpeed * kSpeed * cross(pin.rod, pin.crank);
    slope[0] = y[2];
    slope[1] = y[3];
    slope[2] = kInverseInertia * (inertial - kRod * cross(pin.rod, at.force) + at.bearing_torque);
    slope[3] = at.force.x / kSliderMass;
  }

  void find_gaps(double t, const double* y, std::span<textbook::GapSample> gaps) const noexcept {
    const Pin pin = find_pin(t, y);
    const double eccentricity = norm(pin.offset);
    gaps[0] = {eccentricity - kClearance, eccentricity > 0.0 ? dot(pin.offset, pin.velocity) / eccentricity : 0.0};
  }

  std::vector<ContactMode> contact_modes;

 private:
  struct Pin {
    Vec2 crank;  ///< unit vectors
    Vec2 rod;
    Vec2 offset;    ///< [m] journal minus bearing
    Vec2 velocity;  ///< [m/s]
  };

  static Pin find_pin(double t, const double* y) noexcept {
    const double angle = kSpeed * t;
    const Vec2 crank{std::cos(angle), std::sin(angle)};
    const Vec2 rod{std::cos(y[0]), std::sin(y[0])};
    return {crank, rod, Vec2{y[1], 0.0} - kCrank * crank - kRod * rod,
            Vec2{y[3], 0.0} - kCrank * kSpeed * perp(crank) - kRod * y[2] * perp(rod)};
  }

  static constexpr double kCrank = 0.05, kRod = 0.12, kRodMass = 0.21, kSliderMass = 0.14;
  static constexpr double kInverseInertia = 1.0 / (2.5e-4 + 0.25 * kRodMass * kRod * kRod);
  static constexpr double kSpeed = 5000.0 * std::numbers::pi / 30.0;
  static constexpr double kBearingRadius = 10e-3, kClearance = 0.5e-3, kJournalRadius = kBearingRadius - kClearance;
  static constexpr double kDamping = 0.75 * (1.0 - 0.9 * 0.9);
  static inline const double kStiffness =
      4.0 / 3.0 * 207e9 / (2.0 * (1.0 - 0.3 * 0.3)) * std::sqrt(kBearingRadius * kJournalRadius / kClearance);

  double friction_;
};

}  // namespace gudgeon::hand_written
