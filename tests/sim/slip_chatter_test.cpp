// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Where journals stick, loose steps do not jump to and fro about zero slip.
#include <gtest/gtest.h>

#include "tests/oracle/mechanisms.h"
#include "tests/sim/integrated_motion.h"

namespace gudgeon {
namespace {

double count_evaluations(double tolerance) {
  constexpr double kCycles = 20.0;  // impacts are chaotic: one cycle takes a tenth more than another
  Study study;
  study.relative_tolerance = tolerance;
  IntegratedMotion motion(oracle::make_nine_bar(), study);
  while (motion.integrator.time() < kCycles) EXPECT_TRUE(motion.integrator.advance(kCycles));
  return static_cast<double>(motion.integrator.statistics().evaluations) / kCycles;
}

TEST(SlipChatter, ALooserToleranceTakesFewerEvaluations) {
  EXPECT_LT(count_evaluations(1e-5), 0.95 * count_evaluations(1e-6));
}

}  // namespace
}  // namespace gudgeon
