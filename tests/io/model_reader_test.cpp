// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Reading model files: values, defaults, and everything that can be wrong, each at its place.
#include "gudgeon/io/model_reader.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gudgeon {
namespace {

constexpr double kPi = std::numbers::pi;

constexpr const char* kGood = R"(name = "press"
gravity = ["9.81 m/s^2", 0]
[bodies.rod]
mass = "1 kg"
inertia = "2 kg m^2"
points = { A = [0, 0], S = ["300 mm", 0] }
[bodies.crank]
mass = "148 g"
inertia = 0.5
center_of_mass = ["23 mm", 1e-3]
points = { O = [0, 0], A = ["45 mm", 0] }
start = { angle = "60 deg", position = ["1 mm", 0] }
[bodies.frame]
points = { O = [0, 0] }
[bodies.slider]
mass = 1
inertia = 0
points = { S = [0, 0] }
[joints.O]
type = "revolute"
between = ["frame.O", "crank.O"]
[joints.guide]
type = "prismatic"
between = ["frame.O", "slider.S"]
direction = "pi/2"
start = { displacement = "2 mm" }
[joints.S]
type = "rigid"
between = ["rod.S", "slider.S"]
relative_angle = "90 deg"
[joints.A]
type = "revolute_clearance"
bearing = "crank.A"
journal = "rod.A"
bearing_radius = "15 mm"
radial_clearance = "0.5 mm"
width = "20 mm"
contact = "pin"
[contacts.pin]
bearing_material = "steel"
journal_material = "bronze"
friction = { law = "lugre_steady", static_coefficient = 0.15, kinetic_coefficient = "10 %" }
wear = { law = "archard", coefficient = "8e-14 1/Pa", bearing_share = 0.75 }
normal_direction = "eccentricity"
[materials.steel]
young_modulus = "200 GPa"
poisson_ratio = 0.3
[materials.bronze]
young_modulus = "110 GPa"
poisson_ratio = 0.34
[drivers.crank]
body = "crank"
speed = "-60 rpm"
[loads.push]
point = "slider.S"
force = ["10 N", "-1 kN"]
[loads.motor]
body = "rod"
torque = "0.1 N m"
[study]
cycles = 3
wear_distribution = "point"
compare_ideal = false
[[study.reference]]
quantity = "peak"
channel = "A.normal_force"
measure = "peak"
values = [nan, "2 kN", 3]
)";

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const auto at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

std::string rendered(const ModelFile& model) { return render(model.diagnostics, model.source); }

std::string errors_of(const std::string& text) { return rendered(read_model_text("m.toml", text)); }

TEST(ModelReader, ReadsBodiesInTheOrderOfTheFile) {
  const ModelFile model = read_model_text("m.toml", kGood);
  ASSERT_FALSE(model.diagnostics.has_errors()) << rendered(model);
  const Mechanism& mechanism = model.mechanism;
  ASSERT_EQ(mechanism.bodies.size(), 4U);
  EXPECT_EQ(mechanism.bodies[0].name, "frame");
  EXPECT_EQ(mechanism.bodies[1].name, "rod");
  EXPECT_EQ(mechanism.bodies[2].name, "crank");
  EXPECT_EQ(mechanism.bodies[2].mass, 0.148);
  EXPECT_EQ(mechanism.bodies[2].inertia, 0.5);
  EXPECT_EQ(mechanism.bodies[2].center_of_mass, (Vec2{0.023, 0.001}));
  EXPECT_EQ(mechanism.bodies[2].points[1].position, (Vec2{0.045, 0.0}));
  EXPECT_DOUBLE_EQ(mechanism.bodies[2].start.angle.value(), kPi / 3.0);
  EXPECT_EQ(mechanism.bodies[2].start.position.value(), (Vec2{0.001, 0.0}));
  EXPECT_FALSE(mechanism.bodies[2].start.angle_rate.has_value());
  EXPECT_EQ(mechanism.gravity, (Vec2{9.81, 0.0}));
}

