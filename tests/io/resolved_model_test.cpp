// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// A model written out reads back as it was, bit by bit.
#include "gudgeon/io/resolved_model.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <numbers>

#include "gudgeon/io/model_reader.h"

namespace gudgeon {
namespace {

Mechanism make_every_kind() {
  Mechanism mechanism;
  mechanism.name = "all";
  mechanism.description = "quotes \" and \\ and\nlines\tand µ";
  mechanism.gravity = {0.1 + 0.2, -1e-99};
  mechanism.bodies = {
      {"frame", 0.0, 0.0, {}, {{"O", {}}}, {}},
      {"a", 1.0 / 3.0, 2e-7, {1e22, 3.0}, {{"O", {}}, {"P", {0.1, -0.0}}}, {0.1, 0.2, Vec2{1, 2}, Vec2{3, 4}}},
      {"b", 1.0, 1.0, {}, {{"P", {}}}, {}},
      {"c", 1.0, 1.0, {}, {{"P", {}}}, {}}};
  const Material steel{"steel", 2.07e11, 0.3};
  const Material other_steel{"steel", 1.9e11, 0.3};
  ContactProperties contact{"pin", steel, other_steel, Hertz{1.4}, Frictionless{}, NoWear{}, Archard{1e-14 / 3.0}};
  mechanism.joints = {{"j1", Revolute{{"frame", "O"}, {"a", "O"}}},
                      {"j2", RevoluteClearance{{"a", "P"}, {"b", "P"}, 0.01, 0.0003, 0.02, contact}},
                      {"j3", Prismatic{{"a", "P"}, {"b", "P"}, 0.3, std::numbers::pi, {0.4, 0.5}}},
                      {"j4", Rigid{{"b", "P"}, {"c", "P"}, -0.7}}};
  contact.normal_direction = NormalDirection::eccentricity;
  mechanism.joints.push_back({"j5", RevoluteClearance{{"a", "P"}, {"c", "P"}, 0.01, 0.0003, 0.02, contact}});
  mechanism.joints.push_back(
      {"j6",
       PrismaticClearance{{"a", "P"}, {"c", "P"}, 1.0 / 3.0, -0.2, 0.3, 0.07, 0.05, 3e-3, 1e-4 / 3.0, 0.02, contact}});
  mechanism.joints.push_back(
      {"j7", PinInSlotClearance{{"b", "P"}, {"c", "P"}, -1.0 / 7.0, 0.3, 8e-3, 2e-4, 0.02, contact}});
  mechanism.drivers = {{"d1", DrivenAngle{"a"}, 0.1, -1.0 / 7.0}, {"d2", DrivenSlide{"j3"}, 0.4, 2.0}};
  mechanism.loads = {{"l1", ConstantForce{{"a", "P"}, {1.0, 2.0}}}, {"l2", ConstantTorque{"b", -3.0}}};
  return mechanism;
}

TEST(ResolvedModel, WritesEveryKindSoThatItReadsBack) {
  const Mechanism mechanism = make_every_kind();
  Study study;
  study.cycle_time = 0.7;
  study.wear_acceleration = 1e5;
  study.stabilization = Stabilization::baumgarte;
  study.reference = {{"q", "A", "peak", {1.0, -2.5e-7}}};
  const std::string text = write_resolved_model(mechanism, study);
  const ModelFile back = read_model_text("resolved.toml", text);
  EXPECT_FALSE(back.diagnostics.has_errors()) << render(back.diagnostics, back.source) << text;
  EXPECT_EQ(write_resolved_model(back.mechanism, back.study), text);
  EXPECT_EQ(back.mechanism.description, mechanism.description);
  EXPECT_EQ(back.mechanism.gravity, mechanism.gravity);
  EXPECT_EQ(back.mechanism.bodies[1].mass, mechanism.bodies[1].mass);
  EXPECT_EQ(back.mechanism.bodies[1].center_of_mass, mechanism.bodies[1].center_of_mass);
  EXPECT_EQ(back.mechanism.bodies[1].start.velocity, mechanism.bodies[1].start.velocity);
  EXPECT_EQ(back.mechanism.drivers[0].speed, mechanism.drivers[0].speed);
  EXPECT_EQ(std::get<Prismatic>(back.mechanism.joints[2].kind).relative_angle, std::numbers::pi);
  const auto& pin = std::get<RevoluteClearance>(back.mechanism.joints[1].kind);
  EXPECT_EQ(std::get<Archard>(pin.contact.journal_wear).coefficient, 1e-14 / 3.0);
  EXPECT_EQ(pin.contact.journal_material.young_modulus, 1.9e11);
  const auto& guide = std::get<PrismaticClearance>(back.mechanism.joints[5].kind);
  EXPECT_EQ(guide.direction, 1.0 / 3.0);
  EXPECT_EQ(guide.relative_angle, -0.2);
  EXPECT_EQ(guide.journal_length, 0.07);
  EXPECT_EQ(guide.clearance, 1e-4 / 3.0);
  EXPECT_EQ(std::get<PinInSlotClearance>(back.mechanism.joints[6].kind).journal_radius, 8e-3);
  EXPECT_EQ(back.study.cycle_time, 0.7);
  EXPECT_EQ(back.study.reference[0].values, study.reference[0].values);
}

TEST(ResolvedModel, WritesNestedDampingSoThatItReadsBack) {
  Mechanism mechanism = make_every_kind();
  Study study;
  study.cycle_time = 0.7;
  Johnson johnson;
  johnson.damping = ExactRestitutionDamping{1.0 / 3.0};
  auto& pin = std::get<RevoluteClearance>(mechanism.joints[1].kind);
  for (const AnyNormalForce& law :
       {AnyNormalForce{johnson}, AnyNormalForce{Persson{}}, AnyNormalForce{KelvinVoigt{1e7 / 3.0, 20.0}}}) {
    pin.contact.normal_force = law;
    const std::string text = write_resolved_model(mechanism, study);
    const ModelFile back = read_model_text("resolved.toml", text);
    EXPECT_FALSE(back.diagnostics.has_errors()) << render(back.diagnostics, back.source) << text;
    EXPECT_EQ(write_resolved_model(back.mechanism, back.study), text);
  }
  pin.contact.normal_force = johnson;
  const ModelFile back = read_model_text("resolved.toml", write_resolved_model(mechanism, study));
  const auto& read = std::get<Johnson>(std::get<RevoluteClearance>(back.mechanism.joints[1].kind).contact.normal_force);
  EXPECT_EQ(std::get<ExactRestitutionDamping>(read.damping).restitution, 1.0 / 3.0);
}

TEST(ResolvedModel, WritesFrictionOfIdealJointsSoThatItReadsBack) {
  Mechanism mechanism = make_every_kind();
  const Lugre law{.static_coefficient = 0.2, .kinetic_coefficient = 0.1 / 3.0};
  std::get<Revolute>(mechanism.joints[0].kind).friction = JointFriction{law, 0.01 / 3.0};
  std::get<Prismatic>(mechanism.joints[2].kind).friction = JointFriction{CoulombSmooth{0.1}, 0.0, 0.07 / 3.0, 0.02};
  PinInSlot slot{{"a", "P"}, {"c", "P"}, 0.2};
  slot.friction = JointFriction{Threlfall{0.1}, 0.03 / 7.0};
  mechanism.joints.push_back({"j8", slot});
  Study study;
  study.cycle_time = 0.7;
  study.ideal_friction = true;
  const std::string text = write_resolved_model(mechanism, study);
  const ModelFile back = read_model_text("resolved.toml", text);
  EXPECT_FALSE(back.diagnostics.has_errors()) << render(back.diagnostics, back.source) << text;
  EXPECT_EQ(write_resolved_model(back.mechanism, back.study), text);
  EXPECT_TRUE(back.study.ideal_friction);
  const JointFriction& pin = *find_friction(back.mechanism.joints[0].kind);
  EXPECT_EQ(std::get<Lugre>(pin.law).kinetic_coefficient, 0.1 / 3.0);
  EXPECT_EQ(pin.pin_radius, 0.01 / 3.0);
  const JointFriction& guide = *find_friction(back.mechanism.joints[2].kind);
  EXPECT_EQ(guide.guide_length, 0.07 / 3.0);
  EXPECT_EQ(guide.guide_height, 0.02);
  EXPECT_EQ(find_friction(back.mechanism.joints.back().kind)->pin_radius, 0.03 / 7.0);
}

TEST(ResolvedModel, WritesOutDefaults) {
  const std::string text = write_resolved_model(make_every_kind(), {});
  for (const char* line : {"relative_tolerance = 1e-06", "warm_up_cycles = 0", "wear_distribution = \"spread\"",
                           "onset_speed_floor = \"0.001 m/s\"", "normal_direction = \"gap_gradient\""}) {
    EXPECT_NE(text.find(line), std::string::npos) << line;
  }
}

TEST(ResolvedModel, EveryExampleReadsBack) {
  int n_examples = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(GUDGEON_SOURCE_DIR "/examples")) {
    if (entry.path().extension() != ".toml") continue;
    ++n_examples;
    const ModelFile model = gudgeon::read_model(entry.path());
    EXPECT_EQ(render(model.diagnostics, model.source), "");
    const std::string text = write_resolved_model(model.mechanism, model.study);
    const ModelFile back = read_model_text("resolved.toml", text);
    EXPECT_EQ(render(back.diagnostics, back.source), "");
    EXPECT_EQ(write_resolved_model(back.mechanism, back.study), text);
    EXPECT_EQ(back.study.cycle_time, model.study.cycle_time);
  }
  EXPECT_GE(n_examples, 7);
}

}  // namespace
}  // namespace gudgeon
