// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// How near a free journal can come to worn surfaces between two instants, whatever their cells.
#pragma once

#include "gudgeon/geometry/contact_surfaces.h"

namespace gudgeon {

/// Where a journal is against the unworn surfaces, and over which places of the worn ones.
struct WornFlight {
  double reach = 0.0;         ///< [m] penetration of the unworn surfaces
  double reach_rate = 0.0;    ///< [m/s]
  double bearing_at = 0.0;    ///< [rad], of a slot [m] along it
  double bearing_rate = 0.0;  ///< [rad/s] or [m/s]
  double journal_at = 0.0;    ///< [rad] in the journal's body
  double journal_rate = 0.0;  ///< [rad/s]
};

WornFlight find_worn_flight(const ContactSurfaces& surfaces, const RelativeMotion& motion) noexcept;

/// A penetration [m] that is not reached between two instants so far [s] apart: the unworn surfaces' at most, by the
/// faster of both rates, less the least depths of all places that can be passed at twice the faster of both rates.
double find_greatest_penetration(const ContactSurfaces& surfaces, const WornFlight& start, const WornFlight& end,
                                 double duration) noexcept;

}  // namespace gudgeon
