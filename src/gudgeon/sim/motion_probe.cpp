// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Illinois' method for zeros, golden section for extremes.
#include "gudgeon/sim/motion_probe.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gudgeon {

MotionProbe::MotionProbe(KinematicSolver& solver, int driver)
    : solver_(&solver), driver_(driver), motion_(solver.system()) {
  update();
}

std::vector<MotionProbe::Coordinate> MotionProbe::list_coordinates() const {
  const System& system = solver_->system();
  std::vector<Coordinate> coordinates;
  std::vector<bool> seen(system.topology.counts.n_turns(), false);
  for (std::size_t b = 1; b < system.mechanism.bodies.size(); ++b) {
    const int turn = system.topology.bodies[b].turn;
    if (turn >= system.topology.counts.n_free_turns || seen[turn]) continue;
    seen[turn] = true;
    coordinates.push_back({static_cast<int>(b), -1});
  }
  for (std::size_t j = 0; j < system.mechanism.joints.size(); ++j) {
    const bool is_driven = system.topology.joint_slide[j] >= system.topology.counts.n_free_slides;
    if (has_line(system.mechanism.joints[j].kind) && !is_driven) coordinates.push_back({-1, static_cast<int>(j)});
  }
  return coordinates;
}

double MotionProbe::find_value(Coordinate coordinate) const {
  return coordinate.body >= 0 ? motion_.motions()[coordinate.body].angle : find_slide(coordinate.joint).displacement;
}

double MotionProbe::find_rate(Coordinate coordinate) const {
  return coordinate.body >= 0 ? motion_.motions()[coordinate.body].angle_rate : find_slide(coordinate.joint).speed;
}

SlideMotion MotionProbe::find_slide(int joint) const {
  const Mechanism& mechanism = solver_->system().mechanism;
  return find_slide_motion(mechanism, mechanism.joints[joint], motion_.motions());
}

double MotionProbe::find_driver_value(int driver) const {
  if (driver < 0) return 0.0;
  const Mechanism& mechanism = solver_->system().mechanism;
  if (const auto* angle = std::get_if<DrivenAngle>(&mechanism.drivers[driver].target)) {
    return motion_.motions()[find_body(mechanism, angle->body)].angle -
           motion_.motions()[find_body(mechanism, angle->against)].angle;
  }
  return find_slide(find_joint(mechanism, std::get<DrivenSlide>(mechanism.drivers[driver].target).joint)).displacement;
}

// μ = atan2(|a × b|, −a·b) of two links, α = atan2(|a·b|, |a × b|) with a guide (docs/theory/kinematics.md, Eq. K3)
double MotionProbe::find_transmission(const LoopFold& fold) const {
  const FoldAngle angle = solver_->folds().find_angle(fold, solver_->workspace().coordinates);
  if (solver_->folds().has_guide(fold)) return std::atan2(std::abs(angle.cosine), std::abs(angle.sine));
  return std::atan2(std::abs(angle.sine), -angle.cosine);
}

double MotionProbe::find_fold(const LoopFold& fold) const {
  return solver_->folds().find_angle(fold, solver_->workspace().coordinates).sine;
}

DriverTime MotionProbe::find_time() const { return {solver_->point().time, find_driver_value(driver_)}; }

bool MotionProbe::move_to(const MotionPoint& from, double time) {
  solver_->return_to(from);
  const bool arrived = solver_->move_to(time);
  update();
  return arrived;
}

bool MotionProbe::move_to_zero(const Quantity& quantity, const MotionPoint& low, double high) {
  double left = low.time;
  double right = high;
  if (!move_to(low, high)) return false;
  double right_value = quantity();
  if (!move_to(low, left)) return false;
  double left_value = quantity();
  bool was_right = false;
  // Each pass gains digits as a secant does; a hundred would reach the last bit even by halving.
  for (int pass = 0; pass < 100 && left_value != right_value; ++pass) {
    const double middle = right - right_value * (right - left) / (right_value - left_value);
    if (!(middle > left && middle < right)) break;  // rounding: the bracket is as narrow as it gets
    if (!move_to(low, middle)) return false;
    const double value = quantity();
    if (value == 0.0) return true;
    const bool is_right = (value > 0.0) == (right_value > 0.0);
    (is_right ? right : left) = middle;
    (is_right ? right_value : left_value) = value;
    if (pass > 0 && is_right == was_right) (is_right ? left_value : right_value) *= 0.5;
    was_right = is_right;
    // Four units in the last place of the longest time met.
    if (right - left <= 1e-15 * std::max(std::abs(left), std::abs(right))) return true;
  }
  return true;
}

bool MotionProbe::move_to_least_transmission(const LoopFold& fold, double sign, const MotionPoint& low, double high) {
  constexpr double kGolden = std::numbers::phi - 1.0;
  double left = low.time;
  double right = high;
  const auto eval = [&](double time) { return move_to(low, time) ? sign * find_transmission(fold) : NAN; };
  double inner_left = right - kGolden * (right - left);
  double inner_right = left + kGolden * (right - left);
  double left_value = eval(inner_left);
  double right_value = eval(inner_right);
  // A smooth extreme is flat to the root of rounding: 1e-8 of the bracket is all that can be told.
  while (right - left > 1e-9 * (high - low.time)) {
    if (left_value <= right_value) {
      right = inner_right, inner_right = inner_left, right_value = left_value;
      inner_left = right - kGolden * (right - left);
      left_value = eval(inner_left);
    } else {
      left = inner_left, inner_left = inner_right, left_value = right_value;
      inner_right = left + kGolden * (right - left);
      right_value = eval(inner_right);
    }
  }
  return move_to(low, 0.5 * (left + right));
}

}  // namespace gudgeon
