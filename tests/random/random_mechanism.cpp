// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// A tree first, then what closes it, drives it and loads it.
#include "tests/random/random_mechanism.h"

#include <fmt/format.h>

#include <numbers>
#include <utility>
#include <vector>

#include "tests/oracle/textbook.h"
#include "tests/random/random_curves.h"
#include "tests/random/random_draw.h"
#include "tests/random/random_drivers.h"
#include "tests/random/random_loads.h"

namespace gudgeon::random {

namespace {

struct Place {
  Vec2 origin;
  double angle = 0.0;
};

/// Of every joint of a mechanism, so that its sums can be told.
enum class Wear { none, by_distance, by_friction };

ContactProperties make_contact(Wear wear, Draw& draw) {
  const Material steel{"steel", draw.scaled(20e9, 200e9), 0.3};
  ContactProperties contact{"rubbing", steel, steel, LankaraniNikravesh{draw.between(0.6, 0.95), 1.5}, Frictionless{}};
  if (draw.with_chance(0.3)) contact.normal_force = Hertz{1.5};
  if (draw.with_chance(0.5)) contact.friction = CoulombSmooth{.kinetic_coefficient = draw.between(0.05, 0.2)};
  const double coefficient = draw.scaled(1e-13, 1e-11);
  if (wear == Wear::by_distance) contact.bearing_wear = contact.journal_wear = Archard{coefficient};
  if (wear == Wear::by_friction) contact.bearing_wear = contact.journal_wear = EnergyWear{coefficient};
  return contact;
}

Study make_study(Family family) {
  Study study;
  study.cycle_time = 0.1;
  study.cycles = 1;
  study.outputs_per_cycle = 20;
  study.cells = 100;
  study.compare_ideal = false;
  study.wear_stages = family == Family::clearances ? 1 : 0;
  study.wear_acceleration = 10.0;
  // Impacts of a tenth of a second exchange so little that at the default tolerance some energy balances miss their
  // bound.
  study.relative_tolerance = family == Family::clearances ? 1e-8 : 1e-9;
  study.absolute_tolerance = family == Family::clearances ? 1e-11 : 1e-12;
  return study;
}

/// Puts a mechanism together. Every joint is made where its bodies are: it is closed there.
class Builder {
 public:
  Builder(Family family, std::uint64_t seed) : family_(family), draw_(8 * seed + static_cast<std::uint64_t>(family)) {
    model_.study = make_study(family);
    mechanism_.name = fmt::format("{}_{}", name_family(family), seed);
    mechanism_.gravity = draw_.with_chance(0.8) ? draw_.vector(5.0, 10.0) : Vec2{};
    mechanism_.bodies.push_back({kFrameName, 0.0, 0.0, {}, {}, {}});
    places_.push_back({});
  }

  RandomModel build() {
    wear_ = static_cast<Wear>(draw_.below(3));
    const int n_bodies = 1 + draw_.below(family_ == Family::clearances ? 4 : 6);
    for (int i = 0; i < n_bodies; ++i) grow();
    if (family_ != Family::trees && family_ != Family::clearances) close_loops();
    if (family_ == Family::clearances && draw_.with_chance(0.4)) close_loops();
    if (family_ == Family::redundant) add_redundancy();
    if (draw_.with_chance(find_chance_of_driver())) model_.can_move = add_driver(mechanism_, make_pose(), draw_);
    if (family_ == Family::trees) throw_bodies();
    if (draw_.with_chance(find_chance_of_loads())) add_loads(mechanism_, draw_);
    if (family_ == Family::curves) add_curves(model_, draw_);
    if (family_ == Family::steps) add_jump(model_, draw_);
    return std::move(model_);
  }

 private:
  [[nodiscard]] double find_chance_of_driver() const {
    switch (family_) {
      case Family::driven:
        return 1.0;
      case Family::clearances:
        return 0.5;
      case Family::redundant:
      case Family::curves:
        return 0.3;
      default:
        return 0.0;
    }
  }

  [[nodiscard]] double find_chance_of_loads() const {
    if (family_ == Family::loads) return 1.0;
    return family_ == Family::clearances || family_ == Family::curves ? 0.0 : 0.3;
  }

  [[nodiscard]] Body& body(int index) { return mechanism_.bodies[static_cast<std::size_t>(index)]; }
  [[nodiscard]] int n_bodies() const { return static_cast<int>(mechanism_.bodies.size()); }

  /// A new point of a body, where it lies in the frame.
  Anchor add_point(int index, Vec2 where) {
    const Place& place = places_[static_cast<std::size_t>(index)];
    Body& owner = body(index);
    const std::string name = fmt::format("P{}", owner.points.size());
    owner.points.push_back({name, make_rotation(-place.angle) * (where - place.origin)});
    return {owner.name, name};
  }

