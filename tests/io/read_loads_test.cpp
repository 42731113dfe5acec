// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Loads, motions and functions: what the file says is what the model has, and explain says it again.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "gudgeon/io/explain.h"
#include "gudgeon/io/model_reader.h"

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

TEST(ReadLoads, ExplainsWhatItCanReadAgain) {
  const ModelFile model = read_model(kLoadedModel);
  const std::string explained = explain(model.mechanism, model.study);
  const ModelFile again = read_model(explained);
  ASSERT_FALSE(again.diagnostics.has_errors()) << render(again.diagnostics, again.source) << explained;
  EXPECT_EQ(explain(again.mechanism, again.study), explained);
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
  EXPECT_THAT(find_messages("arguments = [0, 1, 3]", "arguments = [0, \"x\", 3]"), HasSubstr("a number is needed"));
  EXPECT_THAT(find_messages("value_unit = \"N m\"", "value_unit = \"mm\""), HasSubstr("E-FILE-005"));
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
