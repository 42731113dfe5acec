// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// The ledger's lines and verdict.
#include "gudgeon/analysis/energy_audit.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "tests/results/synthetic_run.h"

namespace gudgeon {
namespace {

TEST(EnergyAudit, LinesAddUpToTheResidual) {
  const EnergyLedger ledger{1.0, 2.0, 4.0, 8.0, 16.0, 32.0, 64.0, 128.0, 256.0, 512.0, 1024.0};
  const EnergyAudit audit = check_energy(ledger);
  double sum = 0.0;
  for (const EnergyLine& line : audit.lines) sum += line.value;
  EXPECT_EQ(sum, ledger.residual());
  EXPECT_EQ(audit.residual, ledger.residual());
  EXPECT_EQ(audit.exchanged, 1024.0);
  EXPECT_NEAR(audit.relative, std::abs(ledger.residual()) / 1024.4, 1e-5);
  EXPECT_FALSE(audit.closed);
}

TEST(EnergyAudit, ClosesWithinTheTolerance) {
  EnergyLedger ledger = test::make_stage("x").ledger;
  EXPECT_TRUE(check_energy(ledger).closed);
  ledger.friction += 0.9e-6 * ledger.exchanged;
  EXPECT_TRUE(check_energy(ledger).closed);
  ledger.friction += 0.2e-6 * ledger.exchanged;
  EXPECT_FALSE(check_energy(ledger).closed);
  ledger.friction = std::nan("");
  EXPECT_FALSE(check_energy(ledger).closed);
}

// A rotor of 89 mJ that exchanges next to nothing: 1e-7 of speed are 18 nJ.
TEST(EnergyAudit, WithoutExchangeTheKineticEnergyIsTheScale) {
  EnergyLedger rotor;
  rotor.initial_energy = 89e-3;
  rotor.exchanged = 2e-9;
  rotor.kinetic = 89e-3 + 2e-9;
  EXPECT_TRUE(check_energy(rotor).closed);
  rotor.kinetic = 89e-3 + 17e-9;
  EXPECT_TRUE(check_energy(rotor).closed);
  rotor.kinetic = 89e-3 + 19e-9;
  EXPECT_FALSE(check_energy(rotor).closed);
}

// Where the origin of heights lies is the user's choice: it may count for rounding alone.
TEST(EnergyAudit, PotentialEnergyCountsForRoundingAlone) {
  EnergyLedger swing;
  swing.initial_energy = -3.0;
  swing.potential = -3.0 - 5e-12;
  EXPECT_TRUE(check_energy(swing).closed);
  swing.potential = -3.0 - 1e-9;
  EXPECT_FALSE(check_energy(swing).closed);
  EXPECT_TRUE(check_energy(EnergyLedger{}).closed);
}

// 10 N over 0.5 m; the same mechanism a million times smaller; and one of 1 MN over 100 m. Nothing moves.
TEST(EnergyAudit, WhereNothingMovesLoadsAreTheScale) {
  for (const double reach : {5.0, 5e-12, 1e8}) {
    EnergyLedger locked;
    locked.load_reach = reach;
    locked.exchanged = 1e-15 * reach;
    locked.load_work = 0.9e-12 * reach;
    EXPECT_TRUE(check_energy(locked).closed) << reach;
    locked.load_work = 1.1e-12 * reach;
    EXPECT_FALSE(check_energy(locked).closed) << reach;
  }
}

TEST(EnergyAudit, ExplainsOnlyAFinishedStageThatDoesNotAddUp) {
  StageRecord stage = test::make_stage("x");
  EXPECT_FALSE(is_unbalanced(stage));
  EXPECT_EQ(explain_imbalance(stage), "");
  stage.ledger.friction += 1e-3 * stage.ledger.exchanged;
  EXPECT_TRUE(is_unbalanced(stage));
  EXPECT_THAT(explain_imbalance(stage),
              testing::HasSubstr("E-NUM-020: its energy does not add up: the residual is 0.0232 J, "
                                 "9.9e-04 of the energy exchanged and held, more than 1e-06"));
  stage.status = StageStatus::failed;
  EXPECT_FALSE(is_unbalanced(stage));
  EXPECT_EQ(explain_imbalance(stage), "");
}

}  // namespace
}  // namespace gudgeon
