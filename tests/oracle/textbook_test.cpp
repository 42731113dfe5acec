// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// The oracle tested by itself on every mechanism: its Jacobian against finite differences, its forces by putting Newton
// and Euler together again, its energy against the work of the drivers.
#include "tests/oracle/textbook.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>

#include "tests/oracle/driver_motion.h"
#include "tests/oracle/mechanisms.h"
#include "tests/oracle/textbook_start.h"

namespace gudgeon::oracle {
namespace {

/// Every body but the frame anywhere.
TextbookState make_random_state(const Textbook& textbook, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  TextbookState state = textbook.make_state();
  for (std::size_t i = 1; i < state.bodies.size(); ++i) {
    const double angle = 3.0 * uniform(random);
    const Vec2 center{uniform(random), uniform(random)};
    state.bodies[i] = {center, angle, {uniform(random), uniform(random)}, 2.0 * uniform(random)};
  }
  return state;
}

double& coordinate(TextbookBody& body, int axis) {
  return axis == 0 ? body.center.x : axis == 1 ? body.center.y : body.angle;
}

/// The state a short time later, at constant rates.
TextbookState drift(TextbookState state, double time) {
  for (TextbookBody& body : state.bodies) {
    body.center += time * body.velocity;
    body.angle += time * body.angle_rate;
  }
  return state;
}

/// Sums forces and moments about the centre of mass of every body.
class Balance {
 public:
  Balance(const Textbook& textbook, const TextbookState& state)
      : textbook_(textbook), state_(state), left_(3 * state.bodies.size(), 0.0) {}

  void add(int body, Vec2 at, Vec2 force, double moment) {
    left_[3 * body] += force.x;
    left_[3 * body + 1] += force.y;
    left_[3 * body + 2] += cross(at - state_.bodies[body].center, force) + moment;
  }

  void add_reaction(const AnyJoint& joint, const TextbookReaction& reaction) {
    const auto [first, second] = anchors(joint);
    const Vec2 at = textbook_.eval_point(state_, second).position;
    add(find_body(textbook_.mechanism(), second.body), at, reaction.force, reaction.moment);
    add(find_body(textbook_.mechanism(), first.body), at, -reaction.force, -reaction.moment);
  }

  void add_effort(const Driver& driver, double effort) {
    const Mechanism& mechanism = textbook_.mechanism();
    if (const auto* angle = std::get_if<DrivenAngle>(&driver.target)) {
      add(find_body(mechanism, angle->against), {}, {}, -effort);
      return add(find_body(mechanism, angle->body), {}, {}, effort);
    }
    const int joint = find_joint(mechanism, std::get<DrivenSlide>(driver.target).joint);
    const auto& slide = std::get<Prismatic>(mechanism.joints[joint].kind);
    const double line = state_.bodies[find_body(mechanism, slide.first.body)].angle + slide.direction;
    add_reaction(slide, {effort * Vec2{std::cos(line), std::sin(line)}, 0.0});
  }

  void add_load(const Load& load) {
    if (const auto* force = std::get_if<ConstantForce>(&load.kind)) {
      const TextbookPoint point = textbook_.eval_point(state_, force->point);
      return add(point.body, point.position, force->force, 0.0);
    }
    if (const auto* torque = std::get_if<ConstantTorque>(&load.kind)) {
      add(find_body(textbook_.mechanism(), torque->body), {}, {}, torque->torque);
    }
  }

  /// The largest entry but for the frame's.
  [[nodiscard]] double find_largest() const {
    double largest = 0.0;
    for (std::size_t i = 3; i < left_.size(); ++i) largest = std::max(largest, std::abs(left_[i]));
    return largest;
  }

