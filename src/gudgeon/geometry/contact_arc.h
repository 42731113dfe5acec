// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// How much of its bearing a journal touches when it is pressed into it.
#pragma once

#include <cmath>

namespace gudgeon {

struct ContactArc {
  double half_angle;  ///< β [rad], from the line of centres to where the two circles intersect
  double length;      ///< R_i sin β [m], taken as the whole arc in contact
};

/// cos β = (e² + R_i² − R_j²)/(2 e R_i), arc length R_i sin β, with e = R_i − R_j + δ.
///
/// The real arc is narrower than the geometric overlap; the paper takes half the chord for it. δ → 0: both vanish as
/// √δ. At e² = R_i² − R_j² the chord is the journal's diameter, half of its circumference in contact; a deeper journal
/// keeps that. Eqs. (26) to (28) of the paper, written with 1 − cos β = δ (2 R_j − δ)/(2 e R_i), which loses no digits
/// at small δ. Holds for R_j < R_i.
inline ContactArc find_contact_arc(double penetration, double bearing_radius, double journal_radius) noexcept {
  if (!(penetration > 0.0)) return {0.0, 0.0};
  const double eccentricity = bearing_radius - journal_radius + penetration;
  if (eccentricity * eccentricity > bearing_radius * bearing_radius - journal_radius * journal_radius) {
    return {std::asin(journal_radius / bearing_radius), journal_radius};
  }
  const double versine = penetration * (2.0 * journal_radius - penetration) / (2.0 * eccentricity * bearing_radius);
  const double sine = std::sqrt(versine * (2.0 - versine));
  return {std::atan2(sine, 1.0 - versine), bearing_radius * sine};
}

/// The same on a flat bearing, R_i → ∞: R_i sin β → √(δ (2 R_j − δ)), again half the chord of the overlap and at most
/// the journal's radius [m].
inline double find_flat_contact_length(double penetration, double journal_radius) noexcept {
  if (!(penetration > 0.0)) return 0.0;
  if (penetration > journal_radius) return journal_radius;
  return std::sqrt(penetration * (2.0 * journal_radius - penetration));
}

}  // namespace gudgeon
