// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Guess along the joints, Newton on Φ, then one least-squares solution for the velocities.
#include "tests/oracle/textbook_start.h"

#include <algorithm>
#include <optional>
#include <stdexcept>

#include "tests/oracle/driver_motion.h"

namespace gudgeon::oracle {

namespace {

/// The angle a body is guessed to have: its driver's or its own.
std::optional<double> guess_angle(const Mechanism& mechanism, const Body& body) {
  for (const Driver& driver : mechanism.drivers) {
    const auto* target = std::get_if<DrivenAngle>(&driver.target);
    const bool drives = target != nullptr && target->body == body.name && target->against == kFrameName;
    if (drives) return eval_motion(driver, 0.0).value;
  }
  return body.start.angle;
}

double guess_displacement(const Mechanism& mechanism, const Joint& joint) {
  for (const Driver& driver : mechanism.drivers) {
    const auto* target = std::get_if<DrivenSlide>(&driver.target);
    if (target != nullptr && target->joint == joint.name) return eval_motion(driver, 0.0).value;
  }
  const auto* slide = std::get_if<Prismatic>(&joint.kind);
  return slide == nullptr ? 0.0 : slide->start.displacement.value_or(0.0);
}

std::optional<double> find_relative_angle(const AnyJoint& joint) {
  if (const auto* slide = std::get_if<Prismatic>(&joint)) return slide->relative_angle;
  if (const auto* rigid = std::get_if<Rigid>(&joint)) return rigid->relative_angle;
  return std::nullopt;
}

struct RelativeAngle {
  int first;
  int second;
  double angle;
};

/// Angles between bodies that joints and drivers ask for at the start.
std::vector<RelativeAngle> find_relative_angles(const Mechanism& mechanism) {
  std::vector<RelativeAngle> relatives;
  for (const Joint& joint : mechanism.joints) {
    const auto [first, second] = anchors(joint.kind);
    if (const auto angle = find_relative_angle(joint.kind)) {
      relatives.push_back({find_body(mechanism, first.body), find_body(mechanism, second.body), *angle});
    }
  }
  for (const Driver& driver : mechanism.drivers) {
    const auto* target = std::get_if<DrivenAngle>(&driver.target);
    if (target == nullptr) continue;
    relatives.push_back(
        {find_body(mechanism, target->against), find_body(mechanism, target->body), eval_motion(driver, 0.0).value});
  }
  return relatives;
}

/// Every body's guessed angle; what has none takes it from the body it keeps a relative angle with, or is at zero.
std::vector<double> guess_angles(const Mechanism& mechanism) {
  std::vector<std::optional<double>> angles;
  for (const Body& body : mechanism.bodies) angles.push_back(guess_angle(mechanism, body));
  angles[0] = 0.0;
  for (bool changed = true; changed;) {
    changed = false;
    for (const RelativeAngle& relative : find_relative_angles(mechanism)) {
      std::optional<double>& first = angles[relative.first];
      std::optional<double>& second = angles[relative.second];
      if (first.has_value() == second.has_value()) continue;
      if (first) {
        second = *first + relative.angle;
      } else {
        first = *second - relative.angle;
      }
      changed = true;
    }
  }
  std::vector<double> values;
  for (const std::optional<double>& angle : angles) values.push_back(angle.value_or(0.0));
  return values;
}

/// Places the one body of a joint that has no place yet at its guessed angle, so that the joint is closed.
void place_across(const Textbook& textbook, const Joint& joint, bool first_is_placed, TextbookState& state) {
  const Mechanism& mechanism = textbook.mechanism();
  const auto [first, second] = anchors(joint.kind);
  const int placed = find_body(mechanism, first_is_placed ? first.body : second.body);
  const int moving = find_body(mechanism, first_is_placed ? second.body : first.body);
  const Body& body = mechanism.bodies.at(moving);
  const double angle = state.bodies[moving].angle;

  // the second anchor lies displaced along the line in the first body's axes
  Vec2 target = textbook.eval_point(state, first_is_placed ? first : second).position;
  if (const auto* slide = std::get_if<Prismatic>(&joint.kind)) {
    const double line = (first_is_placed ? state.bodies[placed].angle : angle) + slide->direction;
    const double displacement = guess_displacement(mechanism, joint);
    target += (first_is_placed ? displacement : -displacement) * Vec2{std::cos(line), std::sin(line)};
  }
  const Vec2 local = find_point(body, first_is_placed ? second.point : first.point)->position;
  state.bodies[moving] = textbook.place(moving, target - make_rotation(angle) * local, angle, {}, 0.0);
}

TextbookState guess_positions(const Textbook& textbook) {
  const Mechanism& mechanism = textbook.mechanism();
  TextbookState state = textbook.make_state();
  std::vector<bool> placed(mechanism.bodies.size(), false);
  placed[0] = true;
  const std::vector<double> angles = guess_angles(mechanism);
  for (int i = 1; i < std::ssize(mechanism.bodies); ++i) {
    const std::optional<Vec2> position = mechanism.bodies[i].start.position;
    placed[i] = position.has_value();
    state.bodies[i] = textbook.place(i, position.value_or(Vec2{}), angles[i], {}, 0.0);
  }
  for (bool changed = true; changed;) {
    changed = false;
    for (const Joint& joint : mechanism.joints) {
      const int first = find_body(mechanism, anchors(joint.kind).first.body);
      const int second = find_body(mechanism, anchors(joint.kind).second.body);
      if (placed[first] == placed[second]) continue;
      place_across(textbook, joint, placed[first], state);
      placed[first] = placed[second] = changed = true;
    }
  }
  return state;
}

Eigen::VectorXd solve_least(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& right) {
  Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> factors;
  factors.setThreshold(1e-8);  // close to a solution, redundant rows differ by the closure error only
  factors.compute(matrix);
  return factors.solve(right);
}

/// Closes the joints but for the gaps, one a constraint row.
void close_positions(const Textbook& textbook, const Eigen::VectorXd& gaps, TextbookState& state) {
  for (int iteration = 0; iteration < 50; ++iteration) {
    const TextbookRows rows = textbook.eval_rows(state, 0.0);
    if (rows.residual.size() == 0) return;
    const Eigen::VectorXd error = rows.residual - gaps;
    if (iteration > 3 && error.lpNorm<Eigen::Infinity>() < 1e-12) return;
    const Eigen::MatrixXd jacobian = rows.jacobian.rightCols(rows.jacobian.cols() - 3);
    const Eigen::VectorXd change = solve_least(jacobian, -error);
    for (std::size_t i = 1; i < state.bodies.size(); ++i) {
      state.bodies[i].center += Vec2{change(3 * i - 3), change(3 * i - 2)};
      state.bodies[i].angle += change(3 * i - 1);
    }
  }
  throw std::runtime_error("oracle: joints of " + textbook.mechanism().name + " do not close");
}

/// Linear conditions on the rates, row by row.
struct RateConditions {
  Eigen::MatrixXd matrix;
  Eigen::VectorXd right;

