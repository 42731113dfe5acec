// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Circles, surfaces and laws of each clearance joint.
#include "gudgeon/system/compile_contacts.h"

#include <utility>

namespace gudgeon {

namespace {

// Surfaces of a slot: its left side, seen along its direction, then its right one.
GuideSurfaces make_side(double direction, int bearing_surface, double half_height, double length, double radius) {
  return {direction, bearing_surface == 0 ? 1.0 : -1.0, half_height, 0.5 * length, radius, {}, {}};
}

class ContactCompiler {
 public:
  ContactCompiler(const Topology& topology, Tables& tables) : topology_(topology), tables_(tables) {}

  template <ClearanceJoint Kind>
  void add(int j, const Kind& joint) {
    ContactGroup group{j, static_cast<int>(tables_.contacts.size()), 0, 0, 0};
    for (const ContactCircle& circle : find_circles(joint, topology_.ends[j].second.point)) {
      Contact contact = place(j, circle);
      contact.surfaces = make_surfaces(joint, circle.bearing_surface);
      contact.width = joint.width;
      add_laws(joint.contact, contact);
      group.n_bearing_surfaces = std::max(group.n_bearing_surfaces, circle.bearing_surface + 1);
      group.n_journal_surfaces = std::max(group.n_journal_surfaces, circle.journal_surface + 1);
      tables_.contacts.push_back(std::move(contact));
    }
    group.end_contact = static_cast<int>(tables_.contacts.size());
    tables_.contact_groups.push_back(group);
  }

 private:
  Contact place(int j, const ContactCircle& circle) {
    const auto& [bearing_body, middle] = topology_.ends[j].first;
    const int journal_body = topology_.ends[j].second.body;
    const BodyNode& bearing = topology_.bodies[bearing_body];
    const BodyNode& journal = topology_.bodies[journal_body];
    Contact contact;
    contact.joint = j;
    contact.group = static_cast<int>(tables_.contact_groups.size());
    contact.bearing_surface = circle.bearing_surface;
    contact.journal_surface = circle.journal_surface;
    contact.journal_center = circle.center;
    contact.bearing_row = tables_.points.add(topology_.find_path(bearing_body, middle), topology_.counts);
    contact.journal_row = tables_.points.add(topology_.find_path(journal_body, circle.center), topology_.counts);
    contact.bearing_turn = bearing.turn;
    contact.journal_turn = journal.turn;
    contact.bearing_offset = bearing.offset;
    contact.journal_offset = journal.offset;
    contact.bearing_index = tables_.find_turn_index(bearing.turn);
    contact.journal_index = tables_.find_turn_index(journal.turn);
    return contact;
  }

  void add_laws(const ContactProperties& properties, Contact& contact) {
    contact.stiffness_factor = find_stiffness_factor(properties.bearing_material, properties.journal_material);
    contact.contact_modulus = find_contact_modulus(properties.bearing_material, properties.journal_material);
    contact.damping_factor = std::visit([](const auto& law) { return law.damping_factor(); }, properties.normal_force);
    contact.normal_force = properties.normal_force;
    contact.friction = properties.friction;
    if (has_bristle(contact.friction)) contact.bristle = tables_.n_bristles++;
    contact.bristle_scale = find_bristle_scale(contact.friction);
    contact.slip_scale = find_slip_scale(contact.friction);
    contact.steepest_friction = find_steepest_friction(contact.friction);
    contact.steps_at_onset = steps_at_onset(contact.normal_force);
    contact.bearing_wear = properties.bearing_wear;
    contact.journal_wear = properties.journal_wear;
    contact.onset_speed_floor = properties.onset_speed_floor;
    contact.normal_direction = properties.normal_direction;
    contact.pressure = properties.pressure;
  }

  const Topology& topology_;
  Tables& tables_;
};

}  // namespace

std::vector<ContactCircle> find_circles(const RevoluteClearance&, Vec2 journal) { return {{journal, 0, 0}}; }

std::vector<ContactCircle> find_circles(const PrismaticClearance& joint, Vec2 journal) {
  const Rotation along = make_rotation(joint.direction - joint.relative_angle);
  const double x = 0.5 * joint.journal_length - joint.corner_radius;
  const double y = 0.5 * joint.journal_height - joint.corner_radius;
  return {{journal + along * Vec2{-x, y}, 0, 0},
          {journal + along * Vec2{x, y}, 1, 0},
          {journal + along * Vec2{-x, -y}, 2, 1},
          {journal + along * Vec2{x, -y}, 3, 1}};
}

std::vector<ContactCircle> find_circles(const PinInSlotClearance&, Vec2 journal) {
  return {{journal, 0, 0}, {journal, 0, 1}};
}

ContactSurfaces make_surfaces(const RevoluteClearance& joint, int) {
  return RevoluteSurfaces{joint.bearing_radius, joint.bearing_radius - joint.radial_clearance, {}, {}};
}

ContactSurfaces make_surfaces(const PrismaticClearance& joint, int bearing_surface) {
  return make_side(joint.direction, bearing_surface, 0.5 * joint.journal_height + joint.clearance, joint.bearing_length,
                   joint.corner_radius);
}

ContactSurfaces make_surfaces(const PinInSlotClearance& joint, int bearing_surface) {
  return make_side(joint.direction, bearing_surface, joint.journal_radius + joint.clearance, joint.bearing_length,
                   joint.journal_radius);
}

void compile_contacts(const Mechanism& mechanism, const Topology& topology, Tables& tables) {
  ContactCompiler compiler(topology, tables);
  for (int j = 0; j < static_cast<int>(mechanism.joints.size()); ++j) {
    std::visit(
        [&]<class Kind>(const Kind& kind) {
          if constexpr (ClearanceJoint<Kind>) compiler.add(j, kind);
        },
        mechanism.joints[j].kind);
  }
}

}  // namespace gudgeon
