// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// The contact arc against eqs. (26) to (28) evaluated with more digits, and its limits.
#include "gudgeon/geometry/contact_arc.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

namespace gudgeon {
namespace {

constexpr double kBearing = 15e-3;
constexpr double kJournal = 14.5e-3;

struct LongArc {
  long double half_angle;
  long double length;
};

// As printed: β = arccos((e² + R_i² − R_j²)/(2 e R_i)), |DC| = R_i sin(π − β).
LongArc find_printed_arc(double penetration, double bearing_radius, double journal_radius) {
  const long double ri = bearing_radius;
  const long double rj = journal_radius;
  const long double e = ri - rj + static_cast<long double>(penetration);
  const long double beta = std::acos((e * e + ri * ri - rj * rj) / (2.0L * e * ri));
  return {beta, ri * std::sin(std::numbers::pi_v<long double> - beta)};
}

TEST(ContactArc, AgreesWithThePrintedEquations) {
  for (const double penetration : {1.5e-3, 1e-3, 1e-4, 1e-5, 1e-6}) {
    for (const double journal : {14.9e-3, kJournal, 12e-3}) {
      const ContactArc arc = find_contact_arc(penetration, kBearing, journal);
      const LongArc printed = find_printed_arc(penetration, kBearing, journal);
      // R_i − R_j itself rounds to a part in 1e14 of the smallest clearance.
      EXPECT_NEAR(arc.half_angle, static_cast<double>(printed.half_angle), 1e-13 * arc.half_angle);
      EXPECT_NEAR(arc.length, static_cast<double>(printed.length), 1e-13 * arc.length);
    }
  }
}

TEST(ContactArc, KeepsItsDigitsAtSmallPenetration) {
  for (const double penetration : {1e-8, 1e-11, 1e-15, 1e-30}) {
    const double clearance = kBearing - kJournal;
    const double limit = std::sqrt(2.0 * kJournal * penetration / (clearance * kBearing));
    const ContactArc arc = find_contact_arc(penetration, kBearing, kJournal);
    // The next term of the series is smaller by δ/c.
    const double tolerance = penetration / clearance + 1e-15;
    EXPECT_NEAR(arc.half_angle / limit, 1.0, tolerance);
    EXPECT_NEAR(arc.length / (kBearing * limit), 1.0, tolerance);
  }
}

TEST(ContactArc, VanishesWithoutPenetration) {
  for (const double penetration : {0.0, -0.0, -1e-6, -1.0}) {
    EXPECT_EQ(find_contact_arc(penetration, kBearing, kJournal).half_angle, 0.0);
    EXPECT_EQ(find_contact_arc(penetration, kBearing, kJournal).length, 0.0);
  }
}

// The chord of two intersecting circles is the journal's diameter at most.
TEST(ContactArc, GrowsWithPenetrationAndStopsAtTheJournalsDiameter) {
  double before = 0.0;
  for (double penetration = 1e-6; penetration < 3.3e-3; penetration *= 1.3) {
    const ContactArc arc = find_contact_arc(penetration, kBearing, kJournal);
    EXPECT_GT(arc.length, before);
    EXPECT_LT(arc.length, kJournal);
    EXPECT_NEAR(arc.length, kBearing * std::sin(arc.half_angle), 1e-15 * kBearing);
    before = arc.length;
  }
  const double widest = std::sqrt(kBearing * kBearing - kJournal * kJournal) - (kBearing - kJournal);
  EXPECT_NEAR(find_contact_arc(widest * (1.0 - 1e-9), kBearing, kJournal).length, kJournal, 1e-12 * kJournal);
  for (const double penetration : {widest * (1.0 + 1e-9), 2.0 * kJournal, 2.5 * kJournal, 1.0, 1e10}) {
    const ContactArc arc = find_contact_arc(penetration, kBearing, kJournal);
    EXPECT_EQ(arc.length, kJournal) << penetration;
    EXPECT_DOUBLE_EQ(std::sin(arc.half_angle), kJournal / kBearing) << penetration;
  }
}

TEST(FlatContactLength, IsHalfTheChordOfTheOverlap) {
  EXPECT_DOUBLE_EQ(find_flat_contact_length(0.4e-3, 1e-3), 0.8e-3);  // 0.6, 0.8, 1
  EXPECT_EQ(find_flat_contact_length(0.0, 1e-3), 0.0);
  EXPECT_EQ(find_flat_contact_length(-1e-6, 1e-3), 0.0);
  EXPECT_EQ(find_flat_contact_length(1e-3, 1e-3), 1e-3);
  EXPECT_EQ(find_flat_contact_length(5.0, 1e-3), 1e-3);
}

TEST(FlatContactLength, IsTheLimitOfALargeBearing) {
  for (const double penetration : {1e-7, 1e-5, 3e-4}) {
    const double flat = find_flat_contact_length(penetration, 1e-3);
    // The chord differs by the share of the radii.
    EXPECT_NEAR(find_contact_arc(penetration, 1e4, 1e-3).length / flat, 1.0, 2e-7);
  }
}

}  // namespace
}  // namespace gudgeon
