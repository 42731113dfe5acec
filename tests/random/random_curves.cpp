// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Linear, monotone, splines, and nothing said; steps are two points next to one another.
#include "tests/random/random_curves.h"

#include <fmt/format.h>

#include <numbers>
#include <utility>

namespace gudgeon::random {

SampledCurve draw_curve(Draw& draw, std::string over, double first, double range, double size) {
  constexpr double kStepWidth = 1e-4;  // of the range
  SampledCurve curve;
  curve.over = std::move(over);
  const int shape = draw.below(4);
  if (shape < 3) curve.interpolation = kInterpolations[static_cast<std::size_t>(shape)].second;
  // A spline through a step would overshoot a thousandfold.
  const bool has_step = curve.interpolation != Interpolation::spline && draw.with_chance(0.5);
  const int n = 5 + draw.below(4);
  for (int k = 0; k < n; ++k) {
    curve.arguments.push_back(first + range * (k + (k > 0 && k < n - 1 ? draw.between(-0.3, 0.3) : 0.0)) / (n - 1));
    curve.values.push_back(draw.between(-size, size));
    if (!has_step || k != n / 2) continue;
    curve.arguments.push_back(curve.arguments.back() + kStepWidth * range);
    curve.values.push_back(draw.between(-size, size));
  }
  return curve;
}

void add_curves(RandomModel& model, Draw& draw) {
  Mechanism& mechanism = model.mechanism;
  const int n = 1 + draw.below(3);
  for (int i = 0; i < n; ++i) {
    const int b = 1 + draw.below(static_cast<int>(mechanism.bodies.size()) - 1);
    const Body& body = mechanism.bodies[static_cast<std::size_t>(b)];
    const std::string name = fmt::format("C{}", i);
    if (draw.with_chance(0.4)) {
      SampledCurve curve = draw_curve(draw, body.name + ".angle", draw.angle(), 2.0 * std::numbers::pi, 2.0);
      curve.periodic = true;
      curve.values.back() = curve.values.front();
      mechanism.loads.push_back({name, VariableTorque{body.name, kFrameName, curve}});
      model.curves.push_back({curve, {body.name, ""}});
      continue;
    }
    const auto k = static_cast<std::size_t>(draw.below(static_cast<int>(body.points.size())));
    const Anchor point{body.name, body.points[k].name};
    const bool is_x = draw.with_chance(0.5);
    const std::string over = fmt::format("{}.{}.{}", point.body, point.point, is_x ? "x" : "y");
    const SampledCurve curve = draw_curve(draw, over, draw.between(-1.0, -0.5), 1.5, 20.0);
    VariableForce force{point, 0.0, 0.0, kFrameName};
    (is_x ? force.x : force.y) = curve;
    mechanism.loads.push_back({name, force});
    model.curves.push_back({curve, point});
  }
}

}  // namespace gudgeon::random