TEST(ModelReader, ReadsJointsAndContacts) {
  const Mechanism mechanism = read_model_text("m.toml", kGood).mechanism;
  ASSERT_EQ(mechanism.joints.size(), 4U);
  const auto& guide = std::get<Prismatic>(mechanism.joints[1].kind);
  EXPECT_DOUBLE_EQ(guide.direction, kPi / 2.0);
  EXPECT_EQ(guide.start.displacement.value(), 0.002);
  EXPECT_DOUBLE_EQ(std::get<Rigid>(mechanism.joints[2].kind).relative_angle, kPi / 2.0);
  const auto& pin = std::get<RevoluteClearance>(mechanism.joints[3].kind);
  EXPECT_EQ(pin.bearing.body, "crank");
  EXPECT_EQ(pin.journal.point, "A");
  EXPECT_EQ(pin.radial_clearance, 0.0005);
  EXPECT_EQ(pin.contact.journal_material.young_modulus, 110e9);
  EXPECT_EQ(std::get<LankaraniNikravesh>(pin.contact.normal_force).restitution, 0.9);
  EXPECT_EQ(std::get<LugreSteady>(pin.contact.friction).kinetic_coefficient, 0.1);
  EXPECT_EQ(std::get<LugreSteady>(pin.contact.friction).stribeck_speed, 1e-3);
  EXPECT_DOUBLE_EQ(std::get<Archard>(pin.contact.bearing_wear).coefficient, 6e-14);
  EXPECT_DOUBLE_EQ(std::get<Archard>(pin.contact.journal_wear).coefficient, 2e-14);
  EXPECT_EQ(pin.contact.normal_direction, NormalDirection::eccentricity);
}

TEST(ModelReader, ReadsDriversLoadsAndStudy) {
  const ModelFile model = read_model_text("m.toml", kGood);
  EXPECT_DOUBLE_EQ(model.mechanism.drivers[0].start, kPi / 3.0);  // the body's start angle
  EXPECT_DOUBLE_EQ(model.mechanism.drivers[0].speed, -2.0 * kPi);
  EXPECT_EQ(std::get<ConstantForce>(model.mechanism.loads[0].kind).force, (Vec2{10.0, -1000.0}));
  EXPECT_EQ(std::get<ConstantTorque>(model.mechanism.loads[1].kind).torque, 0.1);
  EXPECT_EQ(model.study.cycle_driver, "crank");
  EXPECT_DOUBLE_EQ(model.study.cycle_time, 1.0);
  EXPECT_EQ(model.study.cycles, 3);
  EXPECT_EQ(model.study.cells, 1000);
  EXPECT_EQ(model.study.wear_distribution, WearDistribution::point);
  EXPECT_FALSE(model.study.compare_ideal);
  ASSERT_EQ(model.study.reference.size(), 1U);
  EXPECT_TRUE(std::isnan(model.study.reference[0].values[0]));
  EXPECT_EQ(model.study.reference[0].values[1], 2000.0);
}

TEST(ModelReader, KnowsWhereValuesStand) {
  const SourceMap source = read_model_text("m.toml", kGood).source;
  EXPECT_EQ(source.spans.at("bodies.crank.mass").line, 8);
  EXPECT_EQ(source.spans.at("bodies.crank.mass").column, 8);
  EXPECT_EQ(source.spans.at("bodies.crank.mass").length, 7);
  EXPECT_EQ(source.spans.at("bodies.crank.points.A").line, 11);
  EXPECT_TRUE(source.spans.contains("contacts.pin.friction.static_coefficient"));
  EXPECT_EQ(source.written.at("joints.A.radial_clearance"), "\"0.5 mm\"");
}

TEST(ModelReader, KnowsTheTextOfValuesBehindLettersOfSeveralBytes) {
  const std::string names = R"(name = "µ–𝛿"  # größer
description = "Δ"
bodies.frame.points = { "µ" = ["1 mm", "2 µm"], B = ["3 mm", "4 µm"] }
)";
  const SourceMap source = read_model_text("m.toml", names).source;
  EXPECT_EQ(source.written.at("name"), "\"µ–𝛿\"");
  EXPECT_EQ(source.written.at("description"), "\"Δ\"");
  EXPECT_EQ(source.written.at("bodies.frame.points.µ.1"), "\"2 µm\"");
  EXPECT_EQ(source.written.at("bodies.frame.points.B.0"), "\"3 mm\"");
  EXPECT_EQ(source.written.at("bodies.frame.points.B.1"), "\"4 µm\"");
  EXPECT_EQ(source.spans.at("bodies.frame.points.B.1").column, 62);
}

