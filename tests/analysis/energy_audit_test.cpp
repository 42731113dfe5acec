// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// The energy balance's lines and verdict.
#include "gudgeon/analysis/energy_audit.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "tests/results/synthetic_run.h"

namespace gudgeon {
namespace {

TEST(EnergyAudit, LinesAddUpToTheResidual) {
  const EnergyBalance balance{1.0, 2.0, 4.0, 8.0, 16.0, 32.0, 64.0, 128.0, 256.0, 512.0, 1024.0};
  const EnergyAudit audit = check_energy(balance);
  double sum = 0.0;
  for (const EnergyLine& line : audit.lines) sum += line.value;
  EXPECT_EQ(sum, balance.residual());
  EXPECT_EQ(audit.residual, balance.residual());
  EXPECT_EQ(audit.exchanged, 1024.0);
  EXPECT_NEAR(audit.relative, std::abs(balance.residual()) / 1024.4, 1e-5);
  EXPECT_FALSE(audit.balanced);
}

TEST(EnergyAudit, ClosesWithinTheTolerance) {
  EnergyBalance balance = test::make_stage("x").energy;
  EXPECT_TRUE(check_energy(balance).balanced);
  balance.friction += 0.9e-6 * balance.exchanged;
  EXPECT_TRUE(check_energy(balance).balanced);
  balance.friction += 0.2e-6 * balance.exchanged;
  EXPECT_FALSE(check_energy(balance).balanced);
  balance.friction = std::nan("");
  EXPECT_FALSE(check_energy(balance).balanced);
}

// A rotor of 89 mJ that exchanges next to nothing: 1e-7 of speed are 18 nJ.
TEST(EnergyAudit, WithoutExchangeTheKineticEnergyIsTheScale) {
  EnergyBalance rotor;
  rotor.initial_energy = 89e-3;
  rotor.exchanged = 2e-9;
  rotor.kinetic = 89e-3 + 2e-9;
  EXPECT_TRUE(check_energy(rotor).balanced);
  rotor.kinetic = 89e-3 + 17e-9;
  EXPECT_TRUE(check_energy(rotor).balanced);
  rotor.kinetic = 89e-3 + 19e-9;
  EXPECT_FALSE(check_energy(rotor).balanced);
}

// Where the origin of heights lies is the user's choice: it may count for rounding alone.
TEST(EnergyAudit, PotentialEnergyCountsForRoundingAlone) {
  EnergyBalance swing;
  swing.initial_energy = -3.0;
  swing.potential = -3.0 - 5e-12;
  EXPECT_TRUE(check_energy(swing).balanced);
  swing.potential = -3.0 - 1e-9;
  EXPECT_FALSE(check_energy(swing).balanced);
  EXPECT_TRUE(check_energy(EnergyBalance{}).balanced);
}

// 10 N over 0.5 m; the same mechanism a million times smaller; and one of 1 MN over 100 m. Nothing moves.
TEST(EnergyAudit, WhereNothingMovesLoadsAreTheScale) {
  for (const double reach : {5.0, 5e-12, 1e8}) {
    EnergyBalance locked;
    locked.load_reach = reach;
    locked.exchanged = 1e-15 * reach;
    locked.load_work = 0.9e-12 * reach;
    EXPECT_TRUE(check_energy(locked).balanced) << reach;
    locked.load_work = 1.1e-12 * reach;
    EXPECT_FALSE(check_energy(locked).balanced) << reach;
  }
}

TEST(EnergyAudit, ExplainsOnlyAFinishedStageThatDoesNotAddUp) {
  StageRecord stage = test::make_stage("x");
  EXPECT_FALSE(is_unbalanced(stage));
  EXPECT_EQ(explain_imbalance(stage), "");
  stage.energy.friction += 1e-3 * stage.energy.exchanged;
  EXPECT_TRUE(is_unbalanced(stage));
  EXPECT_THAT(explain_imbalance(stage),
              testing::HasSubstr("E-NUM-020: its energy balance does not close: the residual is 0.0232 J, "
                                 "9.9e-04 of the energy exchanged and held, more than 1e-06"));
  stage.status = StageStatus::failed;
  EXPECT_FALSE(is_unbalanced(stage));
  EXPECT_EQ(explain_imbalance(stage), "");
}

}  // namespace
}  // namespace gudgeon
