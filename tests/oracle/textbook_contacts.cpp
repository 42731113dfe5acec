// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Where circles overlap bearings and sides, how fast, and what that does.
#include "tests/oracle/textbook_contacts.h"

#include <algorithm>
#include <limits>
#include <numbers>

namespace gudgeon::oracle {

namespace {

using Point2 = TextbookPoint;

/// σᵢ + σⱼ, σ = (1 − ν²)/(π E)
double find_compliance(const ContactProperties& contact) {
  const auto sigma = [](const Material& material) {
    return (1.0 - material.poisson_ratio * material.poisson_ratio) / (std::numbers::pi * material.young_modulus);
  };
  return sigma(contact.bearing_material) + sigma(contact.journal_material);
}

/// What a joint's contact needs beside its geometry.
struct Pair {
  const ContactProperties& properties;
  double bearing_radius;
  double journal_radius;
  double relative_radius;
  double width;
};

class ContactFinder {
 public:
  ContactFinder(const Textbook& textbook, const TextbookState& state) : textbook_(textbook), state_(state) {}

  void add(int joint, const auto&) { joint_ = joint; }

  /// δ = |e| − c along the line of centres
  void add(int j, const RevoluteClearance& joint) {
    joint_ = j;
    const Point2 bearing = textbook_.eval_point(state_, joint.bearing);
    const Point2 journal = textbook_.eval_point(state_, joint.journal);
    const double radius = joint.bearing_radius - joint.radial_clearance;
    const Vec2 e = journal.position - bearing.position;
    const Vec2 n = norm(e) > 0.0 ? (1.0 / norm(e)) * e : Vec2{};
    const Pair pair{joint.contact, joint.bearing_radius, radius,
                    joint.bearing_radius * radius / (joint.bearing_radius - radius), joint.width};
    add_contact(pair, bearing, journal, n, norm(e) - joint.radial_clearance,
                dot(n, journal.velocity - bearing.velocity));
  }

  void add(int j, const PrismaticClearance& joint) {
    joint_ = j;
    const double x = 0.5 * joint.journal_length - joint.corner_radius;
    const double y = 0.5 * joint.journal_height - joint.corner_radius;
    const double half_height = 0.5 * joint.journal_height + joint.clearance;
    const Pair pair{joint.contact, std::numeric_limits<double>::infinity(), joint.corner_radius, joint.corner_radius,
                    joint.width};
    for (const double side : {1.0, -1.0}) {
      for (const double end : {-1.0, 1.0}) {
        const Point2 corner = find_corner(joint.journal, joint.direction - joint.relative_angle, {end * x, side * y});
        add_side(pair, textbook_.eval_point(state_, joint.bearing), joint.direction, side, half_height, corner);
      }
    }
  }

  void add(int j, const PinInSlotClearance& joint) {
    joint_ = j;
    const Pair pair{joint.contact, std::numeric_limits<double>::infinity(), joint.journal_radius, joint.journal_radius,
                    joint.width};
    for (const double side : {1.0, -1.0}) {
      add_side(pair, textbook_.eval_point(state_, joint.bearing), joint.direction, side,
               joint.journal_radius + joint.clearance, textbook_.eval_point(state_, joint.journal));
    }
  }

  std::vector<TextbookContactForce> contacts;

 private:
  /// A point of the journal's body, given from its anchor in axes turned by `turned`.
  Point2 find_corner(const Anchor& anchor, double turned, Vec2 local) const {
    Point2 point = textbook_.eval_point(state_, anchor);
    const TextbookBody& body = state_.bodies[point.body];
    const double angle = body.angle + turned;
    const Vec2 reach{std::cos(angle) * local.x - std::sin(angle) * local.y,
                     std::sin(angle) * local.x + std::cos(angle) * local.y};
    point.arm += reach;
    point.position += reach;
    point.velocity += body.angle_rate * perp(reach);
    return point;
  }

  /// The point of the wall under the circle's centre, fixed to the slot's body, and how far the rim is past it.
  void add_side(const Pair& pair, const Point2& bearing, double direction, double side, double half_height,
                const Point2& circle) {
    const double angle = state_.bodies[bearing.body].angle + direction;
    const Vec2 n = side * Vec2{-std::sin(angle), std::cos(angle)};
    const Vec2 along{std::cos(angle), std::sin(angle)};
    const Vec2 wall = bearing.position + half_height * n + dot(circle.position - bearing.position, along) * along;
    const Vec2 wall_velocity =
        bearing.velocity + state_.bodies[bearing.body].angle_rate * perp(wall - bearing.position);
    add_contact(pair, bearing, circle, n, dot(n, circle.position - wall) + pair.journal_radius,
                dot(n, circle.velocity - wall_velocity));
  }

  void add_contact(const Pair& pair, const Point2& bearing, const Point2& journal, Vec2 n, double penetration,
                   double penetration_rate) {
    TextbookContactForce& contact = contacts.emplace_back();
    const TextbookContact& mode = state_.contacts.at(contacts.size() - 1);
    const double compliance = find_compliance(pair.properties);
    contact.joint = joint_;
    contact.normal = n;
    contact.penetration = penetration;
    contact.penetration_rate = penetration_rate;
    // K = 4/(3π(σᵢ + σⱼ)) √R
    contact.stiffness = 4.0 / (3.0 * std::numbers::pi * compliance) * std::sqrt(pair.relative_radius);
    // material points of both bodies at Q
    const Vec2 t = perp(n);
    contact.point = journal.position + (pair.journal_radius - 0.5 * penetration) * n;
    const auto velocity_at_point = [&](const Point2& center) {
      return center.velocity + state_.bodies[center.body].angle_rate * perp(contact.point - center.position);
    };
    contact.slip_speed = dot(t, velocity_at_point(journal) - velocity_at_point(bearing));
    if (!mode.in_contact || !(penetration > 0.0)) return;

    const double onset_speed = std::max(mode.onset_speed, pair.properties.onset_speed_floor);
    const double damping_factor =
        std::visit([](const auto& law) { return law.damping_factor(); }, pair.properties.normal_force);
    const NormalContact input{penetration,         penetration_rate, onset_speed,
                              contact.stiffness,   damping_factor,   pair.bearing_radius,
                              pair.journal_radius, pair.width,       1.0 / (std::numbers::pi * compliance)};
    const NormalForce normal = std::visit([&](const auto& law) { return law(input); }, pair.properties.normal_force);
    const double mu = std::visit([&](const auto& law) { return law(FrictionContact{contact.slip_speed}).coefficient; },
                                 pair.properties.friction);
    contact.normal_force = normal.force;
    contact.elastic_energy = normal.elastic_energy;
    contact.friction_force = -mu * normal.force;
    contact.force = contact.friction_force * t - contact.normal_force * n;
  }

  const Textbook& textbook_;
  const TextbookState& state_;
  int joint_ = 0;
};

}  // namespace

int n_contacts(const AnyJoint& joint) {
  if (std::holds_alternative<PrismaticClearance>(joint)) return 4;
  if (std::holds_alternative<PinInSlotClearance>(joint)) return 2;
  return std::holds_alternative<RevoluteClearance>(joint) ? 1 : 0;
}

std::vector<TextbookContactForce> find_contacts(const Textbook& textbook, const TextbookState& state) {
  ContactFinder finder(textbook, state);
  const std::vector<Joint>& joints = textbook.mechanism().joints;
  for (int j = 0; j < std::ssize(joints); ++j) {
    std::visit([&](const auto& kind) { finder.add(j, kind); }, joints[j].kind);
  }
  return std::move(finder.contacts);
}

}  // namespace gudgeon::oracle
