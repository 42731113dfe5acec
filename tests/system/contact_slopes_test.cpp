// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// How a contact's forces answer to its motion, against forces at motions nearby.
#include <gtest/gtest.h>

#include "gudgeon/system/contact_force.h"
#include "gudgeon/system/system.h"
#include "tests/oracle/mechanisms.h"

namespace gudgeon {
namespace {

TEST(ContactSlopes, AreThoseOfForcesAlongANearbyMotion) {
  Mechanism mechanism = oracle::make_slider_crank_clearance();
  for (Joint& joint : mechanism.joints) {
    auto* clearance = std::get_if<RevoluteClearance>(&joint.kind);
    if (clearance != nullptr) clearance->contact.friction = CoulombSmooth{0.2, 3e-3};
  }
  const System system = compile(mechanism, assemble(mechanism));
  const Contact& contact = system.tables.contacts.front();
  const double clearance = std::get<RevoluteSurfaces>(contact.surfaces).least_clearance();
  const ContactLatch latch{true, 0.05};
  // Deeper, faster inwards, or slipping faster, all along the normal's and the slip's own directions.
  const auto find_forces = [&](double penetration, double rate, double slip) {
    const Rotation turned = make_rotation(0.7);
    const RelativeMotion motion{
        turned * Vec2{clearance + penetration, 0.0}, turned * Vec2{rate, slip}, 0.0, 0.0, 0.0, 0.0};
    return find_contact_forces(contact, motion, latch);
  };
  constexpr double kDepth = 8e-6;
  constexpr double kRate = 0.02;
  constexpr double kSlip = 1e-3;
  const ContactForces forces = find_forces(kDepth, kRate, kSlip);
  const ContactSlopes slopes = find_contact_slopes(contact, latch, 0.0, forces);
  const auto find_slope = [](double before, double after, double step) { return (after - before) / (2.0 * step); };
  const double by_depth = find_slope(find_forces(kDepth - 1e-9, kRate, kSlip).normal_force,
                                     find_forces(kDepth + 1e-9, kRate, kSlip).normal_force, 1e-9);
  const double by_rate = find_slope(find_forces(kDepth, kRate - 1e-5, kSlip).normal_force,
                                    find_forces(kDepth, kRate + 1e-5, kSlip).normal_force, 1e-5);
  const double by_slip = find_slope(find_forces(kDepth, kRate, kSlip - 1e-6).friction_force,
                                    find_forces(kDepth, kRate, kSlip + 1e-6).friction_force, 1e-6);
  EXPECT_NEAR(slopes.force_by_penetration, by_depth, 1e-5 * by_depth);
  EXPECT_NEAR(slopes.force_by_rate, by_rate, 1e-5 * by_rate);
  EXPECT_NEAR(slopes.coefficient * forces.normal_force, forces.friction_force, 1e-12 * forces.friction_force);
  EXPECT_NEAR(slopes.coefficient_by_slip * forces.normal_force, by_slip, 1e-5 * by_slip);
}

}  // namespace
}  // namespace gudgeon
