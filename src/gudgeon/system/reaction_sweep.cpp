// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Loads, contacts, friction, closures and drivers act; the joints of the tree supply the rest: leaves first, each
// body's joint gives what m (a − g) and I θ̈ still lack and takes it from the parent (docs/theory/dynamics.md, Eq. D14).
#include "gudgeon/system/reaction_sweep.h"

#include <tuple>

#include "gudgeon/model/name_index.h"
#include "gudgeon/system/joint_ends.h"
#include "gudgeon/system/workspace.h"

namespace gudgeon {

ReactionSweep::ReactionSweep(const Mechanism& mechanism, const Topology& topology, const Tables& tables)
    : mechanism_(&mechanism), topology_(&topology), sweep_(mechanism, topology) {
  for (const Contact& contact : tables.contacts) {
    const int body = sweep_.second(contact.joint).body;
    contact_points_.push_back({body, contact.journal_center - mechanism.bodies[body].center_of_mass});
  }
  find_load_ends(mechanism);
}

void ReactionSweep::find_load_ends(const Mechanism& mechanism) {
  const NameIndex names(mechanism);
  const auto anchored = [&](const Anchor& anchor) {
    const JointEnd end = find_end(names, anchor);
    return Anchored{end.body, end.point - mechanism.bodies[end.body].center_of_mass};
  };
  const auto find_index = [&](const std::string& name) { return names.find_body(name); };
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
  for (const DrivenMotion& motion : topology_->driven) {
    const auto* angle = std::get_if<DrivenAngle>(&mechanism.drivers[motion.driver].target);
    driven_angles_.push_back(angle == nullptr ? std::array{-1, -1}
                                              : std::array{find_index(angle->body), find_index(angle->against)});
  }
}

void ReactionSweep::apply_loads(const Workspace& workspace) noexcept {
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

void ReactionSweep::apply_contacts(const Tables& tables, const Workspace& workspace) noexcept {
  for (std::size_t k = 0; k < workspace.contact_forces.size(); ++k) {
    const ContactForces& forces = workspace.contact_forces[k];
    const int joint = tables.contacts[k].joint;
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

// A pair of forces at the place of the second anchor, and a pair of torques.
void ReactionSweep::apply_friction(const Tables& tables, std::span<const FrictionForces> friction) noexcept {
  for (std::size_t k = 0; k < friction.size(); ++k) {
    const auto& [force, torque] = friction[k].pair;
    const Anchored& second = sweep_.second(tables.friction_joints[k].joint);
    const int first_body = sweep_.first(tables.friction_joints[k].joint).body;
    const Vec2 at = sweep_.find_place(second);
    sweep_.add_force(second.body, at, force);
    sweep_.add_torque(second.body, torque);
    sweep_.add_force(first_body, at, -force);
    sweep_.add_torque(first_body, -torque);
  }
}

void ReactionSweep::add_friction_reactions(const Tables& tables, std::span<const FrictionForces> friction) noexcept {
  for (std::size_t k = 0; k < friction.size(); ++k) {
    sweep_.add_reaction(tables.friction_joints[k].joint, friction[k].pair.force, friction[k].pair.torque);
  }
}

void ReactionSweep::apply_closures(const Tables& tables, const Workspace& workspace,
                                   std::span<const double> equations) noexcept {
  for (const ClosureRows& rows : tables.closures) {
    if (rows.kind == ClosureKind::angle) continue;
    // The solution holds −λ; λ pushes the second point along its closure's rows.
    Vec2 force;
    if (rows.active[0]) force.x = -equations[rows.row[0]];
    if (rows.active[1]) force.y = -equations[rows.row[1]];
    if (rows.kind == ClosureKind::line)
      force = force.x * (workspace.coordinates.rotation[rows.line_turn] * rows.normal);
    sweep_.apply_joint_force(rows.joint, force);
  }
}

// Torque on the driven body, what is left over on its root, and its opposite on the body that it is driven against.
void ReactionSweep::apply_driver_torques(std::span<const double> effort) noexcept {
  const int n_driven = topology_->counts.n_driven();
  for (std::size_t d = 0; d < driven_angles_.size(); ++d) {
    const auto& [body, against] = driven_angles_[d];
    if (body < 0) continue;
    if (static_cast<int>(d) >= n_driven) sweep_.add_torque(body, effort[d]);
    sweep_.add_torque(against, -effort[d]);
  }
}

void ReactionSweep::remove_driver_forces(std::span<const double> effort,
                                         const std::vector<BodyMotion>& motions) noexcept {
  const CoordinateCounts& counts = topology_->counts;
  std::vector<JointReaction>& reactions = sweep_.reactions();
  for (std::size_t j = 0; j < reactions.size(); ++j) {
    const int driven = topology_->joint_slide[j] - counts.n_free_slides;
    if (topology_->joint_slide[j] < 0 || driven < 0) continue;
    const auto& prismatic = std::get<Prismatic>(mechanism_->joints[j].kind);
    const Rotation along = make_rotation(motions[sweep_.first(static_cast<int>(j)).body].angle + prismatic.direction);
    reactions[j].force -= effort[counts.n_driven_turns + driven] * Vec2{along.c, along.s};
  }
}

void ReactionSweep::finish(const Tables& tables, const Workspace& workspace, std::span<const FrictionForces> friction,
                           std::span<const double> equations, std::span<const double> effort,
                           const std::vector<BodyMotion>& motions) noexcept {
  apply_friction(tables, friction);
  apply_closures(tables, workspace, equations);
  apply_driver_torques(effort);
  sweep_.finish();
  remove_driver_forces(effort, motions);
  add_friction_reactions(tables, friction);
}

const std::vector<JointReaction>& ReactionSweep::update(const Tables& tables, const Workspace& workspace,
                                                        const std::vector<BodyMotion>& motions) noexcept {
  sweep_.begin(motions);
  for (std::size_t b = 1; b < motions.size(); ++b) {
    const Body& body = mechanism_->bodies[b];
    sweep_.need(static_cast<int>(b), body.mass * (motions[b].acceleration - mechanism_->gravity),
                body.inertia * motions[b].angle_acceleration);
  }
  apply_loads(workspace);
  apply_contacts(tables, workspace);
  finish(tables, workspace, workspace.friction_forces, workspace.equations, workspace.effort, motions);
  return sweep_.reactions();
}

const std::vector<JointReaction>& ReactionSweep::update_response(const Tables& tables, const Workspace& workspace,
                                                                 std::span<const FrictionForces> friction,
                                                                 std::span<const double> equations,
                                                                 std::span<const double> effort,
                                                                 const std::vector<BodyMotion>& motions) noexcept {
  sweep_.begin(motions);
  for (std::size_t b = 1; b < motions.size(); ++b) {
    const Body& body = mechanism_->bodies[b];
    sweep_.need(static_cast<int>(b), body.mass * motions[b].acceleration, body.inertia * motions[b].angle_acceleration);
  }
  finish(tables, workspace, friction, equations, effort, motions);
  return sweep_.reactions();
}

}  // namespace gudgeon
