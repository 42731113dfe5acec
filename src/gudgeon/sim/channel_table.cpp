// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Bodies, clearance joints, joints, drivers, energies.
#include "gudgeon/sim/channel_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "gudgeon/sim/load_channels.h"
#include "gudgeon/sim/motion_equations.h"

namespace gudgeon {

namespace {

constexpr bool kWatched = true;

class ChannelTable {
 public:
  explicit ChannelTable(const System& system) : system_(system) {}

  std::vector<RecordedChannel> make() {
    for (std::size_t b = 1; b < system_.mechanism.bodies.size(); ++b) add_body(b);
    for (std::size_t g = 0; g < system_.tables.contact_groups.size(); ++g) add_clearance(g);
    for (std::size_t j = 0; j < system_.mechanism.joints.size(); ++j) add_joint(j);
    for (std::size_t k = 0; k < system_.tables.friction_joints.size(); ++k) add_friction(k);
    for (std::size_t d = 0; d < system_.mechanism.drivers.size(); ++d) add_driver(d);
    for (std::size_t k = 0; k < system_.mechanism.loads.size(); ++k) add_load(k);
    add_energies();
    return std::move(table_);
  }

 private:
  template <class Read>
  void add(std::string name, const char* symbol, const char* unit, const char* description, Read read,
           bool watched = false) {
    table_.push_back({{std::move(name), symbol, unit, description}, std::move(read), watched});
  }

  void add_body(std::size_t b) {
    const std::string& name = system_.mechanism.bodies[b].name;
    const auto add_of = [&](const char* what, const char* symbol, const char* unit, const char* description, auto read,
                            bool watched = false) {
      add(
          name + what, symbol, unit, description, [=](const Snapshot& at) { return read((*at.motions)[b]); }, watched);
    };
    using Motion = const BodyMotion&;
    add_of(".x", "x", "m", "Centre of mass along the frame's x axis", [](Motion m) { return m.position.x; });
    add_of(".y", "y", "m", "Centre of mass along the frame's y axis", [](Motion m) { return m.position.y; });
    add_of(".angle", "θ", "rad", "Angle of the body against the frame", [](Motion m) { return m.angle; });
    add_of(".x_velocity", "ẋ", "m/s", "Velocity of the centre of mass along x", [](Motion m) { return m.velocity.x; });
    add_of(".y_velocity", "ẏ", "m/s", "Velocity of the centre of mass along y", [](Motion m) { return m.velocity.y; });
    add_of(".angle_rate", "θ̇", "rad/s", "Angular velocity", [](Motion m) { return m.angle_rate; });
    add_of(
        ".x_acceleration", "ẍ", "m/s^2", "Acceleration of the centre of mass along x",
        [](Motion m) { return m.acceleration.x; }, kWatched);
    add_of(
        ".y_acceleration", "ÿ", "m/s^2", "Acceleration of the centre of mass along y",
        [](Motion m) { return m.acceleration.y; }, kWatched);
    add_of(
        ".angle_acceleration", "θ̈", "rad/s^2", "Angular acceleration", [](Motion m) { return m.angle_acceleration; },
        kWatched);
  }

  void add_clearance(std::size_t group) {
    const AnyJoint& kind = system_.mechanism.joints[system_.tables.contact_groups[group].joint].kind;
    if (std::holds_alternative<RevoluteClearance>(kind)) {
      add_bearing_motion(group);
    } else {
      add_slot_motion(group, std::holds_alternative<PrismaticClearance>(kind));
    }
    add_contacts(group, !std::holds_alternative<RevoluteClearance>(kind));
  }

  template <class Read>
  void add_reading(std::size_t group, const char* what, const char* symbol, const char* unit, const char* description,
                   Read read, bool watched = false) {
    const std::string& name = system_.mechanism.joints[system_.tables.contact_groups[group].joint].name;
    add(
        name + what, symbol, unit, description, [=](const Snapshot& at) { return read(at.clearances[group]); },
        watched);
  }
  using Reading = const ClearanceReading&;

