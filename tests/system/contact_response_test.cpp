// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// The contacts' part of the Jacobian against differences of the accelerations.
#include "gudgeon/system/contact_response.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/oracle/mechanisms.h"
#include "tests/oracle/same_state.h"
#include "tests/sim/flying_ball.h"

namespace gudgeon {
namespace {

// A mechanism with all its contacts pressing, evaluated.
struct Pressed {
  explicit Pressed(const Mechanism& mechanism) : Pressed(mechanism, oracle::make_pressed_start(mechanism)) {}
  Pressed(const Mechanism& mechanism, const oracle::SameState& state)
      : at(mechanism, state), n(static_cast<Eigen::Index>(at.equations.n_free())) {
    // So slow a slip that friction turns.
    for (Eigen::Index i = 0; i < n; ++i) at.y[n + i] *= 1e-3;
    at.equations.eval(0.0, at.y.data(), at.slope.data());
  }

  [[nodiscard]] Eigen::VectorXd accelerations() const {
    return Eigen::Map<const Eigen::VectorXd>(at.slope.data() + n, n);
  }
  // Pressures over eccentricities [N/m] are what turning normals add to the stiffness; times what a force of 1 N does
  // to these mechanisms: some 10 m/s^2, or rad/s^2 a lever of 0.1 m.
  [[nodiscard]] double find_turning() const {
    double sum = 0.0;
    for (const ContactForces& forces : at.equations.workspace.contact_forces) {
      sum += 30.0 * forces.normal_force / (forces.gap.bearing_radius - forces.gap.journal_radius);
    }
    return sum;
  }
  // ∂a/∂v [1/s], or ∂a/∂q [1/s^2], by central differences.
  Eigen::MatrixXd find_slopes(bool by_rates) {
    // Against friction that turns within 0.1 mm/s, and micrometres of penetration.
    const double step = by_rates ? 1e-7 : 1e-10;
    Eigen::MatrixXd slopes(n, n);
    const std::vector<double> y = at.y;
    for (Eigen::Index i = 0; i < n; ++i) {
      const auto look = [&](double sign) {
        at.y = y;
        at.y[i + (by_rates ? n : 0)] += sign * step;
        at.equations.eval(0.0, at.y.data(), at.slope.data());
        return accelerations();
      };
      slopes.col(i) = look(1.0) - look(-1.0);
    }
    at.y = y;
    at.equations.eval(0.0, at.y.data(), at.slope.data());
    return slopes / (2.0 * step);
  }