TEST(ModelReader, ReportsSeveralErrorsAtOnceEachAtItsPlace) {
  std::string text = replaced(kGood, "mass = \"1 kg\"", "mass = \"1 m\"");
  text = replaced(text, "radial_clearance = \"0.5 mm\"", "radial_clearance = \"-0.5 mm\"");
  text = replaced(text, "width", "widht");
  text = replaced(text, "journal = \"rod.A\"", "journal = \"rood.A\"");
  const std::string errors = errors_of(text);
  for (const char* expected : {
           "m.toml:4:8: error E-FILE-005: body 'rod': mass is \"1 m\", a length; expected a mass (kg)\n",
           "m.toml:34:11: error E-MODEL-021: joint 'A' is on 'rood.A', and no body has the name 'rood'\n",
           "m.toml:36:20: error E-MODEL-012: joint 'A': radial_clearance is \"-0.5 mm\" (-0.0005 m); it must be "
           "positive\n"
           "   36 | radial_clearance = \"-0.5 mm\"\n"
           "      |                    ^^^^^^^^^\n",
           "m.toml:31:9: error E-FILE-002: joint 'A': width is missing\n",
           "m.toml:37:1: error E-FILE-001: joint 'A' has no key 'widht'\n",
           "Did you mean 'width'?",
           "5 errors\n",
       }) {
    EXPECT_NE(errors.find(expected), std::string::npos) << expected << "in\n" << errors;
  }
}

TEST(ModelReader, ReportsBadSyntaxAtItsPlace) {
  const std::string errors = errors_of("name = \"a\"\nmass = 3 kg\n");
  EXPECT_TRUE(errors.starts_with("m.toml:2:10: error E-TOML-001: ")) << errors;
  EXPECT_TRUE(errors_of("\xff\xfe").starts_with("m.toml:1:")) << errors_of("\xff\xfe");
}

// Line ends of any kind may stand within a text.
TEST(ModelReader, ReadsTextsOverSeveralLinesFromAnySystem) {
  const ModelFile model = read_model_text("m.toml", "name = \"a\"\r\ndescription = \"\"\"one\r\n\ttwo\"\"\"\r\n");
  EXPECT_EQ(model.mechanism.description, "one\n\ttwo");
  EXPECT_EQ(rendered(model).find("E-FILE-015"), std::string::npos);
}

TEST(ModelReader, CutsLongValuesInMessages) {
  const std::string text = replaced(kGood, "mass = 1\n", "mass = \"" + std::string(100000, '3') + "x\"\n");
  const std::string errors = errors_of(text);
  EXPECT_NE(errors.find("E-FILE-004"), std::string::npos);
  EXPECT_LT(errors.size(), 2000U);
}

TEST(ModelReader, SurvivesTablesOfTheWrongKind) {
  for (const char* text : {"", "bodies = 3", "[bodies]\ncrank = 3", "[joints]\nA = [1]", "study = 1", "cases = 1",
                           "[cases]\na = 2", "[cases.a]\nset = 3", "[study]\nreference = 3", "[study]\nreference = [3]",
                           "loads = \"x\"", "materials.a = 1", "contacts.a = 1979-05-27"}) {
    EXPECT_TRUE(read_model_text("m.toml", text).diagnostics.has_errors()) << text;
  }
}

struct Spoiled {
  const char* from;
  const char* to;
  const char* message;
};

class ModelReaderRefuses : public testing::TestWithParam<Spoiled> {};

TEST_P(ModelReaderRefuses, WithItsMessage) {
  const std::string errors = errors_of(replaced(kGood, GetParam().from, GetParam().to));
  EXPECT_NE(errors.find(GetParam().message), std::string::npos) << errors;
}

