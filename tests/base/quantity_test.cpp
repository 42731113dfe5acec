// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Quantities: values to the last bit, dimensions, and messages that name the wrong part.
#include "gudgeon/base/quantity.h"

#include <gtest/gtest.h>

#include <array>
#include <clocale>
#include <numbers>

namespace gudgeon {
namespace {

constexpr double kHalfTurn = std::numbers::pi;

struct Good {
  const char* text;
  double value;
  Dimension dimension;
};

class QuantityReads : public testing::TestWithParam<Good> {};

TEST_P(QuantityReads, ValueAndDimension) {
  const auto parsed = parse_quantity(GetParam().text);
  const auto* quantity = std::get_if<Quantity>(&parsed);
  ASSERT_NE(quantity, nullptr) << std::get<QuantityError>(parsed).message;
  EXPECT_DOUBLE_EQ(quantity->value, GetParam().value);
  EXPECT_EQ(quantity->dimension, GetParam().dimension) << si_unit(quantity->dimension);
}

INSTANTIATE_TEST_SUITE_P(
    Texts, QuantityReads,
    testing::Values(Good{"12", 12.0, dimension::kNone}, Good{"-0.5 mm", -0.0005, dimension::kLength},
                    Good{"0.5mm", 0.0005, dimension::kLength}, Good{" 430 mm ", 0.43, dimension::kLength},
                    Good{"200 GPa", 200e9, dimension::kPressure}, Good{"8e-14 1/Pa", 8e-14, dimension::kPerPressure},
                    Good{"8e-14 Pa^-1", 8e-14, dimension::kPerPressure},
                    Good{"0.2382e-3 kg m^2", 0.2382e-3, dimension::kInertia},
                    Good{"4 kg mm^2", 4e-6, dimension::kInertia}, Good{"148 g", 0.148, dimension::kMass},
                    Good{"60.28 deg", 60.28 * kHalfTurn / 180.0, dimension::kAngle},
                    Good{"60 rpm", 2.0 * kHalfTurn, dimension::kAngularSpeed},
                    Good{"-1 rev/s", -2.0 * kHalfTurn, dimension::kAngularSpeed},
                    Good{"1 rev/min", kHalfTurn / 30.0, dimension::kAngularSpeed},
                    Good{"2*pi rad/s", 2.0 * kHalfTurn, dimension::kAngularSpeed},
                    Good{"-pi rad/s", -kHalfTurn, dimension::kAngularSpeed},
                    Good{"-3 pi rad/s", -3.0 * kHalfTurn, dimension::kAngularSpeed},
                    Good{"pi/2", kHalfTurn / 2.0, dimension::kNone}, Good{"9.81 m/s^2", 9.81, dimension::kAcceleration},
                    Good{"9.81 m/s/s", 9.81, dimension::kAcceleration}, Good{"0.1 N m", 0.1, dimension::kTorque},
                    Good{"0.1 N*m", 0.1, dimension::kTorque}, Good{"3 J", 3.0, dimension::kTorque},
                    Good{"50 Hz", 50.0, dimension::kPerTime}, Good{"2 bar", 2e5, dimension::kPressure},
                    Good{"15 %", 0.15, dimension::kNone}, Good{"2 h", 7200.0, dimension::kTime},
                    Good{"3 min", 180.0, dimension::kTime}, Good{"1 t", 1000.0, dimension::kMass},
                    Good{"1 in", 0.0254, dimension::kLength}, Good{"12 µm", 12e-6, dimension::kLength},
                    Good{"90°", kHalfTurn / 2.0, dimension::kAngle}, Good{"9.81 m/s²", 9.81, dimension::kAcceleration},
                    Good{"400 s/m", 400.0, dimension::kTimePerLength}, Good{"+.5 m", 0.5, dimension::kLength},
                    Good{"2 N/mm", 2000.0, dimension::kStiffness}, Good{"3 N s/m", 3.0, dimension::kDamping},
                    Good{"3 N m/rad", 3.0, dimension::kAngularStiffness},
                    Good{"3 N m s/rad", 3.0, dimension::kAngularDamping}));

struct BadQuantity {
  const char* text;
  const char* message;  ///< a part of it
};

class QuantityRefuses : public testing::TestWithParam<BadQuantity> {};

TEST_P(QuantityRefuses, AndNamesTheWrongPart) {
  const auto parsed = parse_quantity(GetParam().text);
  const auto* wrong = std::get_if<QuantityError>(&parsed);
  ASSERT_NE(wrong, nullptr);
  EXPECT_NE(wrong->message.find(GetParam().message), std::string::npos) << wrong->message;
}

INSTANTIATE_TEST_SUITE_P(
    Texts, QuantityRefuses,
    testing::Values(BadQuantity{"", "empty"}, BadQuantity{"   ", "empty"},
                    BadQuantity{"mm", "must begin with a finite number"}, BadQuantity{"nan", "finite number"},
                    BadQuantity{"-inf m", "finite number"}, BadQuantity{"1e999 m", "1e999"},
                    BadQuantity{"1e300 Gm^3", "too large"},
                    BadQuantity{"3 mmm", "unknown unit 'mmm'; did you mean 'mm'?"},
                    BadQuantity{"3 Mpa", "unknown unit 'Mpa'"}, BadQuantity{"1 gpa", "did you mean 'GPa'?"},
                    BadQuantity{"3 Nm", "did you mean 'N m'?"}, BadQuantity{"3 degrees", "did you mean 'deg'?"},
                    BadQuantity{"3 m^", "power of 'm'"}, BadQuantity{"3 m^0.5", "power of 'm'"},
                    BadQuantity{"3 m^99", "power of 'm'"}, BadQuantity{"3 m^-2147483648", "from -9 to 9"},
                    BadQuantity{"3 m^10", "from -9 to 9"}, BadQuantity{"3 m^99999999999", "power of 'm'"},
                    BadQuantity{"1e-320 nm", "too small"}, BadQuantity{"1e-999 m", "1e-999"},
                    BadQuantity{"3 m/", "missing after '/'"}, BadQuantity{"3 5 m", "'5 m' is not a unit"},
                    BadQuantity{"3,5 mm", "',5'"}, BadQuantity{"1/0 m", "divides by zero"},
                    BadQuantity{"0x10 m", "'x10'"}, BadQuantity{"3 // m", "expected at '/ m'"}));

TEST(Quantity, DoesNotDependOnTheLocale) {
  const std::string before = std::setlocale(LC_ALL, nullptr);
  std::setlocale(LC_ALL, "de_DE.UTF-8");  // where it is installed, the decimal sign is a comma
  EXPECT_EQ(std::get<Quantity>(parse_quantity("0.5 mm")).value, 0.0005);
  std::setlocale(LC_ALL, before.c_str());
}

TEST(Quantity, SiUnitsReadBackToTheirDimension) {
  const std::array<Dimension, 8> dimensions{dimension::kTorque,     dimension::kPerPressure, dimension::kNone,
                                            dimension::kInertia,    Dimension{1, 0, -3, 0},  Dimension{-2, 0, -1, 1},
                                            Dimension{2, 1, -3, 0}, Dimension{0, -1, 0, 0}};
  for (const Dimension dimension : dimensions) {
    const auto parsed = parse_quantity("1 " + si_unit(dimension));
    ASSERT_TRUE(std::holds_alternative<Quantity>(parsed)) << si_unit(dimension);
    EXPECT_EQ(std::get<Quantity>(parsed).dimension, dimension) << si_unit(dimension);
    EXPECT_EQ(std::get<Quantity>(parsed).value, 1.0);
  }
}

TEST(Quantity, DimensionsHaveNames) {
  EXPECT_EQ(dimension_name(dimension::kLength), "a length");
  EXPECT_EQ(dimension_name(dimension::kTorque), "a torque");
  EXPECT_EQ(si_unit(dimension::kAngularSpeed), "rad/s");
  EXPECT_EQ(si_unit(dimension::kNone), "1");
  EXPECT_EQ(dimension_name({1, 0, -3, 0}), "a quantity in m/s^3");
}

}  // namespace
}  // namespace gudgeon