 private:
  const Textbook& textbook_;
  const TextbookState& state_;
  std::vector<double> left_;
};

/// What is left of Newton and Euler, from the reported forces alone.
double find_imbalance(const Textbook& textbook, const TextbookState& state, const TextbookSolution& solution) {
  const Mechanism& mechanism = textbook.mechanism();
  Balance balance(textbook, state);
  for (std::size_t i = 0; i < mechanism.joints.size(); ++i) {
    balance.add_reaction(mechanism.joints[i].kind, solution.reactions[i]);
  }
  for (std::size_t i = 0; i < mechanism.drivers.size(); ++i) {
    balance.add_effort(mechanism.drivers[i], solution.efforts[i]);
  }
  for (const Load& load : mechanism.loads) balance.add_load(load);
  for (const TextbookAction& action : solution.loads.actions) {
    balance.add(action.body, action.at, action.force, action.moment);
  }
  for (int i = 1; i < std::ssize(mechanism.bodies); ++i) {
    const Body& body = mechanism.bodies[i];
    const TextbookAcceleration& acceleration = solution.accelerations[i];
    balance.add(i, state.bodies[i].center, body.mass * (mechanism.gravity - acceleration.center),
                -body.inertia * acceleration.angle);
  }
  return balance.find_largest();
}

class EveryMechanism : public testing::TestWithParam<Mechanism> {};

TEST_P(EveryMechanism, HasTheJacobianOfItsConstraints) {
  const Textbook textbook(GetParam());
  for (unsigned seed = 0; seed < 5; ++seed) {
    const TextbookState state = make_random_state(textbook, seed);
    const TextbookRows rows = textbook.eval_rows(state, 0.3);
    for (Eigen::Index column = 0; column < rows.jacobian.cols(); ++column) {
      constexpr double kStep = 1e-5;  // truncation and rounding both near 1e-10
      TextbookState ahead = state;
      TextbookState behind = state;
      coordinate(ahead.bodies[column / 3], static_cast<int>(column % 3)) += kStep;
      coordinate(behind.bodies[column / 3], static_cast<int>(column % 3)) -= kStep;
      const Eigen::VectorXd slope =
          (textbook.eval_rows(ahead, 0.3).residual - textbook.eval_rows(behind, 0.3).residual) / (2.0 * kStep);
      const Eigen::VectorXd error = slope - rows.jacobian.col(column);
      EXPECT_TRUE(error.size() == 0 || error.cwiseAbs().maxCoeff() < 1e-8) << "column " << column;
    }
  }
}

TEST_P(EveryMechanism, HasTheRatesAndAccelerationTermsOfItsConstraints) {
  const Textbook textbook(GetParam());
  for (unsigned seed = 0; seed < 5; ++seed) {
    constexpr double kStep = 1e-5;
    const TextbookState state = make_random_state(textbook, seed);
    const TextbookRows rows = textbook.eval_rows(state, 0.3);
    const TextbookRows ahead = textbook.eval_rows(drift(state, kStep), 0.3 + kStep);
    const TextbookRows behind = textbook.eval_rows(drift(state, -kStep), 0.3 - kStep);
    if (rows.rate.size() == 0) continue;
    // Φ̈ at q̈ = 0 is −γ
    EXPECT_LT(((ahead.residual - behind.residual) / (2.0 * kStep) - rows.rate).cwiseAbs().maxCoeff(), 1e-8);
    EXPECT_LT(((ahead.rate - behind.rate) / (2.0 * kStep) + rows.gamma).cwiseAbs().maxCoeff(), 1e-7);
  }
}

TEST_P(EveryMechanism, StartsWithAllIdealJointsClosed) {
  const Textbook ideal(make_ideal(GetParam()));
  const TextbookState start = find_start(GetParam());
  const TextbookRows rows = ideal.eval_rows(start, 0.0);
  EXPECT_LT(rows.residual.lpNorm<Eigen::Infinity>(), 1e-12);
  EXPECT_LT(rows.rate.lpNorm<Eigen::Infinity>(), 1e-9);
  for (std::size_t i = 1; i < start.bodies.size(); ++i) {
    const BodyStart& given = GetParam().bodies[i].start;
    EXPECT_NEAR(start.bodies[i].angle, given.angle.value_or(start.bodies[i].angle), 0.05) << GetParam().bodies[i].name;
    EXPECT_NEAR(start.bodies[i].angle_rate, given.angle_rate.value_or(start.bodies[i].angle_rate), 1e-9);
  }
}

TEST_P(EveryMechanism, BalancesEveryBodyWithTheForcesReported) {
  const Textbook textbook(GetParam());
  const TextbookState state = make_pressed_state(textbook.mechanism());
  const TextbookSolution solution = textbook.solve(state, 0.0);
  double scale = 1.0;
  for (const TextbookReaction& reaction : solution.reactions) scale = std::max(scale, norm(reaction.force));
  EXPECT_LT(textbook.eval_rows(state, 0.0).residual.lpNorm<Eigen::Infinity>(), 1e-12);
  EXPECT_LT(textbook.eval_rows(state, 0.0).rate.lpNorm<Eigen::Infinity>(), 1e-9);
  EXPECT_LT(find_imbalance(textbook, state, solution), 1e-11 * scale);
  std::map<int, double> pressed;  // by joint: of a slot, the corners or the side that it faces
  for (const TextbookContactForce& contact : solution.contacts) pressed[contact.joint] += contact.normal_force;
  for (const auto& [joint, force] : pressed) EXPECT_GT(force, 100.0) << textbook.mechanism().joints[joint].name;
}

TEST_P(EveryMechanism, GainsTheEnergyThatDriversAndLoadsDeliver) {
  const Mechanism ideal = make_ideal(GetParam());
  const Textbook textbook(ideal);
  const TextbookState start = find_start(ideal);
  double power = 0.0;
  const TextbookSolution solution = textbook.solve(start, 0.0);
  power += solution.loads.work_power - solution.loads.damper_power;
  for (std::size_t i = 0; i < ideal.drivers.size(); ++i)
    power += solution.efforts[i] * eval_motion(ideal.drivers[i], 0.0).rate;
  // a fortieth of a millisecond: about 0.01 rad of the fastest driver
  constexpr double kStep = 2.5e-5;
  const double before = textbook.eval_energy(textbook.step_rk4(start, 0.0, -kStep)).total();
  const double after = textbook.eval_energy(textbook.step_rk4(start, 0.0, kStep)).total();
  EXPECT_NEAR((after - before) / (2.0 * kStep), power, 1e-3 + 1e-3 * std::abs(power));
}

std::string find_name(const testing::TestParamInfo<Mechanism>& entry) {
  return entry.param.name + "_" + std::to_string(entry.index);
}

INSTANTIATE_TEST_SUITE_P(Oracle, EveryMechanism, testing::ValuesIn(make_all_mechanisms()), find_name);
INSTANTIATE_TEST_SUITE_P(OracleWithLoads, EveryMechanism, testing::ValuesIn(make_loaded_mechanisms()), find_name);

}  // namespace
}  // namespace gudgeon::oracle
