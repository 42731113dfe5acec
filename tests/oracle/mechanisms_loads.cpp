// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Mechanisms with loads that depend on time and on the state.
#include "tests/oracle/mechanism_parts.h"
#include "tests/oracle/mechanisms.h"

namespace gudgeon::oracle {

Mechanism make_sprung_four_bar() {
  Mechanism mechanism = make_four_bar();
  mechanism.name = "sprung_four_bar";
  mechanism.bodies[0].points.push_back({"post", {0.11, 0.42}});
  mechanism.loads.push_back({"return", Spring{{kFrameName, "post"}, {"coupler", "tool"}, 420.0, 7.0, 0.12}});
  mechanism.loads.push_back({"strut", Spring{{"rocker", "a"}, {"crank", "b"}, 90.0, 0.0, 0.3}});
  mechanism.loads.push_back({"shock", Spring{{"crank", "a"}, {"rocker", "b"}, 0.0, 11.0, 0.0}});
  return mechanism;
}

// Offset slider-crank: a motor whose torque falls with speed, a press force that rises along the guide.
Mechanism make_press() {
  Mechanism mechanism = make_slider_crank();
  mechanism.name = "press";
  const Expression motor{"stall * (1 - crank.angle_rate / idle) * smooth_step(t, -0.1, 0.2)",
                         {{"stall", -1.7}, {"idle", -31.0}}};
  const SampledCurve resistance{
      "guide.displacement", {0.1, 0.15, 0.2, 0.25, 0.3, 0.35}, {0.0, -4.0, -19.0, -38.0, -52.0, -55.0}, false};
  mechanism.loads.push_back({"motor", VariableTorque{"crank", kFrameName, motor}});
  mechanism.loads.push_back({"work", VariableForce{{"slider", "a"}, resistance, 1.3, "slider"}});
  mechanism.loads.push_back({"drag", VariableForce{{"rod", "b"}, Expression{"-3.1 * guide.speed", {}}, 0.0, "frame"}});
  return mechanism;
}

// An arm of two links, each with a controller that follows a reference.
Mechanism make_controlled_arm() {
  Mechanism mechanism = make_pendulum_chain(2);
  mechanism.name = "controlled_arm";
  const std::vector<std::pair<std::string, double>> gains{{"kp", 35.0}, {"kd", 1.9}};
  const Expression shoulder{"kp * (0.5 * sin(3 * t) - bar_1.angle) - kd * bar_1.angle_rate", gains};
  const Expression elbow{
      "0.4 * kp * (0.3 - bar_2.angle + bar_1.angle) - 0.3 * kd * (bar_2.angle_rate - bar_1.angle_rate)", gains};
  mechanism.loads.push_back({"shoulder", VariableTorque{"bar_1", kFrameName, shoulder}});
  mechanism.loads.push_back({"elbow", VariableTorque{"bar_2", "bar_1", elbow}});
  return mechanism;
}

// A body that only a bushing holds, on the tip of a swinging bar; another bushing from the frame to the bar.
Mechanism make_pod_on_bushing() {
  Mechanism mechanism = make_pendulum_chain(1);
  mechanism.name = "pod_on_bushing";
  mechanism.bodies[0].points.push_back({"anchor", {0.3, -0.3}});
  BodyStart start = start_turning(0.5, -1.7);
  start.position = {0.42, -0.36};
  start.velocity = {0.3, -0.2};
  mechanism.bodies.push_back({"pod", 0.6, 0.004, {0.02, -0.03}, {{"eye", {-0.05, 0.04}}}, start});
  Bushing mount{{"bar_1", "b"}, {"pod", "eye"}, {900.0, 350.0}, {6.0, 2.5}, 14.0, 0.12, 0.8};
  mechanism.loads.push_back({"mount", mount});
  mechanism.loads.push_back(
      {"stay", Bushing{{kFrameName, "anchor"}, {"bar_1", "b"}, {40.0, 70.0}, {0.0, 1.1}, 3.0, 0.0, -0.2}});
  return mechanism;
}

Mechanism make_torsion_chain() {
  Mechanism mechanism = make_rigid_chain();
  mechanism.name = "torsion_chain";
  mechanism.loads.push_back({"coil", TorsionSpring{"bracket", "pendulum", 5.5, 0.07, -0.9}});
  mechanism.loads.push_back({"root", TorsionSpring{"arm", kFrameName, 2.1, 0.04, 0.3}});
  return mechanism;
}

// A thruster that turns with a rod, over a periodic curve of the time.
Mechanism make_pushed_five_bar() {
  Mechanism mechanism = make_five_bar();
  mechanism.name = "pushed_five_bar";
  const SampledCurve pulses{"t", {0.0, 0.04, 0.1, 0.16, 0.2}, {3.0, 11.0, -2.0, 5.0, 3.0}, true};
  const Expression side{"0.8 * rod_3.b.y_velocity - 20 * (rod_2.x - 0.2)", {}};
  mechanism.loads.push_back({"thruster", VariableForce{{"rod_3", "b"}, pulses, side, "rod_2"}});
  mechanism.loads.push_back({"link", Spring{{"crank_1", "b"}, {"crank_4", "b"}, 150.0, 1.5, 0.2}});
  return mechanism;
}

// Driven slide, its effort and reactions under loads; the loads act on driven and on free bodies.
Mechanism make_loaded_driven_slide() {
  Mechanism mechanism = make_driven_slide();
  mechanism.name = "loaded_driven_slide";
  mechanism.loads.push_back({"spring", Spring{{kFrameName, "pivot"}, {"block", "hook"}, 130.0, 2.2, 0.3}});
  mechanism.loads.push_back(
      {"push", VariableForce{{"pendulum", "b"}, Expression{"-8 * rail.displacement", {}}, 2.0, "arm"}});
  mechanism.loads.push_back(
      {"brake", VariableTorque{"pendulum", "block", Expression{"-0.2 * pendulum.angle_rate + 0.1 * rail.speed", {}}}});
  return mechanism;
}

// Slides of the tree, one of them read backwards: it grows while the carriage falls.
Mechanism make_loaded_slides() {
  Mechanism mechanism = make_two_slides();
  mechanism.name = "loaded_slides";
  const Expression hold{"-60 * (lower.displacement - 0.1) - 3 * lower.speed", {}};
  mechanism.loads.push_back({"hold", VariableForce{{"table", "foot"}, hold, 0.0, "table"}});
  const Expression damp{"4 * upper.speed + 35 * upper.displacement * abs(upper.displacement)", {}};
  mechanism.loads.push_back({"damp", VariableForce{{"carriage", "hook"}, 0.0, damp, "frame"}});
  mechanism.loads.push_back({"stop", TorsionSpring{"carriage", "pendulum", 1.4, 0.03, -0.5}});
  return mechanism;
}

// A clearance joint beside loads at its own points, and a driven crank.
Mechanism make_loaded_clearance() {
  Mechanism mechanism = make_slider_crank_clearance();
  mechanism.name = "loaded_clearance";
  mechanism.bodies[0].points.push_back({"stop", {0.3, 0.02}});
  mechanism.loads.push_back({"gas", Spring{{"slider", "pin"}, {kFrameName, "stop"}, 5e4, 40.0, 0.1}});
  mechanism.loads.push_back(
      {"drag", VariableForce{{"slider", "pin"}, Expression{"-9 * slider.x_velocity", {}}, 0.0, "frame"}});
  mechanism.loads.push_back({"twist", TorsionSpring{"crank", "rod", 20.0, 0.01, 0.0}});
  return mechanism;
}

std::vector<Mechanism> make_loaded_mechanisms() {
  return {make_sprung_four_bar(),     make_press(),         make_controlled_arm(),
          make_pod_on_bushing(),      make_torsion_chain(), make_pushed_five_bar(),
          make_loaded_driven_slide(), make_loaded_slides(), make_loaded_clearance()};
}

}  // namespace gudgeon::oracle
