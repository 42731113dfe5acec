// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// One solve and one sweep for each action of friction, then Newton's method on a = A(ρ₀ + C a)
// (docs/theory/friction.md, Eqs. F11 to F15).
#include "gudgeon/system/friction_solver.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "gudgeon/system/dynamics.h"
#include "gudgeon/system/equations.h"

namespace gudgeon {

namespace {

using Eigen::Index;

// Of what the laws make of the reactions; the method is quadratic or exact, so that one more step leaves rounding.
constexpr double kSolved = 1e-12;
constexpr int kIterations = 30;
// A step that leaves a larger error is halved so often at most.
constexpr int kHalvings = 6;
// Where Newton's method fails, all friction grows from nothing in so many steps.
constexpr int kGrowth = 32;

Friction eval_friction(const FrictionJoint& joint, double speed, double bristle) noexcept {
  return std::visit([&](const auto& law) { return law(FrictionContact{speed, bristle}); }, joint.friction.law);
}

// r sin φ with tan φ = μ [m], of μ's sign: the radius of the friction circle (Eq. F11).
double find_circle(const FrictionJoint& joint, double coefficient) noexcept {
  return joint.friction.pin_radius * coefficient / std::sqrt(1.0 + coefficient * coefficient);
}

Index count_all_actions(const Tables& tables) {
  Index n = 0;
  for (const FrictionJoint& joint : tables.friction_joints) n += count_actions(joint.kind);
  return n;
}

}  // namespace

std::shared_ptr<FrictionSolver> make_friction_solver(const Tables& tables) {
  return tables.friction_joints.empty() ? nullptr : std::make_shared<FrictionSolver>(tables);
}

FrictionSolver::FrictionSolver(const Tables& tables)
    : bodies_(tables.friction_bodies),
      joints_(tables.friction_joints),
      motions_(bodies_->mechanism, bodies_->topology),
      sweep_(bodies_->mechanism, bodies_->topology, tables),
      at_rest_(tables.counts),
      slips_(joints_.size()),
      unit_(joints_.size()),
      response_(static_cast<std::size_t>(count_all_actions(tables)),
                std::vector<double>(static_cast<std::size_t>(tables.n_indices))),
      effort_(tables.driven.size()),
      loads_(tables.points.rows().size()) {
  const auto n_actions = static_cast<Index>(response_.size());
  const auto n_components = static_cast<Index>(2 * joints_.size());
  base_.setZero(n_components);
  components_.setZero(n_components);
  effect_.setZero(n_components, n_actions);
  for (Eigen::VectorXd* vector : {&action_, &trial_, &law_, &scale_, &step_}) vector->setZero(n_actions);
  gradient_.setZero(n_actions, 2);
  matrix_.setIdentity(n_actions, n_actions);
  inverse_ = matrix_;
  factors_.compute(matrix_);
}

void FrictionSolver::solve(const Tables& tables, Workspace& workspace) noexcept {
  workspace.friction_joint = -1;
  workspace.friction_margin = 1.0;
  std::ranges::fill(workspace.friction_forces, FrictionForces{});
  if (!find_slips(tables, workspace)) return write_forces(tables, workspace);
  find_base(tables, workspace);
  if (!base_.allFinite()) return;
  find_responses(tables, workspace);
  action_.setZero();
  eval_laws(1.0);
  action_ = law_;
  const bool solved = find_actions(1.0) || follow_actions();
  find_margin(workspace);
  if (!solved || !(workspace.friction_margin > 0.0)) {
    workspace.friction_margin = std::min(workspace.friction_margin, 0.0);
    std::fill_n(workspace.equations.begin(), tables.n_solve, std::numeric_limits<double>::quiet_NaN());
    std::ranges::fill(workspace.effort, std::numeric_limits<double>::quiet_NaN());
    return;
  }
  add_solution(tables, workspace);
  write_forces(tables, workspace);
}

// Whether any joint rubs.
bool FrictionSolver::find_slips(const Tables& tables, Workspace& ws) noexcept {
  const Coordinates& at = ws.coordinates;
  update_point_motions(tables, ws);
  bool any = false;
  for (std::size_t k = 0; k < joints_.size(); ++k) {
    const FrictionJoint& joint = joints_[k];
    Slip& slip = slips_[k];
    slip.turning = at.angle_rate[joint.second_turn] - at.angle_rate[joint.first_turn];
    double speed = joint.friction.pin_radius * slip.turning;
    double across = 0.0;
    if (joint.kind != FrictionKind::pin) {
      const auto& first = ws.point_motions[joint.first_row];
      const auto& second = ws.point_motions[joint.second_row];
      const Rotation line = make_rotation(at.angle[joint.first_turn] + joint.first_offset + joint.direction);
      slip.along = {line.c, line.s};
      const Vec2 carried = first.velocity + at.angle_rate[joint.first_turn] * perp(second.position - first.position);
      across = joint.kind == FrictionKind::slot ? speed : 0.0;
      speed = dot(second.velocity - carried, slip.along);
    }
    const double bristle = joint.bristle < 0 ? 0.0 : ws.bristles[joint.bristle];
    slip.speed = {speed + across, speed - across};
    for (const int wall : {0, 1}) {
      const Friction friction = eval_friction(joint, slip.speed[wall], bristle);
      slip.coefficient[wall] = friction.coefficient;
      slip.bristle_rate[wall] = friction.bristle_rate;
      any = any || friction.coefficient != 0.0;
    }
  }
  if (!any) {
    action_.setZero();
    components_.setZero();
  }
  return any;
}

FrictionSolver::Components FrictionSolver::find_components(std::size_t k,
                                                           const JointReaction& reaction) const noexcept {
  switch (joints_[k].kind) {
    case FrictionKind::pin:
      return {reaction.force.x, reaction.force.y};
    case FrictionKind::guide:
      return {dot(reaction.force, slips_[k].across()), reaction.moment};
    case FrictionKind::slot:
      break;
  }
  return {dot(reaction.force, slips_[k].across()), 0.0};
}

void FrictionSolver::find_base(const Tables& tables, Workspace& ws) noexcept {
  const std::vector<JointReaction>& reactions = sweep_.update(tables, ws, motions_.update(ws));
  for (std::size_t k = 0; k < joints_.size(); ++k) {
    const Components components = find_components(k, reactions[static_cast<std::size_t>(joints_[k].joint)]);
    base_(static_cast<Index>(2 * k)) = components[0];
    base_(static_cast<Index>(2 * k + 1)) = components[1];
  }
}

void FrictionSolver::find_responses(const Tables& tables, Workspace& ws) noexcept {
  std::ranges::copy(ws.coordinates.angle, at_rest_.angle.begin());
  std::ranges::copy(ws.coordinates.rotation, at_rest_.rotation.begin());
  std::ranges::copy(ws.coordinates.slide, at_rest_.slide.begin());
  for (std::size_t k = 0; k < joints_.size(); ++k) {
    for (int action = 0; action < count_actions(joints_[k].kind); ++action) find_response(tables, ws, k, action);
  }
}

// The pair of a joint from its actions: a torque, a force along the line, or both.
FrictionPair FrictionSolver::make_pair(std::size_t k, const double* action) const noexcept {
  switch (joints_[k].kind) {
    case FrictionKind::pin:
      return {{}, action[0]};
    case FrictionKind::guide:
      return {action[0] * slips_[k].along, 0.0};
    case FrictionKind::slot:
      break;
  }
  return {action[0] * slips_[k].along, action[1]};
}

// Virtual work of one pair, solved, swept to the reactions of all joints with friction.
void FrictionSolver::find_response(const Tables& tables, Workspace& ws, std::size_t k, int action) noexcept {
  const FrictionJoint& joint = joints_[k];
  const double one[2] = {action == 0 ? 1.0 : 0.0, action == 1 ? 1.0 : 0.0};
  const FrictionPair pair = make_pair(k, one);
  std::vector<double>& response = response_[static_cast<std::size_t>(joint.first_action + action)];
  std::ranges::fill(response, 0.0);
  double on_first = -pair.torque;
  if (joint.kind != FrictionKind::pin) {
    std::ranges::fill(loads_, Vec2{});
    loads_[joint.second_row] += pair.force;
    loads_[joint.first_row] -= pair.force;
    add_point_loads(tables, ws, loads_, response);
    const Vec2 arm = ws.point_motions[joint.second_row].position - ws.point_motions[joint.first_row].position;
    on_first -= cross(arm, pair.force);
  }
  response[static_cast<std::size_t>(joint.second_index)] += pair.torque;
  response[static_cast<std::size_t>(joint.first_index)] += on_first;
  tables.elimination.solve(ws.values.data(), ws.inverse_pivots.data(), response.data());
  find_efforts(tables, ws.values, response, effort_);
  unit_[k].pair = pair;
  const std::vector<JointReaction>& reactions =
      sweep_.update_response(tables, ws, unit_, response, effort_, motions_.update_response(at_rest_, response.data()));
  unit_[k].pair = {};
  for (std::size_t other = 0; other < joints_.size(); ++other) {
    const Components components = find_components(other, reactions[static_cast<std::size_t>(joints_[other].joint)]);
    effect_(static_cast<Index>(2 * other), joint.first_action + action) = components[0];
    effect_(static_cast<Index>(2 * other + 1), joint.first_action + action) = components[1];
  }
}

// A of one joint and its slopes, at the components of its reaction.
void FrictionSolver::eval_law(std::size_t k, double share) noexcept {
  const FrictionJoint& joint = joints_[k];
  const auto at = static_cast<Index>(2 * k);
  const double x = components_(at);
  const double y = components_(at + 1);
  const Index a = joint.first_action;
  const double coefficient = share * slips_[k].coefficient[joint.kind == FrictionKind::slot && x < 0.0 ? 1 : 0];
  switch (joint.kind) {
    case FrictionKind::pin: {
      const double circle = find_circle(joint, coefficient);
      const double force = std::hypot(x, y);
      law_(a) = -circle * force;
      gradient_(a, 0) = force > 0.0 ? -circle * x / force : 0.0;
      gradient_(a, 1) = force > 0.0 ? -circle * y / force : 0.0;
      return;
    }
    case FrictionKind::guide: {
      const double length = joint.friction.guide_length;
      const double lever = 0.5 * joint.friction.guide_height * coefficient;
      const double ends = length > 0.0 ? 2.0 / length * (y + lever * x) : 0.0;  // N1 − N2
      const bool tilts = std::abs(ends) > std::abs(x);
      const double sign = std::copysign(1.0, tilts ? ends : x);
      law_(a) = -coefficient * std::max(std::abs(x), std::abs(ends));
      gradient_(a, 0) = -coefficient * sign * (tilts ? 2.0 / length * lever : 1.0);
      gradient_(a, 1) = tilts ? -coefficient * sign * 2.0 / length : 0.0;
      return;
    }
    case FrictionKind::slot: {
      const double radius = joint.friction.pin_radius;
      law_(a) = -coefficient * std::abs(x);
      law_(a + 1) = -radius * coefficient * x;
      gradient_(a, 0) = x < 0.0 ? coefficient : -coefficient;
      gradient_(a + 1, 0) = -radius * coefficient;
      gradient_(a, 1) = gradient_(a + 1, 1) = 0.0;
      return;
    }
  }
}

// At components_ = ρ₀ + C a.
void FrictionSolver::eval_laws(double share) noexcept {
  components_ = base_;
  components_.noalias() += effect_ * action_;
  for (std::size_t k = 0; k < joints_.size(); ++k) eval_law(k, share);
  for (std::size_t k = 0; k < joints_.size(); ++k) {
    for (Index a = joints_[k].first_action; a < joints_[k].first_action + count_actions(joints_[k].kind); ++a) {
      scale_(a) = std::numeric_limits<double>::min();
      for (const Index c : {0, 1}) {
        const Index row = static_cast<Index>(2 * k) + c;
        double size = std::abs(base_(row));
        for (Index other = 0; other < action_.size(); ++other) size += std::abs(effect_(row, other) * action_(other));
        scale_(a) += std::abs(gradient_(a, c)) * size;
      }
    }
  }
}

double FrictionSolver::find_error() const noexcept {
  double error = 0.0;
  for (Index a = 0; a < action_.size(); ++a) {
    const double own = std::abs(law_(a) - action_(a)) / (scale_(a) + std::abs(action_(a)));
    if (!(own <= error)) error = own;
  }
  return error;
}

// I − A′ C at the laws' last slopes.
void FrictionSolver::factor() noexcept {
  for (std::size_t k = 0; k < joints_.size(); ++k) {
    for (Index a = joints_[k].first_action; a < joints_[k].first_action + count_actions(joints_[k].kind); ++a) {
      matrix_.row(a).noalias() = -gradient_(a, 0) * effect_.row(static_cast<Index>(2 * k));
      matrix_.row(a).noalias() -= gradient_(a, 1) * effect_.row(static_cast<Index>(2 * k + 1));
      matrix_(a, a) += 1.0;
    }
  }
  factors_.compute(matrix_);
}

// Newton's method from the actions that are there; the laws' corners are passed by shortened steps.
bool FrictionSolver::find_actions(double share) noexcept {
  eval_laws(share);
  double error = find_error();
  for (int iteration = 0; iteration < kIterations; ++iteration) {
    const bool solved = error <= kSolved;
    factor();
    trial_ = law_ - action_;
    step_.noalias() = factors_.solve(trial_);
    if (!step_.allFinite()) return false;
    trial_ = action_;
    double length = 1.0;
    for (int halving = 0; halving <= kHalvings; ++halving, length *= 0.5) {
      action_ = trial_ + length * step_;
      eval_laws(share);
      if (solved || find_error() < error) break;
    }
    error = find_error();
    if (solved) return true;
  }
  return false;
}

// All friction grows from nothing, and the solution with it.
bool FrictionSolver::follow_actions() noexcept {
  action_.setZero();
  for (int k = 1; k <= kGrowth; ++k) {
    if (!find_actions(static_cast<double>(k) / kGrowth)) return false;
  }
  return true;
}

// How much of det(I − A′ C) is left at least, when one joint's reaction takes another direction (Eq. F15): the piece of
// the laws at hand, and each of its neighbours.
void FrictionSolver::find_margin(Workspace& ws) noexcept {
  factor();
  const double determinant = factors_.determinant();
  if (determinant != 0.0) inverse_ = factors_.inverse();
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < joints_.size(); ++k) {
    const double own = determinant == 0.0 ? 0.0 : determinant * find_least_ratio(k);
    if (!(own >= least)) least = own, ws.friction_joint = joints_[k].joint;
  }
  ws.friction_margin = least < determinant ? least : determinant;
}