INSTANTIATE_TEST_SUITE_P(
    Errors, ModelReaderRefuses,
    testing::Values(
        Spoiled{"\"200 GPa\"", "\"200 GPaa\"", "unknown unit 'GPaa'; did you mean 'GPa'?"},
        Spoiled{"\"revolute\"", "\"revolut\"",
                "possible: revolute, prismatic, pin_in_slot, rigid, revolute_clearance, prismatic_clearance, "
                "pin_in_slot_clearance   Did you mean"},
        Spoiled{"\"revolute\"", "\"\"", "unknown type ''"},
        Spoiled{"[joints.O]\n", "[joints.O]\nbranh = \"left\"\n", "Did you mean 'branch'?"},
        Spoiled{"\"archard\"", "\"archrd\"", "unknown law 'archrd'"}, Spoiled{"\"archard\"", "\"\"", "unknown law ''"},
        Spoiled{"static_coefficient = 0.15, ", "", "static_coefficient is missing"},
        Spoiled{"static_coefficient = 0.15", "static_coefficient = -1",
                "static_coefficient is -1; it must be not negative"},
        Spoiled{"\"bronze\"", "\"bronce\"", "unknown material 'bronce'"},
        Spoiled{"contact = \"pin\"", "contact = \"pen\"", "unknown contact 'pen'"},
        Spoiled{"bearing_share = 0.75", "bearing_share = 2", "from 0 to 1"},
        Spoiled{"normal_direction", "bearing_wear = { law = \"no_wear\" }\nnormal_direction", "exclude each other"},
        Spoiled{"\"crank.A\"", "\"crank\"", "write \"body.point\""},
        Spoiled{"points = { O = [0, 0], A", "points = { O = [0, 0, 0], A", "array of two quantities"},
        Spoiled{"[\"23 mm\", 1e-3]", "[\"23 mm\", \"1 s\"]",
                "center_of_mass: y is \"1 s\", a time; expected a length (m)"},
        Spoiled{"mass = 1\n", "mass = inf\n", "mass is inf; it must be finite"},
        Spoiled{"\"-60 rpm\"", "\"-60 1/s\"", "expected an angular speed (rad/s)"},
        Spoiled{"body = \"crank\"", "slide = \"guide\"", "expected a speed (m/s)"},
        Spoiled{"body = \"crank\"\n", "", "body or slide is missing"},
        Spoiled{"cycles = 3", "cycles = 2.5", "expected a whole number"},
        Spoiled{"cycles = 3", "cycles = 3000000000", "whole numbers go from -1000000000 to 1000000000 here"},
        Spoiled{"cycles = 3", "cycles = -1e300", "whole numbers go from -1000000000 to 1000000000 here"},
        Spoiled{"cycles = 3", "cycles = 99999999999999999999",
                "whole numbers go from -9223372036854775808 to 9223372036854775807"},
        Spoiled{"mass = 1\n", "mass = 1e400\n", "numbers go up to 1.8e308 in size"},
        Spoiled{"mass = 1\n", "mass = 1e101\n", "E-FILE-016"}, Spoiled{"mass = 1\n", "mass = 1e-400\n", "E-FILE-016"},
        Spoiled{"mass = 1\n", "mass = \"1e-400 kg\"\n", "out of the range"},
        Spoiled{"[\"23 mm\", 1e-3]", "[\"23 mm\", \"-1e200 mm\"]",
                "center_of_mass: y is \"-1e200 mm\", -1e+197 in SI; values are 0 or from 1e-100 to 1e+100 in size"},
        Spoiled{"cycles = 3", "cycle_time = \"5e-324 s\"", "cycle_time is \"5e-324 s\""},
        Spoiled{"name = \"press\"", "name = \"pr\\u001b[2Jess\"",
                "the string \"pr\\u001B[2Jess\" contains the control character U+001B"},
        Spoiled{"[bodies.frame]", "[bodies.\"fr\\name\"]\n[bodies.frame]", "contains the control character U+000A"},
        Spoiled{"cycles = 3", "cycle_time = 3\ncycle_driver = \"crank\"", "exclude each other"},
        Spoiled{"compare_ideal = false", "compare_ideal = 0", "expected true or false"},
        Spoiled{"wear_distribution = \"point\"", "wear_distribution = \"points\"",
                "possible: spread, point   Did you mean 'point'?"},
        Spoiled{"[study]", "[studdy]\n[study]", "the model has no key 'studdy'"},
        Spoiled{"[bodies.frame]", "[bodies.frame]\nmass = 1", "body 'frame' has no key 'mass'"},
        Spoiled{"name = \"press\"", "name = \"my press\"", "a name is made of"}));

