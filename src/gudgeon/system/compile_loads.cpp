// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Points, turns, equations and channels of every load.
#include "gudgeon/system/compile_loads.h"

#include <algorithm>
#include <optional>
#include <unordered_map>
#include <utility>

namespace gudgeon {

namespace {

class LoadCompiler {
 public:
  LoadCompiler(const Mechanism& mechanism, const Topology& topology, Tables& tables)
      : mechanism_(mechanism), names_(mechanism), topology_(topology), tables_(tables) {}

  void compile() {
    tables_.loads.effects.resize(mechanism_.loads.size());
    for (int k = 0; k < static_cast<int>(mechanism_.loads.size()); ++k) {
      std::visit([&](const auto& kind) { add(k, kind); }, mechanism_.loads[k].kind);
    }
  }

 private:
  // Constant loads are fields and torques of their own; here they are only known.
  void add(int k, const ConstantForce& force) { tables_.loads.effects[k].force = force.force; }
  void add(int k, const ConstantTorque& torque) { tables_.loads.effects[k].torque = torque.torque; }

  void add(int k, const VariableForce& force) {
    const BodyNode& axes = find_node(force.axes);
    tables_.loads.forces.push_back({k, add_point(force.point), axes.turn, make_rotation(axes.offset),
                                    compile_function(force.x), compile_function(force.y)});
  }

  void add(int k, const VariableTorque& torque) {
    tables_.loads.torques.push_back({k, make_couple(torque.against, torque.body), compile_function(torque.torque)});
  }

  void add(int k, const Spring& spring) {
    tables_.loads.springs.push_back(
        {k, add_point(spring.first), add_point(spring.second), spring.stiffness, spring.damping, spring.free_length});
  }

  void add(int k, const TorsionSpring& spring) {
    tables_.loads.torsions.push_back(
        {k, make_couple(spring.first, spring.second), spring.stiffness, spring.damping, spring.free_angle});
  }

  void add(int k, const Bushing& bushing) {
    const TorsionLoad torsion{k, make_couple(bushing.first.body, bushing.second.body), bushing.angular_stiffness,
                              bushing.angular_damping, bushing.free_angle};
    tables_.loads.bushings.push_back({torsion, add_point(bushing.first), add_point(bushing.second),
                                      make_rotation(find_node(bushing.first.body).offset), bushing.stiffness,
                                      bushing.damping});
  }

  [[nodiscard]] const BodyNode& find_node(const std::string& body) const {
    return topology_.bodies[names_.find_body(body)];
  }

  int add_point(int body, Vec2 local) { return tables_.points.add(topology_.find_path(body, local), topology_.counts); }

  int add_point(const Anchor& anchor) {
    const JointEnd end = find_end(names_, anchor);
    return add_point(end.body, end.point);
  }

  [[nodiscard]] TurnCouple make_couple(const std::string& first_body, const std::string& second_body) const {
    const BodyNode& first = find_node(first_body);
    const BodyNode& second = find_node(second_body);
    return {first.turn, second.turn, tables_.find_turn_index(first.turn), tables_.find_turn_index(second.turn),
            second.offset - first.offset};
  }

  LoadFunction compile_function(const Function& function) {
    LoadFunction compiled;
    if (const auto* constant = std::get_if<double>(&function)) {
      compiled.constant = *constant;
    } else if (const auto* expression = std::get_if<Expression>(&function)) {
      compiled.expression = static_cast<int>(tables_.loads.expressions.size());
      tables_.loads.expressions.push_back(*expression);
      for (const int used : known().find_in_formula(expression->text)) find_channel(used);
    } else {
      const auto& curve = std::get<SampledCurve>(function);
      compiled.curve = static_cast<int>(tables_.loads.curves.size());
      tables_.loads.curves.push_back(make_load_curve(curve));
      compiled.channel = find_channel(known().find(curve.over));
    }
    return compiled;
  }

  // Where one of the known channels stands among those that are used.
  int find_channel(int number) {
    LoadTables& loads = tables_.loads;
    const auto [used, is_new] = used_.emplace(number, static_cast<int>(loads.channels.size()));
    if (is_new) {
      loads.channel_names.push_back(known().names()[number]);
      loads.channels.push_back(make_source(known().channels()[number]));
    }
    return used->second;
  }

  // Made when the first formula or curve asks.
  const ChannelIndex& known() {
    if (!known_) known_.emplace(mechanism_);
    return *known_;
  }

  ChannelSource make_source(const StateChannel& channel) {
    using Quantity = StateChannel::Quantity;
    ChannelSource source;
    source.quantity = channel.quantity;
    switch (channel.quantity) {
      case Quantity::time:
        break;
      case Quantity::x:
      case Quantity::y:
      case Quantity::x_velocity:
      case Quantity::y_velocity:
        source.row = add_point(channel.body, channel.local);
        break;
      case Quantity::angle:
      case Quantity::angle_rate:
        source.turn = topology_.bodies[channel.body].turn;
        source.offset = topology_.bodies[channel.body].offset;
        break;
      case Quantity::displacement:
      case Quantity::speed:
        fill_line(channel.joint, source);
        break;
    }
    return source;
  }

  void fill_line(int joint, ChannelSource& source) {
    const AnyJoint& kind = mechanism_.joints[joint].kind;
    const auto& [first, second] = topology_.ends[joint];
    const double direction = std::visit(
        []<class Kind>(const Kind& k) {
          if constexpr (requires { k.direction; }) {
            return k.direction;
          } else {
            return 0.0;
          }
        },
        kind);
    const BodyNode& node = topology_.bodies[first.body];
    const Rotation along = make_rotation(node.offset + direction);
    source.origin_row = add_point(first.body, first.point);
    source.row = add_point(second.body, second.point);
    source.turn = node.turn;
    source.axis = {along.c, along.s};
    source.slide = topology_.joint_slide[joint];
  }

  const Mechanism& mechanism_;
  NameIndex names_;
  const Topology& topology_;
  Tables& tables_;
  std::optional<ChannelIndex> known_;
  std::unordered_map<int, int> used_;  // where the known channels stand among those that are used
};

}  // namespace

void compile_loads(const Mechanism& mechanism, const Topology& topology, Tables& tables) {
  LoadCompiler(mechanism, topology, tables).compile();
}

}  // namespace gudgeon