  int add_body(Vec2 origin) {
    const double angle = draw_.angle();
    const double mass = draw_.scaled(0.1, 3.0);
    const double radius = draw_.between(0.05, 0.2);
    Body made{fmt::format("b{}", n_bodies()), mass, mass * radius * radius, draw_.vector(0.0, 0.12), {}, {}};
    made.start.angle = angle;
    mechanism_.bodies.push_back(made);
    places_.push_back({origin, angle});
    return n_bodies() - 1;
  }

  std::string name_joint() const { return fmt::format("J{}", mechanism_.joints.size()); }

  void pin(int a, int b, Vec2 where) {
    mechanism_.joints.push_back({name_joint(), Revolute{add_point(a, where), add_point(b, where)}});
  }

  void weld(int a, int b, Vec2 where) {
    mechanism_.joints.push_back({name_joint(), Rigid{add_point(a, where), add_point(b, where), angle_between(a, b)}});
  }

  [[nodiscard]] double angle_between(int a, int b) const {
    return places_[static_cast<std::size_t>(b)].angle - places_[static_cast<std::size_t>(a)].angle;
  }

  void guide(int a, int b, Vec2 where, double direction, double displacement) {
    const Vec2 along{std::cos(direction), std::sin(direction)};
    const double local = direction - places_[static_cast<std::size_t>(a)].angle;
    mechanism_.joints.push_back({name_joint(), Prismatic{add_point(a, where - displacement * along),
                                                         add_point(b, where),
                                                         local,
                                                         angle_between(a, b),
                                                         {displacement, std::nullopt}}});
  }

  void slot(int a, int b, Vec2 where, double direction, double displacement) {
    const Vec2 along{std::cos(direction), std::sin(direction)};
    const double local = direction - places_[static_cast<std::size_t>(a)].angle;
    mechanism_.joints.push_back(
        {name_joint(), PinInSlot{add_point(a, where - displacement * along), add_point(b, where), local}});
  }

  void bear(int a, int b, Vec2 where) {
    const double radius = draw_.between(5e-3, 20e-3);
    mechanism_.joints.push_back(
        {name_joint(),
         RevoluteClearance{add_point(a, where), add_point(b, where), radius, draw_.scaled(2e-3, 5e-2) * radius,
                           draw_.between(10e-3, 30e-3), make_contact(wear_, draw_)}});
  }

  void bear_block(int a, int b, Vec2 where) {
    const double direction = draw_.angle();
    const double height = draw_.between(0.02, 0.05);
    mechanism_.joints.push_back(
        {name_joint(),
         PrismaticClearance{add_point(a, where), add_point(b, where),
                            direction - places_[static_cast<std::size_t>(a)].angle, angle_between(a, b), 2.0,
                            draw_.between(0.06, 0.12), height, 0.2 * height, draw_.scaled(1e-4, 1e-3),
                            draw_.between(10e-3, 30e-3), make_contact(wear_, draw_)}});
  }

  void bear_pin(int a, int b, Vec2 where) {
    const double direction = draw_.angle();
    mechanism_.joints.push_back(
        {name_joint(),
         PinInSlotClearance{add_point(a, where), add_point(b, where),
                            direction - places_[static_cast<std::size_t>(a)].angle, 2.0, draw_.between(5e-3, 15e-3),
                            draw_.scaled(1e-4, 1e-3), draw_.between(10e-3, 30e-3), make_contact(wear_, draw_)}});
  }

  /// One more body on one that is there.
  void grow() {
    const int parent = draw_.with_chance(0.4) ? 0 : draw_.below(n_bodies());
    const Vec2 where = places_[static_cast<std::size_t>(parent)].origin + draw_.vector(0.1, 0.4);
    const int child = add_body(where + draw_.vector(0.1, 0.3));
    const int kind = draw_.below(10);
    if (family_ == Family::clearances && (child == 1 || kind < 4)) {
      if (kind % 4 == 0) return bear_block(parent, child, where);
      if (kind % 4 != 1) return bear(parent, child, where);
      body(child).start.position = places_[static_cast<std::size_t>(child)].origin;
      return bear_pin(parent, child, where);
    }
    if (kind < 6) return pin(parent, child, where);
    if (kind < 8) return guide(parent, child, where, draw_.angle(), draw_.between(-0.2, 0.2));
    if (kind < 9) return weld(parent, child, where);
    // A pin in a slot leaves its body the way along the slot and the turn: both are where they are put.
    body(child).start.position = places_[static_cast<std::size_t>(child)].origin;
    slot(parent, child, where, draw_.angle(), draw_.between(-0.1, 0.1));
  }

