// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Names and values of all channels, in one order.
#include "gudgeon/sim/stage_recorder.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "gudgeon/sim/load_channels.h"

namespace gudgeon {

namespace {

std::vector<std::string> select_names(const std::vector<Channel>& channels, const std::vector<bool>& watched,
                                      bool want) {
  std::vector<std::string> names;
  for (std::size_t k = 0; k < channels.size(); ++k) {
    if (watched[k] == want) names.push_back(channels[k].name);
  }
  return names;
}

}  // namespace

StageRecorder::StageRecorder(const System& system)
    : system_(&system), motion_(system), reaction_(system), step_statistics_({}), sample_statistics_({}) {
  add_body_channels();
  add_clearance_channels();
  add_joint_channels();
  add_driver_channels();
  add_load_channels();
  add_energy_channels();
  row_.resize(channels_.size());
  values_.resize(channels_.size());
  const auto n_watched = static_cast<std::size_t>(std::count(watched_.begin(), watched_.end(), true));
  watched_row_.resize(n_watched);
  sampled_row_.resize(channels_.size() - n_watched);
  step_statistics_ = StatisticsAccumulator(select_names(channels_, watched_, true));
  sample_statistics_ = StatisticsAccumulator(select_names(channels_, watched_, false));
}

void StageRecorder::add(std::string name, std::string symbol, std::string unit, std::string description, bool watched) {
  channels_.push_back({std::move(name), std::move(symbol), std::move(unit), std::move(description)});
  watched_.push_back(watched);
}

void StageRecorder::add_body_channels() {
  for (std::size_t b = 1; b < system_->mechanism.bodies.size(); ++b) {
    const std::string& name = system_->mechanism.bodies[b].name;
    add(name + ".x", "x", "m", "Centre of mass along the frame's x axis");
    add(name + ".y", "y", "m", "Centre of mass along the frame's y axis");
    add(name + ".angle", "θ", "rad", "Angle of the body against the frame");
    add(name + ".x_velocity", "ẋ", "m/s", "Velocity of the centre of mass along x");
    add(name + ".y_velocity", "ẏ", "m/s", "Velocity of the centre of mass along y");
    add(name + ".angle_rate", "θ̇", "rad/s", "Angular velocity");
    add(name + ".x_acceleration", "ẍ", "m/s^2", "Acceleration of the centre of mass along x", true);
    add(name + ".y_acceleration", "ÿ", "m/s^2", "Acceleration of the centre of mass along y", true);
    add(name + ".angle_acceleration", "θ̈", "rad/s^2", "Angular acceleration", true);
  }
}

void StageRecorder::add_clearance_channels() {
  for (const Contact& contact : system_->tables.contacts) {
    const std::string& name = system_->mechanism.joints[contact.joint].name;
    add(name + ".x_offset", "e_x", "m", "Journal centre from bearing centre, along the frame's x axis");
    add(name + ".y_offset", "e_y", "m", "Journal centre from bearing centre, along the frame's y axis");
    add(name + ".x_offset_rate", "ė_x", "m/s", "Velocity of the journal centre against the bearing centre, along x");
    add(name + ".y_offset_rate", "ė_y", "m/s", "Velocity of the journal centre against the bearing centre, along y");
    add(name + ".contact_angle", "φ_i", "rad", "Direction of the line of centres in the bearing's body, in [-π, π]");
    add(name + ".in_contact", "", "1", "1 while the surfaces touch, 0 in free flight");
    add(name + ".penetration", "δ", "m", "Penetration; negative in free flight", true);
    add(name + ".normal_force", "F", "N", "Normal contact force", true);
    add(name + ".friction_force", "μF", "N", "Friction force, of the slip speed's sign", true);
    add(name + ".slip_speed", "v", "m/s", "Slip of the journal's surface along the bearing's, in contact", true);
    if (contact.bristle >= 0) add(name + ".bristle", "z", "m", "Deflection of the bristle; zero in free flight");
  }
}

void StageRecorder::add_joint_channels() {
  for (const Joint& joint : system_->mechanism.joints) {
    add(joint.name + ".x_force", "F_x", "N", "Force on the joint's second body (the journal's), along x");
    add(joint.name + ".y_force", "F_y", "N", "Force on the joint's second body (the journal's), along y");
    add(joint.name + ".force", "|F|", "N", "Magnitude of the joint force");
    if (std::holds_alternative<Prismatic>(joint.kind) || std::holds_alternative<Rigid>(joint.kind)) {
      add(joint.name + ".moment", "M", "N m", "Moment on the joint's second body, about its anchor");
    }
  }
}

void StageRecorder::add_driver_channels() {
  const auto& driven = system_->tables.driven;
  for (std::size_t d = 0; d < system_->mechanism.drivers.size(); ++d) {
    const Driver& driver = system_->mechanism.drivers[d];
    const auto found = std::ranges::find(driven, static_cast<int>(d), &DrivenMotion::driver);
    efforts_.push_back(static_cast<std::size_t>(found - driven.begin()));
    const bool turns = std::holds_alternative<DrivenAngle>(driver.target);
    add(driver.name + ".effort", turns ? "T" : "F", turns ? "N m" : "N",
        turns ? "Torque that the driver delivers" : "Force that the driver delivers", true);
  }
}

// Loads may have the names of joints or bodies: what is taken then is told apart.
void StageRecorder::add_load_channels() {
  for (const Load& load : system_->mechanism.loads) {
    for (const LoadChannel& channel : list_load_channels(load.kind)) {
      std::string name = fmt::format("{}.{}", load.name, channel.ending);
      const bool taken = std::ranges::find(channels_, name, &Channel::name) != channels_.end();
      if (taken) name = fmt::format("{}.load.{}", load.name, channel.ending);
      add(std::move(name), channel.symbol, channel.unit, channel.description);
    }
  }
}

void StageRecorder::add_energy_channels() {
  add("energy.kinetic", "T", "J", "Kinetic energy of all bodies");
  add("energy.potential", "V", "J", "Potential energy of gravity, constant loads and springs");
  add("energy.elastic", "U", "J", "Energy stored in contacts");
  add("energy.driver_work", "W_d", "J", "Work done by the drivers since the start");
  add("energy.load_work", "W_l", "J", "Work done by variable forces and torques since the start");
  add("energy.damper_loss", "D_l", "J", "Energy lost in dampers since the start");
  add("energy.contact_damping", "D", "J", "Energy lost in contacts along their normal since the start");
  add("energy.friction", "W_f", "J", "Energy lost to friction since the start");
  add("energy.residual", "ε", "J", "What the ledger lacks to balance");
}

StageRecorder::Energies StageRecorder::find_energies(const Workspace& workspace) {
  motion_.update(workspace);
  return {find_kinetic_energy(system_->mechanism, motion_.motions()), find_potential_energy(system_->tables, workspace),
          find_elastic_energy(workspace)};
}

void StageRecorder::fill_bodies() {
  for (std::size_t b = 1; b < motion_.motions().size(); ++b) {
    const BodyMotion& motion = motion_.motions()[b];
    put(motion.position), put(motion.angle);
    put(motion.velocity), put(motion.angle_rate);
    put(motion.acceleration), put(motion.angle_acceleration);
  }
}

void StageRecorder::fill_clearances(const Workspace& workspace, std::span<const ContactLatch> latches) {
  for (std::size_t k = 0; k < latches.size(); ++k) {
    const Contact& contact = system_->tables.contacts[k];
    const RelativeMotion motion = find_contact_motion(contact, workspace);
    const RevoluteGap gap = find_revolute_gap(contact.surfaces, motion);
    const ContactForces& forces = workspace.contact_forces[k];
    put(motion.offset), put(motion.velocity);
    put(std::remainder(std::atan2(gap.normal.y, gap.normal.x) - motion.bearing_angle, 2.0 * std::numbers::pi));
    put(latches[k].in_contact ? 1.0 : 0.0);
    put(gap.penetration), put(forces.normal_force), put(forces.friction_force), put(forces.slip_speed);
    if (contact.bristle >= 0) put(workspace.bristles[contact.bristle]);
  }
}

void StageRecorder::fill_joints() {
  const auto& reactions = reaction_.reactions();
  for (std::size_t j = 0; j < reactions.size(); ++j) {
    put(reactions[j].force), put(norm(reactions[j].force));
    const AnyJoint& kind = system_->mechanism.joints[j].kind;
    if (std::holds_alternative<Prismatic>(kind) || std::holds_alternative<Rigid>(kind)) put(reactions[j].moment);
  }
}

void StageRecorder::fill_loads(const Workspace& workspace) {
  const auto& loads = system_->mechanism.loads;
  for (std::size_t k = 0; k < loads.size(); ++k) {
    for (const LoadChannel& channel : list_load_channels(loads[k].kind)) put(channel.find(workspace.loads.effects[k]));
  }
}

void StageRecorder::fill_energies(const Workspace& workspace, double initial_energy, const double* integrals) {
  const Energies energies = find_energies(workspace);
  put(energies.kinetic), put(energies.potential), put(energies.elastic);
  put(integrals[kDriverWork]), put(integrals[kLoadWork]), put(integrals[kDamperLoss]);
  put(integrals[kContactDamping]), put(integrals[kFrictionLoss]);
  put(energies.total() - initial_energy - integrals[kDriverWork] - integrals[kLoadWork] + integrals[kDamperLoss] +
      integrals[kContactDamping] + integrals[kFrictionLoss] - integrals[kSurfaceWork]);
}

void StageRecorder::sample(double time, Workspace& workspace, std::span<const ContactLatch> latches,
                           double initial_energy, const double* integrals) {
  update_point_motions(system_->tables, workspace);
  motion_.update(workspace);
  reaction_.update(workspace, motion_.motions());
  next_ = 0;
  fill_bodies();
  fill_clearances(workspace, latches);
  fill_joints();
  for (const std::size_t d : efforts_) put(workspace.effort[d]);
  fill_loads(workspace);
  fill_energies(workspace, initial_energy, integrals);
  time_.push_back(time);
  std::size_t n_sampled = 0;
  for (std::size_t k = 0; k < row_.size(); ++k) {
    values_[k].push_back(row_[k]);
    if (!watched_[k]) sampled_row_[n_sampled++] = row_[k];
  }
  sample_statistics_.update(time, sampled_row_);
}

void StageRecorder::watch(double time, const Workspace& workspace, std::span<const GapState> gaps) {
  motion_.update(workspace);
  std::size_t at = 0;
  for (std::size_t b = 1; b < motion_.motions().size(); ++b) {
    const BodyMotion& motion = motion_.motions()[b];
    watched_row_[at++] = motion.acceleration.x;
    watched_row_[at++] = motion.acceleration.y;
    watched_row_[at++] = motion.angle_acceleration;
  }
  for (std::size_t k = 0; k < gaps.size(); ++k) {
    const ContactForces& forces = workspace.contact_forces[k];
    watched_row_[at++] = gaps[k].penetration;
    watched_row_[at++] = forces.normal_force;
    watched_row_[at++] = forces.friction_force;
    watched_row_[at++] = forces.slip_speed;
  }
  for (const std::size_t d : efforts_) watched_row_[at++] = workspace.effort[d];
  step_statistics_.update(time, watched_row_);
}

void StageRecorder::finish(StageRecord& stage) {
  stage.channels = channels_;
  stage.time = std::move(time_);
  stage.values = std::move(values_);
  // Back into the order of the channels.
  const auto watched = step_statistics_.summarize();
  const auto sampled = sample_statistics_.summarize();
  std::size_t next_watched = 0;
  std::size_t next_sampled = 0;
  for (const bool is_watched : watched_) {
    stage.statistics.push_back(is_watched ? watched[next_watched++] : sampled[next_sampled++]);
  }
}

}  // namespace gudgeon
