// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// The textbook form that speed is measured against must be the same mechanism: its slopes against the engine's.
#include "bench/textbook/maximal_form.h"

#include <gtest/gtest.h>

#include "gudgeon/system/body_motion.h"
#include "tests/oracle/mechanisms.h"
#include "tests/oracle/same_state.h"

namespace gudgeon {
namespace {

// Relative difference that rounding of a well-conditioned dense solve explains.
constexpr double kFormTolerance = 1e-9;

std::vector<Mechanism> list_constant_mechanisms() {
  return {oracle::make_pendulum_chain(5),
          oracle::make_rigid_chain(),
          oracle::make_slider_crank(),
          oracle::make_four_bar(),
          oracle::make_five_bar(),
          oracle::make_n_four_bar(7),
          oracle::make_six_bar_slide(),
          oracle::make_two_slides(),
          oracle::make_driven_slide(),
          oracle::make_trammel(),
          oracle::make_slider_crank_clearance(),
          oracle::make_free_body_in_bearing(),
          oracle::make_nine_bar()};
}

// Accelerations of every body's centre, and the rate at which energy is put in and lost.
void expect_same_slopes(const Mechanism& mechanism, const oracle::SameState& state, textbook::SaddleSolver::Kind kind) {
  oracle::EngineAt engine(mechanism, state);
  engine.equations.eval(0.0, engine.y.data(), engine.slope.data());
  BodyMotionFinder finder(engine.system);
  const std::vector<BodyMotion>& motions = finder.update(engine.equations.workspace);

  textbook::MaximalForm form(mechanism, {}, kind);
  form.contact_modes = state.contact_modes;
  const std::vector<double> y = form.make_state(state.assembly.poses);
  std::vector<double> slope(form.size());
  form.eval(0.0, y.data(), slope.data());

  const double* accelerations = slope.data() + form.n_coordinates();
  double scale = 0.0;
  for (std::size_t k = 0; k < form.n_coordinates(); ++k) scale = std::max(scale, std::abs(accelerations[k]));
  for (std::size_t body = 1; body < motions.size(); ++body, accelerations += 3) {
    const std::string& name = mechanism.bodies[body].name;
    EXPECT_NEAR(accelerations[0], motions[body].acceleration.x, kFormTolerance * scale) << mechanism.name << name;
    EXPECT_NEAR(accelerations[1], motions[body].acceleration.y, kFormTolerance * scale) << mechanism.name << name;
    EXPECT_NEAR(accelerations[2], motions[body].angle_acceleration, kFormTolerance * scale) << mechanism.name << name;
  }

  const double* power = engine.slope.data() + engine.equations.n_states();
  const double work = power[kDriverWork] - power[kContactDamping] - power[kFrictionLoss];
  EXPECT_NEAR(slope[form.n_states()], work, kFormTolerance * (std::abs(power[kDriverWork]) + std::abs(work)))
      << mechanism.name;
}

TEST(MaximalForm, SlopesAreTheEngines) {
  for (const Mechanism& mechanism : list_constant_mechanisms()) {
    for (const auto kind : {textbook::SaddleSolver::Kind::dense, textbook::SaddleSolver::Kind::sparse}) {
      expect_same_slopes(mechanism, oracle::make_free_start(mechanism), kind);
      if (!oracle::make_free_start(mechanism).contact_modes.empty()) {
        expect_same_slopes(mechanism, oracle::make_pressed_start(mechanism), kind);
      }
    }
  }
}

TEST(MaximalForm, EnergyGoesWhereTheSlopesSay) {
  const Mechanism mechanism = oracle::make_nine_bar();
  const oracle::SameState state = oracle::make_pressed_start(mechanism);
  textbook::MaximalForm form(mechanism, {}, textbook::SaddleSolver::Kind::dense);
  form.contact_modes = state.contact_modes;
  const std::vector<double> y = form.make_state(state.assembly.poses);
  std::vector<double> slope(form.size());
  form.eval(0.0, y.data(), slope.data());
  const double h = 1e-9;  // [s] contact forces change within 1e-5 s
  const auto energy_after = [&](double time) {
    std::vector<double> moved = y;
    for (std::size_t k = 0; k < moved.size(); ++k) moved[k] += time * slope[k];
    return form.find_energy(time, moved.data());
  };
  const double rate = (energy_after(h) - energy_after(-h)) / (2.0 * h);
  // Energies of some 10 J known to 1e-14 of them over 2e-9 s.
  EXPECT_NEAR(rate, slope[form.n_states()], 1e-3 + 1e-5 * std::abs(rate));
}

TEST(MaximalForm, FeedbackPullsClosuresBack) {
  const Mechanism mechanism = oracle::make_four_bar();
  const Feedback feedback{3.0, 7.0};
  textbook::MaximalForm plain(mechanism, {}, textbook::SaddleSolver::Kind::dense);
  textbook::MaximalForm fed(mechanism, feedback, textbook::SaddleSolver::Kind::dense);
  std::vector<double> y = plain.make_state(assemble(mechanism).poses);
  y[0] += 1e-3;  // the crank's centre: its pivot is off by 1 mm along x
  y[plain.n_coordinates()] += 2e-3;
  std::vector<double> slope(plain.size()), fed_slope(plain.size());
  plain.eval(0.0, y.data(), slope.data());
  fed.eval(0.0, y.data(), fed_slope.data());
  // The pivot's acceleration: with the same rates, only −2 α φ̇ − β² φ is new.
  const std::size_t n = plain.n_coordinates();
  const double arm_y = std::sin(y[2]) * -0.047 + std::cos(y[2]) * -0.013;  // from the centre of mass to the pivot
  const double change = (fed_slope[n] - slope[n]) - arm_y * (fed_slope[n + 2] - slope[n + 2]);
  EXPECT_NEAR(change, -2.0 * 3.0 * 2e-3 - 49.0 * 1e-3, 1e-9);
}

TEST(MaximalForm, RefusesWhatItDoesNotKnow) {
  EXPECT_THROW(textbook::MaximalForm(oracle::make_press(), {}, textbook::SaddleSolver::Kind::dense),
               std::invalid_argument);
}

}  // namespace
}  // namespace gudgeon
