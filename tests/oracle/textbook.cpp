// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// The dense system and what its solution means, written out as a textbook has them.
#include "tests/oracle/textbook.h"

#include <algorithm>
#include <array>
#include <numbers>

#include "tests/oracle/textbook_contacts.h"
#include "tests/oracle/textbook_loads.h"

namespace gudgeon::oracle {

namespace {

using Point2 = TextbookPoint;

void add_force(Eigen::VectorXd& applied, int body, Vec2 arm, Vec2 force) {
  applied(3 * body) += force.x;
  applied(3 * body + 1) += force.y;
  applied(3 * body + 2) += cross(arm, force);
}

/// K x = b by a rank-revealing factorization of the equilibrated matrix, refined once.
Eigen::VectorXd solve_dense(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& right, int& rank) {
  Eigen::VectorXd scale = Eigen::VectorXd::Ones(matrix.rows());
  for (int pass = 0; pass < 10; ++pass) {
    const Eigen::MatrixXd scaled = scale.asDiagonal() * matrix * scale.asDiagonal();
    const Eigen::VectorXd largest = scaled.cwiseAbs().rowwise().maxCoeff();
    scale = scale.array() / (largest.array() > 0.0).select(largest.array().sqrt(), 1.0);
  }
  Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> factors;
  // positions assembled to 1e-12 leave redundant rows with pivots of that size
  factors.setThreshold(1e-10);
  factors.compute(scale.asDiagonal() * matrix * scale.asDiagonal());
  rank = static_cast<int>(factors.rank());
  const auto solve_scaled = [&](const Eigen::VectorXd& b) -> Eigen::VectorXd {
    return scale.asDiagonal() * Eigen::VectorXd(factors.solve(scale.asDiagonal() * b));
  };
  const Eigen::VectorXd x = solve_scaled(right);
  return x + solve_scaled(right - matrix * x);
}

}  // namespace

Textbook::Textbook(Mechanism mechanism) : mechanism_(std::move(mechanism)) {
  mechanism_.bodies.front().center_of_mass = {};  // the frame is placed by its origin
}

TextbookState Textbook::make_state() const {
  TextbookState state;
  state.bodies.resize(mechanism_.bodies.size());
  for (const Joint& joint : mechanism_.joints) state.contacts.resize(state.contacts.size() + n_contacts(joint.kind));
  return state;
}

TextbookBody Textbook::place(int body, Vec2 origin, double angle, Vec2 origin_velocity, double angle_rate) const {
  const Vec2 arm = make_rotation(angle) * mechanism_.bodies[body].center_of_mass;
  return {origin + arm, angle, origin_velocity + angle_rate * perp(arm), angle_rate};
}

TextbookPoint Textbook::eval_point(const TextbookState& state, const Anchor& anchor) const {
  const int index = find_body(mechanism_, anchor.body);
  const Body& body = mechanism_.bodies.at(index);
  const TextbookBody& motion = state.bodies.at(index);
  const Vec2 arm = make_rotation(motion.angle) * (find_point(body, anchor.point)->position - body.center_of_mass);
  return {index, arm, motion.center + arm, motion.velocity + motion.angle_rate * perp(arm)};
}

std::vector<TextbookContactForce> Textbook::eval_contacts(const TextbookState& state) const {
  return find_contacts(*this, state);
}

Eigen::VectorXd Textbook::make_masses() const {
  Eigen::VectorXd masses(3 * mechanism_.bodies.size());
  for (std::size_t body = 0; body < mechanism_.bodies.size(); ++body) {
    const Body& description = mechanism_.bodies[body];
    masses.segment<3>(3 * body) << description.mass, description.mass, description.inertia;
  }
  masses.head<3>().setZero();
  return masses;
}

Eigen::VectorXd Textbook::eval_applied(const TextbookState& state, const std::vector<TextbookContactForce>& contacts,
                                       const TextbookLoads& loads) const {
  Eigen::VectorXd applied = Eigen::VectorXd::Zero(3 * mechanism_.bodies.size());
  for (int body = 1; body < std::ssize(mechanism_.bodies); ++body) {
    add_force(applied, body, {}, mechanism_.bodies[body].mass * mechanism_.gravity);
  }
  for (const Load& load : mechanism_.loads) {
    if (const auto* force = std::get_if<ConstantForce>(&load.kind)) {
      const Point2 point = eval_point(state, force->point);
      add_force(applied, point.body, point.arm, force->force);
    } else if (const auto* torque = std::get_if<ConstantTorque>(&load.kind)) {
      applied(3 * find_body(mechanism_, torque->body) + 2) += torque->torque;
    }
  }
  for (const TextbookAction& action : loads.actions) {
    add_force(applied, action.body, action.at - state.bodies[action.body].center, action.force);
    applied(3 * action.body + 2) += action.moment;
  }
  for (const TextbookContactForce& contact : contacts) {
    const auto [bearing, journal] = anchors(mechanism_.joints[contact.joint].kind);
    const int bearing_body = find_body(mechanism_, bearing.body);
    const int journal_body = find_body(mechanism_, journal.body);
    add_force(applied, journal_body, contact.point - state.bodies[journal_body].center, contact.force);
    add_force(applied, bearing_body, contact.point - state.bodies[bearing_body].center, -contact.force);
  }
  return applied;
}

TextbookSolution Textbook::solve(const TextbookState& state, double time) const {
  TextbookSolution solution;
  const TextbookRows rows = eval_rows(state, time);
  solution.contacts = eval_contacts(state);
  solution.loads = find_loads(*this, state, time);
  const Eigen::VectorXd applied = eval_applied(state, solution.contacts, solution.loads);

  // [M Φqᵀ; Φq 0] [q̈; λ] = [Q; γ] without the frame's columns
  const Eigen::Index n = applied.size() - 3;
  const Eigen::Index m = rows.gamma.size();
  const Eigen::MatrixXd jacobian = rows.jacobian.rightCols(n);
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(n + m, n + m);
  matrix.topLeftCorner(n, n) = make_masses().tail(n).asDiagonal();
  matrix.topRightCorner(n, m) = jacobian.transpose();
  matrix.bottomLeftCorner(m, n) = jacobian;
  Eigen::VectorXd right(n + m);
  right << applied.tail(n), rows.gamma;

  int rank = 0;
  const Eigen::VectorXd unknowns = solve_dense(matrix, right, rank);
  solution.n_redundant_rows = static_cast<int>(n + m) - rank;
  solution.multipliers = unknowns.tail(m);
  solution.accelerations.emplace_back();
  for (Eigen::Index i = 0; i < n; i += 3) {
    solution.accelerations.push_back({{unknowns(i), unknowns(i + 1)}, unknowns(i + 2)});
  }
  find_reactions(state, rows, solution);
  return solution;
}

void Textbook::find_reactions(const TextbookState& state, const TextbookRows& rows, TextbookSolution& solution) const {
  int row = 0;
  for (int j = 0; j < std::ssize(mechanism_.joints); ++j) {
    const Joint& joint = mechanism_.joints[j];
    const Point2 second = eval_point(state, anchors(joint.kind).second);
    if (n_contacts(joint.kind) > 0) {
      TextbookReaction& reaction = solution.reactions.emplace_back();
      for (const TextbookContactForce& contact : solution.contacts) {
        if (contact.joint != j) continue;
        reaction.force += contact.force;
        reaction.moment += cross(contact.point - second.position, contact.force);
      }
      continue;
    }
    // −Φqᵀλ of the joint's rows is its generalized force; the second body's part is force and moment about its centre
    const int n = n_rows(joint.kind);
    const Eigen::Vector3d generalized =
        -rows.jacobian.block(row, 3 * second.body, n, 3).transpose() * solution.multipliers.segment(row, n);
    const Vec2 force{generalized(0), generalized(1)};
    solution.reactions.push_back({force, generalized(2) - cross(second.arm, force)});
    row += n;
  }
  // ∂Φ/∂value = −1, so −λ is the effort along the driven value
  for (std::size_t driver = 0; driver < mechanism_.drivers.size(); ++driver) {
    solution.efforts.push_back(-solution.multipliers(row++));
  }
}

TextbookEnergy Textbook::eval_energy(const TextbookState& state) const {
  TextbookEnergy energy;
  for (std::size_t i = 1; i < mechanism_.bodies.size(); ++i) {
    const Body& body = mechanism_.bodies[i];
    const TextbookBody& motion = state.bodies[i];
    energy.kinetic += 0.5 * body.mass * dot(motion.velocity, motion.velocity) +
                      0.5 * body.inertia * motion.angle_rate * motion.angle_rate;
    energy.potential -= body.mass * dot(mechanism_.gravity, motion.center);
  }
  for (const Load& load : mechanism_.loads) {
    if (const auto* force = std::get_if<ConstantForce>(&load.kind)) {
      energy.potential -= dot(force->force, eval_point(state, force->point).position);
    } else if (const auto* torque = std::get_if<ConstantTorque>(&load.kind)) {
      energy.potential -= torque->torque * state.bodies.at(find_body(mechanism_, torque->body)).angle;
    }
  }
  energy.potential += find_loads(*this, state, 0.0).stored_energy;  // springs do not ask for the time
  for (const TextbookContactForce& contact : eval_contacts(state)) energy.elastic += contact.elastic_energy;
  return energy;
}

TextbookState Textbook::step_rk4(const TextbookState& state, double time, double step) const {
  TextbookState end = state;
  TextbookState stage = state;
  constexpr std::array kNodes{0.0, 0.5, 0.5, 1.0};
  constexpr std::array kWeights{1.0 / 6.0, 1.0 / 3.0, 1.0 / 3.0, 1.0 / 6.0};
  for (std::size_t k = 0; k < kNodes.size(); ++k) {
    const TextbookSolution slope = solve(stage, time + kNodes[k] * step);
    const double ahead = k + 1 < kNodes.size() ? kNodes[k + 1] * step : 0.0;
    for (std::size_t i = 1; i < state.bodies.size(); ++i) {
      const TextbookBody rates = stage.bodies[i];
      const TextbookAcceleration& acceleration = slope.accelerations[i];
      const auto advance = [&](const TextbookBody& from, double by) {
        return TextbookBody{from.center + by * rates.velocity, from.angle + by * rates.angle_rate,
                            from.velocity + by * acceleration.center, from.angle_rate + by * acceleration.angle};
      };
      end.bodies[i] = advance(end.bodies[i], kWeights[k] * step);
      stage.bodies[i] = advance(state.bodies[i], ahead);
    }
  }
  return end;
}

}  // namespace gudgeon::oracle
