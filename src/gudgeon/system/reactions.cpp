// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// What every body lacks to its acceleration is handed from the leaves of the tree to the frame.
#include "gudgeon/system/reactions.h"

#include <algorithm>

namespace gudgeon {

ReactionFinder::ReactionFinder(const System& system) : system_(&system) {
  const Mechanism& mechanism = system.mechanism;
  const auto anchored = [&](const Anchor& anchor) {
    const int body = find_body(mechanism, anchor.body);
    const Body& description = mechanism.bodies[body];
    return Anchored{body, find_point(description, anchor.point)->position - description.center_of_mass};
  };
  for (const Joint& joint : mechanism.joints) {
    const auto [first, second] = anchors(joint.kind);
    ends_.push_back({anchored(first), anchored(second)});
  }
  const auto find_index = [&](const std::string& name) { return find_body(mechanism, name); };
  for (const Contact& contact : system.tables.contacts) {
    const int body = ends_[contact.joint].second.body;
    contact_points_.push_back({body, contact.journal_center - mechanism.bodies[body].center_of_mass});
  }
  for (const Load& load : mechanism.loads) {
    load_ends_.push_back(std::visit(
        [&]<class Kind>(const Kind& kind) -> LoadEnds {
          if constexpr (requires { kind.point; }) {
            return {-1, anchored(kind.point)};
          } else if constexpr (requires { kind.against; }) {
            return {find_index(kind.against), {find_index(kind.body), {}}};
          } else if constexpr (requires { kind.body; }) {
            return {-1, {find_index(kind.body), {}}};
          } else if constexpr (requires { kind.first.body; }) {
            return {find_index(kind.first.body), anchored(kind.second)};
          } else {
            return {find_index(kind.first), {find_index(kind.second), {}}};
          }
        },
        load.kind));
  }
  for (const DrivenMotion& motion : system.topology.driven) {
    const auto* angle = std::get_if<DrivenAngle>(&mechanism.drivers[motion.driver].target);
    driven_angles_.push_back(angle == nullptr
                                 ? std::array{-1, -1}
                                 : std::array{find_body(mechanism, angle->body), find_body(mechanism, angle->against)});
  }
  for (std::size_t b = 0; b < mechanism.bodies.size(); ++b) outward_.push_back(static_cast<int>(b));
  std::ranges::stable_sort(outward_, {}, [&](int body) { return system.topology.bodies[body].depth; });
  find_tie_steps();
  force_needed_.resize(mechanism.bodies.size());
  moment_needed_.resize(mechanism.bodies.size());
  reactions_.resize(mechanism.joints.size());
  root_moments_.resize(system.topology.counts.n_turns());
}

// Walks every group of tied bodies outward from its root: the frame, the driven body, or the first of the group.
void ReactionFinder::find_tie_steps() {
  const Mechanism& mechanism = system_->mechanism;
  const Topology& topology = system_->topology;
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
      for (const AngleTie& tie : topology.angle_ties) {
        const auto& [first, second] = ends_[tie.joint];
        for (const bool outer_is_second : {true, false}) {
          const int inner = outer_is_second ? first.body : second.body;
          const int outer = outer_is_second ? second.body : first.body;
          if (inner != open[k] || reached[outer]) continue;
          reached[outer] = true;
          open.push_back(outer);
          tie_steps_.push_back({tie.joint, outer, inner, outer_is_second});
        }
      }
    }
  }
  std::ranges::reverse(tie_steps_);
}

void ReactionFinder::add_force(int body, Vec2 at, Vec2 force) noexcept {
  force_needed_[body] -= force;
  moment_needed_[body] -= cross(at - (*motions_)[body].position, force);
}

// Both bodies feel the force at the second anchor.
void ReactionFinder::apply_joint_force(int joint, Vec2 force_on_second) noexcept {
  const auto& [first, second] = ends_[joint];
  const BodyMotion& motion = (*motions_)[second.body];
  const Vec2 at = motion.position + make_rotation(motion.angle) * second.arm;
  add_force(second.body, at, force_on_second);
  add_force(first.body, at, -force_on_second);
  reactions_[joint].force += force_on_second;
}

void ReactionFinder::apply_loads(const Workspace& workspace) noexcept {
  for (std::size_t k = 0; k < load_ends_.size(); ++k) {
    const auto& [first, second] = load_ends_[k];
    const LoadEffect& effect = workspace.loads.effects[k];
    const BodyMotion& motion = (*motions_)[second.body];
    const Vec2 at = motion.position + make_rotation(motion.angle) * second.arm;
    add_force(second.body, at, effect.force);
    moment_needed_[second.body] -= effect.torque;
    if (first < 0) continue;
    add_force(first, at, -effect.force);
    moment_needed_[first] += effect.torque;
  }
}