  oracle::EngineAt at;
  Eigen::Index n;
};

class PressedContacts : public testing::TestWithParam<Pressed (*)()> {};

Pressed press_nine_bar() { return Pressed(oracle::make_nine_bar()); }

Pressed press_slider_crank_with_friction() {
  Mechanism mechanism = oracle::make_slider_crank_clearance();
  mechanism.drivers.front().speed = 1.0;
  for (Joint& joint : mechanism.joints) {
    if (auto* clearance = std::get_if<RevoluteClearance>(&joint.kind)) {
      clearance->contact.friction = CoulombSmooth{0.1, 1e-3};
    }
  }
  return Pressed(mechanism);
}

// Each in its own bearing, at rest but for a slow slip.
Pressed press_balls(int n, double young_modulus, const AnyFriction& friction) {
  std::vector<BallFlight> flights;
  for (int k = 0; k < n; ++k) flights.push_back({{kBallClearance + 1e-6 * (k + 1), 0.0}, {0.0, 0.1}});
  Mechanism mechanism = make_balls(flights, {}, young_modulus);
  for (Joint& joint : mechanism.joints) std::get<RevoluteClearance>(joint.kind).contact.friction = friction;
  oracle::SameState state = oracle::make_free_start(mechanism);
  for (ContactMode& mode : state.contact_modes) mode = {true, 0.1};
  return {mechanism, state};
}

// More contacts than matrices of a fixed size are made for.
Pressed press_ten_balls() { return press_balls(10, 1e14, CoulombSmooth{0.1, 1e-3}); }

TEST_P(PressedContacts, CorrectAsTheWholeJacobianWould) {
  Pressed pressed = GetParam()();
  ContactResponse response(pressed.at.system.tables);
  response.update(pressed.at.equations.workspace);
  const Eigen::VectorXd residual = Eigen::VectorXd::LinSpaced(pressed.n, 1.0, -0.7);
  const Eigen::MatrixXd by_rates = pressed.find_slopes(true);
  const Eigen::MatrixXd by_coordinates = pressed.find_slopes(false);
  // From where friction alone is stiff to where pressures are as well.
  for (const double tau : {1e-7, 1e-6, 1e-5, 5e-5}) {
    const Eigen::MatrixXd system =
        Eigen::MatrixXd::Identity(pressed.n, pressed.n) - tau * by_rates - tau * tau * by_coordinates;
    const Eigen::VectorXd expected = system.partialPivLu().solve(residual);
    Eigen::VectorXd corrected = residual;
    response.weigh(tau, pressed.at.equations.contact_modes, pressed.at.equations.workspace);
    response.correct(corrected.data());
    // What is not in it: how normals turn as journals move along, and the mechanism's own rates.
    const double turning = tau * tau * pressed.find_turning();
    EXPECT_LT((corrected - expected).norm(), (1e-5 + 100.0 * tau + turning) * residual.norm()) << tau;
    if (tau < 1e-5) continue;
    EXPECT_GT((expected - residual).norm(), 0.1 * residual.norm()) << "nothing to correct";
  }
}

TEST_P(PressedContacts, TellTheFastestRates) {
  Pressed pressed = GetParam()();
  ContactResponse response(pressed.at.system.tables);
  response.update(pressed.at.equations.workspace);
  const ContactRates rates = response.find_rates(pressed.at.equations.contact_modes, pressed.at.equations.workspace);
  const double rate = std::max(rates.decay, rates.swing);
  // Of the motion [q̇ v̇] = [0 1; ∂a/∂q ∂a/∂v] [q v].
  const Eigen::Index n = pressed.n;
  Eigen::MatrixXd motion = Eigen::MatrixXd::Zero(2 * n, 2 * n);
  motion.topRightCorner(n, n).setIdentity();
  motion.bottomLeftCorner(n, n) = pressed.find_slopes(false);
  motion.bottomRightCorner(n, n) = pressed.find_slopes(true);
  const double fastest = motion.eigenvalues().cwiseAbs().maxCoeff();
  // One direction at a time is looked at, so that several that pull at one body are told too slow by some.
  EXPECT_LT(rate, 1.3 * fastest);
  EXPECT_GT(rate, 0.5 * fastest);
}

INSTANTIATE_TEST_SUITE_P(ContactResponse, PressedContacts,
                         testing::Values(press_nine_bar, press_slider_crank_with_friction, press_ten_balls));

// A ball on a Hertzian spring swings with √(1.5 F/(δ m)).
TEST(ContactResponse, TellsTheSwingOfABallFromItsSlip) {
  Pressed pressed = press_balls(1, 1e9, Frictionless{});
  ContactResponse response(pressed.at.system.tables);
  response.update(pressed.at.equations.workspace);
  const ContactForces& forces = pressed.at.equations.workspace.contact_forces.front();
  const ContactRates rates = response.find_rates(pressed.at.equations.contact_modes, pressed.at.equations.workspace);
  const double swing = std::sqrt(1.5 * forces.normal_force / (forces.gap.penetration * 2.0));
  EXPECT_NEAR(rates.swing, swing, 1e-5 * swing);
  EXPECT_EQ(rates.decay, 0.0) << "neither damped nor rubbed";
}

TEST(ContactResponse, LeavesAMotionWithoutContactsAlone) {
  const Mechanism mechanism = oracle::make_nine_bar();
  oracle::EngineAt at(mechanism, oracle::make_free_start(mechanism));
  at.equations.eval(0.0, at.y.data(), at.slope.data());
  ContactResponse response(at.system.tables);
  response.update(at.equations.workspace);
  response.weigh(1e-5, at.equations.contact_modes, at.equations.workspace);
  std::vector<double> residual(at.equations.n_free(), 2.0);
  response.correct(residual.data());
  for (const double value : residual) EXPECT_EQ(value, 2.0);
  const ContactRates rates = response.find_rates(at.equations.contact_modes, at.equations.workspace);
  EXPECT_EQ(rates.decay, 0.0);
  EXPECT_EQ(rates.swing, 0.0);
}

}  // namespace
}  // namespace gudgeon
