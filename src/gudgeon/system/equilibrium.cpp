// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Newton's method on the accelerations of the mechanism at rest, and damped motion where that does not lead on.
#include "gudgeon/system/equilibrium.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "gudgeon/base/diagnostics.h"
#include "gudgeon/system/body_motion.h"
#include "gudgeon/system/dynamics.h"
#include "gudgeon/system/equilibrium_modes.h"
#include "gudgeon/system/held_mechanism.h"
#include "gudgeon/system/load_forces.h"
#include "gudgeon/system/poses.h"

namespace gudgeon {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr int kMostNewtonSteps = 100;
// [rad, shares of the size] A step as small as this changes nothing that could be seen.
constexpr double kConverged = 1e-13;
// Loads balance when this share of what they could do is left: a million times rounding, and far below any error that
// could be seen in the position.
constexpr double kBalanced = 1e-9;
// A chart bends by then; a longer step is taken in parts.
constexpr double kLongestStep = 0.3;
// Central differences for Newton's matrix: truncation h² and rounding 1e-16/h, both at 1e-10.
constexpr double kSlopeStep = 1e-5;
constexpr int kRelaxationSteps = 4000;
// [rad, shares of the size] The first move of a mechanism that is let go, and the longest one: the chart bends little.
constexpr double kFirstMove = 0.02;
constexpr double kLongestMove = 0.1;
// [rad, shares of the size] A walk takes one turn in steps from which Newton's method reaches what lies between.
constexpr double kWalkStep = 0.3;
constexpr int kWalkSteps = 21;
// Less than this share of the direction along which a walk came is no way on.
constexpr double kStraightOn = 0.1;
// Positions [rad, shares of the size] and energies this near to each other are those of one equilibrium.
constexpr double kAlike = 1e-6;
// Damped motion has done its part when this share of the acceleration is left.
constexpr double kRelaxed = 1e-3;

bool has_neutral_mode(const Equilibrium& equilibrium) {
  return std::ranges::find(equilibrium.modes, EquilibriumMode::Kind::neutral, &EquilibriumMode::kind) !=
         equilibrium.modes.end();
}

bool are_alike(const std::vector<BodyPose>& one, const std::vector<BodyPose>& other, double size) {
  for (std::size_t b = 0; b < one.size(); ++b) {
    if (norm(one[b].position - other[b].position) > kAlike * size) return false;
    if (std::abs(std::remainder(one[b].angle - other[b].angle, 2.0 * std::numbers::pi)) > kAlike) return false;
  }
  return true;
}

class EquilibriumFinder {
 public:
  explicit EquilibriumFinder(const Mechanism& mechanism)
      : held_(hold_at_rest(mechanism)), assembly_(assemble(held_)), system_(compile(held_, assembly_)) {
    const std::vector<double> start = make_state(system_, assembly_).q;
    q_ = Eigen::Map<const VectorXd>(start.data(), static_cast<Index>(start.size()));
  }

  Equilibrium find() {
    if (!settle()) throw_not_found();
    return describe();
  }

  std::vector<Equilibrium> find_all() {
    const MotionChart start(system_, q_);
    const VectorXd q = q_;
    if (settle()) add_new();
    for (Index k = 0; k < start.size(); ++k) {
      for (const double sign : {1.0, -1.0}) walk(q, sign * start.basis().col(k));
    }
    if (found_.empty()) throw_not_found();
    std::ranges::stable_sort(found_, {}, &Equilibrium::potential_energy);
    return std::move(found_);
  }

 private:
  bool settle() { return improve() || (relax() && improve()); }

  // Goes on in a direction of x as far as the loops let it, and looks for an equilibrium from every place.
  void walk(VectorXd q, VectorXd direction) {
    for (int k = 0; k < kWalkSteps; ++k) {
      MotionChart chart(system_, q);
      VectorXd along = chart.basis().transpose() * direction;
      if (!(along.norm() > kStraightOn)) return;
      along.normalize();
      direction = chart.basis() * along;
      if (!chart.move_to(kWalkStep * along)) return;
      q = chart.q();
      q_ = q;
      iterations_ = 0;
      if (improve()) add_new();
    }
  }

