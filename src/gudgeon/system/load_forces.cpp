// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Channels first, then every load of every table; equations are numbered as in docs/theory/loads.md.
#include "gudgeon/system/load_forces.h"

#include <cmath>
#include <limits>

namespace gudgeon {

namespace {

// Place and speed of a point along a line that turns with a body, from another point.
struct Displacement {
  double value;  // [m]
  double speed;  // [m/s]
};

Displacement find_displacement(const ChannelSource& source, const Workspace& ws) noexcept {
  const Coordinates& at = ws.coordinates;
  if (source.slide >= 0) return {at.slide[source.slide], at.slide_rate[source.slide]};
  const auto& first = ws.point_motions[source.origin_row];
  const auto& second = ws.point_motions[source.row];
  const Vec2 axis = at.rotation[source.turn] * source.axis;
  const Vec2 apart = second.position - first.position;
  return {dot(axis, apart),
          dot(axis, second.velocity - first.velocity) + at.angle_rate[source.turn] * cross(axis, apart)};
}

double find_value(const ChannelSource& source, double t, const Workspace& ws) noexcept {
  using Quantity = StateChannel::Quantity;
  switch (source.quantity) {
    case Quantity::time:
      return t;
    case Quantity::x:
      return ws.point_motions[source.row].position.x;
    case Quantity::y:
      return ws.point_motions[source.row].position.y;
    case Quantity::x_velocity:
      return ws.point_motions[source.row].velocity.x;
    case Quantity::y_velocity:
      return ws.point_motions[source.row].velocity.y;
    case Quantity::angle:
      return ws.coordinates.angle[source.turn] + source.offset;
    case Quantity::angle_rate:
      return ws.coordinates.angle_rate[source.turn];
    case Quantity::displacement:
      return find_displacement(source, ws).value;
    case Quantity::speed:
      return find_displacement(source, ws).speed;
  }
  return std::numeric_limits<double>::quiet_NaN();
}

double eval_expression(std::size_t expression, LoadScratch& scratch) noexcept {
  ExpressionEvaluator& evaluator = scratch.evaluators[expression];
  const double* values = scratch.channel_values.data();
  if (evaluator.breaks().empty()) return evaluator.eval(values);
  const std::size_t first = scratch.first_break[expression];
  const HeldPieces& held = scratch.held;
  const double share = held.shares[expression];
  double value = 0.0;
  if (share != 0.0) {
    value = share * evaluator.eval(values, held.others.data() + first, scratch.breaks.data() + first);
  }
  if (share == 1.0) return value;
  return value + (1.0 - share) * evaluator.eval(values, held.pieces.data() + first, scratch.breaks.data() + first);
}

double eval_function(const LoadTables& tables, const LoadFunction& function, LoadScratch& scratch) noexcept {
  if (function.expression >= 0) return eval_expression(static_cast<std::size_t>(function.expression), scratch);
  if (function.curve >= 0) return tables.curves[function.curve].eval(scratch.channel_values[function.channel]).value;
  return function.constant;
}

void add_couple(const TurnCouple& couple, double torque, Workspace& ws) noexcept {
  ws.equations[couple.second_index] += torque;
  ws.equations[couple.first_index] -= torque;
}

// Rate of the second turn against the first.
double find_rate(const TurnCouple& couple, const Coordinates& at) noexcept {
  return at.angle_rate[couple.second_turn] - at.angle_rate[couple.first_turn];
}

// F = R(θ_axes) (f_x, f_y) at a point r, P = F·ṙ      (Eq. L1)
void add_force(const ForceLoad& load, const LoadTables& tables, Workspace& ws) noexcept {
  const Vec2 components{eval_function(tables, load.x, ws.loads), eval_function(tables, load.y, ws.loads)};
  LoadEffect& effect = ws.loads.effects[load.load];
  effect.force = ws.coordinates.rotation[load.axes_turn] * (load.axes * components);
  effect.work_power = dot(effect.force, ws.point_motions[load.row].velocity);
  ws.point_loads[load.row] += effect.force;
}

// M on a body, −M on the one it acts against, P = M (θ̇ − θ̇_against)      (Eq. L1)
void add_torque(const TorqueLoad& load, const LoadTables& tables, Workspace& ws) noexcept {
  LoadEffect& effect = ws.loads.effects[load.load];
  effect.torque = eval_function(tables, load.torque, ws.loads);
  effect.work_power = effect.torque * find_rate(load.couple, ws.coordinates);
  add_couple(load.couple, effect.torque, ws);
}

// Direction from a spring's first point to its second. Where they coincide there is none: only a spring that pulls
// nothing there, k L₀ = 0, passes, in the direction it moves; for any other there is no force to be told.      (Eq. L3)
Vec2 find_direction(const SpringLoad& spring, Vec2 apart, double length, Vec2 velocity) noexcept {
  if (length > 0.0) return (1.0 / length) * apart;
  if (spring.stiffness * spring.free_length != 0.0) {
    constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
    return {kNone, kNone};
  }
  const double speed = norm(velocity);
  return speed > 0.0 ? (1.0 / speed) * velocity : Vec2{};
}

// F = k (L − L₀) + d L̇ draws the points together,  V = ½ k (L − L₀)²      (Eq. L2)
void add_spring(const SpringLoad& spring, Workspace& ws) noexcept {
  const auto& first = ws.point_motions[spring.first_row];
  const auto& second = ws.point_motions[spring.second_row];
  const Vec2 apart = second.position - first.position;
  const Vec2 velocity = second.velocity - first.velocity;
  LoadEffect& effect = ws.loads.effects[spring.load];
  effect.length = norm(apart);
  const Vec2 along = find_direction(spring, apart, effect.length, velocity);
  const double rate = dot(along, velocity);
  const double stretch = effect.length - spring.free_length;
  effect.pull = spring.stiffness * stretch + spring.damping * rate;
  effect.force = -effect.pull * along;
  effect.stored_energy = 0.5 * spring.stiffness * stretch * stretch;
  effect.storing_power = spring.stiffness * stretch * rate;
  effect.damper_power = spring.damping * rate * rate;
  ws.point_loads[spring.second_row] += effect.force;
  ws.point_loads[spring.first_row] -= effect.force;
}

// M = −k (θ − θ₀) − d θ̇ on the second body, −M on the first,  V = ½ k (θ − θ₀)²      (Eq. L4)
void add_torsion(const TorsionLoad& spring, Workspace& ws) noexcept {
  const TurnCouple& couple = spring.couple;
  const Coordinates& at = ws.coordinates;
  LoadEffect& effect = ws.loads.effects[spring.load];
  effect.twist = at.angle[couple.second_turn] - at.angle[couple.first_turn] + couple.offset;
  const double stretch = effect.twist - spring.free_angle;
  const double rate = find_rate(couple, at);
  effect.torque = -spring.stiffness * stretch - spring.damping * rate;
  effect.stored_energy = 0.5 * spring.stiffness * stretch * stretch;
  effect.storing_power = spring.stiffness * stretch * rate;
  effect.damper_power = spring.damping * rate * rate;
  add_couple(couple, effect.torque, ws);
}

// F = −k r − d ṙ with r = R(−θ_1) (r_2 − r_1) as the first body sees it, each component its own      (Eq. L5)
// The first body feels the force at the second point's place, so that no angular momentum comes from nowhere.
void add_bushing(const BushingLoad& bushing, Workspace& ws) noexcept {
  add_torsion(bushing.torsion, ws);
  const TurnCouple& couple = bushing.torsion.couple;
  const auto& first = ws.point_motions[bushing.first_row];
  const auto& second = ws.point_motions[bushing.second_row];
  const Rotation turned = ws.coordinates.rotation[couple.first_turn];
  const Rotation axes{turned.c * bushing.axes.c - turned.s * bushing.axes.s,
                      turned.s * bushing.axes.c + turned.c * bushing.axes.s};
  const Rotation back{axes.c, -axes.s};
  const Vec2 apart = second.position - first.position;
  const Vec2 offset = back * apart;
  // As seen from the first body.
  const double turning = ws.coordinates.angle_rate[couple.first_turn];
  const Vec2 rate = back * (second.velocity - first.velocity - turning * perp(apart));
  const Vec2 elastic{bushing.stiffness.x * offset.x, bushing.stiffness.y * offset.y};
  const Vec2 damping{bushing.damping.x * rate.x, bushing.damping.y * rate.y};

  LoadEffect& effect = ws.loads.effects[bushing.torsion.load];
  effect.offset = offset;
  effect.force = axes * -(elastic + damping);
  effect.stored_energy += 0.5 * dot(elastic, offset);
  effect.storing_power += dot(elastic, rate);
  effect.damper_power += dot(damping, rate);
  ws.point_loads[bushing.second_row] += effect.force;
  ws.point_loads[bushing.first_row] -= effect.force;
  ws.equations[couple.first_index] -= cross(apart, effect.force);
}

}  // namespace

void update_load_channels(const Tables& tables, double t, Workspace& workspace) noexcept {
  for (std::size_t k = 0; k < tables.loads.channels.size(); ++k) {
    workspace.loads.channel_values[k] = find_value(tables.loads.channels[k], t, workspace);
  }
}

void update_breaks(const Tables& tables, double t, Workspace& workspace) noexcept {
  update_load_channels(tables, t, workspace);
  for (std::size_t k = 0; k < workspace.loads.evaluators.size(); ++k) eval_expression(k, workspace.loads);
}

void add_variable_loads(const Tables& tables, double t, Workspace& workspace) noexcept {
  const LoadTables& loads = tables.loads;
  LoadScratch& scratch = workspace.loads;
  update_load_channels(tables, t, workspace);
  for (const ForceLoad& force : loads.forces) add_force(force, loads, workspace);
  for (const TorqueLoad& torque : loads.torques) add_torque(torque, loads, workspace);
  for (const SpringLoad& spring : loads.springs) add_spring(spring, workspace);
  for (const TorsionLoad& spring : loads.torsions) add_torsion(spring, workspace);
  for (const BushingLoad& bushing : loads.bushings) add_bushing(bushing, workspace);

  scratch.work_power = scratch.damper_power = scratch.storing_power = 0.0;
  for (const LoadEffect& effect : scratch.effects) {
    scratch.work_power += effect.work_power;
    scratch.damper_power += effect.damper_power;
    scratch.storing_power += effect.storing_power;
  }
}

double find_spring_energy(const Workspace& workspace) noexcept {
  double energy = 0.0;
  for (const LoadEffect& effect : workspace.loads.effects) energy += effect.stored_energy;
  return energy;
}

int find_lost_load(const Workspace& workspace) noexcept {
  const auto& effects = workspace.loads.effects;
  for (std::size_t k = 0; k < effects.size(); ++k) {
    const double sum = effects[k].force.x + effects[k].force.y + effects[k].torque;
    if (!std::isfinite(sum)) return static_cast<int>(k);
  }
  return -1;
}

}  // namespace gudgeon
