// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// The constraint rows of joints and drivers, with their Jacobian and acceleration terms.
#include "tests/oracle/driver_motion.h"
#include "tests/oracle/textbook.h"

namespace gudgeon::oracle {

namespace {

using Point2 = TextbookPoint;

/// Writes constraint rows one below the other.
class RowWriter {
 public:
  RowWriter(TextbookRows& rows, const TextbookState& state) : rows_(rows), state_(state) {}

  /// Φ = r₂ − r₁
  void add_coincidence(const Point2& first, const Point2& second) {
    add_offset(first, second, {1.0, 0.0}, 0.0, {});
    add_offset(first, second, {0.0, 1.0}, 0.0, {});
  }

  /// Φ = e·(r₂ − r₁) − value, where e turns with the first body
  void add_slide(const Point2& first, const Point2& second, Vec2 e, const TextbookMotion& value) {
    add_offset(first, second, e, 1.0, value);
  }

  /// Φ = θ₂ − θ₁ − value
  void add_angle(int first, int second, const TextbookMotion& value) {
    rows_.residual(row_) = state_.bodies[second].angle - state_.bodies[first].angle - value.value;
    rows_.jacobian(row_, 3 * second + 2) += 1.0;
    rows_.jacobian(row_, 3 * first + 2) -= 1.0;
    rows_.time_rate(row_) = -value.rate;
    rows_.gamma(row_) = value.acceleration;
    ++row_;
  }

 private:
  /// Φ = e·D − value with D = r₂ − r₁ and ė = turns θ̇₁ perp(e), turns being 0 or 1
  void add_offset(const Point2& first, const Point2& second, Vec2 e, double turns, const TextbookMotion& value) {
    const double rate_1 = state_.bodies[first.body].angle_rate;
    const double rate_2 = state_.bodies[second.body].angle_rate;
    const Vec2 offset = second.position - first.position;
    const Vec2 offset_rate = second.velocity - first.velocity;

    rows_.residual(row_) = dot(e, offset) - value.value;
    rows_.time_rate(row_) = -value.rate;
    add_point_columns(second, e, 1.0);
    add_point_columns(first, e, -1.0);
    rows_.jacobian(row_, 3 * first.body + 2) += turns * dot(perp(e), offset);

    // what Φ̈ holds besides Φq q̈: centripetal parts of D̈, 2 ė·Ḋ, and −θ̇₁² e·D of ë·D
    const Vec2 centripetal = rate_1 * rate_1 * first.arm - rate_2 * rate_2 * second.arm;
    const double turning = 2.0 * rate_1 * dot(perp(e), offset_rate) - rate_1 * rate_1 * dot(e, offset);
    rows_.gamma(row_) = value.acceleration - dot(e, centripetal) - turns * turning;
    ++row_;
  }

  void add_point_columns(const Point2& point, Vec2 e, double sign) {
    rows_.jacobian(row_, 3 * point.body) += sign * e.x;
    rows_.jacobian(row_, 3 * point.body + 1) += sign * e.y;
    rows_.jacobian(row_, 3 * point.body + 2) += sign * dot(e, perp(point.arm));
  }

  TextbookRows& rows_;
  const TextbookState& state_;
  int row_ = 0;
};

/// The line of a prismatic joint or a slot as a unit vector in the frame's axes.
template <class Kind>
Vec2 find_line(const Kind& joint, const TextbookState& state, int first_body) {
  const double angle = state.bodies[first_body].angle + joint.direction;
  return {std::cos(angle), std::sin(angle)};
}

void add_joint_rows(RowWriter& writer, const Textbook& textbook, const TextbookState& state, const AnyJoint& joint) {
  if (n_rows(joint) == 0) return;
  const Point2 first = textbook.eval_point(state, anchors(joint).first);
  const Point2 second = textbook.eval_point(state, anchors(joint).second);
  if (const auto* slide = std::get_if<Prismatic>(&joint)) {
    writer.add_slide(first, second, perp(find_line(*slide, state, first.body)), {});
    writer.add_angle(first.body, second.body, {slide->relative_angle});
    return;
  }
  if (const auto* slot = std::get_if<PinInSlot>(&joint)) {
    return writer.add_slide(first, second, perp(find_line(*slot, state, first.body)), {});
  }
  writer.add_coincidence(first, second);
  if (const auto* rigid = std::get_if<Rigid>(&joint)) {
    writer.add_angle(first.body, second.body, {rigid->relative_angle});
  }
}

void add_driver_row(RowWriter& writer, const Textbook& textbook, const TextbookState& state, const Driver& driver,
                    double time) {
  const Mechanism& mechanism = textbook.mechanism();
  const TextbookMotion value = eval_motion(driver, time);
  if (const auto* angle = std::get_if<DrivenAngle>(&driver.target)) {
    writer.add_angle(find_body(mechanism, angle->against), find_body(mechanism, angle->body), value);
    return;
  }
  const int joint = find_joint(mechanism, std::get<DrivenSlide>(driver.target).joint);
  const auto& slide = std::get<Prismatic>(mechanism.joints.at(joint).kind);
  const Point2 first = textbook.eval_point(state, slide.first);
  const Point2 second = textbook.eval_point(state, slide.second);
  writer.add_slide(first, second, find_line(slide, state, first.body), value);
}

}  // namespace

int n_rows(const AnyJoint& joint) {
  if (has_clearance(joint)) return 0;
  if (std::holds_alternative<PinInSlot>(joint)) return 1;
  return std::holds_alternative<Rigid>(joint) ? 3 : 2;
}

TextbookRows Textbook::eval_rows(const TextbookState& state, double time) const {
  int n = static_cast<int>(mechanism_.drivers.size());
  for (const Joint& joint : mechanism_.joints) n += n_rows(joint.kind);
  const int n_columns = 3 * static_cast<int>(mechanism_.bodies.size());
  const Eigen::VectorXd zero = Eigen::VectorXd::Zero(n);
  TextbookRows rows{zero, zero, zero, zero, Eigen::MatrixXd::Zero(n, n_columns)};

  RowWriter writer(rows, state);
  for (const Joint& joint : mechanism_.joints) add_joint_rows(writer, *this, state, joint.kind);
  for (const Driver& driver : mechanism_.drivers) add_driver_row(writer, *this, state, driver, time);

  Eigen::VectorXd rates(n_columns);
  for (int body = 0; 3 * body < n_columns; ++body) {
    const TextbookBody& motion = state.bodies[body];
    rates.segment<3>(3 * body) << motion.velocity.x, motion.velocity.y, motion.angle_rate;
  }
  rows.rate = rows.jacobian * rates + rows.time_rate;
  return rows;
}

}  // namespace gudgeon::oracle