  void add_new() {
    Equilibrium one = describe();
    const double size = find_longest_arm(held_);
    const bool known = std::ranges::any_of(found_, [&](const Equilibrium& other) {
      // The same but for whole turns, or two places of a rest that goes on and on.
      const double energy = std::max(std::abs(one.potential_energy), std::abs(other.potential_energy));
      const bool is_level = std::abs(one.potential_energy - other.potential_energy) <= kAlike * energy;
      return are_alike(one.poses, other.poses, size) || (is_level && has_neutral_mode(one) && has_neutral_mode(other));
    });
    if (!known) found_.push_back(std::move(one));
  }

  // Newton's method with steps that shrink until the acceleration does.
  bool improve() {
    bool balanced = false;
    for (int iteration = 0; iteration < kMostNewtonSteps; ++iteration, ++iterations_) {
      MotionChart chart(system_, q_);
      const Index n = chart.size();
      if (!chart.move_to(VectorXd::Zero(n))) return false;
      const VectorXd force = chart.find_acceleration(VectorXd::Zero(n));
      // Where nothing is free to move no acceleration shows it.
      lost_load_ = find_lost_load(chart.workspace());
      if (lost_load_ >= 0) return false;
      note_residual(chart, force);
      if (residual_ == 0.0) return true;
      if (!std::isfinite(residual_)) return false;
      const double level = find_level(chart.workspace());
      const MatrixXd slope = find_slope(chart);
      balanced = residual_ <= kBalanced * std::max(level, slope.cwiseAbs().maxCoeff());
      VectorXd step = Eigen::CompleteOrthogonalDecomposition<MatrixXd>(slope).solve(-force);
      const double length = step.cwiseAbs().maxCoeff();
      if (!std::isfinite(length)) return balanced;
      if (length > kLongestStep) step *= kLongestStep / length;
      if (!take_shrinking_step(chart, step, force.norm())) return balanced;
      if (balanced && length <= kConverged) return true;
    }
    return balanced;
  }

  // How the acceleration changes with the chart's numbers.
  static MatrixXd find_slope(MotionChart& chart) {
    const Index n = chart.size();
    MatrixXd slope(n, n);
    for (Index k = 0; k < n; ++k) {
      const VectorXd step = kSlopeStep * VectorXd::Unit(n, k);
      slope.col(k) = (find_force(chart, step) - find_force(chart, -step)) / (2.0 * kSlopeStep);
    }
    return slope;
  }

  // The acceleration [1/s^2, as in a chart] that all loads would give together, if each had its way.
  [[nodiscard]] double find_level(const Workspace& workspace) const {
    double mass = 0.0;
    for (const Body& body : held_.bodies) mass += body.mass;
    double force = mass * norm(held_.gravity);
    double torque = 0.0;
    for (const LoadEffect& effect : workspace.loads.effects) {
      force += norm(effect.force) + std::abs(effect.pull);
      torque += std::abs(effect.torque);
    }
    const double size = find_longest_arm(held_);
    return (force + torque / size) / (mass * size);
  }

  void note_residual(const MotionChart& chart, const VectorXd& force) {
    residual_ = force.size() == 0 ? 0.0 : force.cwiseAbs().maxCoeff();
    if (residual_ == 0.0) return;
    Index most = 0;
    const double fastest = chart.accelerations().cwiseAbs().maxCoeff(&most);
    const bool turns = most < system_.topology.counts.n_free_turns;
    restless_ = fmt::format("'{}' at rest would still accelerate with {:.4g} {}", name_coordinate(system_, most),
                            turns ? fastest : fastest * find_longest_arm(held_), turns ? "rad/s^2" : "m/s^2");
  }

  bool take_shrinking_step(MotionChart& chart, VectorXd step, double force) {
    for (int attempt = 0; attempt < 12; ++attempt, step *= 0.5) {
      if (!chart.move_to(step)) continue;
      if (!(chart.find_acceleration(VectorXd::Zero(step.size())).norm() < force)) continue;
      q_ = chart.q();
      return true;
    }
    return false;
  }

