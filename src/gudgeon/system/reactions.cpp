// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Loads, contacts, closures and drivers act; the joints of the tree supply the rest: leaves first, each body's joint
// gives what m (a − g) and I θ̈ still lack and takes it from the parent (docs/theory/dynamics.md, Eq. D14).
#include "gudgeon/system/reactions.h"

#include <tuple>

namespace gudgeon {

ReactionFinder::ReactionFinder(const System& system) : system_(&system), sweep_(system), self_stress_(system) {
  const Mechanism& mechanism = system.mechanism;
  const NameIndex names(mechanism);
  const auto anchored = [&](const Anchor& anchor) {
    const JointEnd end = find_end(names, anchor);
    return Anchored{end.body, end.point - mechanism.bodies[end.body].center_of_mass};
  };
  const auto find_index = [&](const std::string& name) { return names.find_body(name); };
  for (const Contact& contact : system.tables.contacts) {
    const int body = sweep_.second(contact.joint).body;
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
    driven_angles_.push_back(angle == nullptr ? std::array{-1, -1}
                                              : std::array{find_index(angle->body), find_index(angle->against)});
  }
}

void ReactionFinder::apply_loads(const Workspace& workspace) noexcept {
  for (std::size_t k = 0; k < load_ends_.size(); ++k) {
    const auto& [first, second] = load_ends_[k];
    const LoadEffect& effect = workspace.loads.effects[k];
    const Vec2 at = sweep_.find_place(second);
    sweep_.add_force(second.body, at, effect.force);
    sweep_.add_torque(second.body, effect.torque);
    if (first < 0) continue;
    sweep_.add_force(first, at, -effect.force);
    sweep_.add_torque(first, -effect.torque);
  }
}

void ReactionFinder::apply_contacts(const Workspace& workspace) noexcept {
  for (std::size_t k = 0; k < workspace.contact_forces.size(); ++k) {
    const ContactForces& forces = workspace.contact_forces[k];
    const int joint = system_->tables.contacts[k].joint;
    const Anchored& bearing = sweep_.first(joint);
    const Anchored& journal = contact_points_[k];
    for (const auto& [point, force, torque] :
         {std::tuple{bearing, -forces.force_on_journal, forces.torque_on_bearing},
          std::tuple{journal, forces.force_on_journal, forces.torque_on_journal}}) {
      sweep_.add_force(point.body, sweep_.find_place(point), force);
      sweep_.add_torque(point.body, torque);
    }
    const Vec2 from_anchor = sweep_.turn(journal.body, journal.arm - sweep_.second(joint).arm);
    sweep_.add_reaction(joint, forces.force_on_journal,
                        forces.torque_on_journal + cross(from_anchor, forces.force_on_journal));
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
    sweep_.apply_joint_force(rows.joint, force);
  }
}

// Torque on the driven body, what is left over on its root, and its opposite on the body that it is driven against.
void ReactionFinder::apply_driver_torques(const Workspace& workspace) noexcept {
  const int n_driven = system_->topology.counts.n_driven();
  for (std::size_t d = 0; d < driven_angles_.size(); ++d) {
    const auto& [body, against] = driven_angles_[d];
    if (body < 0) continue;
    if (static_cast<int>(d) >= n_driven) sweep_.add_torque(body, workspace.effort[d]);
    sweep_.add_torque(against, -workspace.effort[d]);
  }
}

void ReactionFinder::remove_driver_forces(const Workspace& workspace, const std::vector<BodyMotion>& motions) noexcept {
  const CoordinateCounts& counts = system_->topology.counts;
  std::vector<JointReaction>& reactions = sweep_.reactions();
  for (std::size_t j = 0; j < reactions.size(); ++j) {
    const int driven = system_->topology.joint_slide[j] - counts.n_free_slides;
    if (system_->topology.joint_slide[j] < 0 || driven < 0) continue;
    const auto& prismatic = std::get<Prismatic>(system_->mechanism.joints[j].kind);
    const Rotation along = make_rotation(motions[sweep_.first(static_cast<int>(j)).body].angle + prismatic.direction);
    reactions[j].force -= workspace.effort[counts.n_driven_turns + driven] * Vec2{along.c, along.s};
  }
}

const std::vector<JointReaction>& ReactionFinder::update(const Workspace& workspace,
                                                         const std::vector<BodyMotion>& motions) noexcept {
  const Mechanism& mechanism = system_->mechanism;
  sweep_.begin(motions);
  for (std::size_t b = 1; b < motions.size(); ++b) {
    const Body& body = mechanism.bodies[b];
    sweep_.need(static_cast<int>(b), body.mass * (motions[b].acceleration - mechanism.gravity),
                body.inertia * motions[b].angle_acceleration);
  }
  apply_loads(workspace);
  apply_contacts(workspace);
  apply_closures(workspace);
  apply_driver_torques(workspace);
  sweep_.finish();
  remove_driver_forces(workspace, motions);
  self_stress_.relax(workspace, motions, sweep_.reactions());
  return sweep_.reactions();
}

}  // namespace gudgeon
