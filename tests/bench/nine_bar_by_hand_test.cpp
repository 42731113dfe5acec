// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// The hand-written press must be the same press: its accelerations against the engine's.
#include <gtest/gtest.h>

#include <random>

#include "bench/hand_written/nine_bar.h"
#include "tests/oracle/mechanisms.h"
#include "tests/oracle/same_state.h"

namespace gudgeon {
namespace {

// Relative difference that rounding of a five by five solve explains.
constexpr double kHandTolerance = 1e-10;

// At the state and at states some micrometres beside it, where closures do not hold but both take them as they are.
void expect_same_press(const oracle::SameState& state) {
  using hand_written::NineBar;
  const Mechanism mechanism = oracle::make_nine_bar();
  oracle::EngineAt engine(mechanism, state);
  NineBar press{state.contact_modes[0], state.contact_modes[1]};
  std::mt19937 random(7);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  for (int draw = 0; draw < 20; ++draw) {
    const double time = 1e-5 * draw;
    for (std::size_t i = 0; i < engine.equations.n_free(); ++i) engine.y[i] += 1e-6 * uniform(random);
    for (std::size_t i = 0; i < engine.equations.n_free(); ++i) engine.y[5 + i] += 0.3 * uniform(random);
    engine.equations.eval(time, engine.y.data(), engine.slope.data());
    double y[10], slope[10];
    std::vector<double> expected;
    double scale = 0.0;
    for (int i = 0; i < NineBar::kCoordinates; ++i) {
      const BodyNode& node = engine.system.topology.bodies[find_body(mechanism, NineBar::kBodies[i])];
      y[i] = engine.y[node.turn] + node.offset;
      y[5 + i] = engine.y[5 + node.turn];
      expected.push_back(engine.slope[5 + node.turn]);
      scale = std::max(scale, std::abs(expected.back()));
    }
    press.eval(time, y, slope);
    for (int i = 0; i < NineBar::kCoordinates; ++i) {
      EXPECT_EQ(slope[i], y[5 + i]);
      EXPECT_NEAR(slope[5 + i], expected[i], kHandTolerance * scale) << NineBar::kBodies[i] << " at draw " << draw;
    }
  }
}

TEST(NineBarByHand, InFlight) { expect_same_press(oracle::make_free_start(oracle::make_nine_bar())); }

TEST(NineBarByHand, InContact) {
  oracle::SameState state = oracle::make_pressed_start(oracle::make_nine_bar());
  expect_same_press(state);
  state.contact_modes[0] = {};
  expect_same_press(state);
}

}  // namespace
}  // namespace gudgeon
