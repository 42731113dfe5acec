// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Contact forces: stiffness, signs, action and reaction, and where every watt goes.
#include "gudgeon/system/contact_force.h"

#include <gtest/gtest.h>

#include <limits>
#include <random>

#include "gudgeon/system/body_motion.h"
#include "gudgeon/system/dynamics.h"
#include "tests/laws/sample_law.h"
#include "tests/oracle/mechanisms.h"

namespace gudgeon {
namespace {

const Material kSteel{"", 200e9, 0.3};

RadialProfile make_wear(std::size_t n, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(0.0, 4e-5);
  std::vector<double> depths(n);
  for (double& depth : depths) depth = uniform(random);
  return RadialProfile(depths);
}

void set_normal_force(Contact& contact, const AnyNormalForce& any) {
  contact.normal_force = any;
  contact.damping_factor = std::visit([](const auto& law) { return law.damping_factor(); }, any);
}

Contact make_contact(double clearance) {
  Contact contact;
  contact.surfaces = RevoluteSurfaces{15e-3, 15e-3 - clearance, {}, {}};
  contact.stiffness_factor = find_stiffness_factor(kSteel, kSteel);
  contact.contact_modulus = find_contact_modulus(kSteel, kSteel);
  contact.width = 20e-3;
  set_normal_force(contact, LankaraniNikravesh{0.7, 1.5});
  contact.friction = CoulombSmooth{0.2, 3e-3};
  contact.onset_speed_floor = 1e-3;
  return contact;
}

struct Surfaces {
  bool bearing_worn;
  bool journal_worn;
  NormalDirection direction;
};
constexpr Surfaces kSurfaces[] = {
    {false, false, NormalDirection::gap_gradient}, {true, false, NormalDirection::gap_gradient},
    {false, true, NormalDirection::gap_gradient},  {true, true, NormalDirection::gap_gradient},
    {true, true, NormalDirection::eccentricity},   {false, true, NormalDirection::eccentricity}};

Contact make_contact(const Surfaces& surfaces) {
  Contact contact = make_contact(0.5e-3);
  auto& worn = std::get<RevoluteSurfaces>(contact.surfaces);
  if (surfaces.bearing_worn) worn.bearing_wear = make_wear(20, 1);
  if (surfaces.journal_worn) worn.journal_wear = make_wear(26, 2);
  contact.normal_direction = surfaces.direction;
  return contact;
}

// A journal that stays pressed in while it circles, and both bodies turn.
RelativeMotion make_pressed_motion(double t) {
  const double radius = 6.4e-4 + 2e-5 * std::sin(5.0 * t);
  const double radius_rate = 1e-4 * std::cos(5.0 * t);
  const double direction = 0.4 - 3.0 * t;
  const Vec2 normal{std::cos(direction), std::sin(direction)};
  return {
      radius * normal, radius_rate * normal + (-3.0 * radius) * perp(normal), 1.3 + 2.0 * t, -0.7 - 4.5 * t, 2.0, -4.5};
}

TEST(ContactForce, HasTheStiffnessOfThePaper) {
  for (const auto& [clearance, stiffness] : {std::pair{0.3e-3, 1.256e11}, {0.5e-3, 9.664e10}, {0.8e-3, 7.560e10}}) {
    Contact contact = make_contact(clearance);
    set_normal_force(contact, Hertz{});
    constexpr double kPenetration = 1e-6;
    const ContactForces forces = find_contact_forces(contact, {{clearance + kPenetration, 0.0}, {}}, {true, 0.1});
    const double found = forces.normal_force / (kPenetration * std::sqrt(kPenetration));
    EXPECT_NEAR(found, stiffness, 5e-4 * stiffness);  // printed with four digits
  }
}

TEST(ContactForce, IsNothingUnlessActiveAndPressed) {
  const Contact contact = make_contact(0.5e-3);
  const RelativeMotion pressed = make_pressed_motion(0.0);
  const RelativeMotion apart{{0.4e-3, 0.0}, {1.0, 1.0}, 0.0, 0.0, 3.0, -3.0};
  for (const ContactForces& forces :
       {find_contact_forces(contact, pressed, {false, 0.1}), find_contact_forces(contact, apart, {true, 0.1})}) {
    EXPECT_EQ(forces.normal_force, 0.0);
    EXPECT_EQ(forces.friction_force, 0.0);
    EXPECT_EQ(forces.force_on_journal, (Vec2{}));
    EXPECT_EQ(forces.torque_on_bearing, 0.0);
    EXPECT_EQ(forces.torque_on_journal, 0.0);
    EXPECT_EQ(forces.elastic_energy, 0.0);
    EXPECT_NE(forces.gap.penetration, 0.0) << "the gap is told all the same";
  }
}

// A linear damper presses from the first touch on; a hair before it an active contact presses as much.
TEST(ContactForce, BeginsWithItsStep) {
  for (const AnyNormalForce& law :
       {AnyNormalForce{KelvinVoigt{2e8, 3e3}}, AnyNormalForce{Anagnostopoulos{2e8, 0.14}}}) {
    EXPECT_TRUE(steps_at_onset(law));
    Contact contact = make_contact(0.5e-3);
    set_normal_force(contact, law);
    contact.steps_at_onset = true;
    const auto press = [&](double penetration, double rate) {
      return find_contact_forces(contact, {{0.5e-3 + penetration, 0.0}, {rate, 0.2}}, {true, 0.1});
    };
    EXPECT_GT(press(-1e-12, 0.1).normal_force, 1.0);
    // A picometre's elastic force, 2e-4 N, and rounding of half a millimetre.
    EXPECT_NEAR(press(-1e-12, 0.1).normal_force, press(1e-12, 0.1).normal_force, 4e-4);
    EXPECT_EQ(press(-1e-12, -0.1).normal_force, 0.0) << "parted";
    EXPECT_NEAR(press(-1e-12, 0.1).elastic_energy, 0.0, 1e-20);
    EXPECT_EQ(find_contact_forces(contact, {{0.4e-3, 0.0}, {0.1, 0.0}}, {false, 0.0}).normal_force, 0.0);
  }
  EXPECT_FALSE(steps_at_onset(LankaraniNikravesh{}));
}

TEST(ContactForce, HandsOnNaN) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const ContactForces forces = find_contact_forces(make_contact(0.5e-3), {{nan, 0.0}, {}}, {true, 0.1});
  EXPECT_TRUE(std::isnan(forces.normal_force));
  EXPECT_TRUE(std::isnan(forces.force_on_journal.x));
}

TEST(ContactForce, PressesBackAndRubsAgainstTheSlip) {
  const Contact contact = make_contact(0.5e-3);
  // Journal pressed along +x, turning counter-clockwise: its surface there moves along +y.
  const double e = 0.6e-3;
  const ContactForces spun = find_contact_forces(contact, {{e, 0.0}, {}, 0.0, 0.0, 0.0, 10.0}, {true, 0.1});
  const double lever = 14.5e-3 - 0.05e-3;  // to the middle of an overlap of 0.1 mm
  EXPECT_NEAR(spun.slip_speed, 10.0 * lever, 1e-15);
  EXPECT_LT(spun.force_on_journal.x, 0.0);
  EXPECT_NEAR(spun.force_on_journal.y, -0.2 * spun.normal_force, 1e-12 * spun.normal_force);
  EXPECT_NEAR(spun.torque_on_journal, -0.2 * spun.normal_force * lever, 1e-12 * spun.normal_force);
  EXPECT_NEAR(spun.torque_on_bearing, 0.2 * spun.normal_force * (lever + e), 1e-12 * spun.normal_force);
  // A bearing that turns the same way rubs the other way; a centre that moves along +y slips like a turning journal.
  const ContactForces bearing = find_contact_forces(contact, {{e, 0.0}, {}, 0.0, 0.0, 10.0, 0.0}, {true, 0.1});
  EXPECT_NEAR(bearing.slip_speed, -10.0 * (lever + e), 1e-15);
  EXPECT_GT(bearing.force_on_journal.y, 0.0);
  EXPECT_DOUBLE_EQ(find_contact_forces(contact, {{e, 0.0}, {0.0, 0.3}}, {true, 0.1}).slip_speed, 0.3);
  // Everything turning as one does not slip.
  const ContactForces together =
      find_contact_forces(contact, {{e, 0.0}, {0.0, 7.0 * e}, 0.0, 0.0, 7.0, 7.0}, {true, 0.1});
  EXPECT_NEAR(together.slip_speed, 0.0, 1e-16);
}

TEST(ContactForce, ScalesDampingWithTheFloorAtLeast) {
  const Contact contact = make_contact(0.5e-3);
  const RelativeMotion approaching{{0.6e-3, 0.0}, {5e-4, 0.0}};
  const auto force = [&](double onset) {
    return find_contact_forces(contact, approaching, {true, onset}).normal_force;
  };
  EXPECT_EQ(force(1e-9), force(1e-3));
  EXPECT_EQ(force(0.0), force(1e-3));
  EXPECT_LT(force(2e-3), force(1e-3));
  const double elastic = find_contact_forces(contact, {{0.6e-3, 0.0}, {}}, {true, 0.1}).normal_force;
  EXPECT_NEAR(force(1e-3), elastic * (1.0 + 0.75 * 0.51 * 0.5), 1e-12 * elastic);  // χ = 0.75 (1 − 0.7²)
}

TEST(ContactForce, TurnsNothingByItself) {
  for (const Surfaces& surfaces : kSurfaces) {
    const Contact contact = make_contact(surfaces);
    for (double t = 0.0; t < 2.0; t += 0.07) {
      const RelativeMotion motion = make_pressed_motion(t);
      const ContactForces forces = find_contact_forces(contact, motion, {true, 0.1});
      ASSERT_GT(forces.normal_force, 0.0);
      const double moment =
          cross(motion.offset, forces.force_on_journal) + forces.torque_on_journal + forces.torque_on_bearing;
      EXPECT_NEAR(moment, 0.0, 1e-15 * forces.normal_force);  // levers of 15 mm, rounded
    }
  }
}

void expect_balanced_power(const AnyNormalForce& law) {
  constexpr double kStep = 1e-6;
  for (const Surfaces& surfaces : kSurfaces) {
    Contact contact = make_contact(surfaces);
    set_normal_force(contact, law);
    const ContactMode mode{true, 2e-3};
    for (double t = 0.0; t < 2.0; t += 0.07) {
      const RelativeMotion motion = make_pressed_motion(t);
      const ContactForces forces = find_contact_forces(contact, motion, mode);
      const double power = dot(forces.force_on_journal, motion.velocity) +
                           forces.torque_on_bearing * motion.bearing_rate +
                           forces.torque_on_journal * motion.journal_rate;
      const double stored = (find_contact_forces(contact, make_pressed_motion(t + kStep), mode).elastic_energy -
                             find_contact_forces(contact, make_pressed_motion(t - kStep), mode).elastic_energy) /
                            (2.0 * kStep);
      // Energies of F δ round to 1e-16 of that over the step; the step squared is smaller.
      const double tolerance = 1e-8 * forces.normal_force * 1e-3;
      EXPECT_NEAR(power, -stored - forces.damping_power - forces.friction_power + forces.surface_power, tolerance)
          << law_name(law) << " at " << t;
      EXPECT_GE(forces.damping_power, 0.0);
      EXPECT_GE(forces.friction_power, 0.0);
      if (!surfaces.bearing_worn && !surfaces.journal_worn) {
        EXPECT_EQ(forces.surface_power, 0.0);
      }
    }
  }
}

TEST(ContactForce, PowerIsBalancedByEveryLaw) {
  for_each_alternative<AnyNormalForce>([]<class Law> {
    auto law = make_sample_law<Law>();
    if constexpr (requires { law.stiffness; }) law.stiffness = 1e8;
    if constexpr (std::same_as<Law, KelvinVoigt>) law.damping = 1e4;
    expect_balanced_power(law);
  });
}

// Round and round a worn pair without damping and friction: what the motion puts in comes back but for surface work.
TEST(ContactForce, SlidesOverWornSurfacesWithoutLoss) {
  for_each_alternative<AnyNormalForce>([]<class Law> {
    Contact contact = make_contact(kSurfaces[3]);
    auto law = make_sample_law<Law>();
    if constexpr (requires { law.stiffness; }) law.stiffness = 1e8;
    if constexpr (requires { law.restitution; }) law.restitution = 1.0;
    if constexpr (std::same_as<Law, KelvinVoigt>) law.damping = 0.0;
    if constexpr (NestsDamping<Law>) law.damping = NoDamping{};
    set_normal_force(contact, law);
    contact.friction = Frictionless{};
    const ContactMode mode{true, 2e-3};
    constexpr double kEnd = 1.3;
    constexpr int kSteps = 20000;
    double work = 0.0;
    double surface_work = 0.0;
    for (int i = 0; i < kSteps; ++i) {  // midpoints
      const RelativeMotion motion = make_pressed_motion(kEnd * (i + 0.5) / kSteps);
      const ContactForces forces = find_contact_forces(contact, motion, mode);
      work += (dot(forces.force_on_journal, motion.velocity) + forces.torque_on_bearing * motion.bearing_rate +
               forces.torque_on_journal * motion.journal_rate) *
              kEnd / kSteps;
      surface_work += forces.surface_power * kEnd / kSteps;
    }
    const double start = find_contact_forces(contact, make_pressed_motion(0.0), mode).elastic_energy;
    const double end = find_contact_forces(contact, make_pressed_motion(kEnd), mode).elastic_energy;
    EXPECT_NEAR(work - surface_work, start - end, 1e-6 * start) << Law::kName;  // midpoints, their step squared
    EXPECT_GT(std::abs(end - start), 0.01 * start) << "the energies differ enough to tell";
  });
}

// Total momentum and angular momentum of two free bodies that rub in one joint.
TEST(ContactForce, LeavesAFreePairItsMomentum) {
  const Mechanism mechanism = oracle::make_free_pair();
  const Assembly assembly = assemble(mechanism);
  for (const Surfaces& surfaces : kSurfaces) {
    System system = compile(mechanism, assembly);
    const Contact contact = make_contact(surfaces);
    const auto& worn = std::get<RevoluteSurfaces>(contact.surfaces);
    auto& pair = std::get<RevoluteSurfaces>(system.tables.contacts[0].surfaces);
    pair.bearing_wear = worn.bearing_wear;
    pair.journal_wear = worn.journal_wear;
    system.tables.contacts[0].normal_direction = surfaces.direction;
    State state = make_state(system, assembly);
    state.q[system.tables.counts.n_free_turns] += 3e-4;
    state.q[system.tables.counts.n_free_turns + 1] -= 4e-4;
    Workspace workspace(system.tables);
    BodyMotionFinder finder(system);
    const std::vector<ContactMode> contact_modes{{true, 0.1}};
    eval_dynamics(system.tables, 0.0, state.q.data(), state.v.data(), contact_modes, {}, workspace);
    const double force = workspace.contact_forces[0].normal_force;
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

}  // namespace
}  // namespace gudgeon
