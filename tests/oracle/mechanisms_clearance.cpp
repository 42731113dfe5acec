// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Mechanisms with clearance joints.
#include <cmath>
#include <numbers>

#include "tests/oracle/mechanism_parts.h"
#include "tests/oracle/mechanisms.h"

namespace gudgeon::oracle {

namespace {

double find_direction(Vec2 from, Vec2 to) { return std::atan2(to.y - from.y, to.x - from.x); }

ContactProperties make_steel_contact(double young_modulus, AnyFriction friction) {
  const Material steel{"steel", young_modulus, 0.3};
  return {"steel_on_steel", steel, steel, LankaraniNikravesh{0.9, 1.5}, std::move(friction)};
}

/// A slender-looking bar of the nine-bar press between two start points, its centre of mass on its axis.
Body make_press_bar(std::string name, double length, double center, double mass, double inertia, Vec2 from, Vec2 to) {
  const BodyStart start = start_at(find_direction(from, to));
  return make_bar(std::move(name), length, mass, inertia, {center, 0.0}, start);
}

/// Bodies of the press, from the start positions that nine_bar.md lists.
void add_press_bodies(Mechanism& mechanism) {
  const Vec2 a{22.3093, 39.0806}, b{487.3576, -75.7304}, d{187.1338, 320.3436}, e{6.5307, 499.7974};
  const Vec2 f{252.2438, 566.4774}, s{569.8719, 460.0}, p6{-220.0, 460.0};
  const double side = 0.2546;
  const Vec2 tip{0.5 * side, 0.5 * std::numbers::sqrt3 * side};
  const Body panel{"panel_7",
                   4.334,
                   12.12e-3,
                   (1.0 / 3.0) * (Vec2{side, 0.0} + tip),
                   {{"E", {0.0, 0.0}}, {"D", {side, 0.0}}, {"F", tip}},
                   start_at(find_direction(e, d))};
  std::vector<Body>& bodies = mechanism.bodies;
  bodies.push_back(make_bar("crank_1", 0.045, 0.148, 0.2382e-3, {0.023, 0.0}, {}));
  bodies.push_back(make_press_bar("rod_2", 0.326, 0.163, 0.805, 8.001e-3, a, d));
  bodies.push_back(make_press_bar("rod_3", 0.497, 0.249, 0.603, 13.37e-3, b, d));
  bodies.push_back(make_bar("crank_4", 0.095, 0.265, 1.210e-3, {0.048, 0.0}, {}));
  bodies.push_back(make_press_bar("rod_6", 0.230, 0.115, 0.581, 3.802e-3, p6, e));
  bodies.push_back(panel);
  bodies.push_back(make_press_bar("rod_8", 0.335, 0.168, 0.827, 8.663e-3, f, s));
  bodies.push_back({"slider_9", 0.801, 1e-3, {}, {{"S", {0.0, 0.0}}}, {}});  // it does not turn: any inertia will do
}

RevoluteClearance make_press_joint(Anchor bearing, Anchor journal) {
  LugreSteady friction;
  friction.static_coefficient = 0.15;
  friction.kinetic_coefficient = 0.10;
  ContactProperties contact = make_steel_contact(200e9, friction);
  contact.bearing_wear = contact.journal_wear = Archard{4e-14};
  return {std::move(bearing), std::move(journal), 15e-3, 0.5e-3, 20e-3, contact};
}

}  // namespace

Mechanism make_slider_crank_clearance() {
  Mechanism mechanism = make_empty("slider_crank_clearance", {}, {{"pivot", {0.0, 0.0}}});
  mechanism.bodies.push_back(make_bar("crank", 0.05, 0.3, 1e-5, {}, {}));  // the inertia is about the pivot
  mechanism.bodies.push_back(make_bar("rod", 0.12, 0.21, 2.5e-4, {0.06, 0.0}, start_at(0.0)));
  mechanism.bodies.push_back({"slider", 0.14, 1e-4, {}, {{"pin", {0.0, 0.0}}}, {}});
  add_revolute(mechanism, "main", {kFrameName, "pivot"}, {"crank", "a"});
  add_revolute(mechanism, "big_end", {"crank", "b"}, {"rod", "a"});
  const ContactProperties contact = make_steel_contact(207e9, Frictionless{});
  mechanism.joints.push_back(
      {"pin", RevoluteClearance{{"rod", "b"}, {"slider", "pin"}, 10e-3, 0.5e-3, 15e-3, contact}});
  mechanism.joints.push_back({"guide", make_slide({kFrameName, "pivot"}, {"slider", "pin"}, 0.0, 0.0, 0.17)});
  mechanism.drivers.push_back({"motor", DrivenAngle{"crank"}, 0.0, 5000.0 * std::numbers::pi / 30.0});
  return mechanism;
}

Mechanism make_free_body_in_bearing() {
  Mechanism mechanism = make_empty("free_body_in_bearing", kObliqueGravity, {{"bearing", {0.07, -0.04}}});
  BodyStart start = start_turning(0.6, 9.0);
  mechanism.bodies.push_back({"disc", 2.0, 0.015, {0.013, 0.008}, {{"journal", {-0.006, 0.011}}}, start});
  const ContactProperties contact = make_steel_contact(207e9, CoulombSmooth{0.12, 2e-3});
  mechanism.joints.push_back(
      {"bearing", RevoluteClearance{{kFrameName, "bearing"}, {"disc", "journal"}, 0.02, 0.4e-3, 0.03, contact}});
  return mechanism;
}

Mechanism make_free_pair() {
  Mechanism mechanism = make_empty("free_pair", {}, {});
  BodyStart start = start_turning(0.3, 4.0);
  start.position = {0.5, -0.3};
  start.velocity = {0.2, 0.7};
  mechanism.bodies.push_back({"housing", 1.7, 0.012, {0.021, -0.013}, {{"bearing", {-0.03, 0.017}}}, start});
  mechanism.bodies.push_back(
      {"shaft", 0.9, 0.005, {-0.011, 0.009}, {{"journal", {0.024, 0.03}}}, start_turning(-0.8, -7.0)});
  const ContactProperties contact = make_steel_contact(180e9, CoulombSmooth{0.2, 3e-3});
  mechanism.joints.push_back(
      {"bearing", RevoluteClearance{{"housing", "bearing"}, {"shaft", "journal"}, 0.012, 0.3e-3, 0.02, contact}});
  return mechanism;
}

Mechanism make_free_pair_of_cylinders() {
  Mechanism mechanism = make_free_pair();
  mechanism.name = "free_pair_of_cylinders";
  ContactProperties& contact = std::get<RevoluteClearance>(mechanism.joints[0].kind).contact;
  contact.bearing_material = {"bronze", 105e9, 0.34};
  contact.normal_force = Liu{};  // its force has no end, however deep a state presses
  return mechanism;
}

Mechanism make_nine_bar() {
  Mechanism mechanism =
      make_empty("nine_bar", {9.81, 0.0},
                 {{"O1", {0.0, 0.0}}, {"O4", {0.43, 0.0}}, {"P6", {-0.22, 0.46}}, {"guide", {0.0, 0.46}}});
  add_press_bodies(mechanism);
  add_revolute(mechanism, "O1", {kFrameName, "O1"}, {"crank_1", "a"});
  add_revolute(mechanism, "O4", {kFrameName, "O4"}, {"crank_4", "a"});
  mechanism.joints.push_back({"A", make_press_joint({"crank_1", "b"}, {"rod_2", "a"})});
  mechanism.joints.push_back({"B", make_press_joint({"crank_4", "b"}, {"rod_3", "a"})});
  add_revolute(mechanism, "D2", {"rod_2", "b"}, {"panel_7", "D"});
  add_revolute(mechanism, "D3", {"rod_3", "b"}, {"panel_7", "D"});
  add_revolute(mechanism, "P6", {kFrameName, "P6"}, {"rod_6", "a"});
  add_revolute(mechanism, "E", {"rod_6", "b"}, {"panel_7", "E"});
  add_revolute(mechanism, "F", {"panel_7", "F"}, {"rod_8", "a"});
  add_revolute(mechanism, "S", {"rod_8", "b"}, {"slider_9", "S"});
  mechanism.joints.push_back({"guide", make_slide({kFrameName, "guide"}, {"slider_9", "S"}, 0.0, 0.0, 0.57)});
  const double turn = 2.0 * std::numbers::pi;
  mechanism.drivers.push_back({"motor_1", DrivenAngle{"crank_1"}, 60.28 * kDegree, -turn});
  mechanism.drivers.push_back({"motor_4", DrivenAngle{"crank_4"}, -52.86 * kDegree, turn});
  return mechanism;
}

}  // namespace gudgeon::oracle