  void add_bearing_motion(std::size_t group) {
    add_reading(group, ".x_offset", "e_x", "m", "Journal centre from bearing centre, along the frame's x axis",
                [](Reading r) { return r.offset.x; });
    add_reading(group, ".y_offset", "e_y", "m", "Journal centre from bearing centre, along the frame's y axis",
                [](Reading r) { return r.offset.y; });
    add_reading(group, ".x_offset_rate", "ė_x", "m/s",
                "Velocity of the journal centre against the bearing centre, along x",
                [](Reading r) { return r.offset_rate.x; });
    add_reading(group, ".y_offset_rate", "ė_y", "m/s",
                "Velocity of the journal centre against the bearing centre, along y",
                [](Reading r) { return r.offset_rate.y; });
    add_reading(group, ".contact_angle", "φ_i", "rad",
                "Direction of the line of centres in the bearing's body, in [-π, π]",
                [](Reading r) { return r.contact_angle; });
  }

  void add_slot_motion(std::size_t group, bool is_block) {
    add_reading(group, ".displacement", "s", "m", "Middle of the journal from the middle of the slot, along the slot",
                [](Reading r) { return r.displacement; });
    add_reading(group, ".speed", "ṡ", "m/s", "Speed of the journal along the slot", [](Reading r) { return r.speed; });
    add_reading(group, ".height", "h", "m", "Middle of the journal from the middle of the slot, across it to the left",
                [](Reading r) { return r.height; });
    add_reading(group, ".height_rate", "ḣ", "m/s", "Speed of the journal across the slot",
                [](Reading r) { return r.height_rate; });
    if (!is_block) return;
    add_reading(group, ".tilt", "α", "rad", "Angle of the block against its slot", [](Reading r) { return r.tilt; });
    add_reading(group, ".tilt_rate", "α̇", "rad/s", "Angular velocity of the block against its slot",
                [](Reading r) { return r.tilt_rate; });
  }

  void add_contacts(std::size_t group, bool is_slot) {
    const std::string& name = system_.mechanism.joints[system_.tables.contact_groups[group].joint].name;
    const ContactGroup contacts = system_.tables.contact_groups[group];
    add(name + ".in_contact", "", "1", "1 while the surfaces touch, 0 in free flight", [=](const Snapshot& at) {
      for (int k = contacts.first_contact; k < contacts.end_contact; ++k) {
        if (at.contact_modes[static_cast<std::size_t>(k)].in_contact) return 1.0;
      }
      return 0.0;
    });
    add_reading(
        group, ".penetration", "δ", "m", "Penetration, the largest of the joint; negative in free flight",
        [](Reading r) { return r.penetration; }, kWatched);
    add_reading(
        group, ".normal_force", "F", "N", "Normal contact force, all contacts together",
        [](Reading r) { return r.normal_force; }, kWatched);
    add_reading(
        group, ".friction_force", "μF", "N", "Friction force, of the slip speed's sign",
        [](Reading r) { return r.friction_force; }, kWatched);
    add_reading(
        group, ".slip_speed", "v", "m/s", "Slip of the journal's surface along the bearing's, in contact",
        [](Reading r) { return r.slip_speed; }, kWatched);
    if (system_.tables.contacts[contacts.first_contact].bristle >= 0) {
      add_reading(group, ".bristle", "z", "m", "Deflection of the bristle; zero in free flight",
                  [](Reading r) { return r.bristle; });
    }
    if (!is_slot) return;
    add_reading(
        group, ".left_force", "F_l", "N", "Normal force on the left side of the slot",
        [](Reading r) { return r.left_force; }, kWatched);
    add_reading(
        group, ".right_force", "F_r", "N", "Normal force on the right side of the slot",
        [](Reading r) { return r.right_force; }, kWatched);
    add_reading(
        group, ".n_contacts", "", "1", "How many corners or sides of the journal touch",
        [](Reading r) { return static_cast<double>(r.n_contacts); }, kWatched);
  }

  void add_joint(std::size_t j) {
    const Joint& joint = system_.mechanism.joints[j];
    const auto add_of = [&](const char* what, const char* symbol, const char* unit, const char* description,
                            auto read) {
      add(joint.name + what, symbol, unit, description, [=](const Snapshot& at) { return read((*at.reactions)[j]); });
    };
    using Reaction = const JointReaction&;
    add_of(".x_force", "F_x", "N", "Force on the joint's second body (the journal's), along x",
           [](Reaction r) { return r.force.x; });
    add_of(".y_force", "F_y", "N", "Force on the joint's second body (the journal's), along y",
           [](Reaction r) { return r.force.y; });
    add_of(".force", "|F|", "N", "Magnitude of the joint force", [](Reaction r) { return norm(r.force); });
    if (std::holds_alternative<Prismatic>(joint.kind) || std::holds_alternative<Rigid>(joint.kind) ||
        std::holds_alternative<PrismaticClearance>(joint.kind)) {
      add_of(".moment", "M", "N m", "Moment on the joint's second body, about its anchor",
             [](Reaction r) { return r.moment; });
    }
  }

