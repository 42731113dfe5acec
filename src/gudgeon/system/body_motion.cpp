// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// One chain through all centres of mass.
#include "gudgeon/system/body_motion.h"

#include <algorithm>

#include "gudgeon/system/load_forces.h"

namespace gudgeon {

BodyMotionFinder::BodyMotionFinder(const Mechanism& mechanism, const Topology& topology) : topology_(&topology) {
  for (std::size_t b = 0; b < mechanism.bodies.size(); ++b) {
    const Path path = topology.find_path(static_cast<int>(b), mechanism.bodies[b].center_of_mass);
    rows_.push_back(chain_.add(path, topology.counts));
  }
  points_.resize(chain_.rows().size());
  accelerations_.resize(chain_.rows().size());
  angle_accelerations_.assign(topology.counts.n_turns(), 0.0);
  slide_accelerations_.assign(topology.counts.n_slides(), 0.0);
  motions_.resize(mechanism.bodies.size());
}

void BodyMotionFinder::take_free_accelerations(const double* accelerations) noexcept {
  const CoordinateCounts& counts = topology_->counts;
  for (int k = 0; k < counts.n_free_turns; ++k) angle_accelerations_[k] = accelerations[k];
  for (int k = 0; k < counts.n_free_slides; ++k) slide_accelerations_[k] = accelerations[counts.n_free_turns + k];
}

void BodyMotionFinder::find_motions(const Coordinates& coordinates) noexcept {
  chain_.find_motions(coordinates, points_.data());
  chain_.find_accelerations(coordinates, points_.data(), angle_accelerations_.data(), slide_accelerations_.data(),
                            accelerations_.data());
  for (std::size_t b = 0; b < motions_.size(); ++b) {
    const BodyNode& node = topology_->bodies[b];
    motions_[b] = {points_[rows_[b]].position,        points_[rows_[b]].velocity,
                   accelerations_[rows_[b]],          coordinates.angle[node.turn] + node.offset,
                   coordinates.angle_rate[node.turn], angle_accelerations_[node.turn]};
  }
}

const std::vector<BodyMotion>& BodyMotionFinder::update(const Workspace& workspace) noexcept {
  const CoordinateCounts& counts = topology_->counts;
  take_free_accelerations(workspace.equations.data());
  const std::vector<DrivenValue>& driven = workspace.coordinates.driven;
  for (int k = 0; k < counts.n_driven_turns; ++k)
    angle_accelerations_[counts.n_free_turns + k] = driven[k].acceleration;
  for (int k = 0; k < counts.n_driven_slides; ++k) {
    slide_accelerations_[counts.n_free_slides + k] = driven[counts.n_driven_turns + k].acceleration;
  }
  find_motions(workspace.coordinates);
  return motions_;
}

const std::vector<BodyMotion>& BodyMotionFinder::update_response(const Coordinates& at_rest,
                                                                 const double* accelerations) noexcept {
  take_free_accelerations(accelerations);
  const CoordinateCounts& counts = topology_->counts;
  std::fill_n(angle_accelerations_.begin() + counts.n_free_turns, counts.n_driven_turns, 0.0);
  std::fill_n(slide_accelerations_.begin() + counts.n_free_slides, counts.n_driven_slides, 0.0);
  find_motions(at_rest);
  return motions_;
}

double find_kinetic_energy(const Mechanism& mechanism, const std::vector<BodyMotion>& motions) noexcept {
  double energy = 0.0;
  for (std::size_t b = 1; b < motions.size(); ++b) {
    const Body& body = mechanism.bodies[b];
    const BodyMotion& motion = motions[b];
    energy += 0.5 * (body.mass * dot(motion.velocity, motion.velocity) +
                     body.inertia * motion.angle_rate * motion.angle_rate);
  }
  return energy;
}

double find_kinetic_energy(const Tables& tables, const Coordinates& at) noexcept {
  double twice = 0.0;  // of a pair's two terms, of a term with itself
  for (std::size_t k = 0; k < tables.turn_inertia.size(); ++k) {
    twice += tables.turn_inertia[k] * at.angle_rate[k] * at.angle_rate[k];
  }
  double mixed = 0.0;
  for (const TurnPair& pair : tables.turn_pairs) {
    const double c = turn_products(pair.dot, pair.cross, at.rotation[pair.turn_i], at.rotation[pair.turn_j]).dot;
    mixed += c * at.angle_rate[pair.turn_i] * at.angle_rate[pair.turn_j];
  }
  for (const SlidePair& pair : tables.slide_pairs) {
    const auto [c, s] = turn_products(pair.dot, pair.cross, at.rotation[pair.turn_i], at.rotation[pair.turn_j]);
    const double turning_p = at.slide[pair.slide_i] * at.angle_rate[pair.turn_i];
    const double turning_q = at.slide[pair.slide_j] * at.angle_rate[pair.turn_j];
    const double sliding_p = at.slide_rate[pair.slide_i];
    const double sliding_q = at.slide_rate[pair.slide_j];
    const double product =
        (sliding_p * sliding_q + turning_p * turning_q) * c + (turning_p * sliding_q - sliding_p * turning_q) * s;
    (pair.is_self ? twice : mixed) += product;
  }
  return 0.5 * twice + mixed;
}

double find_potential_energy(const Tables& tables, const Coordinates& coordinates) noexcept {
  double energy = 0.0;
  for (const FieldTerm& field : tables.fields) {
    const Rotation r = coordinates.rotation[field.turn];
    energy -= coordinates.slide[field.slide] * (field.dot * r.c + field.cross * r.s);
  }
  for (const TurnTorque& torque : tables.torques) energy -= torque.torque * coordinates.angle[torque.turn];
  return energy;
}

double find_potential_energy(const Tables& tables, const Workspace& workspace) noexcept {
  return find_potential_energy(tables, workspace.coordinates) + find_spring_energy(workspace);
}

double find_elastic_energy(const Workspace& workspace) noexcept {
  double energy = 0.0;
  for (const ContactForces& forces : workspace.contact_forces) energy += forces.elastic_energy;
  return energy;
}

}  // namespace gudgeon
