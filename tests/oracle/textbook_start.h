// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// A consistent state for the oracle at time zero, from the start guesses of the description.
#pragma once

#include "tests/oracle/textbook.h"

namespace gudgeon::oracle {

/// Where a journal is in its bearing: in the frame's axes, or in a slot how far to its left [m] and how far a block is
/// tilted [rad].
struct Eccentricity {
  Vec2 vector;  ///< e [m], journal minus bearing centre; or (m, rad) in a slot
  Vec2 rate;    ///< [m/s], or (m/s, rad/s)
};

/// Places bodies by their guesses, closes joints by Newton's method with the smallest change, and finds velocities
/// that hold the given start rates and all constraints. Journals get the eccentricities given, one a clearance joint;
/// without any they are concentric and at rest in their bearings. No contact is active.
/// Throws std::runtime_error when positions do not close or rates conflict. Rates not determined are the least ones.
TextbookState find_start(const Mechanism& mechanism, const std::vector<Eccentricity>& eccentricities = {});

/// The start with every journal 8 um and more deep in its bearing, moving further in, in contact.
TextbookState make_pressed_state(const Mechanism& mechanism);

}  // namespace gudgeon::oracle