  Eigen::Index add_row(double value) {
    const Eigen::Index row = right.size();
    matrix.conservativeResize(row + 1, Eigen::NoChange);
    matrix.row(row).setZero();
    right.conservativeResize(row + 1);
    right(row) = value;
    return row;
  }
};

/// The start rates that the description gives, as conditions.
void add_start_rates(const Textbook& textbook, const TextbookState& state, RateConditions& conditions) {
  const Mechanism& mechanism = textbook.mechanism();
  for (int i = 1; i < std::ssize(mechanism.bodies); ++i) {
    const BodyStart& start = mechanism.bodies[i].start;
    if (start.angle_rate) conditions.matrix(conditions.add_row(*start.angle_rate), 3 * i + 2) = 1.0;
    if (!start.velocity) continue;
    const Vec2 arm = make_rotation(state.bodies[i].angle) * mechanism.bodies[i].center_of_mass;
    for (const auto& [axis, value] :
         {std::pair{Vec2{1.0, 0.0}, start.velocity->x}, {Vec2{0.0, 1.0}, start.velocity->y}}) {
      const Eigen::Index row = conditions.add_row(value);
      conditions.matrix.row(row).segment<3>(3 * i) << axis.x, axis.y, -dot(axis, perp(arm));
    }
  }
  // a slide's start speed is the row that a driver of that slide would have
  for (const Joint& joint : mechanism.joints) {
    const auto* slide = std::get_if<Prismatic>(&joint.kind);
    if (slide == nullptr || !slide->start.speed) continue;
    Mechanism driven = mechanism;
    driven.drivers.assign(1, Driver{"start", DrivenSlide{joint.name}});
    const TextbookRows rows = Textbook(driven).eval_rows(state, 0.0);
    conditions.matrix.row(conditions.add_row(*slide->start.speed)) = rows.jacobian.bottomRows<1>();
  }
}

void find_velocities(const Textbook& textbook, const Eigen::VectorXd& gap_rates, TextbookState& state) {
  const TextbookRows rows = textbook.eval_rows(state, 0.0);
  RateConditions conditions{rows.jacobian, gap_rates - rows.time_rate};
  add_start_rates(textbook, state, conditions);
  if (conditions.right.size() == 0) return;
  const Eigen::MatrixXd matrix = conditions.matrix.rightCols(conditions.matrix.cols() - 3);
  const Eigen::VectorXd rates = solve_least(matrix, conditions.right);
  if ((matrix * rates - conditions.right).norm() > 1e-9 * (1.0 + conditions.right.norm())) {
    throw std::runtime_error("oracle: start rates of " + textbook.mechanism().name + " conflict");
  }
  for (std::size_t i = 1; i < state.bodies.size(); ++i) {
    state.bodies[i].velocity = {rates(3 * i - 3), rates(3 * i - 2)};
    state.bodies[i].angle_rate = rates(3 * i - 1);
  }
}

/// The rows of the ideal mechanism, with the clearance joints' numbers in theirs and zero in all others.
Eigen::VectorXd make_gaps(const Mechanism& mechanism, const std::vector<Vec2>& vectors) {
  const Mechanism ideal = make_ideal(mechanism);
  const Textbook textbook(ideal);
  Eigen::VectorXd gaps = Eigen::VectorXd::Zero(textbook.eval_rows(textbook.make_state(), 0.0).residual.size());
  Eigen::Index row = 0;
  auto vector = vectors.begin();
  for (std::size_t i = 0; i < mechanism.joints.size(); ++i) {
    if (find_contact(mechanism.joints[i].kind) != nullptr) {
      const double both[2] = {vector->x, vector->y};
      for (int k = 0; k < n_rows(ideal.joints[i].kind); ++k) gaps(row + k) = both[k];
      ++vector;
    }
    row += n_rows(ideal.joints[i].kind);
  }
  return gaps;
}

}  // namespace

TextbookState find_start(const Mechanism& mechanism, const std::vector<Eccentricity>& eccentricities) {
  const Textbook ideal(make_ideal(mechanism));
  const std::vector<TextbookContact> contacts = Textbook(mechanism).make_state().contacts;
  const auto is_clearance = [](const Joint& joint) { return find_contact(joint.kind) != nullptr; };
  std::vector<Vec2> vectors(std::ranges::count_if(mechanism.joints, is_clearance));
  std::vector<Vec2> rates(vectors.size());
  for (std::size_t i = 0; i < eccentricities.size(); ++i) {
    vectors.at(i) = eccentricities[i].vector;
    rates.at(i) = eccentricities[i].rate;
  }
  TextbookState state = guess_positions(ideal);
  close_positions(ideal, make_gaps(mechanism, vectors), state);
  find_velocities(ideal, make_gaps(mechanism, rates), state);
  state.contacts = contacts;
  return state;
}

TextbookState make_pressed_state(const Mechanism& mechanism) {
  std::vector<Eccentricity> eccentricities;
  for (const Joint& joint : mechanism.joints) {
    if (find_contact(joint.kind) == nullptr) continue;
    const double depth = find_clearance(joint.kind) + 8e-6 + 3e-6 * static_cast<double>(eccentricities.size());
    if (std::holds_alternative<RevoluteClearance>(joint.kind)) {
      eccentricities.push_back({depth * Vec2{0.6, -0.8}, {0.03, -0.11}});
    } else {
      eccentricities.push_back({{depth, 2e-5}, {0.09, 0.4}});  // to the left, and a block a little tilted
    }
  }
  TextbookState state = find_start(mechanism, eccentricities);
  for (TextbookContact& contact : state.contacts) contact = {true, 0.05};
  return state;
}

}  // namespace gudgeon::oracle