void ReactionFinder::apply_contacts(const Workspace& workspace) noexcept {
  for (std::size_t k = 0; k < workspace.contact_forces.size(); ++k) {
    const ContactForces& forces = workspace.contact_forces[k];
    const int joint = system_->tables.contacts[k].joint;
    const Anchored& bearing = ends_[joint].first;
    const Anchored& journal = contact_points_[k];
    for (const auto& [body, arm, force, torque] :
         {std::tuple{bearing.body, bearing.arm, -forces.force_on_journal, forces.torque_on_bearing},
          std::tuple{journal.body, journal.arm, forces.force_on_journal, forces.torque_on_journal}}) {
      const BodyMotion& motion = (*motions_)[body];
      add_force(body, motion.position + make_rotation(motion.angle) * arm, force);
      moment_needed_[body] -= torque;
    }
    const Vec2 from_anchor = make_rotation((*motions_)[journal.body].angle) * (journal.arm - ends_[joint].second.arm);
    reactions_[joint].force += forces.force_on_journal;
    reactions_[joint].moment += forces.torque_on_journal + cross(from_anchor, forces.force_on_journal);
  }
}

void ReactionFinder::apply_closures(const Workspace& workspace) noexcept {
  const Tables& tables = system_->tables;
  for (const ClosureRows& rows : tables.closures) {
    if (rows.kind == ClosureKind::angle) continue;
    // The solution holds −λ; λ pushes the second point along its closure's rows.
    Vec2 force;
    if (rows.active[0]) force.x = -workspace.equations[rows.row[0]];
    if (rows.active[1]) force.y = -workspace.equations[rows.row[1]];
    if (rows.kind == ClosureKind::line)
      force = force.x * (workspace.coordinates.rotation[rows.line_turn] * rows.normal);
    apply_joint_force(rows.joint, force);
  }
}

// Torque on the driven body, what is left over on its root, and its opposite on the body that it is driven against.
void ReactionFinder::apply_driver_torques(const Workspace& workspace) noexcept {
  const int n_driven = system_->topology.counts.n_driven();
  for (std::size_t d = 0; d < driven_angles_.size(); ++d) {
    const auto& [body, against] = driven_angles_[d];
    if (body < 0) continue;
    if (static_cast<int>(d) >= n_driven) moment_needed_[body] -= workspace.effort[d];
    moment_needed_[against] += workspace.effort[d];
  }
}

void ReactionFinder::sweep_tree() noexcept {
  for (std::size_t k = outward_.size(); k-- > 0;) {
    const int body = outward_[k];
    const int joint = system_->topology.bodies[body].joint;
    if (joint < 0) continue;
    const Vec2 needed = force_needed_[body];
    apply_joint_force(joint, ends_[joint].second.body == body ? needed : -needed);
  }
}

void ReactionFinder::sweep_ties() noexcept {
  for (const TieStep& step : tie_steps_) {
    const double moment = moment_needed_[step.outer];
    reactions_[step.joint].moment = step.outer_is_second ? moment : -moment;
    moment_needed_[step.outer] = 0.0;
    moment_needed_[step.inner] += moment;
  }
  std::ranges::fill(root_moments_, 0.0);
  for (std::size_t b = 0; b < moment_needed_.size(); ++b) {
    root_moments_[system_->topology.bodies[b].turn] += moment_needed_[b];
  }
}

void ReactionFinder::remove_driver_forces(const Workspace& workspace) noexcept {
  const CoordinateCounts& counts = system_->topology.counts;
  for (std::size_t j = 0; j < reactions_.size(); ++j) {
    const int driven = system_->topology.joint_slide[j] - counts.n_free_slides;
    if (system_->topology.joint_slide[j] < 0 || driven < 0) continue;
    const auto& prismatic = std::get<Prismatic>(system_->mechanism.joints[j].kind);
    const Rotation along = make_rotation((*motions_)[ends_[j].first.body].angle + prismatic.direction);
    reactions_[j].force -= workspace.effort[counts.n_driven_turns + driven] * Vec2{along.c, along.s};
  }
}

const std::vector<JointReaction>& ReactionFinder::update(const Workspace& workspace,
                                                         const std::vector<BodyMotion>& motions) noexcept {
  const Mechanism& mechanism = system_->mechanism;
  motions_ = &motions;
  std::ranges::fill(reactions_, JointReaction{});
  for (std::size_t b = 0; b < motions.size(); ++b) {
    const Body& body = mechanism.bodies[b];
    force_needed_[b] = b == 0 ? Vec2{} : body.mass * (motions[b].acceleration - mechanism.gravity);
    moment_needed_[b] = b == 0 ? 0.0 : body.inertia * motions[b].angle_acceleration;
  }
  apply_loads(workspace);
  apply_contacts(workspace);
  apply_closures(workspace);
  apply_driver_torques(workspace);
  sweep_tree();
  sweep_ties();
  remove_driver_forces(workspace);
  return reactions_;
}

}  // namespace gudgeon
