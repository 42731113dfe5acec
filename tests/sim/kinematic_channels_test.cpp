// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Inverse dynamics over a cycle: efforts and reactions of every driven mechanism against the textbook form, and the
// work of a cycle, which conservative loads give back.
#include "gudgeon/sim/kinematic_channels.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "gudgeon/sim/kinematic_cycle.h"
#include "gudgeon/system/mobility.h"
#include "tests/oracle/mechanisms.h"
#include "tests/oracle/textbook.h"

namespace gudgeon {
namespace {

Mechanism drive_crank(Mechanism mechanism, double speed) {
  for (Body& body : mechanism.bodies) body.start.angle_rate.reset();
  const double angle = *mechanism.bodies[1].start.angle;
  mechanism.bodies[1].start = {};
  mechanism.drivers.push_back({"motor", DrivenAngle{mechanism.bodies[1].name}, angle, speed});
  return mechanism;
}

/// Every test mechanism that its drivers move completely, and some to which a driver was given.
std::vector<Mechanism> make_driven_mechanisms() {
  std::vector<Mechanism> driven{drive_crank(oracle::make_four_bar(), 5.3),
                                drive_crank(oracle::make_sprung_four_bar(), -4.1),
                                drive_crank(oracle::make_press(), 3.7)};
  for (const Mechanism& mechanism : oracle::make_all_mechanisms()) {
    const Mechanism ideal = make_ideal(mechanism);
    if (!ideal.drivers.empty() && find_mobility(ideal).n_degrees_of_freedom == 0) driven.push_back(ideal);
  }
  return driven;
}

double find_at(const StageRecord& stage, const std::string& channel, std::size_t sample) {
  const std::vector<double>* values = find_values(stage, channel);
  if (values == nullptr) ADD_FAILURE() << "no channel " << channel;
  return values == nullptr ? 0.0 : (*values)[sample];
}

oracle::TextbookState make_state_of(const oracle::Textbook& textbook, const StageRecord& stage, std::size_t sample) {
  oracle::TextbookState state = textbook.make_state();
  for (std::size_t b = 1; b < state.bodies.size(); ++b) {
    const std::string& name = textbook.mechanism().bodies[b].name;
    const auto at = [&](const char* ending) { return find_at(stage, name + ending, sample); };
    state.bodies[b] = {{at(".x"), at(".y")}, at(".angle"), {at(".x_velocity"), at(".y_velocity")}, at(".angle_rate")};
  }
  return state;
}

void expect_textbook_cycle(const Mechanism& mechanism) {
  const StageRecord stage = run_kinematics(mechanism, {0.4, 1, 9, {}}).motion;
  ASSERT_EQ(stage.status, StageStatus::finished) << mechanism.name << stage.message;
  const oracle::Textbook textbook(mechanism);
  for (std::size_t i = 0; i < stage.time.size(); ++i) {
    const std::string where = mechanism.name + " at " + std::to_string(stage.time[i]) + " ";
    const oracle::TextbookSolution solution = textbook.solve(make_state_of(textbook, stage, i), stage.time[i]);
    ASSERT_EQ(solution.n_redundant_rows, 0) << where;
    double scale = 1.0;
    for (const auto& reaction : solution.reactions) scale = std::max({scale, norm(reaction.force), reaction.moment});
    const double tolerance = 1e-9 * scale;  // a dense solve of a well-conditioned matrix
    for (std::size_t d = 0; d < mechanism.drivers.size(); ++d) {
      const std::string name = mechanism.drivers[d].name + ".effort";
      EXPECT_NEAR(find_at(stage, name, i), solution.efforts[d], tolerance) << where << name;
    }
    for (std::size_t j = 0; j < mechanism.joints.size(); ++j) {
      const std::string& name = mechanism.joints[j].name;
      EXPECT_NEAR(find_at(stage, name + ".x_force", i), solution.reactions[j].force.x, tolerance) << where << name;
      EXPECT_NEAR(find_at(stage, name + ".y_force", i), solution.reactions[j].force.y, tolerance) << where << name;
      if (find_values(stage, name + ".moment") == nullptr) continue;
      EXPECT_NEAR(find_at(stage, name + ".moment", i), solution.reactions[j].moment, tolerance) << where << name;
    }
  }
}

TEST(KinematicChannels, EffortsAndReactionsAreThoseOfTheTextbook) {
  const std::vector<Mechanism> driven = make_driven_mechanisms();
  EXPECT_GE(driven.size(), 7u) << "the choice of mechanisms has become thin";
  for (const Mechanism& mechanism : driven) expect_textbook_cycle(mechanism);
}

TEST(KinematicChannels, ConservativeLoadsTakeNoWorkInACycle) {
  // Gravity, a constant force and springs: the crank's torque does no work in one turn. The mean over even samples of
  // a periodic function has no error of the rule.
  Mechanism mechanism = drive_crank(oracle::make_sprung_four_bar(), 2.0 * std::numbers::pi);
  std::erase_if(mechanism.loads, [](const Load& load) {
    const auto* spring = std::get_if<Spring>(&load.kind);
    return std::holds_alternative<ConstantTorque>(load.kind) || (spring != nullptr && spring->damping > 0.0);
  });
  const StageRecord stage = run_kinematics(mechanism, {1.0, 1, 360, "motor"}).motion;
  ASSERT_EQ(stage.status, StageStatus::finished) << stage.message;
  const ChannelStatistics& effort = *find_statistics(stage, "motor.effort");
  EXPECT_GT(effort.maximum, 1.0);
  EXPECT_NEAR(effort.mean, 0.0, 1e-9 * effort.maximum);
}

}  // namespace
}  // namespace gudgeon
