// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// The hand-written slider-crank must be the same one: its accelerations and gap against the engine's.
#include "bench/hand_written/slider_crank.h"

#include <gtest/gtest.h>

#include <array>

#include "tests/oracle/mechanisms.h"
#include "tests/oracle/same_state.h"

namespace gudgeon {
namespace {

// Relative difference that rounding explains: the penetration is a difference of lengths a thousand times as long.
constexpr double kSliderTolerance = 1e-10;

void expect_same_slider(double friction, bool in_contact) {
  Mechanism mechanism = oracle::make_slider_crank_clearance();
  for (Joint& joint : mechanism.joints) {
    auto* clearance = std::get_if<RevoluteClearance>(&joint.kind);
    if (clearance != nullptr && friction > 0.0) clearance->contact.friction = CoulombSmooth{friction, 1e-3};
  }
  const oracle::SameState state =
      in_contact ? oracle::make_pressed_start(mechanism) : oracle::make_free_start(mechanism);
  oracle::EngineAt engine(mechanism, state);
  hand_written::SliderCrank by_hand(friction);
  by_hand.contact_modes = state.contact_modes;
  const BodyNode& rod = engine.system.topology.bodies[find_body(mechanism, "rod")];
  ASSERT_EQ(engine.equations.n_free(), 2U) << "rod's angle and slide";
  for (int draw = 0; draw < 10; ++draw) {
    engine.y[0] += 1e-7 * draw;
    engine.y[1] -= 2e-7 * draw;
    engine.y[2] += 0.3 * draw;
    engine.equations.eval(0.0, engine.y.data(), engine.slope.data());
    const std::array y{engine.y[rod.turn] + rod.offset, engine.y[1 - rod.turn], engine.y[2 + rod.turn],
                       engine.y[3 - rod.turn]};
    std::array<double, 4> slope{};
    by_hand.eval(0.0, y.data(), slope.data());
    const double scale = std::max(std::abs(engine.slope[2]), std::abs(engine.slope[3]));
    EXPECT_NEAR(slope[2], engine.slope[2 + rod.turn], kSliderTolerance * scale);
    EXPECT_NEAR(slope[3], engine.slope[3 - rod.turn], kSliderTolerance * scale);
    std::array<textbook::GapSample, 1> gaps;
    by_hand.find_gaps(0.0, y.data(), gaps);
    Workspace& at = engine.equations.workspace;
    update_point_motions(engine.system.tables, at);
    const Contact& pin = engine.system.tables.contacts[0];
    const ContactGap gap = find_gap(pin.surfaces, find_contact_motion(pin, at));
    EXPECT_NEAR(gaps[0].penetration, gap.penetration, 1e-15);
    EXPECT_NEAR(gaps[0].penetration_rate, gap.penetration_rate, 1e-10);
  }
}

TEST(SliderCrankByHand, InFlight) { expect_same_slider(0.0, false); }
TEST(SliderCrankByHand, InContact) { expect_same_slider(0.0, true); }
TEST(SliderCrankByHand, WithFriction) { expect_same_slider(0.1, true); }

}  // namespace
}  // namespace gudgeon