  void add_friction(std::size_t k) {
    const FrictionJoint& at_joint = system_.tables.friction_joints[k];
    const std::string& name = system_.mechanism.joints[at_joint.joint].name;
    if (at_joint.kind == FrictionKind::pin) {
      add(name + ".friction_torque", "T_f", "N m", "Friction torque on the joint's second body",
          [=](const Snapshot& at) { return at.workspace->friction_forces[k].pair.torque; });
    } else {
      add(name + ".friction_force", "F_f", "N", "Friction force on the joint's second body, along its line",
          [=](const Snapshot& at) { return at.workspace->friction_forces[k].force; });
    }
    add(name + ".slip_speed", "v", "m/s", "Slip speed of the second body's surface on the first one's",
        [=](const Snapshot& at) { return at.workspace->friction_forces[k].slip_speed; });
    if (at_joint.bristle < 0) return;
    add(name + ".bristle", "z", "m", "Deflection of the bristle",
        [bristle = at_joint.bristle](const Snapshot& at) { return at.workspace->bristles[bristle]; });
  }

  // In the model's order; the tables have turns first, then slides, then angles between bodies.
  void add_driver(std::size_t at_driver) {
    const Driver& driver = system_.mechanism.drivers[at_driver];
    const auto& driven = system_.tables.driven;
    const auto found = std::ranges::find(driven, static_cast<int>(at_driver), &DrivenMotion::driver);
    const auto d = static_cast<std::size_t>(found - driven.begin());
    const bool turns = std::holds_alternative<DrivenAngle>(driver.target);
    add(
        driver.name + ".effort", turns ? "T" : "F", turns ? "N m" : "N",
        turns ? "Torque that the driver delivers" : "Force that the driver delivers",
        [=](const Snapshot& at) { return at.workspace->effort[d]; }, kWatched);
  }

  // Loads may have the names of joints or bodies: what is taken then is told apart.
  void add_load(std::size_t k) {
    const Load& load = system_.mechanism.loads[k];
    for (const LoadChannel& channel : list_load_channels(load.kind)) {
      std::string name = fmt::format("{}.{}", load.name, channel.ending);
      const bool taken =
          std::ranges::any_of(table_, [&](const RecordedChannel& entry) { return entry.channel.name == name; });
      if (taken) name = fmt::format("{}.load.{}", load.name, channel.ending);
      add(std::move(name), channel.symbol, channel.unit, channel.description,
          [find = channel.find, k](const Snapshot& at) { return find(at.workspace->loads.effects[k]); });
    }
  }

  void add_energies() {
    using At = const Snapshot&;
    add("energy.kinetic", "T", "J", "Kinetic energy of all bodies", [](At at) { return at.kinetic; });
    add("energy.potential", "V", "J", "Potential energy of gravity, constant loads and springs",
        [](At at) { return at.potential; });
    add("energy.elastic", "U", "J", "Energy stored in contacts", [](At at) { return at.elastic; });
    add("energy.driver_work", "W_d", "J", "Work done by the drivers since the start",
        [](At at) { return at.integrals[kDriverWork]; });
    add("energy.load_work", "W_l", "J", "Work done by variable forces and torques since the start",
        [](At at) { return at.integrals[kLoadWork]; });
    add("energy.damper_loss", "D_l", "J", "Energy lost in dampers since the start",
        [](At at) { return at.integrals[kDamperLoss]; });
    add("energy.contact_damping", "D", "J", "Energy lost in contacts along their normal since the start",
        [](At at) { return at.integrals[kContactDamping]; });
    add("energy.friction", "W_f", "J", "Energy lost to friction since the start",
        [](At at) { return at.integrals[kFrictionLoss]; });
    add("energy.residual", "ε", "J", "Residual of the energy balance", [](At at) {
      return at.kinetic + at.potential + at.elastic - at.initial_energy - at.integrals[kDriverWork] -
             at.integrals[kLoadWork] + at.integrals[kDamperLoss] + at.integrals[kContactDamping] +
             at.integrals[kFrictionLoss] - at.integrals[kSurfaceWork];
    });
  }

  const System& system_;
  std::vector<RecordedChannel> table_;
};

}  // namespace

std::vector<RecordedChannel> make_channel_table(const System& system) { return ChannelTable(system).make(); }

}  // namespace gudgeon
