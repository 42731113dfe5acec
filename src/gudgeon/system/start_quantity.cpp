// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Sums along paths, term by term.
#include "gudgeon/system/start_quantity.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

namespace gudgeon {

Eigen::RowVectorXd StartQuantity::make_row(Eigen::Index n_free) const {
  Eigen::RowVectorXd row = Eigen::RowVectorXd::Zero(n_free);
  for (const auto& [coordinate, derivative] : gradient) row(coordinate) += derivative;
  return row;
}

int StartQuantity::find_coordinate() const {
  return gradient.size() == 1 && gradient.front().second == 1.0 ? gradient.front().first : -1;
}

namespace {

class QuantitySum {
 public:
  QuantitySum(const Topology& topology, const Coordinates& at) : counts_(topology.counts), at_(at) {}

  void add_turn(int turn, double derivative) {
    quantity.rate += derivative * at_.angle_rate[turn];
    if (turn < counts_.n_free_turns) add(turn, derivative);
  }

  void add_slide(int slide, double derivative) {
    quantity.rate += derivative * at_.slide_rate[slide];
    if (slide < counts_.n_free_slides) add(counts_.n_free_turns + slide, derivative);
  }

  void add_path(const Path& path, Vec2 direction, double sign) {
    for (const Term& term : path) {
      const Vec2 arm = at_.rotation[term.turn] * term.vector;
      const double scale = at_.slide[term.slide];
      way += sign * scale * arm;
      add_turn(term.turn, sign * scale * dot(direction, perp(arm)));
      add_slide(term.slide, sign * dot(direction, arm));
    }
  }

  Vec2 way;
  StartQuantity quantity;

 private:
  void add(int coordinate, double derivative) {
    const auto known = std::ranges::find(quantity.gradient, coordinate, &std::pair<int, double>::first);
    if (known != quantity.gradient.end()) {
      known->second += derivative;
    } else {
      quantity.gradient.emplace_back(coordinate, derivative);
    }
  }

  const CoordinateCounts& counts_;
  const Coordinates& at_;
};

}  // namespace

StartQuantity find_quantity(const Topology& topology, const DirectedWay& way, const Coordinates& at) {
  const BodyNode& axes = topology.bodies[way.axes_body];
  const Vec2 direction = at.rotation[axes.turn] * (make_rotation(axes.offset) * way.direction);
  QuantitySum sum(topology, at);
  sum.add_path(topology.find_path(way.to_body, way.to), direction, 1.0);
  sum.add_path(topology.find_path(way.from_body, way.from), direction, -1.0);
  sum.quantity.value = dot(direction, sum.way);
  sum.add_turn(axes.turn, dot(perp(direction), sum.way));
  // What both paths share moves neither.
  std::erase_if(sum.quantity.gradient, [](const auto& entry) { return entry.second == 0.0; });
  return sum.quantity;
}

StartQuantity find_angle(const Topology& topology, int body, const Coordinates& at) {
  QuantitySum sum(topology, at);
  const BodyNode& node = topology.bodies[body];
  sum.quantity.value = at.angle[node.turn] + node.offset;
  sum.add_turn(node.turn, 1.0);
  return sum.quantity;
}

StartQuantity find_quantity(const Mechanism& mechanism, const Topology& topology, const GivenStart& given,
                            const Coordinates& at) {
  using Kind = GivenStart::Kind;
  if (given.kind == Kind::angle) return find_angle(topology, given.index, at);
  if (given.kind != Kind::displacement) {
    return find_quantity(topology, {0, {}, given.index, {}, 0, given.kind == Kind::x ? Vec2{1.0, 0.0} : Vec2{0.0, 1.0}},
                         at);
  }
  const AnyJoint& joint = mechanism.joints[given.index].kind;
  const auto& [first, second] = topology.ends[given.index];
  const Rotation line = make_rotation(find_line_direction(joint));
  return find_quantity(topology, {first.body, first.point, second.body, second.point, first.body, {line.c, line.s}},
                       at);
}

double find_way(const GivenStart& given, double from) {
  const double way = given.value - from;
  return given.kind == GivenStart::Kind::angle ? std::remainder(way, 2.0 * std::numbers::pi) : way;
}

namespace {

struct StartNames {
  const char* angle_key;
  const char* angle;
  const char* place_key;
  const char* place;
  const char* slide_key;
  const char* slide;
};
constexpr StartNames kPositions{"angle", "angle", "position", "position", "displacement", "displacement"};
constexpr StartNames kRates{"angle_rate", "angle rate", "velocity", "velocity", "speed", "speed"};

std::vector<GivenStart> list_given(const Mechanism& mechanism, const StartNames& names,
                                   std::optional<double> BodyStart::*angle, std::optional<Vec2> BodyStart::*place,
                                   std::optional<double> SlideStart::*slide) {
  using Kind = GivenStart::Kind;
  std::vector<GivenStart> given;
  for (std::size_t b = 1; b < mechanism.bodies.size(); ++b) {
    const Body& body = mechanism.bodies[b];
    const auto add = [&](Kind kind, double value, const char* key, const std::string& name) {
      given.push_back({kind, static_cast<int>(b), value, fmt::format("bodies.{}.start.{}", body.name, key),
                       fmt::format("body '{}': its start {}", body.name, name)});
    };
    if (const auto& value = body.start.*angle) add(Kind::angle, *value, names.angle_key, names.angle);
    if (const auto& value = body.start.*place) {
      add(Kind::x, value->x, names.place_key, fmt::format("{}'s x", names.place));
      add(Kind::y, value->y, names.place_key, fmt::format("{}'s y", names.place));
    }
  }
  for (std::size_t j = 0; j < mechanism.joints.size(); ++j) {
    const Joint& joint = mechanism.joints[j];
    const auto* guide = std::get_if<Prismatic>(&joint.kind);
    if (guide == nullptr || !(guide->start.*slide)) continue;
    given.push_back({Kind::displacement, static_cast<int>(j), *(guide->start.*slide),
                     fmt::format("joints.{}.start.{}", joint.name, names.slide_key),
                     fmt::format("joint '{}': its start {}", joint.name, names.slide)});
  }
  return given;
}

}  // namespace

std::vector<GivenStart> list_given_positions(const Mechanism& mechanism) {
  return list_given(mechanism, kPositions, &BodyStart::angle, &BodyStart::position, &SlideStart::displacement);
}

std::vector<GivenStart> list_given_rates(const Mechanism& mechanism) {
  return list_given(mechanism, kRates, &BodyStart::angle_rate, &BodyStart::velocity, &SlideStart::speed);
}

}  // namespace gudgeon
