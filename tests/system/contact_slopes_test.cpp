// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// How a contact's forces answer to its motion, against forces at motions nearby.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "gudgeon/system/contact_force.h"
#include "gudgeon/system/system.h"
#include "tests/oracle/mechanisms.h"

namespace gudgeon {
namespace {

// A kind of contact: what is changed of a round journal's, or a pin in a slot with these laws.
struct ContactKind {
  std::string name;
  AnyNormalForce normal_force;
  bool is_worn = false;
  bool is_slot = false;
  NormalDirection direction = NormalDirection::gap_gradient;
};

std::vector<double> make_depths() {
  std::vector<double> depths;
  for (int k = 0; k < 60; ++k) depths.push_back(2e-6 * (1.0 + std::sin(0.3 * k)));
  return depths;
}

Contact make_contact_of(const ContactKind& kind) {
  Mechanism mechanism = kind.is_slot ? oracle::make_scotch_yoke_clearance() : oracle::make_slider_crank_clearance();
  for (Joint& joint : mechanism.joints) {
    const auto set = [&](ContactProperties& contact) {
      contact.normal_force = kind.normal_force;
      contact.friction = CoulombSmooth{0.2, 3e-3};
      contact.normal_direction = kind.direction;
    };
    if (auto* round = std::get_if<RevoluteClearance>(&joint.kind)) set(round->contact);
    if (auto* slot = std::get_if<PinInSlotClearance>(&joint.kind)) set(slot->contact);
  }
  Contact contact = compile(mechanism, assemble(mechanism)).tables.contacts.front();
  if (kind.is_worn) {
    auto& surfaces = std::get<RevoluteSurfaces>(contact.surfaces);
    surfaces.bearing_wear = RadialProfile(make_depths());
    surfaces.journal_wear = RadialProfile(make_depths());
  }
  return contact;
}

class SlopesOf : public testing::TestWithParam<ContactKind> {};

TEST_P(SlopesOf, AContactAreThoseOfForcesAlongANearbyMotion) {
  const Contact contact = make_contact_of(GetParam());
  const ContactMode mode{true, 0.05};
  // The journal touches here, deeper, faster inwards, or slipping faster, all along the normal's and the slip's own
  // directions.
  const RelativeMotion centred{Vec2{1e-9, 0.0}, {}, 0.0, 0.0, 0.0, 0.0};
  const Vec2 normal =
      GetParam().is_slot ? find_gap(contact.surfaces, centred).normal : Vec2{std::cos(0.7), std::sin(0.7)};
  double reach = 0.0;  // [m] from the middle to where the surfaces touch
  for (int pass = 0; pass < 3; ++pass) {
    reach -= find_gap(contact.surfaces, {reach * normal + 1e-12 * normal, {}}).penetration;
  }
  const auto find_forces = [&](double penetration, double rate, double slip) {
    const RelativeMotion motion{
        (reach + penetration) * normal, rate * normal + slip * perp(normal), 0.0, 0.0, 0.0, 0.0};
    return find_contact_forces(contact, motion, mode);
  };
  constexpr double kDepth = 8e-6;
  constexpr double kRate = 0.02;
  constexpr double kSlip = 1e-3;
  const ContactForces forces = find_forces(kDepth, kRate, kSlip);
  ASSERT_NEAR(forces.gap.penetration, kDepth, 1e-9);
  ASSERT_GT(forces.normal_force, 0.0);
  const ContactSlopes slopes = find_contact_slopes(contact, mode, 0.0, forces);
  const auto find_slope = [](double before, double after, double step) { return (after - before) / (2.0 * step); };
  const double by_depth = find_slope(find_forces(kDepth - 1e-9, kRate, kSlip).normal_force,
                                     find_forces(kDepth + 1e-9, kRate, kSlip).normal_force, 1e-9);
  const double by_rate = find_slope(find_forces(kDepth, kRate - 1e-5, kSlip).normal_force,
                                    find_forces(kDepth, kRate + 1e-5, kSlip).normal_force, 1e-5);
  const auto find_coefficient = [&](double slip) {
    const ContactForces at = find_forces(kDepth, kRate, slip);
    return at.friction_force / at.normal_force;
  };
  const double by_slip = find_slope(find_coefficient(kSlip - 1e-6), find_coefficient(kSlip + 1e-6), 1e-6);
  // Forward differences of a share of 1e-6, and central ones of a share of 1e-4.
  EXPECT_NEAR(slopes.force_by_penetration, by_depth, 1e-5 * by_depth);
  EXPECT_NEAR(slopes.force_by_rate, by_rate, 1e-5 * by_rate);
  EXPECT_NEAR(slopes.coefficient * forces.normal_force, forces.friction_force, 1e-12 * forces.friction_force);
  EXPECT_NEAR(slopes.coefficient_by_slip, by_slip, 1e-5 * by_slip);
}

INSTANTIATE_TEST_SUITE_P(ContactSlopes, SlopesOf,
                         testing::Values(ContactKind{"round", LankaraniNikravesh{}},
                                         ContactKind{"worn", LankaraniNikravesh{}, true},
                                         ContactKind{"worn_by_line_of_centres", LankaraniNikravesh{}, true, false,
                                                     NormalDirection::eccentricity},
                                         ContactKind{"slot", LankaraniNikravesh{}, false, true},
                                         ContactKind{"that_steps_at_onset", KelvinVoigt{1e8, 1e4}},
                                         ContactKind{"cylindrical", Johnson{}},
                                         ContactKind{"worn_cylindrical", Pereira{}, true}),
                         [](const auto& each) { return each.param.name; });

}  // namespace
}  // namespace gudgeon