// The good model with a law of normal force.
std::string with_normal_force(const std::string& law) {
  std::string text = kGood;
  const std::string key = "normal_direction";
  return text.insert(text.find(key), "normal_force = " + law + "\n");
}

AnyNormalForce read_normal_force(const std::string& law) {
  const ModelFile model = read_model_text("press.toml", with_normal_force(law));
  EXPECT_FALSE(model.diagnostics.has_errors()) << render(model.diagnostics, model.source);
  return std::get<RevoluteClearance>(model.mechanism.joints.back().kind).contact.normal_force;
}

TEST(ModelReader, ReadsDampedPointLaws) {
  const auto law = read_normal_force(R"({ law = "exact_restitution", restitution = 0.3, exponent = 1.4 })");
  EXPECT_EQ(std::get<DampedHertz<ExactRestitutionDamping>>(law).restitution, 0.3);
  EXPECT_EQ(std::get<DampedHertz<ExactRestitutionDamping>>(law).exponent, 1.4);
  const auto linear = read_normal_force(R"({ law = "kelvin_voigt", stiffness = "2 kN/mm", damping = "3 N s/m" })");
  EXPECT_EQ(std::get<KelvinVoigt>(linear).stiffness, 2e6);
  EXPECT_EQ(std::get<KelvinVoigt>(linear).damping, 3.0);
}

TEST(ModelReader, ReadsNestedDamping) {
  const auto law = read_normal_force(R"({ law = "johnson", damping = { law = "lee_wang", restitution = "80 %" } })");
  EXPECT_EQ(std::get<LeeWangDamping>(std::get<Johnson>(law).damping).restitution, 0.8);
  const auto elastic = read_normal_force(R"({ law = "persson" })");
  EXPECT_TRUE(std::holds_alternative<NoDamping>(std::get<Persson>(elastic).damping));
}

TEST(ModelReader, FindsWhatIsWrongWithNestedDamping) {
  for (const auto& [law, message] :
       {std::pair{R"({ law = "johnson", damping = { law = "lee_wong" } })", "Did you mean 'lee_wang'?"},
        {R"({ law = "johnson", damping = { law = "lee_wang", restitusion = 0.8 } })", "has no key 'restitusion'"},
        {R"({ law = "johnson", damping = 3 })", "damping"},
        {R"({ law = "johnson", restitution = 0.9 })", "has no key 'restitution'"},
        {R"({ law = "hertz", damping = { law = "lee_wang" } })", "has no key 'damping'"},
        {R"({ law = "johnson", damping = { law = "lee_wang", restitution = 1.2 } })", "restitution is 1.2"},
        {R"({ law = "kelvin_voigt", stiffness = "1 N/m" })", "damping is missing"}}) {
    const std::string found = errors_of(with_normal_force(law));
    EXPECT_NE(found.find(message), std::string::npos) << law << "\n" << found;
  }
}

TEST(ModelReader, RemarksUnusedContacts) {
  const std::string text =
      std::string{kGood} + "[contacts.other]\nbearing_material = \"steel\"\njournal_material = \"steel\"\n";
  EXPECT_NE(errors_of(text).find("R-FILE-001: contact 'other' is used by no joint"), std::string::npos);
}

TEST(ModelReader, ThrowsOnlyWhenTheFileCannotBeRead) {
  EXPECT_THROW(read_model("/nowhere/model.toml"), FileError);
  EXPECT_THROW(read_model("/tmp"), FileError);
}

}  // namespace
}  // namespace gudgeon
