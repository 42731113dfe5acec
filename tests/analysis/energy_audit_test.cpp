// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// The ledger's lines and verdict.
#include "gudgeon/analysis/energy_audit.h"

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
  EXPECT_EQ(audit.relative, std::abs(ledger.residual()) / 1024.0);
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

TEST(EnergyAudit, WithoutExchangeTheEnergyHeldIsTheScale) {
  EnergyLedger swing;
  swing.initial_energy = -3.0;
  swing.potential = -3.0 - 1e-9;
  EXPECT_TRUE(check_energy(swing).closed);
  EXPECT_NEAR(check_energy(swing).relative, 1e-9 / 3.0, 1e-12);
  EXPECT_TRUE(check_energy(EnergyLedger{}).closed);
}

}  // namespace
}  // namespace gudgeon
