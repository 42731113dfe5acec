// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Every load becomes forces and moments on single bodies; what they deliver is found from those alone.
#include "tests/oracle/textbook_loads.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "gudgeon/base/expression.h"
#include "gudgeon/model/channel_names.h"
#include "tests/oracle/textbook_curves.h"

namespace gudgeon::oracle {

namespace {

Eigen::Vector2d to_eigen(Vec2 a) { return {a.x, a.y}; }
Vec2 from_eigen(const Eigen::Vector2d& a) { return {a.x(), a.y()}; }

Eigen::Matrix2d turn(double angle) { return Eigen::Rotation2Dd(angle).toRotationMatrix(); }

class LoadWriter {
 public:
  LoadWriter(const Textbook& textbook, const TextbookState& state, double time)
      : textbook_(textbook), mechanism_(textbook.mechanism()), state_(state), time_(time) {}

  TextbookLoads write() {
    for (const Load& load : mechanism_.loads) {
      std::visit([&](const auto& kind) { add(kind); }, load.kind);
    }
    return std::move(loads_);
  }

 private:
  void add(const ConstantForce&) {}
  void add(const ConstantTorque&) {}

  void add(const VariableForce& load) {
    const TextbookPoint point = textbook_.eval_point(state_, load.point);
    const double angle = state_.bodies[find_body(mechanism_, load.axes)].angle;
    const Vec2 force = from_eigen(turn(angle) * Eigen::Vector2d(eval(load.x), eval(load.y)));
    act(point.body, point.position, force, 0.0);
    loads_.work_power += dot(force, point.velocity);
  }

  void add(const VariableTorque& load) {
    const int body = find_body(mechanism_, load.body);
    const int against = find_body(mechanism_, load.against);
    const double torque = eval(load.torque);
    act(body, {}, {}, torque);
    act(against, {}, {}, -torque);
    loads_.work_power += torque * state_.bodies[body].angle_rate - torque * state_.bodies[against].angle_rate;
  }

  // Along the line between the points, at the end of either.
  void add(const Spring& load) {
    const TextbookPoint first = textbook_.eval_point(state_, load.first);
    const TextbookPoint second = textbook_.eval_point(state_, load.second);
    const double x = second.position.x - first.position.x;
    const double y = second.position.y - first.position.y;
    const double length = std::hypot(x, y);
    const double rate =
        (x * (second.velocity.x - first.velocity.x) + y * (second.velocity.y - first.velocity.y)) / length;
    const double pull = load.stiffness * (length - load.free_length) + load.damping * rate;
    const double slope = std::atan2(y, x);
    const Vec2 toward_second{pull * std::cos(slope), pull * std::sin(slope)};
    act(first.body, first.position, toward_second, 0.0);
    act(second.body, second.position, -toward_second, 0.0);
    loads_.stored_energy += 0.5 * load.stiffness * std::pow(length - load.free_length, 2);
    loads_.damper_power += load.damping * rate * rate;
  }

  void add(const TorsionSpring& load) {
    add_twist(find_body(mechanism_, load.first), find_body(mechanism_, load.second), load.stiffness, load.damping,
              load.free_angle);
  }

  void add(const Bushing& load) {
    const TextbookPoint first = textbook_.eval_point(state_, load.first);
    const TextbookPoint second = textbook_.eval_point(state_, load.second);
    const TextbookBody& carrier = state_.bodies[first.body];
    const Eigen::Vector2d apart = to_eigen(second.position - first.position);
    const Eigen::Vector2d velocity = to_eigen(second.velocity - first.velocity);
    // d/dt of R(−θ) (r₂ − r₁)
    const Eigen::Vector2d r = turn(-carrier.angle) * apart;
    const Eigen::Matrix2d slope = turn(-carrier.angle - 0.5 * std::numbers::pi);  // of R(−θ), by θ
    const Eigen::Vector2d rate = turn(-carrier.angle) * velocity + carrier.angle_rate * (slope * apart);
    const Eigen::Vector2d k = to_eigen(load.stiffness);
    const Eigen::Vector2d d = to_eigen(load.damping);
    const Eigen::Vector2d local = -k.cwiseProduct(r) - d.cwiseProduct(rate);
    const Vec2 force = from_eigen(turn(carrier.angle) * local);
    act(second.body, second.position, force, 0.0);
    act(first.body, second.position, -force, 0.0);
    loads_.stored_energy += 0.5 * r.dot(k.cwiseProduct(r));
    loads_.damper_power += rate.dot(d.cwiseProduct(rate));
    add_twist(first.body, second.body, load.angular_stiffness, load.angular_damping, load.free_angle);
  }

