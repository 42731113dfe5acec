// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Contact forces on flat bearings: action and reaction, and where every watt goes, by every law that a slot may have.
#include <gtest/gtest.h>

#include <cmath>

#include "gudgeon/system/body_motion.h"
#include "gudgeon/system/contact_force.h"
#include "gudgeon/system/dynamics.h"
#include "tests/geometry/guide_motion.h"
#include "tests/laws/sample_law.h"
#include "tests/oracle/mechanisms.h"

namespace gudgeon {
namespace {

struct GuideCase {
  double side;
  bool bearing_worn;
  bool journal_worn;
  NormalDirection direction;
};
constexpr GuideCase kGuideCases[] = {
    {1.0, false, false, NormalDirection::gap_gradient}, {-1.0, true, false, NormalDirection::gap_gradient},
    {1.0, false, true, NormalDirection::gap_gradient},  {-1.0, true, true, NormalDirection::gap_gradient},
    {1.0, true, true, NormalDirection::eccentricity},   {-1.0, false, false, NormalDirection::eccentricity}};

Contact make_side_contact(const GuideCase& guide, const AnyNormalForce& law) {
  const Material steel{"steel", 200e9, 0.3};
  Contact contact;
  contact.surfaces = test::make_guide(guide.side, guide.bearing_worn, guide.journal_worn);
  contact.stiffness_factor = find_stiffness_factor(steel, steel);
  contact.contact_modulus = find_contact_modulus(steel, steel);
  contact.width = 20e-3;
  contact.normal_force = law;
  contact.damping_factor = std::visit([](const auto& any) { return any.damping_factor(); }, law);
  contact.friction = CoulombSmooth{0.2, 3e-3};
  contact.onset_speed_floor = 1e-3;
  contact.normal_direction = guide.direction;
  return contact;
}

RelativeMotion find_motion_at(const Contact& contact, double t) {
  return test::make_guide_motion(std::get<GuideSurfaces>(contact.surfaces), t);
}

TEST(GuideForce, IsThatOfASphereOfTheCornersRadius) {
  const Contact contact = make_side_contact(kGuideCases[0], Hertz{});
  const ContactForces forces = find_contact_forces(contact, find_motion_at(contact, 0.0), {true, 0.1});
  // 4/3 E* √R δ^(3/2), E* = 200 GPa/(2 · 0.91)
  EXPECT_NEAR(forces.normal_force / (4.0 / 3.0 * 200e9 / 1.82 * std::sqrt(5e-3) * std::pow(5e-5, 1.5)), 1.0, 1e-10);
}

TEST(GuideForce, TurnsNothingByItself) {
  for (const GuideCase& guide : kGuideCases) {
    const Contact contact = make_side_contact(guide, LankaraniNikravesh{0.7, 1.5});
    for (double t = 0.0; t < 2.0; t += 0.07) {
      const RelativeMotion motion = find_motion_at(contact, t);
      const ContactForces forces = find_contact_forces(contact, motion, {true, 0.1});
      ASSERT_GT(forces.normal_force, 0.0);
      const double moment =
          cross(motion.offset, forces.force_on_journal) + forces.torque_on_journal + forces.torque_on_bearing;
      EXPECT_NEAR(moment, 0.0, 1e-15 * forces.normal_force);  // levers of 0.1 m, rounded
    }
  }
}

template <class Law>
void expect_balanced_guide_power(const Law& law) {
  constexpr double kStep = 1e-6;
  for (const GuideCase& guide : kGuideCases) {
    const Contact contact = make_side_contact(guide, law);
    const ContactMode mode{true, 2e-3};
    for (double t = 0.0; t < 2.0; t += 0.07) {
      const RelativeMotion motion = find_motion_at(contact, t);
      const ContactForces forces = find_contact_forces(contact, motion, mode);
      const double power = dot(forces.force_on_journal, motion.velocity) +
                           forces.torque_on_bearing * motion.bearing_rate +
                           forces.torque_on_journal * motion.journal_rate;
      const auto energy = [&](double at) {
        return find_contact_forces(contact, find_motion_at(contact, at), mode).elastic_energy;
      };
      const double stored = (energy(t + kStep) - energy(t - kStep)) / (2.0 * kStep);
      // Lengths of 0.1 m round to 1e-17 m, a few of which over the step are 5e-11 m/s; rates are up to 1e-3 m/s.
      const double tolerance = 5e-11 * forces.normal_force;
      EXPECT_NEAR(power, -stored - forces.damping_power - forces.friction_power + forces.surface_power, tolerance)
          << Law::kName << " at " << t;
      EXPECT_GE(forces.damping_power, 0.0);
      EXPECT_GE(forces.friction_power, 0.0);
      EXPECT_TRUE(std::isfinite(forces.surface_power));
      if (!guide.bearing_worn && !guide.journal_worn) {
        EXPECT_NEAR(forces.surface_power, 0.0, 1e-16 * forces.normal_force);
      }
    }
  }
}

TEST(GuideForce, PowerIsBalancedByEveryLawThatMayBeFlat) {
  int n_laws = 0;
  for_each_alternative<AnyNormalForce>([&]<class Law> {
    if constexpr (!NeedsRoundBearing<Law>) {
      auto law = make_sample_law<Law>();
      if constexpr (requires { law.stiffness; }) law.stiffness = 1e8;
      if constexpr (std::same_as<Law, KelvinVoigt>) law.damping = 1e4;
      expect_balanced_guide_power(law);
      ++n_laws;
    }
  });
  EXPECT_GE(n_laws, 13) << "eleven point laws and two linear ones";
}

// Total momentum and angular momentum of two free bodies, one a block in the worn slot of the other.
TEST(GuideForce, LeavesAFreePairItsMomentum) {
  const Mechanism mechanism = oracle::make_free_pair_in_slot();
  const Assembly assembly = assemble(mechanism);
  const auto& joint = std::get<PrismaticClearance>(mechanism.joints[0].kind);
  const double across = assembly.poses[find_body(mechanism, joint.bearing.body)].angle + joint.direction;
  for (const double shift : {-1.5, 1.5}) {
    for (const bool worn : {false, true}) {
      System system = compile(mechanism, assembly);
      if (worn) set_surfaces(system, 0, test::make_depths(80, 5e-5, 5), test::make_depths(104, 5e-5, 6));
      State state = make_state(system, assembly);
      const auto first = static_cast<std::size_t>(system.tables.counts.n_free_turns);
      state.q[first] -= shift * joint.clearance * std::sin(across);
      state.q[first + 1] += shift * joint.clearance * std::cos(across);
      Workspace workspace(system.tables);
      BodyMotionFinder finder(system);
      const std::vector<ContactMode> contact_modes(4, ContactMode{true, 0.1});
      eval_dynamics(system.tables, 0.0, state.q.data(), state.v.data(), contact_modes, {}, workspace);
      double force = 0.0;
      for (const ContactForces& forces : workspace.contact_forces) force = std::max(force, forces.normal_force);
      ASSERT_GT(force, 0.0);
      Vec2 push;
      double turn = 0.0;
      const auto& motions = finder.update(workspace);
      for (std::size_t b = 1; b < motions.size(); ++b) {
        const Body& body = mechanism.bodies[b];
        push += body.mass * motions[b].acceleration;
        turn += body.inertia * motions[b].angle_acceleration +
                body.mass * cross(motions[b].position, motions[b].acceleration);
      }
      EXPECT_NEAR(norm(push), 0.0, 1e-14 * force);
      EXPECT_NEAR(turn, 0.0, 1e-14 * force);
    }
  }
}

}  // namespace
}  // namespace gudgeon
