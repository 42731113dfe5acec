// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// A model that is good, and ways to break one rule of the check in it.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <limits>
#include <variant>

#include "gudgeon/model/check.h"

namespace gudgeon::broken {

inline constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

struct Model {
  Mechanism mechanism;
  Study study;

  RevoluteClearance& pin() { return std::get<RevoluteClearance>(mechanism.joints[1].kind); }
};

inline Model make_good() {
  Model model;
  Mechanism& mechanism = model.mechanism;
  mechanism.name = "press";
  mechanism.bodies = {{"frame", 0.0, 0.0, {}, {{"O", {}}, {"G", {}}}, {}},
                      {"crank", 1.0, 1.0, {}, {{"O", {}}, {"A", {1.0, 0.0}}}, {}},
                      {"rod", 1.0, 1.0, {}, {{"A", {}}, {"S", {2.0, 0.0}}}, {}},
                      {"slider", 1.0, 0.0, {}, {{"S", {}}}, {}}};
  const Material steel{"steel", 200e9, 0.3};
  const ContactProperties contact{
      "pin",          steel,         steel, LankaraniNikravesh{}, CoulombSmooth{.kinetic_coefficient = 0.1},
      Archard{1e-14}, Archard{1e-14}};
  mechanism.joints = {{"O", Revolute{{"frame", "O"}, {"crank", "O"}}},
                      {"A", RevoluteClearance{{"crank", "A"}, {"rod", "A"}, 0.01, 0.0005, 0.02, contact}},
                      {"S", Revolute{{"rod", "S"}, {"slider", "S"}}},
                      {"guide", Prismatic{{"frame", "G"}, {"slider", "S"}, 0.0, 0.0, {}}}};
  mechanism.drivers = {{"crank", DrivenAngle{"crank"}, 0.0, 1.0}};
  mechanism.loads = {{"push", ConstantForce{{"slider", "S"}, {1.0, 0.0}}}, {"brake", ConstantTorque{"crank", 1.0}}};
  model.study.cycle_driver = "crank";
  model.study.wear_stages = 1;
  return model;
}

struct Broken {
  const char* code;
  const char* path;
  const char* message;  ///< a part of what is rendered
  std::function<void(Model&)> spoil;
};

/// The broken rule is among what the check finds.
inline void expect_found(const Broken& broken) {
  Model model = make_good();
  broken.spoil(model);
  const Diagnostics found = check(model.mechanism, model.study);
  const auto hit = std::ranges::find_if(
      found.items(), [&](const Diagnostic& item) { return item.code == broken.code && item.path == broken.path; });
  const std::string text = render(found, {});
  EXPECT_NE(hit, found.items().end()) << text;
  EXPECT_NE(text.find(broken.message), std::string::npos) << text;
}

inline std::function<void(Model&)> with_load(const AnyLoad& kind) {
  return [kind](Model& m) { m.mechanism.loads.push_back({"x", kind}); };
}

/// The driver with that motion, in a study that has a cycle of its own: 10 cycles of 1 s.
inline std::function<void(Model&)> with_motion(const std::variant<std::monostate, Expression, SampledCurve>& motion) {
  return [motion](Model& m) {
    m.mechanism.drivers[0] = {"crank", DrivenAngle{"crank"}, 0.0, 0.0, motion};
    m.study.cycle_driver = "";
    m.study.cycle_time = 1.0;
  };
}

inline VariableTorque torque_of(const Function& function) { return {"crank", "frame", function}; }

/// A guide with clearance in place of the good model's.
inline std::function<void(Model&)> with_guide(double bearing_length, double journal_length, double corner_radius,
                                              double clearance) {
  return [=](Model& m) {
    m.mechanism.joints[3].kind =
        PrismaticClearance{{"frame", "G"}, {"slider", "S"}, 0.0,       0.0,  bearing_length, journal_length,
                           0.02,           corner_radius,   clearance, 0.01, m.pin().contact};
  };
}

}  // namespace gudgeon::broken
