// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// A good model, and one way to spoil it beside what the check must say then.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <limits>

#include "gudgeon/model/check.h"

namespace gudgeon::test {

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
                      {"guide", Prismatic{{"frame", "G"}, {"slider", "S"}, 0.0, 0.0, {}, {}}}};
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

}  // namespace gudgeon::test