  /// How many ways to move the tree has, less what closes it.
  [[nodiscard]] int count_freedoms() const {
    int freedoms = 3 * (n_bodies() - 1);
    for (const Joint& joint : mechanism_.joints) {
      if (has_clearance(joint.kind)) continue;
      freedoms -=
          std::holds_alternative<Rigid>(joint.kind) ? 3 : (std::holds_alternative<PinInSlot>(joint.kind) ? 1 : 2);
    }
    return freedoms;
  }

  [[nodiscard]] bool are_joined(int a, int b) {
    for (const Joint& joint : mechanism_.joints) {
      const auto [first, second] = anchors(joint.kind);
      const bool forth = first.body == body(a).name && second.body == body(b).name;
      const bool back = second.body == body(a).name && first.body == body(b).name;
      if (forth || back) return true;
    }
    return false;
  }

  /// Joints between bodies that have none, while at least one freedom is left.
  void close_loops() {
    for (int tries = 0; tries < 6; ++tries) {
      const int a = draw_.below(n_bodies());
      const int b = 1 + draw_.below(n_bodies() - 1);
      const bool with_slot = draw_.with_chance(0.35);
      if (a == b || are_joined(a, b) || count_freedoms() - (with_slot ? 1 : 2) < 1) continue;
      const Vec2 middle =
          0.5 * (places_[static_cast<std::size_t>(a)].origin + places_[static_cast<std::size_t>(b)].origin);
      const Vec2 where = middle + draw_.vector(0.0, 0.2);
      with_slot ? slot(a, b, where, draw_.angle(), draw_.between(-0.1, 0.1)) : pin(a, b, where);
    }
  }

  /// What is held already, held once more: two bodies pinned twice, a guide beside a guide, a third crank of a
  /// parallelogram, a weld beside a weld.
  void add_redundancy() {
    const int kind = draw_.below(4);
    const int parent = draw_.with_chance(0.5) ? 0 : draw_.below(n_bodies());
    const Vec2 where = places_[static_cast<std::size_t>(parent)].origin + draw_.vector(0.2, 0.4);
    if (kind == 3) return add_cranks(parent, where);
    const int child = add_body(where + draw_.vector(0.1, 0.3));
    const Vec2 beside = where + draw_.vector(0.05, 0.3);
    if (kind == 0) {
      pin(parent, child, where);
      pin(parent, child, beside);
    } else if (kind == 1) {
      const double direction = draw_.angle();
      guide(parent, child, where, direction, 0.05);
      guide(parent, child, beside, direction, -0.08);
    } else {
      weld(parent, child, where);
      weld(parent, child, beside);
    }
    // Something hangs on it, so that it carries.
    const int last = add_body(beside + draw_.vector(0.1, 0.3));
    pin(child, last, beside + draw_.vector(0.05, 0.1));
  }

  void add_cranks(int parent, Vec2 where) {
    const Vec2 arm = draw_.vector(0.08, 0.2);
    const int coupler = add_body(where + arm + draw_.vector(0.0, 0.2));
    const int n_cranks = 3 + draw_.below(2);
    for (int i = 0; i < n_cranks; ++i) {
      const Vec2 foot = where + draw_.vector(0.05, 0.4);
      const int crank = add_body(foot);
      pin(parent, crank, foot);
      pin(crank, coupler, foot + arm);
    }
  }

  /// Where the bodies were put, at rest.
  [[nodiscard]] oracle::TextbookState make_pose() const {
    const oracle::Textbook textbook(mechanism_);
    oracle::TextbookState pose = textbook.make_state();
    for (std::size_t b = 1; b < places_.size(); ++b) {
      pose.bodies[b] = textbook.place(static_cast<int>(b), places_[b].origin, places_[b].angle, {}, 0.0);
    }
    return pose;
  }

  /// Rates of what is free in a tree: turns of pinned bodies, and slides.
  void throw_bodies() {
    for (Joint& joint : mechanism_.joints) {
      if (const auto* hinge = std::get_if<Revolute>(&joint.kind)) {
        body(find_body(mechanism_, hinge->second.body)).start.angle_rate = draw_.between(-5.0, 5.0);
      }
      if (auto* slide = std::get_if<Prismatic>(&joint.kind)) slide->start.speed = draw_.between(-0.5, 0.5);
    }
  }

  Family family_;
  Draw draw_;
  Wear wear_ = Wear::none;
  RandomModel model_;
  Mechanism& mechanism_ = model_.mechanism;
  std::vector<Place> places_;
};

}  // namespace

const char* name_family(Family family) {
  static constexpr const char* kNames[] = {"trees", "loops",  "driven", "redundant",
                                           "loads", "curves", "steps",  "clearances"};
  return kNames[static_cast<int>(family)];
}

RandomModel make_model(Family family, std::uint64_t seed) { return Builder(family, seed).build(); }

}  // namespace gudgeon::random
