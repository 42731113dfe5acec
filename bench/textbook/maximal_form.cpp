// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// One evaluation of the textbook form.
#include "bench/textbook/maximal_form.h"

#include <algorithm>

namespace gudgeon::textbook {

void MaximalForm::eval(double t, const double* y, double* slope) {
  move_bodies(y);
  std::ranges::copy(constant_load_, solver_.right.data());
  cursor_ = 0;
  int row = static_cast<int>(n_coordinates());
  for (const Constraint& constraint : constraints_) {
    switch (constraint.kind) {
      case Constraint::Kind::point:
        write_point(constraint, row);
        break;
      case Constraint::Kind::line:
        write_line(constraint, t, row);
        break;
      case Constraint::Kind::angle:
        write_angle(constraint, t, row);
        break;
    }
    row += constraint.kind == Constraint::Kind::point ? 2 : 1;
  }
  add_forces(y + 2 * n_coordinates());
  solver_.solve();

  const std::size_t n = n_coordinates();
  std::copy_n(y + n, n, slope);
  std::copy_n(solver_.solution.data(), n, slope + n);
  double power = 0.0;
  for (std::size_t k = 0; k < pairs_.size(); ++k) {
    const ContactForces& forces = contact_forces[k];
    if (pairs_[k].contact.bristle >= 0) slope[2 * n + pairs_[k].contact.bristle] = forces.bristle_rate;
    power -= forces.damping_power + forces.friction_power;
  }
  // ∂Φ/∂value = −1, so −λ is the effort along the driven value.
  for (std::size_t k = 0; k < driver_rows_.size(); ++k) power -= solver_.solution[driver_rows_[k]] * driver_speeds_[k];
  slope[n_states()] = power;
}

void MaximalForm::find_gaps(double /*t*/, const double* y, std::span<GapSample> gaps) {
  move_bodies(y);
  for (std::size_t k = 0; k < pairs_.size(); ++k) {
    const ContactGap gap = find_gap(pairs_[k].contact.surfaces, find_relative_motion(pairs_[k]));
    gaps[k] = {gap.penetration, gap.penetration_rate};
  }
}

double MaximalForm::find_energy(double /*t*/, const double* y) {
  move_bodies(y);
  double energy = 0.0;
  for (int body = 1; body <= n_bodies_; ++body) {
    const Body& description = mechanism_.bodies[body];
    energy += 0.5 * description.mass * dot(velocity_[body], velocity_[body]) +
              0.5 * description.inertia * angle_rate_[body] * angle_rate_[body] -
              description.mass * dot(mechanism_.gravity, center_[body]);
  }
  for (const PointForce& force : forces_) energy -= dot(force.force, find_point(force.point).position);
  for (const Load& load : mechanism_.loads) {
    const auto* torque = std::get_if<ConstantTorque>(&load.kind);
    if (torque != nullptr) energy -= torque->torque * angle_[find_body(mechanism_, torque->body)];
  }
  for (std::size_t k = 0; k < pairs_.size(); ++k) {
    const ContactPair& pair = pairs_[k];
    const double bristle = pair.contact.bristle >= 0 ? y[2 * n_coordinates() + pair.contact.bristle] : 0.0;
    energy += find_contact_forces(pair.contact, find_relative_motion(pair), contact_modes[k], bristle).elastic_energy;
  }
  return energy;
}

void MaximalForm::move_bodies(const double* y) {
  const double* v = y + n_coordinates();
  for (int body = 1; body <= n_bodies_; ++body, y += 3, v += 3) {
    center_[body] = {y[0], y[1]};
    velocity_[body] = {v[0], v[1]};
    angle_[body] = y[2];
    angle_rate_[body] = v[2];
    rotation_[body] = make_rotation(y[2]);
  }
}

MaximalForm::PointMotion MaximalForm::find_point(const BodyPoint& point) const {
  const Vec2 arm = rotation_[point.body] * point.arm;
  return {arm, center_[point.body] + arm, velocity_[point.body] + angle_rate_[point.body] * perp(arm)};
}

RelativeMotion MaximalForm::find_relative_motion(const ContactPair& pair) const {
  const PointMotion bearing = find_point(pair.bearing);
  const PointMotion journal = find_point(pair.journal);
  return {journal.position - bearing.position, journal.velocity - bearing.velocity, angle_[pair.bearing.body],
          angle_[pair.journal.body],           angle_rate_[pair.bearing.body],      angle_rate_[pair.journal.body]};
}

void MaximalForm::put(double value) { solver_.set(cursor_++, value); }

// Of the columns only those of the angles change.
void MaximalForm::write_point(const Constraint& constraint, int row) {
  const PointMotion first = find_point(constraint.first);
  const PointMotion second = find_point(constraint.second);
  const double rate_1 = angle_rate_[constraint.first.body];
  const double rate_2 = angle_rate_[constraint.second.body];
  put(-second.arm.y);
  put(second.arm.x);
  put(first.arm.y);
  put(-first.arm.x);
  const Vec2 gamma = rate_2 * rate_2 * second.arm - rate_1 * rate_1 * first.arm -
                     2.0 * feedback_.alpha * (second.velocity - first.velocity) -
                     feedback_.beta * feedback_.beta * (second.position - first.position);
  solver_.right[row] = gamma.x;
  solver_.right[row + 1] = gamma.y;
}

void MaximalForm::write_line(const Constraint& constraint, double t, int row) {
  const PointMotion first = find_point(constraint.first);
  const PointMotion second = find_point(constraint.second);
  const double rate_1 = angle_rate_[constraint.first.body];
  const double rate_2 = angle_rate_[constraint.second.body];
  const Vec2 e =
      rotation_[constraint.first.body] * Vec2{std::cos(constraint.direction), std::sin(constraint.direction)};
  const Vec2 offset = second.position - first.position;
  const Vec2 offset_rate = second.velocity - first.velocity;
  put(e.x);
  put(e.y);
  put(dot(e, perp(second.arm)));
  put(-e.x);
  put(-e.y);
  put(dot(perp(e), offset) - dot(e, perp(first.arm)));
  const Vec2 centripetal = rate_1 * rate_1 * first.arm - rate_2 * rate_2 * second.arm;
  const double gap = dot(e, offset) - constraint.start - constraint.speed * t;
  const double gap_rate = dot(e, offset_rate) + rate_1 * dot(perp(e), offset) - constraint.speed;
  solver_.right[row] = rate_1 * rate_1 * dot(e, offset) - dot(e, centripetal) -
                       2.0 * rate_1 * dot(perp(e), offset_rate) - 2.0 * feedback_.alpha * gap_rate -
                       feedback_.beta * feedback_.beta * gap;
}

void MaximalForm::write_angle(const Constraint& constraint, double t, int row) {
  const double gap =
      angle_[constraint.second.body] - angle_[constraint.first.body] - constraint.start - constraint.speed * t;
  const double gap_rate = angle_rate_[constraint.second.body] - angle_rate_[constraint.first.body] - constraint.speed;
  solver_.right[row] = -2.0 * feedback_.alpha * gap_rate - feedback_.beta * feedback_.beta * gap;
}

void MaximalForm::push(int body, Vec2 arm, Vec2 force, double torque) {
  if (body == 0) return;
  double* right = solver_.right.data() + 3 * (body - 1);
  right[0] += force.x;
  right[1] += force.y;
  right[2] += cross(arm, force) + torque;
}

void MaximalForm::add_forces(const double* bristles) {
  for (const PointForce& force : forces_) {
    push(force.point.body, rotation_[force.point.body] * force.point.arm, force.force, 0.0);
  }
  for (std::size_t k = 0; k < pairs_.size(); ++k) {
    const ContactPair& pair = pairs_[k];
    const double bristle = pair.contact.bristle >= 0 ? bristles[pair.contact.bristle] : 0.0;
    const ContactForces forces =
        find_contact_forces(pair.contact, find_relative_motion(pair), contact_modes[k], bristle);
    push(pair.journal.body, rotation_[pair.journal.body] * pair.journal.arm, forces.force_on_journal,
         forces.torque_on_journal);
    push(pair.bearing.body, rotation_[pair.bearing.body] * pair.bearing.arm, -forces.force_on_journal,
         forces.torque_on_bearing);
    contact_forces[k] = forces;
  }
}

}  // namespace gudgeon::textbook
