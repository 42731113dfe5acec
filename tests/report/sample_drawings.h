// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Linkages made by hand for the tests of the picture.
#pragma once

#include <string>

#include "gudgeon/report/mechanism_drawing.h"

namespace gudgeon::test {

/// The nine-bar press at its start, positions in metres.
inline MechanismDrawing make_nine_bar_drawing() {
  constexpr Vec2 kO1{0.0, 0.0}, kO4{0.430, 0.0}, kP6{-0.220, 0.460};
  constexpr Vec2 kA{0.0223093, 0.0390806}, kB{0.4873576, -0.0757304}, kD{0.1871338, 0.3203436};
  constexpr Vec2 kE{0.0065307, 0.4997974}, kF{0.2522438, 0.5664774}, kS{0.5698719, 0.460};
  const Vec2 guide{0.0, 0.460};
  using enum DrawnJointKind;
  return {.title = "Nine-bar press",
          .subtitle = "t = 0 s",
          .bodies = {{"frame", true, {kO1, kO4, kP6, guide}, {}},
                     {"crank_1", false, {kO1, kA}, {}},
                     {"rod_2", false, {kA, kD}, {}},
                     {"rod_3", false, {kB, kD}, {}},
                     {"crank_4", false, {kO4, kB}, {}},
                     {"rod_6", false, {kP6, kE}, {}},
                     {"panel_7", false, {kD, kE, kF}, {}},
                     {"rod_8", false, {kF, kS}, {}},
                     {"slider_9", false, {kS}, kS}},
          .joints = {{"O1", revolute, 0, 1, kO1, kO1},
                     {"A", clearance, 1, 2, kA, kA},
                     {"D2", revolute, 2, 6, kD, kD},
                     {"D3", revolute, 3, 6, kD, kD},
                     {"B", clearance, 4, 3, kB, kB},
                     {"O4", revolute, 0, 4, kO4, kO4},
                     {"P6", revolute, 0, 5, kP6, kP6},
                     {"E", revolute, 5, 6, kE, kE},
                     {"F", revolute, 6, 7, kF, kF},
                     {"S", revolute, 7, 8, kS, kS},
                     {"guide", prismatic, 0, 8, guide, kS, 0.0}},
          .drivers = {{1, false, kO1, 0.0, -6.283}, {4, false, kO4, 0.0, 6.283}},
          .traces = {},
          .gravity = {9.81, 0.0}};
}

inline MechanismDrawing make_slider_crank_drawing() {
  constexpr Vec2 kO{0.0, 0.0}, kA{0.0354, 0.0354}, kS{0.1511, 0.0};
  using enum DrawnJointKind;
  return {.title = "Slider-crank",
          .subtitle = "t = 0 s",
          .bodies = {{"frame", true, {kO}, {}},
                     {"crank", false, {kO, kA}, {}},
                     {"connecting_rod", false, {kA, kS}, {}},
                     {"piston", false, {kS}, kS}},
          .joints = {{"O", revolute, 0, 1, kO, kO},
                     {"A", revolute, 1, 2, kA, kA},
                     {"gudgeon_pin", clearance, 3, 2, kS, kS},
                     {"guide", prismatic, 0, 3, kO, kS, 0.0}},
          .drivers = {{1, false, kO, 0.0, 10.0}},
          .traces = {},
          .gravity = {0.0, -9.81}};
}

inline MechanismDrawing make_four_bar_drawing() {
  constexpr Vec2 kO{0.0, 0.0}, kC{4.0, 0.0}, kA{0.5, 0.866}, kB{3.2, 2.58}, kP{1.2, 3.1};
  using enum DrawnJointKind;
  MechanismDrawing drawing{.title = "Four-bar with a coupler point",
                           .subtitle = "t = 0.25 s",
                           .bodies = {{"frame", true, {kO, kC}, {}},
                                      {"crank", false, {kO, kA}, {}},
                                      {"coupler", false, {kA, kB, kP}, {}},
                                      {"rocker", false, {kB, kC}, {}}},
                           .joints = {{"O", revolute, 0, 1, kO, kO},
                                      {"A", revolute, 1, 2, kA, kA},
                                      {"B", revolute, 2, 3, kB, kB},
                                      {"C", revolute, 0, 3, kC, kC}},
                           .drivers = {{1, false, kO, 0.0, 1.0}},
                           .traces = {{"P", {}}},
                           .gravity = {0.0, -9.81}};
  for (int i = 0; i <= 60; ++i) {
    const double angle = i * 6.283185307179586 / 60.0;
    drawing.traces[0].points.push_back(kP + Vec2{0.9 * std::cos(angle) - 0.9, 0.45 * std::sin(angle)});
  }
  return drawing;
}

/// A rail that turns with its crank, a block sliding on it, and a pendulum welded below.
inline MechanismDrawing make_quick_return_drawing() {
  constexpr Vec2 kO{0.0, 0.0}, kC{0.0, -0.3}, kA{0.12, 0.05}, kG{0.2057, 0.3};
  using enum DrawnJointKind;
  return {.title = "Quick return <&>",
          .subtitle = "t = 0 s",
          .bodies = {{"frame", true, {kO, kC}, {}},
                     {"crank", false, {kO, kA}, {}},
                     {"block", false, {kA}, kA},
                     {"lever", false, {kC, kG}, {}},
                     {"bob", false, {kG}, kG + Vec2{0.08, -0.06}}},
          .joints = {{"O", revolute, 0, 1, kO, kO},
                     {"A", revolute, 1, 2, kA, kA},
                     {"C", revolute, 0, 3, kC, kC},
                     {"slot", prismatic, 3, 2, kC, kA, 1.2404},
                     {"W", rigid, 3, 4, kG, kG}},
          .drivers = {{1, false, kO, 0.0, 1.0}},
          .traces = {},
          .gravity = {0.0, -9.81}};
}

/// A pin with clearance in an upright slot of a yoke, which stands loose in a guide.
inline MechanismDrawing make_yoke_drawing() {
  constexpr Vec2 kO{0.0, 0.0}, kP{0.03, 0.02}, kS{0.03, 0.0}, kF{0.13, 0.0}, kG{0.1, 0.0};
  using enum DrawnJointKind;
  return {.title = "Scotch yoke",
          .subtitle = "t = 0 s",
          .bodies = {{"frame", true, {kO, kG}, {}}, {"crank", false, {kO, kP}, {}}, {"yoke", false, {kS, kF}, {}}},
          .joints = {{"O", revolute, 0, 1, kO, kO},
                     {"pin", pin_in_slot_clearance, 2, 1, kS, kP, 1.5707963267948966, 0.08},
                     {"guide", prismatic_clearance, 0, 2, kG, kF, 0.0, 0.14}},
          .drivers = {{1, false, kO, 0.0, 10.0}},
          .traces = {},
          .gravity = {}};
}

/// A flat scissor lift of n pairs of links under a tall path of its top: much to name on little of the sheet.
inline MechanismDrawing make_scissors_drawing(int n) {
  constexpr double kWide = 0.135;
  constexpr double kHigh = 0.036;
  MechanismDrawing drawing;
  drawing.title = "Scissors";
  drawing.subtitle = "t = 0 s";
  drawing.bodies.push_back({"frame", true, {{0.0, 0.0}, {kWide, 0.0}}, {}});
  for (int i = 0; i < n; ++i) {
    const Vec2 low{0.0, kHigh * i}, high{kWide, kHigh * (i + 1)};
    const std::string number = std::to_string(i);
    drawing.bodies.push_back({"link_right_" + number, false, {low, high}, {}});
    drawing.bodies.push_back({"link_left_" + number, false, {{high.x, low.y}, {low.x, high.y}}, {}});
    const int right = 2 * i + 1;
    const int left = right + 1;
    drawing.joints.push_back(
        {"m" + number, DrawnJointKind::revolute, right, left, 0.5 * (low + high), 0.5 * (low + high)});
    if (i == 0) continue;
    drawing.joints.push_back({"a" + number, DrawnJointKind::revolute, left - 2, right, low, low});
    const Vec2 beside{high.x, low.y};
    drawing.joints.push_back({"b" + number, DrawnJointKind::revolute, right - 2, left, beside, beside});
  }
  drawing.joints.push_back({"O", DrawnJointKind::revolute, 0, 1, {0.0, 0.0}, {0.0, 0.0}});
  drawing.joints.push_back({"slot", DrawnJointKind::pin_in_slot, 0, 2, {kWide, 0.0}, {kWide, 0.0}, 0.0});
  drawing.traces.push_back({"top", {{0.0, kHigh * n}, {0.0, 4.0 * kHigh * n}}});
  return drawing;
}

}  // namespace gudgeon::test
