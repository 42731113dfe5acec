// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Our values beside reference values.
#include "gudgeon/analysis/reference_values.h"

#include <gtest/gtest.h>

#include <cmath>

#include "gudgeon/base/diagnostics.h"
#include "tests/results/synthetic_run.h"

namespace gudgeon {
namespace {

TEST(ReferenceValues, PeaksBelongToTheWornStages) {
  const ReferenceRow row{"contact force A", "A.normal_force", "peak", {1000.0, -5000.0, 7.0}, ""};
  const ReferenceComparison comparison = compare_with_reference(test::make_run(), row);
  EXPECT_EQ(comparison.reference.unit, "N");
  EXPECT_EQ(comparison.stages, (std::vector<std::string>{"no_wear", "wear_1", "wear_2"}));
  EXPECT_EQ(comparison.ours[0], 2000.0);
  EXPECT_EQ(comparison.ours[1], 2500.0);
  EXPECT_TRUE(std::isnan(comparison.ours[2]));
  EXPECT_EQ(comparison.ratio[0], 2.0);
  EXPECT_EQ(comparison.ratio[1], 0.5);
  EXPECT_TRUE(std::isnan(comparison.ratio[2]));
}

TEST(ReferenceValues, WearDepthIsThatOfTheSurfacesAStageRanOn) {
  const ReferenceRow row{"wear depth A", "A", "wear_depth", {std::nan(""), 8e-6, std::nan("")}, ""};
  const ReferenceComparison comparison = compare_with_reference(test::make_run(), row);
  EXPECT_EQ(comparison.reference.unit, "m");
  EXPECT_TRUE(std::isnan(comparison.ours[0])) << "unworn";
  EXPECT_DOUBLE_EQ(comparison.ours[1], 4e-6);
  EXPECT_DOUBLE_EQ(comparison.ours[2], 10e-6);
  EXPECT_DOUBLE_EQ(comparison.ratio[1], 0.5);
  EXPECT_TRUE(std::isnan(comparison.ratio[2]));
}

TEST(ReferenceValues, UnknownThingsHaveNoValueAndUnknownMeasuresAreRefused) {
  const RunRecord run = test::make_run();
  EXPECT_TRUE(std::isnan(compare_with_reference(run, {"q", "Z", "wear_depth", {1.0, 1.0}, ""}).ours[1]));
  EXPECT_TRUE(std::isnan(compare_with_reference(run, {"q", "Z.effort", "peak", {1.0}, ""}).ours[0]));
  EXPECT_THROW(compare_with_reference(run, {"q", "A", "mean", {1.0}, ""}), NumericalError);
}

}  // namespace
}  // namespace gudgeon
