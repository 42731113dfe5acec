// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Mechanisms with clearance in guides and slots.
#include <numbers>

#include "tests/oracle/mechanism_parts.h"
#include "tests/oracle/mechanisms.h"

namespace gudgeon::oracle {

namespace {

ContactProperties make_contact(double young_modulus, AnyFriction friction) {
  const Material iron{"iron", young_modulus, 0.27};
  ContactProperties contact{"iron_on_iron", iron, iron, LankaraniNikravesh{0.8, 1.5}, std::move(friction)};
  contact.bearing_wear = Archard{3e-14};
  contact.journal_wear = Archard{1e-14};
  return contact;
}

}  // namespace

Mechanism make_slider_crank_guide() {
  Mechanism mechanism =
      make_empty("slider_crank_guide", kObliqueGravity, {{"pivot", {0.0, 0.0}}, {"rail", {0.3, 0.01}}});
  mechanism.bodies.push_back(make_bar("crank", 0.06, 0.4, 2e-4, {0.02, 0.004}, {}));
  mechanism.bodies.push_back(make_bar("rod", 0.25, 0.35, 2.1e-3, {0.11, -0.006}, start_at(-0.15)));
  mechanism.bodies.push_back(
      {"slider", 0.6, 6e-4, {0.012, -0.009}, {{"pin", {0.005, -0.003}}, {"middle", {-0.004, 0.002}}}, start_at(0.3)});
  add_revolute(mechanism, "main", {kFrameName, "pivot"}, {"crank", "a"});
  add_revolute(mechanism, "big_end", {"crank", "b"}, {"rod", "a"});
  add_revolute(mechanism, "small_end", {"rod", "b"}, {"slider", "pin"});
  mechanism.joints.push_back({"guide", PrismaticClearance{{kFrameName, "rail"},
                                                          {"slider", "middle"},
                                                          0.1,
                                                          0.3,
                                                          0.4,
                                                          0.05,
                                                          0.03,
                                                          2e-3,
                                                          2e-4,
                                                          0.02,
                                                          make_contact(190e9, CoulombSmooth{0.1, 5e-3})}});
  mechanism.drivers.push_back({"motor", DrivenAngle{"crank"}, 0.7, 25.0});
  return mechanism;
}

Mechanism make_block_in_turning_slot() {
  Mechanism mechanism = make_empty("block_in_turning_slot", kObliqueGravity, {{"pivot", {0.05, 0.02}}});
  Body arm = make_bar("arm", 0.5, 1.2, 0.04, {0.22, 0.03}, start_turning(1.2, 1.4));
  arm.points.push_back({"slot", {0.3, -0.02}});
  mechanism.bodies.push_back(arm);
  mechanism.bodies.push_back(
      {"block", 0.5, 4e-4, {0.01, -0.006}, {{"middle", {-0.007, 0.004}}, {"hook", {0.02, -0.03}}}, {}});
  mechanism.bodies.push_back(make_bar("pendulum", 0.22, 0.3, 1.6e-3, {0.13, 0.012}, start_turning(-1.7, -2.2)));
  add_revolute(mechanism, "pivot", {kFrameName, "pivot"}, {"arm", "a"});
  mechanism.joints.push_back({"slot", PrismaticClearance{{"arm", "slot"},
                                                         {"block", "middle"},
                                                         0.7,
                                                         -0.4,
                                                         0.3,
                                                         0.06,
                                                         0.04,
                                                         3e-3,
                                                         3e-4,
                                                         0.015,
                                                         make_contact(120e9, CoulombSmooth{0.15, 4e-3})}});
  add_revolute(mechanism, "hook", {"block", "hook"}, {"pendulum", "a"});
  return mechanism;
}

Mechanism make_scotch_yoke_clearance() {
  Mechanism mechanism = make_scotch_yoke();
  mechanism.name = "scotch_yoke_clearance";
  mechanism.joints[find_joint(mechanism, "pin")].kind = PinInSlotClearance{
      {"yoke", "slot"}, {"crank", "b"}, 1.35, 0.3, 8e-3, 2e-4, 0.012, make_contact(150e9, CoulombSmooth{0.2, 3e-3})};
  return mechanism;
}

Mechanism make_loose_block(BodyStart start, double young_modulus) {
  Mechanism mechanism = make_empty("loose_block", {}, {{"slot", {0.0, 0.0}}});
  mechanism.bodies.push_back({"block", 2.0, 1e-3, {}, {{"middle", {0.0, 0.0}}}, start});
  ContactProperties contact = make_contact(young_modulus, Frictionless{});
  contact.normal_force = Hertz{};
  mechanism.joints.push_back(
      {"slot", PrismaticClearance{
                   {kFrameName, "slot"}, {"block", "middle"}, 0.0, 0.0, 1.0, 0.1, 0.05, 5e-3, 1e-3, 0.02, contact}});
  return mechanism;
}

Mechanism make_free_pair_in_slot() {
  Mechanism mechanism = make_free_pair();
  mechanism.name = "free_pair_in_slot";
  mechanism.bodies[find_body(mechanism, "shaft")].start.angle_rate.reset();  // its slot's
  mechanism.joints[0].kind = PrismaticClearance{{"housing", "bearing"},
                                                {"shaft", "journal"},
                                                1.9,
                                                -1.1,
                                                0.3,
                                                0.05,
                                                0.04,
                                                4e-3,
                                                3e-4,
                                                0.02,
                                                make_contact(180e9, CoulombSmooth{0.2, 3e-3})};
  return mechanism;
}

}  // namespace gudgeon::oracle