  void add_twist(int first, int second, double stiffness, double damping, double free_angle) {
    const double twist = state_.bodies[second].angle - state_.bodies[first].angle - free_angle;
    const double rate = state_.bodies[second].angle_rate - state_.bodies[first].angle_rate;
    act(first, {}, {}, stiffness * twist + damping * rate);
    act(second, {}, {}, -stiffness * twist - damping * rate);
    loads_.stored_energy += 0.5 * stiffness * twist * twist;
    loads_.damper_power += damping * rate * rate;
  }

  void act(int body, Vec2 at, Vec2 force, double moment) { loads_.actions.push_back({body, at, force, moment}); }

  [[nodiscard]] double eval(const Function& function) const {
    if (const auto* constant = std::get_if<double>(&function)) return *constant;
    const std::vector<StateChannel> channels = list_state_channels(mechanism_);
    std::vector<std::string> names;
    std::vector<double> values;
    for (const StateChannel& channel : channels) {
      names.push_back(channel.name);
      values.push_back(eval_channel(channel));
    }
    if (const auto* expression = std::get_if<Expression>(&function)) {
      return ExpressionEvaluator(expression->text, expression->constants, names).eval(values.data());
    }
    const auto& curve = std::get<SampledCurve>(function);
    const auto at = std::ranges::find(names, curve.over) - names.begin();
    return TextbookCurve::of_load(curve).eval(values.at(at)).value;
  }

  [[nodiscard]] double eval_channel(const StateChannel& channel) const {
    using Quantity = StateChannel::Quantity;
    if (channel.quantity == Quantity::time) return time_;
    if (channel.joint >= 0) return eval_slide(channel);
    const TextbookBody& body = state_.bodies.at(channel.body);
    if (channel.quantity == Quantity::angle) return body.angle;
    if (channel.quantity == Quantity::angle_rate) return body.angle_rate;
    const Vec2 arm = make_rotation(body.angle) * (channel.local - mechanism_.bodies[channel.body].center_of_mass);
    const Vec2 position = body.center + arm;
    const Vec2 velocity = body.velocity + body.angle_rate * perp(arm);
    if (channel.quantity == Quantity::x) return position.x;
    if (channel.quantity == Quantity::y) return position.y;
    return channel.quantity == Quantity::x_velocity ? velocity.x : velocity.y;
  }

  // e·(r₂ − r₁) and its rate, e turning with the first body.
  [[nodiscard]] double eval_slide(const StateChannel& channel) const {
    const auto& slide = std::get<Prismatic>(mechanism_.joints.at(channel.joint).kind);
    const TextbookPoint first = textbook_.eval_point(state_, slide.first);
    const TextbookPoint second = textbook_.eval_point(state_, slide.second);
    const double angle = state_.bodies[first.body].angle + slide.direction;
    const Vec2 e{std::cos(angle), std::sin(angle)};
    if (channel.quantity == StateChannel::Quantity::displacement) return dot(e, second.position - first.position);
    return dot(e, second.velocity - first.velocity) +
           state_.bodies[first.body].angle_rate * dot(perp(e), second.position - first.position);
  }

  const Textbook& textbook_;
  const Mechanism& mechanism_;
  const TextbookState& state_;
  double time_;
  TextbookLoads loads_;
};

}  // namespace

TextbookLoads find_loads(const Textbook& textbook, const TextbookState& state, double time) {
  return LoadWriter(textbook, state, time).write();
}

}  // namespace gudgeon::oracle
