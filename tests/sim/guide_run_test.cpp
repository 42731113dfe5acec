// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Runs of slots: the same bits again, stages on what those before left, events of corners and sides.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <future>
#include <numbers>
#include <set>

#include "gudgeon/sim/run_study.h"
#include "tests/oracle/mechanism_parts.h"
#include "tests/oracle/mechanisms.h"

namespace gudgeon {
namespace {

Study make_slot_study() {
  Study study;
  study.cycle_time = 0.25;
  study.cycles = 1;
  study.outputs_per_cycle = 50;
  study.wear_stages = 1;
  study.wear_acceleration = 1e4;
  study.cells = 120;
  return study;
}

// Without gravity a block is thrown to all of its corners, a driven pin to both of its sides.
Mechanism make_loose_slider() {
  Mechanism mechanism = oracle::make_slider_crank_guide();
  mechanism.gravity = {};
  mechanism.drivers[0].speed = 40.0;
  return mechanism;
}

Mechanism make_loose_yoke() {
  Mechanism mechanism = oracle::make_scotch_yoke_clearance();
  mechanism.gravity = {};
  mechanism.drivers.push_back({"motor", DrivenAngle{"crank"}, 0.8, 25.0});
  return mechanism;
}

// A pin of 10 kg that a carriage drags to and fro in its slot: F = m g, and every cell that it passes n times is worn
// by h = n k_d F/w, whatever the cells and however long the steps.
TEST(GuideRun, EveryCellOfASlotIsWornByItsPasses) {
  Mechanism mechanism = oracle::make_empty("dragged_pin", {0.0, -9.81}, {{"slot", {0.0, 0.0}}});
  mechanism.bodies.push_back({"carriage", 1.0, 0.1, {}, {{"middle", {0.0, 0.0}}}, {}});
  mechanism.bodies.push_back({"pin", 10.0, 0.1, {}, {{"middle", {0.0, 0.0}}}, {}});
  mechanism.joints.push_back({"rail", oracle::make_slide({kFrameName, "slot"}, {"carriage", "middle"}, 0.0, 0.0, 0.0)});
  mechanism.joints.push_back(
      {"post", oracle::make_slide({"carriage", "middle"}, {"pin", "middle"}, 0.5 * std::numbers::pi, 0.0, 0.0)});
  ContactProperties contact;
  contact.bearing_material = contact.journal_material = {"steel", 200e9, 0.3};
  contact.normal_force = KelvinVoigt{1e7, 1e5};
  contact.friction = Frictionless{};
  contact.bearing_wear = Archard{1e-13};
  mechanism.joints.push_back(
      {"slot", PinInSlotClearance{{kFrameName, "slot"}, {"pin", "middle"}, 0.0, 0.3, 8e-3, 5e-5, 0.02, contact}});
  mechanism.drivers.push_back({"drag", DrivenSlide{"rail"}, 0.0, 0.0, Expression{"0.1 * sin(2 * pi * t)", {}}});
  for (const int n_cells : {100, 1000, 100000}) {
    Study study;
    study.cycle_time = 1.0;
    study.warm_up_cycles = 1;
    study.cycles = 2;
    study.outputs_per_cycle = 10;
    study.cells = n_cells;
    study.compare_ideal = false;
    const auto stages = run_study(mechanism, study);
    ASSERT_EQ(stages.at(0).status, StageStatus::finished) << stages[0].message;
    const JointWear& wear = stages[0].wear.at(0);
    const double expected = 4.0 * 1e-13 * 98.1 / 0.02;
    const double arc = std::sqrt(98.1 / 1e7 * 2.0 * 8e-3);
    const double cell = 0.3 / n_cells;
    int n_compared = 0;
    for (int k = 0; k < n_cells; ++k) {
      const double position = (k + 0.5) * cell - 0.15;
      EXPECT_EQ(wear.bearing_depth_added[k], 0.0) << "the left side";
      if (std::abs(position) + 0.5 * cell > 0.1 - arc) continue;
      ++n_compared;
      EXPECT_NEAR(wear.bearing_depth_added[n_cells + k] / expected, 1.0, 0.02) << position << " of " << n_cells;
    }
    EXPECT_GT(n_compared, n_cells / 2);
    EXPECT_NEAR(wear.removed_volume / (8.0 * 0.1 * 1e-13 * 98.1), 1.0, 1e-4);
  }
}

TEST(GuideRun, HasTheSameBitsOnAnyThreadAndAfterAResume) {
  for (const Mechanism& mechanism : {make_loose_slider(), make_loose_yoke()}) {
    const auto whole = run_study(mechanism, make_slot_study());
    ASSERT_EQ(whole.size(), 3U);
    for (const StageRecord& stage : whole) ASSERT_EQ(stage.status, StageStatus::finished) << stage.message;
    auto other = std::async(std::launch::async, [&] { return run_study(mechanism, make_slot_study()); });
    const auto resumed = run_study(mechanism, make_slot_study(), {}, {whole[0], whole[1]});
    const auto again = other.get();
    for (std::size_t s = 0; s < whole.size(); ++s) {
      EXPECT_EQ(again[s].values, whole[s].values) << mechanism.name;
      EXPECT_EQ(resumed[s].values, whole[s].values) << mechanism.name;
    }
    EXPECT_EQ(resumed[2].wear.at(0).bearing_depth_added, whole[2].wear.at(0).bearing_depth_added);
    EXPECT_EQ(resumed[2].wear.at(0).journal_depth_added, whole[2].wear.at(0).journal_depth_added);
  }
}

TEST(GuideRun, EveryStageRunsOnWhatTheOneBeforeLeft) {
  for (const auto& [mechanism, n_corners] :
       {std::pair{make_loose_slider(), std::size_t{4}}, {make_loose_yoke(), std::size_t{1}}}) {
    const auto stages = run_study(mechanism, make_slot_study());
    const JointWear& before = stages.at(1).wear.at(0);
    const JointWear& after = stages.at(2).wear.at(0);
    ASSERT_EQ(before.bearing_depth.size(), 2U * 120U) << "two sides";
    ASSERT_EQ(before.journal_depth.size(), n_corners * 120U);
    EXPECT_EQ(before.n_cells(), 120U);
    EXPECT_GT(before.slot_length, 0.0);
    EXPECT_NEAR(before.removed_volume / before.archard_volume, 1.0, 1e-9) << "rounding of many increments";
    for (std::size_t k = 0; k < after.bearing_depth.size(); ++k) {
      EXPECT_EQ(after.bearing_depth[k], before.bearing_depth[k] + before.bearing_depth_added[k]);
    }
    for (std::size_t k = 0; k < after.journal_depth.size(); ++k) {
      EXPECT_EQ(after.journal_depth[k], before.journal_depth[k] + before.journal_depth_added[k]);
    }
    const auto worn = [](const std::vector<double>& depths, std::size_t surface, std::size_t n) {
      const auto first = depths.begin() + static_cast<std::ptrdiff_t>(surface * n);
      return *std::max_element(first, first + static_cast<std::ptrdiff_t>(n));
    };
    for (std::size_t side = 0; side < 2; ++side) EXPECT_GT(worn(before.bearing_depth_added, side, 120), 0.0) << side;
    for (std::size_t c = 0; c < n_corners; ++c) EXPECT_GT(worn(before.journal_depth_added, c, 120), 0.0) << c;
    EXPECT_NE(*find_values(stages[1], mechanism.joints[0].name + ".x_force"),
              *find_values(stages[2], mechanism.joints[0].name + ".x_force"))
        << "worn surfaces are felt";
  }
}

// Each corner has a bristle of its own; both integrators, stiff and explicit, keep the energy balance.
// Cells far finer than a contact show the steps in which wear was distributed, unless their waves are left out: a stage
// on such surfaces then takes several times the evaluations.
TEST(GuideRun, FineCellsTakeNoMoreEvaluations) {
  Mechanism mechanism = oracle::make_scotch_yoke_clearance();
  mechanism.drivers.push_back({"motor", DrivenAngle{"crank"}, 0.8, 25.0});
  Study study = make_slot_study();
  study.wear_stages = 2;
  const auto count = [&](int cells) {
    study.cells = cells;
    return static_cast<double>(run_study(mechanism, study).back().solver.evaluations);
  };
  EXPECT_LT(count(100000), 1.3 * count(1000));
}

TEST(GuideRun, BristlesOfCornersKeepTheEnergyBalance) {
  Mechanism mechanism = make_loose_slider();
  Lugre friction;
  friction.static_coefficient = 0.15;
  friction.kinetic_coefficient = 0.1;
  std::get<PrismaticClearance>(mechanism.joints[find_joint(mechanism, "guide")].kind).contact.friction = friction;
  for (const Integrator integrator : {Integrator::explicit_pair, Integrator::stiff}) {
    Study study = make_slot_study();
    study.cycle_time = 0.05;
    study.wear_stages = 0;
    study.compare_ideal = false;
    study.integrator = integrator;
    const StageRecord stage = run_study(mechanism, study).at(0);
    ASSERT_EQ(stage.status, StageStatus::finished) << stage.message;
    EXPECT_GE(stage.solver.onsets, 4);
    EXPECT_GT(stage.energy.friction, 0.0);
    EXPECT_NEAR(stage.energy.residual() / stage.energy.exchanged, 0.0, 1e-6);
    EXPECT_NE(find_values(stage, "guide.bristle"), nullptr);
  }
}

TEST(GuideRun, EventsTellWhichCornerMetItsSideAndWhere) {
  Study study = make_slot_study();
  study.wear_stages = 0;
  study.compare_ideal = false;
  const StageRecord stage = run_study(make_loose_slider(), study).at(0);
  std::set<int> contacts;
  for (const ContactEvent& event : stage.events) {
    EXPECT_EQ(event.joint, 0);
    contacts.insert(event.contact);
    EXPECT_LE(std::abs(event.position), 0.15);
    // The left side lies a quarter turn to the left of the slot, at 0.1 rad in the frame.
    const double side = event.contact < 2 ? 0.5 : -0.5;
    EXPECT_NEAR(event.angle, 0.1 + side * std::acos(-1.0), 1e-12);
    EXPECT_GT(event.onset_speed, 0.0);
  }
  EXPECT_EQ(contacts, (std::set{0, 1, 2, 3})) << "every corner in a turn of the crank";
  const auto& n_contacts = *find_values(stage, "guide.n_contacts");
  EXPECT_GE(std::ranges::max(n_contacts), 2.0);
}

}  // namespace
}  // namespace gudgeon
