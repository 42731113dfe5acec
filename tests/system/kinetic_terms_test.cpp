// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Mass, inertia and loads summed over shared terms: a double pendulum by hand, and kinetic energy body by body.
#include "gudgeon/system/kinetic_terms.h"

#include <gtest/gtest.h>

#include "tests/oracle/mechanism_parts.h"
#include "tests/oracle/mechanisms.h"
#include "tests/system/smooth_motion.h"

namespace gudgeon {
namespace {

TEST(KineticTerms, AreThoseOfADoublePendulum) {
  const Mechanism mechanism = oracle::make_pendulum_chain(2);
  const Topology topology = find_topology(mechanism);
  const KineticTerms terms = sum_kinetic_terms(mechanism, topology);
  const Body& first = mechanism.bodies[1];
  const Body& second = mechanism.bodies[2];
  const double length = first.points[1].position.x;
  const TermKey one{0, topology.counts.unit_slide()};
  const TermKey two{1, topology.counts.unit_slide()};

  const Vec2 c1 = first.center_of_mass;
  const Vec2 c2 = second.center_of_mass;
  // A few products and sums.
  constexpr double kTolerance = 1e-16;
  EXPECT_NEAR(terms.pairs.at({one, one}).dot, first.mass * dot(c1, c1) + second.mass * length * length, kTolerance);
  EXPECT_NEAR(terms.pairs.at({one, two}).dot, second.mass * length * c2.x, kTolerance);
  EXPECT_NEAR(terms.pairs.at({one, two}).cross, second.mass * length * c2.y, kTolerance);
  EXPECT_NEAR(terms.pairs.at({two, two}).dot, second.mass * dot(c2, c2), kTolerance);
  EXPECT_EQ(terms.pairs.count({two, one}), 0u) << "each pair once, in the order of the keys";
  EXPECT_EQ(terms.turn_inertia[0], first.inertia);
  EXPECT_EQ(terms.turn_inertia[1], second.inertia);

  const Vec2 g = mechanism.gravity;
  EXPECT_NEAR(terms.fields.at(one).dot, first.mass * dot(c1, g) + second.mass * length * g.x, 1e-15);
  EXPECT_NEAR(terms.fields.at(one).cross, first.mass * cross(c1, g) + second.mass * length * g.y, 1e-15);
  EXPECT_NEAR(terms.fields.at(two).cross, second.mass * cross(c2, g), 1e-15);
}

TEST(KineticTerms, CountLoadsWithTheirBodies) {
  Mechanism mechanism = oracle::make_rigid_chain();
  mechanism.gravity = {};
  mechanism.loads.push_back({"twist", ConstantTorque{"bracket", 0.7}});
  mechanism.loads.push_back({"twist_more", ConstantTorque{"arm", -0.2}});
  mechanism.loads.push_back({"push", ConstantForce{{"pendulum", "b"}, {2.0, 5.0}}});
  const Topology topology = find_topology(mechanism);
  const KineticTerms terms = sum_kinetic_terms(mechanism, topology);
  // Arm and bracket turn together, so their torques and inertias add.
  const int tied = topology.bodies[1].turn;
  const int pendulum = topology.bodies[3].turn;
  EXPECT_DOUBLE_EQ(terms.turn_torque[tied], 0.5);
  EXPECT_EQ(terms.turn_torque[pendulum], 0.0);
  EXPECT_DOUBLE_EQ(terms.turn_inertia[tied], 0.013 + 0.004);
  const TermKey own{pendulum, topology.counts.unit_slide()};
  EXPECT_DOUBLE_EQ(terms.fields.at(own).dot, 0.27 * 2.0);
  EXPECT_DOUBLE_EQ(terms.fields.at(own).cross, 0.27 * 5.0);
}

TEST(KineticTerms, MergeAddsTermsOfTheSameCoordinates) {
  const auto merged = merge_terms({{1, 0, {1.0, 2.0}}, {0, 0, {5.0, 0.0}}, {1, 0, {0.5, -1.0}}, {1, 2, {7.0, 0.0}}});
  ASSERT_EQ(merged.size(), 3u);
  EXPECT_EQ(merged.at({1, 0}), (Vec2{1.5, 1.0}));
  EXPECT_EQ(merged.begin()->first, (TermKey{0, 0}));
}

// u_p·u_q and u_p×u_q of two turned vectors, from their products in their own axes.
Products turn(const Products& products, Rotation p, Rotation q) {
  const double cosine = p.c * q.c + p.s * q.s;
  const double sine = p.c * q.s - p.s * q.c;
  return {products.dot * cosine - products.cross * sine, products.cross * cosine + products.dot * sine};
}

double find_energy_of_terms(const KineticTerms& terms, const Coordinates& at) {
  double energy = 0.0;
  for (std::size_t turn = 0; turn < terms.turn_inertia.size(); ++turn) {
    energy += 0.5 * terms.turn_inertia[turn] * at.angle_rate[turn] * at.angle_rate[turn];
  }
  for (const auto& [keys, products] : terms.pairs) {
    const auto& [i, j] = keys;
    const Products turned = turn(products, at.rotation[i.turn], at.rotation[j.turn]);
    // Velocities ċ u + c θ̇ perp(u) of both terms.
    const double along_i = at.slide_rate[i.slide];
    const double along_j = at.slide_rate[j.slide];
    const double across_i = at.slide[i.slide] * at.angle_rate[i.turn];
    const double across_j = at.slide[j.slide] * at.angle_rate[j.turn];
    const double product = (along_i * along_j + across_i * across_j) * turned.dot +
                           (across_i * along_j - along_i * across_j) * turned.cross;
    energy += (i == j ? 0.5 : 1.0) * product;
  }
  return energy;
}

double find_energy_of_bodies(const Mechanism& mechanism, const Topology& topology, const Coordinates& at) {
  double energy = 0.0;
  for (std::size_t b = 1; b < mechanism.bodies.size(); ++b) {
    const Body& body = mechanism.bodies[b];
    Vec2 velocity;
    for (const Term& term : topology.find_path(static_cast<int>(b), body.center_of_mass)) {
      const Vec2 arm = at.rotation[term.turn] * term.vector;
      velocity += at.slide_rate[term.slide] * arm + at.slide[term.slide] * at.angle_rate[term.turn] * perp(arm);
    }
    const double rate = at.angle_rate[topology.bodies[b].turn];
    energy += 0.5 * (body.mass * dot(velocity, velocity) + body.inertia * rate * rate);
  }
  return energy;
}

TEST(KineticTerms, HoldTheKineticEnergyOfEveryMechanism) {
  for (const Mechanism& mechanism : oracle::make_all_mechanisms()) {
    const Topology topology = find_topology(mechanism);
    const KineticTerms terms = sum_kinetic_terms(mechanism, topology);
    const SmoothMotion motion(topology.counts, 8);
    for (const double t : {0.0, 0.6, 1.4}) {
      const Coordinates at = motion.eval(t);
      const double expected = find_energy_of_bodies(mechanism, topology, at);
      EXPECT_NEAR(find_energy_of_terms(terms, at), expected, 1e-13 * (1.0 + expected)) << mechanism.name;  // rounding
    }
  }
}

}  // namespace
}  // namespace gudgeon
