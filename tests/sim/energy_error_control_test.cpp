// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// The decision on energy balances whose numbers are known.
#include "gudgeon/sim/energy_error_control.h"

#include <gtest/gtest.h>

#include <cmath>

namespace gudgeon {
namespace {

constexpr double kMost = EnergyErrorControl::kLargestResidual;
constexpr double kShare = EnergyErrorControl::kShareOfRest;

EnergyErrorControl begin_at(double residual, double exchanged) {
  EnergyErrorControl control;
  control.begin(residual, exchanged);
  return control;
}

TEST(EnergyErrorControl, AStepMayAddItsShareOfWhatItExchanges) {
  const EnergyErrorControl control = begin_at(0.0, 0.0);
  EXPECT_DOUBLE_EQ(control.find_error(kMost * 2.0, 2.0), 1.0);
  EXPECT_DOUBLE_EQ(control.find_error(-kMost * 2.0, 2.0), 1.0) << "either way";
  EXPECT_DOUBLE_EQ(control.find_error(kMost * 1.0, 2.0), 0.5);
}

TEST(EnergyErrorControl, AStepThatExchangesNothingMayUseAPartOfWhatIsLeft) {
  const EnergyErrorControl control = begin_at(0.25 * kMost * 8.0, 8.0);
  const double rest = 0.75 * kMost * 8.0;
  EXPECT_NEAR(control.find_error(0.25 * kMost * 8.0 + kShare * rest, 8.0), 1.0, 1e-12);
}

TEST(EnergyErrorControl, BeyondItsBoundOnlyWhatTheStepExchangesCounts) {
  const EnergyErrorControl control = begin_at(-5.0 * kMost, 1.0);
  EXPECT_NEAR(control.find_error(-5.5 * kMost, 1.5), 1.0, 1e-12);
}

TEST(EnergyErrorControl, WhatBringsTheResidualNearerToZeroIsFree) {
  const EnergyErrorControl control = begin_at(-0.5, 1.0);
  EXPECT_EQ(control.find_error(-0.4, 1.0), 0.0);
  EXPECT_EQ(control.find_error(0.5, 1.0), 0.0) << "no larger than before";
  EXPECT_GT(control.find_error(0.6, 1.0), 1.0);
}

TEST(EnergyErrorControl, WhereNothingWasExchangedNothingMayBeAdded) {
  EXPECT_EQ(begin_at(0.0, 0.0).find_error(0.0, 0.0), 0.0);
  EXPECT_TRUE(std::isinf(begin_at(0.0, 0.0).find_error(1e-20, 0.0)));
}

// However steps spend what they may, the energy balance stays within its bound.
TEST(EnergyErrorControl, StepsThatAddAllTheyMayKeepTheBound) {
  double residual = 0.0;
  double exchanged = 0.0;
  for (int step = 0; step < 1000; ++step) {
    const double more = step % 7 == 0 ? 1.0 : 0.0;
    const EnergyErrorControl control = begin_at(residual, exchanged);
    const double unit = 1e-12;
    const double allowed = unit / control.find_error(residual + unit, exchanged + more);
    residual += allowed;
    exchanged += more;
    ASSERT_LE(residual, kMost * exchanged * (1.0 + 1e-6)) << step;
  }
  EXPECT_GT(residual, 0.9 * kMost * exchanged) << "and they may use it";
}

}  // namespace
}  // namespace gudgeon