  static VectorXd find_force(MotionChart& chart, const VectorXd& y) {
    chart.move_to(y);
    return chart.find_acceleration(VectorXd::Zero(y.size()));
  }

  // Lets the mechanism move and stops it whenever it begins to lose speed: it then is at a peak of kinetic energy.
  bool relax() {
    double step = 0.0;
    double first = 0.0;
    VectorXd rate;  // of x, along the chart's basis
    for (int k = 0; k < kRelaxationSteps; ++k, ++iterations_) {
      MotionChart chart(system_, q_);
      const VectorXd force = find_force(chart, VectorXd::Zero(chart.size()));
      if (!force.allFinite() || force.size() == 0) return false;
      if (k == 0)
        first = force.norm(), step = std::sqrt(kFirstMove / first), rate = VectorXd::Zero(chart.basis().rows());
      if (force.norm() <= kRelaxed * first) return true;
      VectorXd along = chart.basis().transpose() * rate;
      if (along.dot(force) < 0.0) along.setZero();
      along += step * force;
      VectorXd move = step * along;
      const double longest = move.cwiseAbs().maxCoeff();
      if (longest > kLongestMove) move *= kLongestMove / longest;
      if (!chart.move_to(move)) return false;
      rate = chart.basis() * along;
      q_ = chart.q();
    }
    return true;
  }

  Equilibrium describe() {
    Equilibrium result;
    MotionChart chart(system_, q_);
    result.modes = find_modes(system_, chart);
    chart.move_to(VectorXd::Zero(chart.size()));
    const VectorXd force = chart.find_acceleration(VectorXd::Zero(chart.size()));
    result.residual = force.size() == 0 ? 0.0 : force.cwiseAbs().maxCoeff();
    const Workspace& workspace = chart.workspace();
    result.poses = find_poses(held_, system_.topology, workspace.coordinates);
    result.efforts.assign(held_.drivers.size(), 0.0);
    for (std::size_t d = 0; d < workspace.effort.size(); ++d) {
      result.efforts[system_.tables.driven[d].driver] = workspace.effort[d];
    }
    BodyMotionFinder motions(system_);
    motions.update(workspace);
    ReactionFinder reactions(system_);
    result.reactions = reactions.update(workspace, motions.motions());
    result.potential_energy = find_potential_energy(system_.tables, workspace);
    result.iterations = iterations_;
    result.mechanism = held_;
    return result;
  }

  [[noreturn]] void throw_not_found() {
    if (lost_load_ >= 0) {
      throw NumericalError(fmt::format(
          "E-NUM-011: no equilibrium was found: load '{}' has no finite value (a formula outside its range, a spring "
          "whose points meet); correct it, or give other start angles",
          held_.loads[lost_load_].name));
    }
    if (!std::isfinite(residual_)) {
      throw NumericalError(
          "E-NUM-011: no equilibrium was found: the mechanism got to a singular position; give other start angles");
    }
    throw NumericalError(fmt::format(
        "E-NUM-011: no equilibrium was found: {} steps from the start, {}; the loads balance in no position "
        "met: add what holds the mechanism (a spring, a stop, a driver), or give start angles nearer to "
        "where it may rest",
        iterations_, restless_));
  }

  Mechanism held_;
  Assembly assembly_;
  System system_;
  VectorXd q_;
  double residual_ = 0.0;
  int lost_load_ = -1;    // without a finite value where Newton's method was last; -1: none
  std::string restless_;  // what accelerates most, in words
  int iterations_ = 0;
  std::vector<Equilibrium> found_;
};

}  // namespace

Equilibrium find_equilibrium(const Mechanism& mechanism) { return EquilibriumFinder(mechanism).find(); }

std::vector<Equilibrium> find_equilibria(const Mechanism& mechanism) { return EquilibriumFinder(mechanism).find_all(); }

}  // namespace gudgeon
