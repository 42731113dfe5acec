// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Loads, motions and functions: what the file says is what the model has, and the resolved model says it again.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numbers>

#include "gudgeon/io/model_reader.h"
#include "gudgeon/io/resolved_model.h"

namespace gudgeon {
namespace {

constexpr const char* kLoadedModel = R"toml(
name = "loads"
[bodies.frame]
points.O = [0, 0]
points.P = ["1 m", 0]
[bodies.arm]
mass = 1
inertia = 1
points.O = [0, 0]
points.A = ["0.5 m", 0]
[bodies.leg]
mass = 1
inertia = 1
points.A = [0, 0]
points.B = ["0.5 m", 0]
[joints.O]
type = "revolute"
between = ["frame.O", "arm.O"]
[joints.A]
type = "revolute"
between = ["arm.A", "leg.A"]
[drivers.knee]
body = "leg"
against = "arm"
motion = "a*sin(2*pi*f*t)"
constants = { a = "30 deg", f = "2 Hz" }
[loads.push]
point = "leg.B"
force = ["10 N", "-c*leg.B.y_velocity"]
axes = "arm"
constants = { c = "3 N s/m" }
[loads.motor]
body = "arm"
torque = { over = "arm.angle_rate", arguments = [0, 1, 3], values = [20, 15, 0], value_unit = "N m" }
[loads.spring]
type = "spring"
between = ["frame.P", "arm.A"]
stiffness = "2 N/mm"
damping = 4
free_length = "200 mm"
[loads.twist]
type = "torsion_spring"
between = ["arm", "leg"]
stiffness = "5 N m/rad"
free_angle = "10 deg"
[loads.bushing]
type = "bushing"
between = ["arm.A", "leg.A"]
stiffness = ["1 kN/m", "2 kN/m"]
angular_damping = "0.1 N m s/rad"
[study]
cycle_time = 1
)toml";

ModelFile read_model(const std::string& text) { return read_model_text("model.toml", text); }

/// Reads the model with one text replaced and returns all messages.
std::string find_messages(const std::string& from, const std::string& to) {
  std::string text = kLoadedModel;
  text.replace(text.find(from), from.size(), to);
  const ModelFile model = read_model(text);
  return render(model.diagnostics, model.source);
}

TEST(ReadLoads, TakesEveryTypeInSi) {
  const ModelFile model = read_model(kLoadedModel);
  ASSERT_FALSE(model.diagnostics.has_errors()) << render(model.diagnostics, model.source);
  const auto& loads = model.mechanism.loads;
  ASSERT_EQ(loads.size(), 5U);
  const auto& push = std::get<VariableForce>(loads[0].kind);
  EXPECT_EQ(push.axes, "arm");
  EXPECT_EQ(std::get<double>(push.x), 10.0);
  EXPECT_EQ(std::get<Expression>(push.y).constants.at(0).second, 3.0);
  const auto& curve = std::get<SampledCurve>(std::get<VariableTorque>(loads[1].kind).torque);
  EXPECT_EQ(curve.over, "arm.angle_rate");
  EXPECT_EQ(curve.values, (std::vector<double>{20.0, 15.0, 0.0}));
  const auto& spring = std::get<Spring>(loads[2].kind);
  EXPECT_DOUBLE_EQ(spring.stiffness, 2000.0);
  EXPECT_DOUBLE_EQ(spring.free_length, 0.2);
  EXPECT_DOUBLE_EQ(std::get<TorsionSpring>(loads[3].kind).free_angle, 0.17453292519943295);
  EXPECT_EQ(std::get<Bushing>(loads[4].kind).stiffness, (Vec2{1000.0, 2000.0}));
  const Driver& knee = model.mechanism.drivers.at(0);
  EXPECT_EQ(std::get<DrivenAngle>(knee.target).against, "arm");
  EXPECT_EQ(std::get<Expression>(knee.motion).text, "a*sin(2*pi*f*t)");
}

TEST(ReadLoads, ResolvedModelReadsBack) {
  const ModelFile model = read_model(kLoadedModel);
  const std::string resolved = write_resolved_model(model.mechanism, model.study);
  const ModelFile again = read_model(resolved);
  ASSERT_FALSE(again.diagnostics.has_errors()) << render(again.diagnostics, again.source) << resolved;
  EXPECT_EQ(write_resolved_model(again.mechanism, again.study), resolved);
}

TEST(ReadLoads, TellsWhatIsWrongWithAFormula) {
  using testing::AllOf;
  using testing::HasSubstr;
  EXPECT_THAT(find_messages("-c*leg.B.y_velocity", "-c*leg.B.y_velocit"),
              AllOf(HasSubstr("E-MODEL-082"), HasSubstr("Did you mean 'leg.B.y_velocity'?")));
  EXPECT_THAT(find_messages("-c*leg.B.y_velocity", "-c*leg.y_acceleration"), HasSubstr("E-MODEL-083"));
  EXPECT_THAT(find_messages("-c*leg.B.y_velocity", "-c*(leg.angle"), HasSubstr("E-MODEL-081"));
  EXPECT_THAT(find_messages("a*sin(2*pi*f*t)", "a*sin(arm.angle)"), HasSubstr("the time t only"));
}

TEST(ReadLoads, TellsWhatIsWrongWithACurve) {
  using testing::AllOf;
  using testing::HasSubstr;
  EXPECT_THAT(find_messages("arguments = [0, 1, 3]", "arguments = [0, 3, 1]"),
              AllOf(HasSubstr("E-MODEL-085"), HasSubstr("must increase")));
  EXPECT_THAT(find_messages("arguments = [0, 1, 3]", "arguments = [0, \"x\", 3]"),
              HasSubstr("entry 2 of arguments is \"x\""));
  EXPECT_THAT(find_messages("value_unit = \"N m\"", "value_unit = \"mm\""), HasSubstr("E-FILE-005"));
}

TEST(ReadLoads, MarksThePartOfAFormulaThatIsWrong) {
  EXPECT_THAT(
      find_messages("-c*leg.B.y_velocity", "-c*µ*leg.B.z"),
      testing::AllOf(
          testing::HasSubstr(" | force = [\"10 N\", \"-c*µ*leg.B.z\"]\n      |                      ^\n"),
          testing::HasSubstr(" | force = [\"10 N\", \"-c*µ*leg.B.z\"]\n      |                        ^^^^^^^\n")));
  // All names at once, and the quantity that may have been meant.
  const std::string messages = find_messages("-c*leg.B.y_velocity", "5 Nn + q");
  EXPECT_THAT(messages, testing::HasSubstr("uses unknown name 'Nn'"));
  EXPECT_THAT(messages, testing::HasSubstr("uses unknown name 'q'"));
  EXPECT_THAT(messages, testing::HasSubstr("if a quantity was meant: unknown unit 'Nn'; did you mean 'N'?"));
}

TEST(ReadLoads, ScalesCurves) {
  std::string text = kLoadedModel;
  const std::string from = "arguments = [0, 1, 3], values = [20, 15, 0], value_unit = \"N m\"";
  text.replace(
      text.find(from), from.size(),
      "arguments = [0, \"60 rpm\", 720], argument_unit = \"deg/s\", values = [2, \"1500 N m\", 0], value_unit = "
      "\"kN m\"");
  const ModelFile model = read_model(text);
  ASSERT_FALSE(model.diagnostics.has_errors()) << render(model.diagnostics, model.source);
  const auto& torque = std::get<VariableTorque>(model.mechanism.loads[1].kind).torque;
  const auto& curve = std::get<SampledCurve>(torque);
  EXPECT_DOUBLE_EQ(curve.arguments[1], 2.0 * std::numbers::pi);
  EXPECT_DOUBLE_EQ(curve.arguments[2], 4.0 * std::numbers::pi);
  EXPECT_EQ(curve.values, (std::vector<double>{2000.0, 1500.0, 0.0}));
  EXPECT_THAT(find_messages("arguments = [0, 1, 3]", "argument_unit = \"s\", arguments = [0, 1, 3]"),
              testing::HasSubstr("argument_unit is \"s\", a time; expected an angular speed"));
}

TEST(ReadLoads, TakesFormulasThatLookLikeQuantities) {
  Mechanism mechanism = read_model(kLoadedModel).mechanism;
  mechanism.loads[1].kind = VariableTorque{"arm", "frame", Expression{"0.5", {}}};
  auto& push = std::get<VariableForce>(mechanism.loads[0].kind);
  push.x = Expression{"2*t + b", {{"b", 0.1}, {"c", 3.0}}};
  Study study;
  study.cycle_time = 1.0;
  const ModelFile back = read_model(write_resolved_model(mechanism, study));
  ASSERT_FALSE(back.diagnostics.has_errors()) << render(back.diagnostics, back.source);
  EXPECT_EQ(std::get<Expression>(std::get<VariableTorque>(back.mechanism.loads[1].kind).torque).text, "(0.5)");
  const auto& again = std::get<VariableForce>(back.mechanism.loads[0].kind);
  EXPECT_EQ(std::get<Expression>(again.x).constants.size(), 2U);  // those of x, and the same c of y
  EXPECT_EQ(std::get<Expression>(again.x).text, "2*t + b");
}

TEST(ReadLoads, HoldsTheKeyThatWasSetLater) {
  const auto read_with = [](const std::vector<Override>& overrides) {
    return read_model_text("model.toml", kLoadedModel, {}, overrides);
  };
  const ModelFile slow = read_with({{"drivers.knee.speed", "1 rev/s"}, {"study.cycle_driver", "knee"}});
  ASSERT_FALSE(slow.diagnostics.has_errors()) << render(slow.diagnostics, slow.source);
  EXPECT_TRUE(slow.mechanism.drivers[0].is_uniform());
  EXPECT_DOUBLE_EQ(slow.study.cycle_time, 1.0);
  EXPECT_EQ(slow.study.cycle_driver, "knee");
  const ModelFile both = read_with({{"study.cycle_driver", "knee"}, {"study.cycle_time", "2 s"}});
  EXPECT_THAT(render(both.diagnostics, both.source), testing::HasSubstr("exclude each other"));
}

TEST(ReadLoads, MotionsNeedACycleTime) {
  EXPECT_THAT(find_messages("cycle_time = 1", ""), testing::HasSubstr("E-STUDY-013"));
  EXPECT_THAT(find_messages("cycle_time = 1", "cycle_driver = \"knee\""), testing::HasSubstr("E-STUDY-012"));
}

TEST(ReadLoads, TellsWhatIsWrongWithASpring) {
  using testing::HasSubstr;
  EXPECT_THAT(find_messages("stiffness = \"2 N/mm\"", "stiffness = \"-2 N/mm\""), HasSubstr("stiffness"));
  EXPECT_THAT(find_messages("free_length = \"200 mm\"", ""), HasSubstr("free_length is missing"));
  EXPECT_THAT(find_messages("type = \"bushing\"", "type = \"bushin\""), HasSubstr("Did you mean 'bushing'?"));
  EXPECT_THAT(find_messages("motion = ", "speed = 1\nmotion = "), HasSubstr("exclude each other"));
}

}  // namespace
}  // namespace gudgeon
