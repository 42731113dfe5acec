// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Rates and accelerations of expressions and tables against those written down, and motions that have none.
#include "gudgeon/system/motion_function.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>

#include "tests/oracle/driver_motion.h"
#include "tests/oracle/mechanism_parts.h"
#include "tests/system/model_errors.h"

namespace gudgeon {
namespace {

using testing::HasSubstr;

// A crank with that motion, and another that sets the cycle time when it turns.
Mechanism make_driven(Expression expression, double turns_per_second = 0.0) {
  Mechanism mechanism = oracle::make_empty("driven", {}, {});
  mechanism.drivers.push_back({"motor", DrivenAngle{"crank"}, 0.0, 0.0, std::move(expression)});
  if (turns_per_second != 0.0) {
    mechanism.drivers.push_back({"clock", DrivenAngle{"clock"}, 0.0, 2.0 * std::numbers::pi * turns_per_second});
  }
  return mechanism;
}

std::vector<DrivenMotion> choose(const Mechanism& mechanism) {
  std::vector<DrivenMotion> motions{{0, 0.25, 0.0, mechanism.drivers[0].motion}};
  choose_difference_steps(mechanism, motions);
  return motions;
}

struct Known {
  std::string text;
  double turns_per_second;  // 0: the cycle is a second
  std::function<DrivenValue(double)> motion;
};

std::vector<Known> make_known() {
  return {
      {"3.5", 0.0,
       [](double) {
         return DrivenValue{3.5, 0.0, 0.0};
       }},
      {"0.3 - 40*t", 0.0,
       [](double t) {
         return DrivenValue{0.3 - 40.0 * t, -40.0, 0.0};
       }},
      {"sin(500*t)", 0.0,
       [](double t) {
         return DrivenValue{std::sin(500.0 * t), 500.0 * std::cos(500.0 * t), -250000.0 * std::sin(500.0 * t)};
       }},
      // many whole waves a cycle, for which a coarse grid sees nothing
      {"0.02*sin(2*pi*64*t)", 0.0,
       [](double t) {
         const double w = 128.0 * std::numbers::pi;
         return DrivenValue{0.02 * std::sin(w * t), 0.02 * w * std::cos(w * t), -0.02 * w * w * std::sin(w * t)};
       }},
      {"cos(0.5*t)", 0.0,
       [](double t) {
         return DrivenValue{std::cos(0.5 * t), -0.5 * std::sin(0.5 * t), -0.25 * std::cos(0.5 * t)};
       }},
      {"2*t^3 + exp(-4*t)", 0.0,
       [](double t) {
         const double e = std::exp(-4.0 * t);
         return DrivenValue{2.0 * t * t * t + e, 6.0 * t * t - 4.0 * e, 12.0 * t + 16.0 * e};
       }},
      {"10*t + 0.1*sin(523.6*t)", 83.3333,
       [](double t) {
         const double w = 523.6;
         return DrivenValue{10.0 * t + 0.1 * std::sin(w * t), 10.0 + 0.1 * w * std::cos(w * t),
                            -0.1 * w * w * std::sin(w * t)};
       }},
  };
}

TEST(MotionFunction, ExpressionsAreDifferentiatedToTenDigits) {
  for (const Known& known : make_known()) {
    const Mechanism mechanism = make_driven({known.text, {}}, known.turns_per_second);
    const auto motions = choose(mechanism);
    MotionFunction function(motions[0]);
    const double cycle_time = known.turns_per_second > 0.0 ? 1.0 / known.turns_per_second : 1.0;
    double speed = 1.0;
    double curvature = 1.0;
    for (int k = 0; k <= 300; ++k) {
      speed = std::max(speed, std::abs(known.motion(k * cycle_time / 97.0).rate));
      curvature = std::max(curvature, std::abs(known.motion(k * cycle_time / 97.0).acceleration));
    }
    // Rounding of a value of its size is all that a motion without curvature shows.
    curvature = std::max(curvature, speed / cycle_time);
    // Three cycles: what the step was chosen for, and beyond.
    for (int k = 0; k <= 300; ++k) {
      const double t = k * cycle_time / 97.0;
      const DrivenValue expected = known.motion(t);
      const DrivenValue found = function.eval(t);
      EXPECT_NEAR(found.value, 0.25 + expected.value, 1e-13 * (1.0 + std::abs(expected.value))) << known.text;
      EXPECT_NEAR(found.rate, expected.rate, 1e-10 * speed) << known.text << " at " << t;
      EXPECT_NEAR(found.acceleration, expected.acceleration, 1e-10 * curvature) << known.text << " at " << t;
    }
  }
}

TEST(MotionFunction, TablesAreDifferentiatedExactly) {
  const DrivenMotion motion{0, 0.25, 0.0, oracle::make_cubic_curve(-0.08, 0.5, -2.1, 3.0)};
  MotionFunction function(motion);
  for (const double t : {-0.4, 0.0, 0.33, 1.2}) {
    const DrivenValue found = function.eval(t);
    EXPECT_NEAR(found.value, 0.25 - 0.08 + t * (0.5 + t * (-2.1 + t * 3.0)), 1e-14);
    EXPECT_NEAR(found.rate, 0.5 + t * (-4.2 + t * 9.0), 1e-13);
    EXPECT_NEAR(found.acceleration, -4.2 + 18.0 * t, 1e-12);
  }
}

TEST(MotionFunction, UniformMotionHasNoAcceleration) {
  const DrivenValue at = MotionFunction({0, 0.5, -3.0}).eval(0.2);
  EXPECT_NEAR(at.value, -0.1, 1e-15);
  EXPECT_EQ(at.rate, -3.0);
  EXPECT_EQ(at.acceleration, 0.0);
}

TEST(MotionFunction, RoughMotionsAreErrors) {
  // A kink, a jump of the acceleration, a jump.
  for (const char* text : {"abs(t - 0.3217)", "t < 0.3217 ? 0 : (t - 0.3217)^2", "t < 0.3217 ? 0 : 0.01"}) {
    const auto found = catch_diagnostics([&] { choose(make_driven({text, {}})); });
    ASSERT_EQ(found.size(), 1u) << text;
    EXPECT_EQ(found[0].code, "E-MODEL-062");
    EXPECT_EQ(found[0].path, "drivers.motor.motion");
    EXPECT_THAT(found[0].message, HasSubstr("is not smooth")) << text;
    EXPECT_THAT(found[0].notes.at(0), HasSubstr("table"));
  }
}

TEST(MotionFunction, MotionsWithoutValueAndBadTextsAreErrors) {
  const auto nothing = catch_diagnostics([&] { choose(make_driven({"sqrt(t - 0.1)", {}})); });
  ASSERT_EQ(nothing.size(), 1u);
  EXPECT_THAT(nothing[0].message, HasSubstr("has no value"));
  const auto unreadable = catch_diagnostics([&] { choose(make_driven({"3*(t", {}})); });
  ASSERT_EQ(unreadable.size(), 1u);
  EXPECT_EQ(unreadable[0].code, "E-MODEL-062");
}

}  // namespace
}  // namespace gudgeon
