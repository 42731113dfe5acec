// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Every rule of friction in ideal joints, each broken alone.
#include "tests/model/broken_model.h"

namespace gudgeon::broken {
namespace {

std::function<void(Model&)> with_pin_friction(const JointFriction& friction) {
  return [friction](Model& m) { std::get<Revolute>(m.mechanism.joints[0].kind).friction = friction; };
}

std::function<void(Model&)> with_guide_friction(const JointFriction& friction) {
  return [friction](Model& m) { std::get<Prismatic>(m.mechanism.joints[3].kind).friction = friction; };
}

std::function<void(Model&)> with_slot_friction(const JointFriction& friction) {
  return [friction](Model& m) { m.mechanism.joints[2].kind = PinInSlot{{"rod", "S"}, {"slider", "S"}, 0.1, friction}; };
}

const CoulombSmooth kGood{.kinetic_coefficient = 0.1};
const Dahl kBristles{.kinetic_coefficient = 0.1};

TEST(Check, FindsNothingInGoodFriction) {
  for (const auto& change : {with_pin_friction({kGood, 0.01}), with_pin_friction({kBristles, 0.01}),
                             with_guide_friction({kGood}), with_guide_friction({kBristles, 0.0, 0.1, 0.02}),
                             with_slot_friction({kGood}), with_slot_friction({kGood, 0.01})}) {
    Model model = make_good();
    change(model);
    EXPECT_EQ(render(check(model.mechanism, model.study), {}), "");
  }
}

class CheckFindsInFriction : public testing::TestWithParam<Broken> {};

TEST_P(CheckFindsInFriction, TheBrokenRule) { expect_found(GetParam()); }

INSTANTIATE_TEST_SUITE_P(
    Of, CheckFindsInFriction,
    testing::Values(
        Broken{"E-MODEL-012", "joints.O.friction.pin_radius", "joint 'O': pin_radius is 0 m",
               with_pin_friction({kGood, 0.0})},
        Broken{"E-MODEL-012", "joints.S.friction.pin_radius", "not negative", with_slot_friction({kGood, -0.01})},
        Broken{"E-MODEL-012", "joints.guide.friction.guide_length", "not negative",
               with_guide_friction({kGood, 0.0, -0.1})},
        Broken{"E-MODEL-012", "joints.guide.friction.guide_height", "no meaning without a guide_length",
               with_guide_friction({kGood, 0.0, 0.0, 0.02})},
        Broken{"E-MODEL-030", "joints.O.friction.kinetic_coefficient", "joint 'O': friction",
               with_pin_friction({CoulombSmooth{.kinetic_coefficient = -0.1}, 0.01})},
        Broken{"E-MODEL-035", "joints.O.friction", "full_speed must be above dead_speed",
               with_pin_friction({CoulombRamp{0.1, 1e-3, 1e-4}, 0.01})},
        Broken{"E-MODEL-018", "joints.S.friction.law", "joint 'S': dahl bends bristles",
               with_slot_friction({kBristles, 0.01})},
        Broken{"E-MODEL-018", "study.ideal_friction", "joint 'A': the friction law of its contact", [](Model& m) {
                 ContactProperties contact = m.pin().contact;
                 contact.friction = kBristles;
                 m.mechanism.joints[1].kind =
                     PinInSlotClearance{{"crank", "A"}, {"rod", "A"}, 0.1, 0.3, 8e-3, 1e-4, 0.02, contact};
                 m.study.ideal_friction = true;
               }}));

TEST(IdealCounterpart, RubsAtTheSizesOfTheJournals) {
  Model model = make_good();
  const ContactProperties contact = model.pin().contact;
  auto& joints = model.mechanism.joints;
  joints.push_back({"block", PrismaticClearance{
                                 {"crank", "A"}, {"rod", "A"}, 0.1, 0.2, 0.3, 0.06, 0.04, 3e-3, 1e-4, 0.02, contact}});
  joints.push_back({"slot", PinInSlotClearance{{"crank", "A"}, {"rod", "A"}, 0.1, 0.3, 8e-3, 1e-4, 0.02, contact}});
  const Mechanism ideal = make_ideal_with_friction(model.mechanism);
  EXPECT_EQ(find_friction(ideal.joints[0].kind), nullptr);
  EXPECT_DOUBLE_EQ(find_friction(ideal.joints[1].kind)->pin_radius, 0.0095);
  EXPECT_DOUBLE_EQ(find_friction(ideal.joints[4].kind)->guide_length, 0.054);
  EXPECT_DOUBLE_EQ(find_friction(ideal.joints[4].kind)->guide_height, 0.04);
  EXPECT_DOUBLE_EQ(find_friction(ideal.joints[5].kind)->pin_radius, 8e-3);
  EXPECT_EQ(std::get<CoulombSmooth>(find_friction(ideal.joints[5].kind)->law).kinetic_coefficient, 0.1);
  for (const Joint& joint : make_ideal(model.mechanism).joints) EXPECT_EQ(find_friction(joint.kind), nullptr);
}

}  // namespace
}  // namespace gudgeon::broken
