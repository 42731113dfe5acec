// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
#include "gudgeon/sim/fastest_rates.h"

#include <gtest/gtest.h>

#include <cmath>

#include "gudgeon/sim/run_study.h"
#include "tests/oracle/mechanism_parts.h"

namespace gudgeon {
namespace {

TEST(FastestRates, AreMeansOverTimeOfEachKindOfStep) {
  FastestRates rates;
  EXPECT_EQ(rates.in_contact(), 0.0);
  rates.note(1e-3, 1.0, true);
  rates.note(3e-3, 2.0, true);
  rates.note(0.5, 0.25, false);
  rates.note(1.0, std::nan(""), false);
  EXPECT_DOUBLE_EQ(rates.in_contact(), 750.0);
  EXPECT_DOUBLE_EQ(rates.in_flight(), 0.5);
  rates.note(1e-3, 1e9, true);
  EXPECT_DOUBLE_EQ(rates.in_contact(), 6.5 / 5e-3);
}

// A milligram that 10 N press onto a steel bearing swings at √(k/m) of three million 1/s, and explicit steps follow it.
TEST(FastestRates, TellWhyAStageIsCostly) {
  Mechanism mechanism = oracle::make_empty("mote", {0.0, -1e7}, {{"post", {0.0, 0.0}}});
  mechanism.bodies.push_back({"mote", 1e-6, 1e-12, {}, {{"middle", {0.0, 0.0}}}, {}});
  ContactProperties contact;
  contact.bearing_material = contact.journal_material = {"steel", 200e9, 0.3};
  contact.normal_force = KelvinVoigt{1e7, 1e-3};
  contact.friction = Frictionless{};
  mechanism.joints.push_back(
      {"seat", RevoluteClearance{{kFrameName, "post"}, {"mote", "middle"}, 10e-3, 0.1e-3, 10e-3, contact}});
  Study study;
  study.cycle_time = 0.11;
  study.cycles = 1;
  study.integrator = Integrator::explicit_pair;
  study.compare_ideal = false;
  const StageRecord stage = run_study(mechanism, study).back();
  ASSERT_EQ(stage.status, StageStatus::finished) << stage.message;
  EXPECT_NE(stage.message.find("'seat' presses"), std::string::npos) << stage.message;
}

}  // namespace
}  // namespace gudgeon
