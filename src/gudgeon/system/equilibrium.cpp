// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Newton's method on the accelerations of the mechanism at rest, and damped motion where that does not lead on.
#include "gudgeon/system/equilibrium.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "gudgeon/base/diagnostics.h"
#include "gudgeon/system/body_motion.h"
#include "gudgeon/system/dynamics.h"
#include "gudgeon/system/equilibrium_modes.h"
#include "gudgeon/system/poses.h"
#include "gudgeon/system/slide_motion.h"

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
// Damped motion has done its part when this share of the acceleration is left.
constexpr double kRelaxed = 1e-3;

/// Ideal joints, no start rates, every driver held where it is at t = 0.
Mechanism hold_at_rest(const Mechanism& mechanism) {
  Mechanism held = make_ideal(mechanism);
  const std::vector<BodyPose> poses = assemble(held).poses;
  std::vector<BodyMotion> motions;
  for (std::size_t b = 0; b < poses.size(); ++b) {
    BodyMotion motion;
    motion.position = poses[b].find_point(held.bodies[b].center_of_mass);
    motion.angle = poses[b].angle;
    motions.push_back(motion);
  }
  for (Driver& driver : held.drivers) {
    if (const auto* angle = std::get_if<DrivenAngle>(&driver.target)) {
      driver.start = poses[find_body(held, angle->body)].angle - poses[find_body(held, angle->against)].angle;
    } else {
      const int joint = find_joint(held, std::get<DrivenSlide>(driver.target).joint);
      driver.start = find_slide_motion(held, held.joints[joint], motions).displacement;
    }
    driver.speed = 0.0;
    driver.motion = std::monostate{};
  }
  for (Body& body : held.bodies) body.start.angle_rate.reset(), body.start.velocity.reset();
  for (Joint& joint : held.joints) {
    if (auto* slide = std::get_if<Prismatic>(&joint.kind)) slide->start_speed.reset();
  }
  return held;
}

class EquilibriumFinder {
 public:
  explicit EquilibriumFinder(const Mechanism& mechanism)
      : held_(hold_at_rest(mechanism)), assembly_(assemble(held_)), system_(compile(held_, assembly_)) {
    const std::vector<double> start = make_state(system_, assembly_).q;
    q_ = Eigen::Map<const VectorXd>(start.data(), static_cast<Index>(start.size()));
  }

  Equilibrium find() {
    bool found = improve();
    if (!found && relax()) found = improve();
    if (!found) throw_not_found();
    return describe();
  }

 private:
  // Newton's method with steps that shrink until the acceleration does.
  bool improve() {
    bool balanced = false;
    for (int iteration = 0; iteration < kMostNewtonSteps; ++iteration, ++iterations_) {
      MotionChart chart(system_, q_);
      const Index n = chart.size();
      if (!chart.move_to(VectorXd::Zero(n))) return false;
      const VectorXd force = chart.find_acceleration(VectorXd::Zero(n));
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
      if (k == 0) first = force.norm(), step = std::sqrt(0.02 / first), rate = VectorXd::Zero(chart.basis().rows());
      if (force.norm() <= kRelaxed * first) return true;
      VectorXd along = chart.basis().transpose() * rate;
      if (along.dot(force) < 0.0) along.setZero();
      along += step * force;
      VectorXd move = step * along;
      const double longest = move.cwiseAbs().maxCoeff();
      if (longest > 0.1) move *= 0.1 / longest;
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
    if (!std::isfinite(residual_)) {
      throw NumericalError(
          "E-NUM-011: no equilibrium was found: the mechanism got to a singular position, or a load has no finite "
          "value; give other start angles");
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
  std::string restless_;  // what accelerates most, in words
  int iterations_ = 0;
};

}  // namespace

Equilibrium find_equilibrium(const Mechanism& mechanism) { return EquilibriumFinder(mechanism).find(); }

}  // namespace gudgeon
