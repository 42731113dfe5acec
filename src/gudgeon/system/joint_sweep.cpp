// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// What every body lacks to its acceleration is handed from the leaves of the tree to the frame.
#include "gudgeon/system/joint_sweep.h"

#include <algorithm>

namespace gudgeon {

JointSweep::JointSweep(const Mechanism& mechanism, const Topology& topology) : topology_(&topology) {
  const std::vector<Body>& bodies = mechanism.bodies;
  const auto anchored = [&](const JointEnd& end) {
    return Anchored{end.body, end.point - bodies[end.body].center_of_mass};
  };
  for (const auto& [first, second] : topology.ends) ends_.push_back({anchored(first), anchored(second)});
  for (std::size_t b = 0; b < bodies.size(); ++b) outward_.push_back(static_cast<int>(b));
  std::ranges::stable_sort(outward_, {}, [&](int body) { return topology.bodies[body].depth; });
  find_tie_steps(mechanism);
  force_needed_.resize(bodies.size());
  moment_needed_.resize(bodies.size());
  reactions_.resize(ends_.size());
  root_moments_.resize(topology.counts.n_turns());
}

// Walks every group of tied bodies outward from its root: the frame, the driven body, or the first of the group.
void JointSweep::find_tie_steps(const Mechanism& mechanism) {
  const Topology& topology = *topology_;
  std::vector<std::vector<int>> ties_at(mechanism.bodies.size());
  for (const AngleTie& tie : topology.angle_ties) {
    for (const int body : {ends_[tie.joint].first.body, ends_[tie.joint].second.body}) {
      ties_at[body].push_back(tie.joint);
    }
  }
  std::vector<bool> reached(mechanism.bodies.size(), false);
  std::vector<int> roots{0};
  for (int d = 0; d < topology.counts.n_driven_turns; ++d) {
    const Driver& driver = mechanism.drivers[topology.driven[d].driver];
    roots.push_back(find_body(mechanism, std::get<DrivenAngle>(driver.target).body));
  }
  for (std::size_t b = 0; b < mechanism.bodies.size(); ++b) roots.push_back(static_cast<int>(b));
  for (const int root : roots) {
    if (reached[root]) continue;
    std::vector<int> open{root};
    reached[root] = true;
    for (std::size_t k = 0; k < open.size(); ++k) {
      for (const int joint : ties_at[open[k]]) {
        const bool outer_is_second = ends_[joint].first.body == open[k];
        const int outer = outer_is_second ? ends_[joint].second.body : ends_[joint].first.body;
        if (reached[outer]) continue;
        reached[outer] = true;
        tie_steps_.push_back({joint, outer, open[k], outer_is_second});
        open.push_back(outer);
      }
    }
  }
  std::ranges::reverse(tie_steps_);
}

void JointSweep::begin(const std::vector<BodyMotion>& motions) noexcept {
  motions_ = &motions;
  std::ranges::fill(force_needed_, Vec2{});
  std::ranges::fill(moment_needed_, 0.0);
  std::ranges::fill(reactions_, JointReaction{});
}

void JointSweep::need(int body, Vec2 force, double moment) noexcept {
  force_needed_[body] += force;
  moment_needed_[body] += moment;
}

Vec2 JointSweep::find_place(const Anchored& anchored) const noexcept {
  return (*motions_)[anchored.body].position + turn(anchored.body, anchored.arm);
}

void JointSweep::add_force(int body, Vec2 at, Vec2 force) noexcept {
  force_needed_[body] -= force;
  moment_needed_[body] -= cross(at - (*motions_)[body].position, force);
}

void JointSweep::apply_joint_force(int joint, Vec2 force_on_second) noexcept {
  const auto& [first, second] = ends_[joint];
  const Vec2 at = find_place(second);
  add_force(second.body, at, force_on_second);
  add_force(first.body, at, -force_on_second);
  reactions_[joint].force += force_on_second;
}

void JointSweep::apply_joint_moment(int joint, double moment_on_second) noexcept {
  add_torque(ends_[joint].second.body, moment_on_second);
  add_torque(ends_[joint].first.body, -moment_on_second);
  reactions_[joint].moment += moment_on_second;
}

void JointSweep::add_reaction(int joint, Vec2 force, double moment) noexcept {
  reactions_[joint].force += force;
  reactions_[joint].moment += moment;
}

void JointSweep::finish() noexcept {
  sweep_tree();
  sweep_ties();
}

void JointSweep::sweep_tree() noexcept {
  for (std::size_t k = outward_.size(); k-- > 0;) {
    const int body = outward_[k];
    const int joint = topology_->bodies[body].joint;
    if (joint < 0) continue;
    const Vec2 needed = force_needed_[body];
    apply_joint_force(joint, ends_[joint].second.body == body ? needed : -needed);
  }
}

void JointSweep::sweep_ties() noexcept {
  for (const TieStep& step : tie_steps_) {
    const double moment = moment_needed_[step.outer];
    reactions_[step.joint].moment = step.outer_is_second ? moment : -moment;
    moment_needed_[step.outer] = 0.0;
    moment_needed_[step.inner] += moment;
  }
  std::ranges::fill(root_moments_, 0.0);
  for (std::size_t b = 0; b < moment_needed_.size(); ++b) {
    root_moments_[topology_->bodies[b].turn] += moment_needed_[b];
  }
}

}  // namespace gudgeon
