// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Mechanisms with accelerating drivers, drivers between moving bodies, pins in slots, and a body without any joint.
#include "tests/oracle/driver_motion.h"
#include "tests/oracle/mechanism_parts.h"
#include "tests/oracle/mechanisms.h"

namespace gudgeon::oracle {

namespace {

Driver make_wave_driver(std::string name, DrivenAngle angle, const Wave& wave) {
  return {std::move(name), std::move(angle), 0.0, 0.0, make_wave(wave)};
}

}  // namespace

Mechanism make_swung_slider_crank() {
  Mechanism mechanism = make_slider_crank();
  mechanism.name = "swung_slider_crank";
  mechanism.bodies[1].start = {};
  mechanism.drivers.push_back(make_wave_driver("motor", {"crank"}, {0.9, -1.3, 0.5, 7.0, 0.3}));
  return mechanism;
}

Mechanism make_driven_arm(bool shoulder_driven) {
  Mechanism mechanism = make_empty("driven_arm", kObliqueGravity, {{"pivot", {-0.08, 0.17}}});
  mechanism.bodies.push_back(make_bar("arm", 0.4, 0.9, 0.013, {0.17, 0.04}, start_turning(-0.7, 1.9)));
  mechanism.bodies.push_back(make_bar("bracket", 0.22, 0.6, 0.004, {0.13, -0.05}, {}));
  mechanism.bodies.push_back(make_bar("hand", 0.27, 0.45, 0.006, {0.19, 0.02}, {}));
  mechanism.bodies.push_back(make_bar("tassel", 0.15, 0.2, 4e-4, {0.09, 0.01}, start_turning(-1.4, 2.2)));
  add_revolute(mechanism, "shoulder", {kFrameName, "pivot"}, {"arm", "a"});
  add_revolute(mechanism, "elbow", {"arm", "b"}, {"bracket", "a"});
  mechanism.joints.push_back({"weld", Rigid{{"bracket", "b"}, {"hand", "a"}, -0.45}});
  add_revolute(mechanism, "hook", {"hand", "b"}, {"tassel", "a"});
  if (shoulder_driven) {
    mechanism.name = "driven_arm_and_shoulder";
    mechanism.bodies[1].start = {};
    mechanism.drivers.push_back(make_wave_driver("lift", {"arm"}, {-0.7, 0.8, 0.3, 9.0, -0.4}));
  }
  mechanism.drivers.push_back(make_wave_driver("bend", {"hand", "arm"}, {0.6, 0.4, 0.35, 8.0, 0.2}));
  return mechanism;
}

Mechanism make_scotch_yoke() {
  Mechanism mechanism = make_empty("scotch_yoke", kObliqueGravity, {{"pivot", {0.02, 0.05}}, {"guide", {0.3, 0.02}}});
  mechanism.bodies.push_back(make_bar("crank", 0.09, 0.5, 1.2e-3, {0.03, 0.011}, start_turning(0.8, 4.1)));
  // the slot runs at 1.35 rad in the yoke's own axes
  mechanism.bodies.push_back(
      {"yoke", 0.8, 3e-3, {0.04, -0.02}, {{"slot", {-0.25, 0.03}}, {"foot", {0.01, 0.005}}}, {}});
  add_revolute(mechanism, "main", {kFrameName, "pivot"}, {"crank", "a"});
  mechanism.joints.push_back({"guide", make_slide({kFrameName, "guide"}, {"yoke", "foot"}, 0.1, 0.15, 0.07)});
  mechanism.joints.push_back({"pin", PinInSlot{{"yoke", "slot"}, {"crank", "b"}, 1.35}});
  return mechanism;
}

Mechanism make_quick_return() {
  Mechanism mechanism = make_six_bar_slide();
  mechanism.name = "quick_return";
  mechanism.bodies[1].start = {};
  std::erase_if(mechanism.bodies, [](const Body& body) { return body.name == "block"; });
  std::erase_if(mechanism.joints, [](const Joint& joint) { return joint.name == "crank_pin"; });
  mechanism.joints[find_joint(mechanism, "slot")].kind = PinInSlot{{"rocker", "slot"}, {"crank", "b"}, -0.15};
  mechanism.drivers.push_back(make_wave_driver("motor", {"crank"}, {0.4, 5.0, 0.25, 6.0, 0.1}));
  return mechanism;
}

Mechanism make_trammel() {
  Mechanism mechanism = make_empty("trammel", kObliqueGravity, {{"centre", {0.04, -0.03}}, {"side", {0.05, 0.01}}});
  BodyStart start = start_turning(0.6, 2.4);
  start.position = {-0.1, 0.1};
  mechanism.bodies.push_back(make_bar("rod", 0.3, 0.7, 6e-3, {0.19, 0.02}, start));
  mechanism.joints.push_back({"across", PinInSlot{{kFrameName, "centre"}, {"rod", "a"}, 0.1}});
  // written from the rod to the frame: this line turns
  mechanism.joints.push_back({"along", PinInSlot{{"rod", "b"}, {kFrameName, "side"}, 0.9}});
  return mechanism;
}

Mechanism make_moved_slides() {
  Mechanism mechanism = make_two_slides();
  mechanism.name = "moved_slides";
  for (const int joint : {0, 1}) std::get<Prismatic>(mechanism.joints[joint].kind).start.speed.reset();
  mechanism.bodies.back().start = {};
  mechanism.bodies.push_back(make_bar("tail", 0.2, 0.3, 1.4e-3, {0.12, 0.015}, start_turning(-0.6, -1.7)));
  add_revolute(mechanism, "tip", {"pendulum", "b"}, {"tail", "a"});
  mechanism.drivers.push_back({"lift", DrivenSlide{"lower"}, 0.0, 0.0, make_wave({0.11, 0.05, 0.06, 11.0, 0.7})});
  mechanism.drivers.push_back({"press", DrivenSlide{"upper"}, 0.0, 0.0, make_cubic_curve(-0.08, 0.5, -2.1, 3.0)});
  mechanism.drivers.push_back(make_wave_driver("swing", {"pendulum"}, {-1.0, 0.9, 0.4, 6.0, 0.5}));
  return mechanism;
}

Mechanism make_splined_slide() {
  Mechanism mechanism = make_driven_slide();
  mechanism.name = "splined_slide";
  mechanism.drivers[0] = {"actuator", DrivenSlide{"rail"}, 0.0, 0.0, make_cubic_curve(0.12, 0.85, -3.0, 4.2)};
  return mechanism;
}

Mechanism make_projectile() {
  Mechanism mechanism = make_empty("projectile", kObliqueGravity, {});
  BodyStart start = start_turning(0.4, -7.0);
  start.position = {0.3, -0.2};
  start.velocity = {2.5, 4.0};
  mechanism.bodies.push_back(make_bar("bar", 0.3, 0.7, 6e-3, {0.19, 0.02}, start));
  return mechanism;
}

}  // namespace gudgeon::oracle
