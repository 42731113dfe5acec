// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Numbers for people.
#include "gudgeon/report/number_format.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

namespace gudgeon {
namespace {

TEST(FormatEngineering, ChoosesAFittingUnit) {
  EXPECT_EQ(format_engineering(5.768e-6, "m"), "5.768 µm");
  EXPECT_EQ(format_engineering(0.0005, "m"), "500.0 µm");
  EXPECT_EQ(format_engineering(0.0223093, "m"), "22.31 mm");
  EXPECT_EQ(format_engineering(-2072.0, "N"), "-2.072 kN");
  EXPECT_EQ(format_engineering(200e9, "Pa"), "200.0 GPa");
  EXPECT_EQ(format_engineering(-52.33, "N m"), "-52.33 N m");
  EXPECT_EQ(format_engineering(3e-9, "m^3"), "3.000 mm^3");
  EXPECT_EQ(format_engineering(4.2e-13, "m^3"), "420000 µm^3");
  EXPECT_EQ(format_engineering(1.621e-10, "m^3"), "0.1621 mm^3");
  EXPECT_EQ(format_engineering(1.6e-12, "m^3"), "0.001600 mm^3");
  EXPECT_EQ(format_engineering(2.5, "s"), "2.500 s");
}

TEST(FormatEngineering, LeavesUnitsWithoutPrefixAlone) {
  EXPECT_EQ(format_engineering(606.1, "m/s^2"), "606.1 m/s^2");
  EXPECT_EQ(format_engineering(1500.0, "m"), "1500 m");
  EXPECT_EQ(format_engineering(0.148, "kg"), "0.1480 kg");
  EXPECT_EQ(format_engineering(0.5, "rad"), "0.5000 rad");
  EXPECT_EQ(format_engineering(12.0, "1"), "12.00");
  EXPECT_EQ(format_engineering(12.0, ""), "12.00");
}

TEST(FormatEngineering, RoundsBeforeItChooses) {
  EXPECT_EQ(format_engineering(0.99996, "m"), "1.000 m");
  EXPECT_EQ(format_engineering(999.94, "N"), "999.9 N");
  EXPECT_EQ(format_engineering(999.96, "N"), "1.000 kN");
}

TEST(FormatEngineering, ZeroNothingAndTheUnspeakable) {
  EXPECT_EQ(format_engineering(0.0, "m"), "0 m");
  EXPECT_EQ(format_engineering(std::nan(""), "m"), "–");
  EXPECT_EQ(format_engineering(std::numeric_limits<double>::infinity(), "1"), "inf");
  EXPECT_EQ(format_engineering(1.5e-17, "J"), "1.500e-17 J");
}

TEST(FormatNumber, KeepsFourDigits) {
  EXPECT_EQ(format_number(0.94123), "0.9412");
  EXPECT_EQ(format_number(12345.6), "12346");
  EXPECT_EQ(format_number(1.5e-9), "1.500e-09");
}

TEST(FormatCount, GroupsDigits) {
  EXPECT_EQ(format_count(0), "0");
  EXPECT_EQ(format_count(999), "999");
  EXPECT_EQ(format_count(12345678), "12 345 678");
  EXPECT_EQ(format_count(-123456), "-123 456");
}

TEST(FormatDegrees, RoundsToWholeDegrees) {
  EXPECT_EQ(format_degrees(0.5 * std::numbers::pi), "90°");
  EXPECT_EQ(format_degrees(std::nan("")), "–");
}

}  // namespace
}  // namespace gudgeon
