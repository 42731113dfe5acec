// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// From clearance joints to contacts: one a circle and the surface it may touch.
#pragma once

#include "gudgeon/system/tables.h"

namespace gudgeon {

/// Where the centre of a circle of the journal stands, and what it may touch.
struct ContactCircle {
  Vec2 center;  ///< [m] in the journal's body
  int journal_surface = 0;
  int bearing_surface = 0;
};

/// The circles of a joint: one in a bearing; a pin twice, against the left side of its slot and against the right; a
/// block's corners left rear, left front, right rear, right front, each against the side it faces.
std::vector<ContactCircle> find_circles(const RevoluteClearance& joint, Vec2 journal);
std::vector<ContactCircle> find_circles(const PrismaticClearance& joint, Vec2 journal);
std::vector<ContactCircle> find_circles(const PinInSlotClearance& joint, Vec2 journal);

/// The unworn surfaces of a joint's contact against one surface of its bearing.
ContactSurfaces make_surfaces(const RevoluteClearance& joint, int bearing_surface);
ContactSurfaces make_surfaces(const PrismaticClearance& joint, int bearing_surface);
ContactSurfaces make_surfaces(const PinInSlotClearance& joint, int bearing_surface);

/// Adds every clearance joint's contacts and the points they stand on.
void compile_contacts(const Mechanism& mechanism, const Topology& topology, Tables& tables);

}  // namespace gudgeon
