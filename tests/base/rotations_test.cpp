// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
#include "gudgeon/base/rotations.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "gudgeon/base/rotation_lanes.h"

namespace gudgeon {
namespace {

// Against the library's in extended precision, over a few turns and over the many turns of a long run.
TEST(Rotations, AreThoseOfTheAngles) {
  std::mt19937_64 random(7);
  for (const double largest : {1.0, 10.0, 1e3, 1e6}) {
    std::uniform_real_distribution<double> any(-largest, largest);
    std::vector<double> angles(10007);
    for (double& angle : angles) angle = any(random);
    std::vector<Rotation> rotations(angles.size());
    make_rotations(angles, rotations.data());
    for (std::size_t k = 0; k < angles.size(); ++k) {
      const long double angle = angles[k];
      // The largest of four million was 1.9e-16, a little more than half of the last digit below 1.
      EXPECT_LT(std::abs(static_cast<double>(rotations[k].c - std::cos(angle))), 2.2e-16) << angles[k];
      EXPECT_LT(std::abs(static_cast<double>(rotations[k].s - std::sin(angle))), 2.2e-16) << angles[k];
    }
  }
}

TEST(Rotations, AreExactAtZeroAndDoNotDependOnTheirPlace) {
  for (std::size_t n = 0; n <= 9; ++n) {
    std::vector<double> angles(n, 0.7);
    std::vector<Rotation> rotations(n + 1, Rotation{5.0, 5.0});
    make_rotations(angles, rotations.data());
    for (std::size_t k = 0; k < n; ++k) {
      EXPECT_EQ(rotations[k].c, rotations[0].c);
      EXPECT_EQ(rotations[k].s, rotations[0].s);
    }
    EXPECT_EQ(rotations[n].c, 5.0) << "nothing is written behind the last";
  }
  const std::vector<double> zero{0.0};
  Rotation none;
  make_rotations(zero, &none);
  EXPECT_EQ(none.c, 1.0);
  EXPECT_EQ(none.s, 0.0);
}

#ifdef __x86_64__
TEST(Rotations, HaveTheSameBitsInAnyLanes) {
  if (!__builtin_cpu_supports("avx2")) GTEST_SKIP() << "no AVX2 here";
  std::mt19937_64 random(11);
  for (const double largest : {1.0, 30.0, 1e3, 1e7, 1e300}) {
    std::uniform_real_distribution<double> any(-largest, largest);
    std::vector<double> angles(1003);
    for (double& angle : angles) angle = any(random);
    std::vector<double> two(2 * angles.size());
    std::vector<double> four(2 * angles.size());
    write_rotations<xsimd::default_arch>(angles.data(), angles.size(), two.data());
    write_rotations_avx2(angles.data(), angles.size(), four.data());
    EXPECT_EQ(two, four) << largest;
  }
}
#endif

TEST(Rotations, AreNotNumbersWhereAnAngleIsNot) {
  const std::vector<double> angles{std::numeric_limits<double>::quiet_NaN(), 1.0,
                                   std::numeric_limits<double>::infinity()};
  std::vector<Rotation> rotations(3);
  make_rotations(angles, rotations.data());
  EXPECT_TRUE(std::isnan(rotations[0].c) && std::isnan(rotations[0].s));
  EXPECT_NEAR(rotations[1].s, std::sin(1.0), 2.2e-16);
  EXPECT_TRUE(std::isnan(rotations[2].c) && std::isnan(rotations[2].s));
}

}  // namespace
}  // namespace gudgeon
