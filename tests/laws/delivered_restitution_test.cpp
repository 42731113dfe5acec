// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// The closed form of the delivered restitution against tabulated values, its limits, and a simulated impact.
#include "gudgeon/laws/normal/delivered_restitution.h"

#include <gtest/gtest.h>

#include <array>
#include <utility>

#include "gudgeon/laws/normal/lankarani_nikravesh.h"

namespace gudgeon {
namespace {

TEST(DeliveredRestitution, AgreesWithTheTableForLankaraniNikravesh) {
  constexpr std::array<std::pair<double, double>, 6> kTable{
      {{0.1, 0.66527}, {0.3, 0.68422}, {0.5, 0.72524}, {0.7, 0.79597}, {0.9, 0.91318}, {0.99, 0.99015}}};
  for (const auto& [asked, delivered] : kTable) {
    EXPECT_NEAR(find_delivered_restitution(0.75 * (1.0 - asked * asked)), delivered, 5e-6);  // printed to 5 digits
  }
}

TEST(DeliveredRestitution, InvertsTheExactDampingFactors) {
  constexpr std::array<std::pair<double, double>, 4> kTable{
      {{9.998159, 0.1}, {1.432751, 0.5}, {0.166482, 0.9}, {0.015151, 0.99}}};
  for (const auto& [factor, delivered] : kTable) EXPECT_NEAR(find_delivered_restitution(factor), delivered, 1e-6);
}

TEST(DeliveredRestitution, HasItsLimits) {
  EXPECT_EQ(find_delivered_restitution(0.0), 1.0);
  EXPECT_NEAR(find_delivered_restitution(1e-5), 1.0 - 2e-5 / 3.0, 1e-9);
  EXPECT_LT(find_delivered_restitution(1e6), 1e-5);
  // The series takes over without a step.
  EXPECT_NEAR(find_delivered_restitution(0.99e-7), find_delivered_restitution(1.01e-7), 5e-9);
}

TEST(DeliveredRestitution, IsWhatAnImpactReturns) {
  const LankaraniNikravesh law{.restitution = 0.5, .exponent = 1.5};
  constexpr double kMass = 2.0;
  constexpr double kStep = 1e-8;
  double penetration = 0.0;
  double rate = 3.0;
  do {  // symplectic Euler; its error at this step is below 1e-5
    rate -= kStep * law({penetration, rate, 3.0, 1e6, law.damping_factor()}).force / kMass;
    penetration += kStep * rate;
  } while (penetration > 0.0);
  EXPECT_NEAR(-rate / 3.0, find_delivered_restitution(0.75 * (1.0 - 0.25)), 1e-4);
}

}  // namespace
}  // namespace gudgeon
