// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// From the description to bodies, constraints and matrix entries by number, once.
#include <stdexcept>

#include "bench/textbook/maximal_form.h"

namespace gudgeon::textbook {

namespace {

BodyPoint resolve(const Mechanism& mechanism, const Anchor& anchor) {
  const int body = find_body(mechanism, anchor.body);
  const Vec2 position = gudgeon::find_point(mechanism.bodies[body], anchor.point)->position;
  return {body, body == 0 ? position : position - mechanism.bodies[body].center_of_mass};
}

// A body by its centre of mass.
BodyPoint resolve_body(const Mechanism& mechanism, const std::string& name) { return {find_body(mechanism, name), {}}; }

[[noreturn]] void refuse(const char* what) { throw std::invalid_argument(what); }

}  // namespace

MaximalForm::MaximalForm(const Mechanism& mechanism, Feedback feedback, SaddleSolver::Kind solver)
    : mechanism_(mechanism),
      feedback_(feedback),
      n_bodies_(static_cast<int>(mechanism.bodies.size()) - 1),
      constant_load_(n_coordinates(), 0.0),
      center_(mechanism.bodies.size()),
      velocity_(mechanism.bodies.size()),
      angle_(mechanism.bodies.size(), 0.0),
      angle_rate_(mechanism.bodies.size(), 0.0),
      rotation_(mechanism.bodies.size()) {
  for (const Joint& joint : mechanism_.joints) add_joint(joint.kind);
  for (const Driver& driver : mechanism_.drivers) add_driver(driver);
  for (int body = 1; body <= n_bodies_; ++body) {
    constant_load_[3 * body - 3] = mechanism_.bodies[body].mass * mechanism_.gravity.x;
    constant_load_[3 * body - 2] = mechanism_.bodies[body].mass * mechanism_.gravity.y;
  }
  for (const Load& load : mechanism_.loads) add_load(load.kind);

  const System system = compile(mechanism_, assemble(mechanism_));
  n_bristles_ = static_cast<std::size_t>(system.tables.n_bristles);
  for (const Contact& contact : system.tables.contacts) {
    const auto [bearing, journal] = anchors(mechanism_.joints[contact.joint].kind);
    pairs_.push_back({contact, resolve(mechanism_, bearing), resolve(mechanism_, journal)});
  }
  contact_modes.resize(pairs_.size());
  contact_forces.resize(pairs_.size());
  number_entries(solver);
}

void MaximalForm::add_joint(const AnyJoint& joint) {
  if (std::holds_alternative<RevoluteClearance>(joint)) return;
  using Kind = Constraint::Kind;
  const BodyPoint first = resolve(mechanism_, anchors(joint).first);
  const BodyPoint second = resolve(mechanism_, anchors(joint).second);
  if (const auto* slide = std::get_if<Prismatic>(&joint)) {
    const double across = slide->direction + std::acos(0.0);
    constraints_.push_back({Kind::line, first, second, across});
    constraints_.push_back({Kind::angle, first, second, 0.0, slide->relative_angle});
  } else if (const auto* slot = std::get_if<PinInSlot>(&joint)) {
    constraints_.push_back({Kind::line, first, second, slot->direction + std::acos(0.0)});
  } else if (const auto* rigid = std::get_if<Rigid>(&joint)) {
    constraints_.push_back({Kind::point, first, second});
    constraints_.push_back({Kind::angle, first, second, 0.0, rigid->relative_angle});
  } else if (std::holds_alternative<Revolute>(joint)) {
    constraints_.push_back({Kind::point, first, second});
  } else {
    refuse("textbook form: a joint of a kind it does not know");
  }
}

void MaximalForm::add_driver(const Driver& driver) {
  if (!driver.is_uniform()) refuse("textbook form: a driver that is not uniform");
  if (const auto* angle = std::get_if<DrivenAngle>(&driver.target)) {
    constraints_.push_back({Constraint::Kind::angle, resolve_body(mechanism_, angle->against),
                            resolve_body(mechanism_, angle->body), 0.0, driver.start, driver.speed});
  } else {
    const int joint = find_joint(mechanism_, std::get<DrivenSlide>(driver.target).joint);
    const auto& slide = std::get<Prismatic>(mechanism_.joints[joint].kind);
    constraints_.push_back({Constraint::Kind::line, resolve(mechanism_, slide.first), resolve(mechanism_, slide.second),
                            slide.direction, driver.start, driver.speed});
  }
  driver_speeds_.push_back(driver.speed);
}

void MaximalForm::add_load(const AnyLoad& load) {
  if (const auto* force = std::get_if<ConstantForce>(&load)) {
    forces_.push_back({resolve(mechanism_, force->point), force->force});
  } else if (const auto* torque = std::get_if<ConstantTorque>(&load)) {
    const int body = find_body(mechanism_, torque->body);
    if (body > 0) constant_load_[3 * body - 1] += torque->torque;
  } else {
    refuse("textbook form: a load that is not constant");
  }
}

// Entries in the order in which an evaluation writes them; those that never change are set here.
void MaximalForm::number_entries(SaddleSolver::Kind solver) {
  std::vector<SaddleSolver::Place> places;
  std::vector<std::pair<SaddleSolver::Place, double>> constants;
  const auto column = [](const BodyPoint& point, int component) {
    return point.body == 0 ? -1 : 3 * (point.body - 1) + component;
  };
  int row = 0;
  for (const Constraint& constraint : constraints_) {
    const BodyPoint& first = constraint.first;
    const BodyPoint& second = constraint.second;
    if (constraint.kind == Constraint::Kind::point) {
      for (const BodyPoint& point : {second, first}) {
        for (int k = 0; k < 2; ++k) places.push_back({row + k, column(point, 2)});
      }
      for (int k = 0; k < 2; ++k) {
        constants.push_back({{row + k, column(second, k)}, 1.0});
        constants.push_back({{row + k, column(first, k)}, -1.0});
      }
      row += 2;
      continue;
    }
    if (constraint.kind == Constraint::Kind::line) {
      for (const BodyPoint& point : {second, first}) {
        for (int k = 0; k < 3; ++k) places.push_back({row, column(point, k)});
      }
    } else {
      constants.push_back({{row, column(second, 2)}, 1.0});
      constants.push_back({{row, column(first, 2)}, -1.0});
    }
    ++row;
  }
  for (std::size_t k = 0; k < driver_speeds_.size(); ++k) {  // drivers have one row each and come last
    driver_rows_.push_back(static_cast<int>(n_coordinates() + k) + row - static_cast<int>(driver_speeds_.size()));
  }
  std::vector<double> masses;
  for (int body = 1; body <= n_bodies_; ++body) {
    const Body& description = mechanism_.bodies[body];
    masses.insert(masses.end(), {description.mass, description.mass, description.inertia});
  }
  const std::size_t n_changing = places.size();
  for (const auto& [place, value] : constants) places.push_back(place);
  solver_.prepare(solver, masses, row, places);
  for (std::size_t k = 0; k < constants.size(); ++k) solver_.set(n_changing + k, constants[k].second);
}

std::vector<double> MaximalForm::make_state(std::span<const BodyPose> poses) const {
  std::vector<double> y(size(), 0.0);
  double* q = y.data();
  for (int body = 1; body <= n_bodies_; ++body, q += 3) {
    const BodyPose& pose = poses[body];
    const Vec2 arm = make_rotation(pose.angle) * mechanism_.bodies[body].center_of_mass;
    const Vec2 center = pose.position + arm;
    const Vec2 velocity = pose.velocity + pose.angle_rate * perp(arm);
    std::ranges::copy(std::array{center.x, center.y, pose.angle}, q);
    std::ranges::copy(std::array{velocity.x, velocity.y, pose.angle_rate}, q + n_coordinates());
  }
  return y;
}

}  // namespace gudgeon::textbook