// The least of det/det(here) over the other directions and sides of one joint's reaction; the rows of its actions are
// replaced in the matrix.
double FrictionSolver::find_least_ratio(std::size_t k) const noexcept {
  const FrictionJoint& joint = joints_[k];
  const Index a = joint.first_action;
  const auto row = static_cast<Index>(2 * k);
  const auto effect_on = [&](Index component, Index action) {
    return effect_.row(row + component).dot(inverse_.col(action));
  };
  switch (joint.kind) {
    case FrictionKind::pin: {
      const double circle = find_circle(joint, slips_[k].coefficient[0]);
      return inverse_(a, a) - std::abs(circle) * std::hypot(effect_on(0, a), effect_on(1, a));
    }
    case FrictionKind::guide: {
      const double coefficient = slips_[k].coefficient[0];
      const double across = effect_on(0, a);
      double steepest = std::abs(across);
      if (joint.friction.guide_length > 0.0) {
        const double lever = 0.5 * joint.friction.guide_height * coefficient;
        steepest = std::max(steepest, 2.0 / joint.friction.guide_length * std::abs(effect_on(1, a) + lever * across));
      }
      return inverse_(a, a) - std::abs(coefficient) * steepest;
    }
    case FrictionKind::slot:
      break;
  }
  double least = std::numeric_limits<double>::infinity();
  for (const int wall : {0, 1}) {
    const double force = (wall == 0 ? -1.0 : 1.0) * slips_[k].coefficient[wall];
    const double torque = -joint.friction.pin_radius * slips_[k].coefficient[wall];
    const double ff = inverse_(a, a) - force * effect_on(0, a);
    const double ft = inverse_(a, a + 1) - force * effect_on(0, a + 1);
    const double tf = inverse_(a + 1, a) - torque * effect_on(0, a);
    const double tt = inverse_(a + 1, a + 1) - torque * effect_on(0, a + 1);
    least = std::min(least, ff * tt - ft * tf);
  }
  return least;
}

void FrictionSolver::add_solution(const Tables& tables, Workspace& ws) noexcept {
  for (std::size_t a = 0; a < response_.size(); ++a) {
    const double size = action_(static_cast<Index>(a));
    for (std::size_t i = 0; i < response_[a].size(); ++i) ws.equations[i] += size * response_[a][i];
  }
  find_efforts(tables, ws.values, ws.equations, ws.effort);
}

void FrictionSolver::write_forces(const Tables& tables, Workspace& ws) noexcept {
  for (std::size_t k = 0; k < joints_.size(); ++k) {
    const FrictionJoint& joint = tables.friction_joints[k];
    const double* action = action_.data() + joint.first_action;
    const int wall = joint.kind == FrictionKind::slot && components_(static_cast<Index>(2 * k)) < 0.0 ? 1 : 0;
    FrictionForces& forces = ws.friction_forces[k];
    forces.pair = make_pair(k, action);
    forces.slip_speed = slips_[k].speed[wall];
    forces.bristle_rate = slips_[k].bristle_rate[wall];
    forces.force = joint.kind == FrictionKind::pin ? action[0] / joint.friction.pin_radius : action[0];
    forces.power = -forces.force * forces.slip_speed;
  }
}

}  // namespace gudgeon
