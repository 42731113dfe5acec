// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Mechanisms with ideal joints.
#include "tests/oracle/mechanisms.h"

#include <numbers>

#include "tests/oracle/mechanism_parts.h"

namespace gudgeon::oracle {

Mechanism make_pendulum_chain(int n) {
  Mechanism mechanism = make_empty("pendulum_chain", kObliqueGravity, {{"pivot", {0.13, -0.21}}});
  Anchor tip{kFrameName, "pivot"};
  for (int i = 0; i < n; ++i) {
    const std::string name = "bar_" + std::to_string(i + 1);
    const double length = 0.31 + 0.04 * (i % 3);
    const Vec2 center{0.55 * length, 0.03 - 0.02 * (i % 4)};
    const BodyStart start = start_turning(-0.4 - 0.37 * i, 1.1 - 0.8 * (i % 3));
    mechanism.bodies.push_back(make_bar(name, length, 0.7 + 0.23 * (i % 5), 0.011 + 0.002 * i, center, start));
    add_revolute(mechanism, "pin_" + std::to_string(i + 1), tip, {name, "a"});
    tip = {name, "b"};
  }
  return mechanism;
}

Mechanism make_point_mass_pendulum() {
  Mechanism mechanism = make_empty("point_mass_pendulum", {0.0, -9.81}, {{"pivot", {0.0, 0.0}}});
  const BodyStart start = start_turning(std::numbers::pi, 0.0);
  mechanism.bodies.push_back(make_bar("bar", 1.0, 1.0, 0.0, {1.0, 0.0}, start));
  add_revolute(mechanism, "pin", {kFrameName, "pivot"}, {"bar", "a"});
  return mechanism;
}

Mechanism make_rigid_chain() {
  Mechanism mechanism = make_empty("rigid_chain", kObliqueGravity, {{"pivot", {-0.08, 0.17}}});
  mechanism.bodies.push_back(make_bar("arm", 0.4, 0.9, 0.013, {0.17, 0.04}, start_turning(-0.7, 1.9)));
  mechanism.bodies.push_back(make_bar("bracket", 0.22, 0.6, 0.004, {0.13, -0.05}, {}));
  mechanism.bodies.push_back(make_bar("pendulum", 0.27, 0.45, 0.006, {0.19, 0.02}, start_turning(-1.9, -2.3)));
  add_revolute(mechanism, "pivot", {kFrameName, "pivot"}, {"arm", "a"});
  mechanism.joints.push_back({"weld", Rigid{{"arm", "b"}, {"bracket", "a"}, 0.6}});
  add_revolute(mechanism, "hinge", {"bracket", "b"}, {"pendulum", "a"});
  return mechanism;
}

Mechanism make_slider_crank() {
  Mechanism mechanism = make_empty("slider_crank", kObliqueGravity, {{"pivot", {0.02, 0.05}}, {"guide", {0.1, -0.03}}});
  mechanism.bodies.push_back(make_bar("crank", 0.08, 0.5, 1.2e-3, {0.03, 0.011}, start_turning(0.9, -4.7)));
  mechanism.bodies.push_back(make_bar("rod", 0.26, 0.8, 5.1e-3, {0.11, -0.017}, start_at(-0.4)));
  mechanism.bodies.push_back({"slider", 0.65, 2e-3, {0.012, 0.007}, {{"a", {-0.015, 0.004}}}, {}});
  add_revolute(mechanism, "main", {kFrameName, "pivot"}, {"crank", "a"});
  add_revolute(mechanism, "big_end", {"crank", "b"}, {"rod", "a"});
  add_revolute(mechanism, "pin", {"slider", "a"}, {"rod", "b"});  // the other way round on purpose
  mechanism.joints.push_back({"guide", make_slide({kFrameName, "guide"}, {"slider", "a"}, 0.2, 0.35, 0.21)});
  mechanism.loads.push_back({"push", ConstantForce{{"slider", "a"}, {-6.0, 2.5}}});
  return mechanism;
}

Mechanism make_slider_crank_torque() {
  Mechanism mechanism = make_empty("slider_crank_torque", {}, {{"pivot", {0.0, 0.0}}});
  mechanism.bodies.push_back(make_slender("crank", 0.1, 0.2, start_turning(0.0, 0.0)));
  mechanism.bodies.push_back(make_slender("rod", 0.3, 0.2, start_at(0.0)));
  mechanism.bodies.push_back({"slider", 0.4, 1e-3, {}, {{"pin", {0.0, 0.0}}}, {}});
  add_revolute(mechanism, "main", {kFrameName, "pivot"}, {"crank", "a"});
  add_revolute(mechanism, "big_end", {"crank", "b"}, {"rod", "a"});
  add_revolute(mechanism, "pin", {"rod", "b"}, {"slider", "pin"});
  mechanism.joints.push_back({"guide", make_slide({kFrameName, "pivot"}, {"slider", "pin"}, 0.0, 0.0, 0.4)});
  mechanism.loads.push_back({"torque", ConstantTorque{"crank", 0.1}});
  return mechanism;
}

Mechanism make_four_bar() {
  Mechanism mechanism = make_empty("four_bar", kObliqueGravity, {{"left", {-0.04, 0.06}}, {"right", {0.31, 0.11}}});
  mechanism.bodies.push_back(make_bar("crank", 0.11, 0.4, 9e-4, {0.047, 0.013}, start_turning(1.1, 5.3)));
  mechanism.bodies.push_back(make_bar("coupler", 0.34, 1.1, 0.012, {0.15, 0.05}, start_at(0.56)));
  mechanism.bodies.push_back(make_bar("rocker", 0.23, 0.7, 4e-3, {0.09, -0.02}, start_at(1.62)));
  mechanism.bodies[2].points.push_back({"tool", {0.21, 0.09}});
  add_revolute(mechanism, "left", {kFrameName, "left"}, {"crank", "a"});
  add_revolute(mechanism, "crank_pin", {"crank", "b"}, {"coupler", "a"});
  add_revolute(mechanism, "rocker_pin", {"coupler", "b"}, {"rocker", "b"});
  add_revolute(mechanism, "right", {"rocker", "a"}, {kFrameName, "right"});
  mechanism.loads.push_back({"torque", ConstantTorque{"crank", -0.7}});
  mechanism.loads.push_back({"force", ConstantForce{{"coupler", "tool"}, {3.1, 4.7}}});
  return mechanism;
}

Mechanism make_five_bar() {
  Mechanism mechanism = make_empty("five_bar", kObliqueGravity, {{"left", {0.03, -0.02}}, {"right", {0.38, 0.05}}});
  mechanism.bodies.push_back(make_bar("crank_1", 0.12, 0.35, 8e-4, {0.05, -0.01}, start_turning(1.72, 3.1)));
  mechanism.bodies.push_back(make_bar("rod_2", 0.3, 0.8, 7e-3, {0.16, 0.02}, start_at(0.72)));
  mechanism.bodies.push_back(make_bar("rod_3", 0.28, 0.75, 6e-3, {0.12, 0.03}, start_at(2.63)));
  mechanism.bodies.push_back(make_bar("crank_4", 0.15, 0.45, 1.3e-3, {0.08, 0.015}, start_turning(0.82, -2.6)));
  add_revolute(mechanism, "left", {kFrameName, "left"}, {"crank_1", "a"});
  add_revolute(mechanism, "pin_1", {"crank_1", "b"}, {"rod_2", "a"});
  add_revolute(mechanism, "right", {kFrameName, "right"}, {"crank_4", "a"});
  add_revolute(mechanism, "pin_4", {"crank_4", "b"}, {"rod_3", "a"});
  add_revolute(mechanism, "top", {"rod_2", "b"}, {"rod_3", "b"});
  return mechanism;
}

Mechanism make_parallelogram() {
  Mechanism mechanism =
      make_empty("parallelogram", kObliqueGravity, {{"p0", {0, 0}}, {"p1", {0.2, 0}}, {"p2", {0.5, 0}}});
  mechanism.bodies.push_back(
      {"coupler", 1.3, 0.03, {0.22, 0.04}, {{"p0", {0, 0}}, {"p1", {0.2, 0}}, {"p2", {0.5, 0}}}, start_at(0.0)});
  for (int i = 0; i < 3; ++i) {
    const std::string name = "crank_" + std::to_string(i);
    const std::string point = "p" + std::to_string(i);
    const BodyStart start = i == 0 ? start_turning(1.2, 2.7) : start_at(1.2);
    mechanism.bodies.push_back(make_bar(name, 0.18, 0.3 + 0.1 * i, 1e-3 + 2e-4 * i, {0.08, 0.01 * i}, start));
    add_revolute(mechanism, "foot_" + std::to_string(i), {kFrameName, point}, {name, "a"});
    add_revolute(mechanism, "top_" + std::to_string(i), {name, "b"}, {"coupler", point});
  }
  return mechanism;
}

Mechanism make_n_four_bar(int n) {
  Mechanism mechanism = make_empty("n_four_bar", {0.0, -9.81}, {});
  for (int i = 0; i <= n; ++i) {
    const std::string index = std::to_string(i);
    mechanism.bodies[0].points.push_back({"p" + index, {static_cast<double>(i), 0.0}});
    const double up = 0.5 * std::numbers::pi;
    mechanism.bodies.push_back(
        make_slender("post_" + index, 1.0, 1.0, i == 0 ? start_turning(up, -1.0) : start_at(up)));
    add_revolute(mechanism, "foot_" + index, {kFrameName, "p" + index}, {"post_" + index, "a"});
    if (i == 0) continue;
    const std::string beam = "beam_" + index;
    mechanism.bodies.push_back(make_slender(beam, 1.0, 1.0, start_at(0.0)));
    add_revolute(mechanism, "left_" + index, {"post_" + std::to_string(i - 1), "b"}, {beam, "a"});
    add_revolute(mechanism, "right_" + index, {beam, "b"}, {"post_" + index, "b"});
  }
  return mechanism;
}

Mechanism make_six_bar_slide() {
  Mechanism mechanism = make_empty("six_bar_slide", kObliqueGravity,
                                   {{"crank", {0.01, 0.22}}, {"rocker", {-0.02, 0.0}}, {"guide", {0.03, 0.5}}});
  // the rocker's slot runs at -0.15 rad in its own axes, through a point beside its pivot
  mechanism.bodies.push_back(make_bar("crank", 0.09, 0.5, 1.1e-3, {0.035, 0.012}, start_turning(0.4, 3.9)));
  mechanism.bodies.push_back({"block", 0.25, 3e-4, {0.006, -0.009}, {{"pin", {0.004, 0.003}}}, {}});
  mechanism.bodies.push_back({"rocker",
                              1.4,
                              0.04,
                              {0.21, 0.015},
                              {{"a", {0.0, 0.0}}, {"b", {0.47, 0.02}}, {"slot", {0.02, 0.03}}},
                              start_at(1.18)});
  mechanism.bodies.push_back(make_bar("rod", 0.21, 0.4, 1.9e-3, {0.1, -0.014}, start_at(0.36)));
  mechanism.bodies.push_back({"ram", 0.9, 5e-3, {0.03, -0.02}, {{"pin", {-0.01, 0.015}}}, {}});
  add_revolute(mechanism, "crank", {kFrameName, "crank"}, {"crank", "a"});
  add_revolute(mechanism, "crank_pin", {"crank", "b"}, {"block", "pin"});
  add_revolute(mechanism, "rocker", {kFrameName, "rocker"}, {"rocker", "a"});
  mechanism.joints.push_back({"slot", make_slide({"rocker", "slot"}, {"block", "pin"}, -0.15, 0.3, 0.25)});
  add_revolute(mechanism, "rod_pin", {"rocker", "b"}, {"rod", "a"});
  add_revolute(mechanism, "ram_pin", {"rod", "b"}, {"ram", "pin"});
  mechanism.joints.push_back({"guide", make_slide({kFrameName, "guide"}, {"ram", "pin"}, 0.05, -0.2, 0.3)});
  mechanism.loads.push_back({"cutting", ConstantForce{{"ram", "pin"}, {-11.0, 3.0}}});
  return mechanism;
}

Mechanism make_two_slides() {
  Mechanism mechanism = make_empty("two_slides", kObliqueGravity, {{"guide", {0.05, -0.07}}});
  Body table{"table", 1.2, 0.02, {0.04, 0.03}, {{"foot", {-0.02, 0.01}}, {"rail", {0.06, 0.05}}}, {}};
  Body carriage{"carriage", 0.8, 0.008, {-0.02, 0.035}, {{"foot", {0.01, -0.02}}, {"hook", {0.03, 0.04}}}, {}};
  mechanism.bodies.insert(mechanism.bodies.end(), {table, carriage});
  mechanism.bodies.push_back(make_bar("pendulum", 0.33, 0.5, 4e-3, {0.19, -0.03}, start_turning(-1.0, 3.3)));
  Prismatic lower = make_slide({kFrameName, "guide"}, {"table", "foot"}, 0.3, 0.15, 0.11);
  lower.start.speed = 0.6;
  // written from the carriage to the table, perpendicular to the lower guide: 0.3 − 0.15 − 0.25 + π/2 in its own axes
  Prismatic upper = make_slide({"carriage", "foot"}, {"table", "rail"}, -0.1 + 0.5 * std::numbers::pi, -0.25, -0.08);
  upper.start.speed = -0.45;
  mechanism.joints.push_back({"lower", lower});
  mechanism.joints.push_back({"upper", upper});
  add_revolute(mechanism, "hook", {"carriage", "hook"}, {"pendulum", "a"});
  return mechanism;
}

Mechanism make_driven_slide() {
  Mechanism mechanism = make_empty("driven_slide", kObliqueGravity, {{"pivot", {-0.11, 0.09}}});
  mechanism.bodies.push_back(make_bar("arm", 0.6, 1.1, 0.035, {0.26, 0.05}, start_turning(-0.5, 1.7)));
  mechanism.bodies.push_back(
      {"block", 0.7, 6e-3, {0.02, -0.03}, {{"shoe", {-0.015, 0.01}}, {"hook", {0.04, -0.05}}}, {}});
  mechanism.bodies.push_back(make_bar("pendulum", 0.3, 0.45, 3.5e-3, {0.17, 0.025}, start_turning(-1.8, -2.9)));
  add_revolute(mechanism, "pivot", {kFrameName, "pivot"}, {"arm", "a"});
  mechanism.joints.push_back({"rail", make_slide({"arm", "b"}, {"block", "shoe"}, 2.9, 0.4, 0.12)});
  add_revolute(mechanism, "hook", {"block", "hook"}, {"pendulum", "a"});
  mechanism.drivers.push_back({"actuator", DrivenSlide{"rail"}, 0.12, 0.85});
  return mechanism;
}

std::vector<Mechanism> make_all_mechanisms() {
  return {make_pendulum_chain(1),
          make_pendulum_chain(5),
          make_point_mass_pendulum(),
          make_rigid_chain(),
          make_slider_crank(),
          make_slider_crank_torque(),
          make_slider_crank_clearance(),
          make_four_bar(),
          make_five_bar(),
          make_parallelogram(),
          make_n_four_bar(3),
          make_six_bar_slide(),
          make_two_slides(),
          make_driven_slide(),
          make_swung_slider_crank(),
          make_driven_arm(false),
          make_driven_arm(true),
          make_scotch_yoke(),
          make_quick_return(),
          make_trammel(),
          make_moved_slides(),
          make_splined_slide(),
          make_projectile(),
          make_free_body_in_bearing(),
          make_slider_crank_guide(),
          make_block_in_turning_slot(),
          make_scotch_yoke_clearance(),
          make_free_pair_in_slot(),
          make_free_pair(),
          make_free_pair_of_cylinders(),
          make_nine_bar()};
}

}  // namespace gudgeon::oracle
