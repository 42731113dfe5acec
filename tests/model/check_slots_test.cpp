// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Every rule of blocks and pins in slots, each broken alone.
#include <concepts>
#include <functional>

#include "tests/model/broken_model.h"

namespace gudgeon::broken {
namespace {

// The good model with a slot at A, spoiled.
template <class Kind>
std::function<void(Model&)> with_slot(std::function<void(Kind&)> spoil) {
  return [spoil](Model& m) {
    const ContactProperties contact = m.pin().contact;
    Kind slot;
    if constexpr (std::same_as<Kind, PrismaticClearance>) {
      slot = {{"crank", "A"}, {"rod", "A"}, 0.1, 0.0, 0.3, 0.06, 0.04, 3e-3, 1e-4, 0.02, contact};
    } else {
      slot = {{"crank", "A"}, {"rod", "A"}, 0.1, 0.3, 8e-3, 1e-4, 0.02, contact};
    }
    spoil(slot);
    m.mechanism.joints[1].kind = slot;
  };
}

std::function<void(Model&)> with_block(std::function<void(PrismaticClearance&)> spoil) { return with_slot(spoil); }
std::function<void(Model&)> with_pin(std::function<void(PinInSlotClearance&)> spoil) { return with_slot(spoil); }

TEST(Check, FindsNothingInAGoodSlot) {
  for (const auto& change : {with_block([](auto&) {}), with_pin([](auto&) {})}) {
    Model model = make_good();
    change(model);
    EXPECT_EQ(render(check(model.mechanism, model.study), {}), "");
  }
}

class CheckFindsInSlots : public testing::TestWithParam<Broken> {};

TEST_P(CheckFindsInSlots, TheBrokenRule) { expect_found(GetParam()); }

INSTANTIATE_TEST_SUITE_P(
    Of, CheckFindsInSlots,
    testing::Values(
        Broken{"E-MODEL-012", "joints.A.bearing_length", "joint 'A': bearing_length is 0 m; it must be positive",
               with_block([](auto& slot) { slot.bearing_length = 0.0; })},
        Broken{"E-MODEL-012", "joints.A.journal_length", "positive",
               with_block([](auto& slot) { slot.journal_length = -0.1; })},
        Broken{"E-MODEL-012", "joints.A.journal_height", "positive",
               with_block([](auto& slot) { slot.journal_height = 0.0; })},
        Broken{"E-MODEL-012", "joints.A.corner_radius", "positive",
               with_block([](auto& slot) { slot.corner_radius = 0.0; })},
        Broken{"E-MODEL-012", "joints.A.clearance", "clearance is -0.0001 m; it must be positive",
               with_block([](auto& slot) { slot.clearance = -1e-4; })},
        Broken{"E-MODEL-012", "joints.A.width", "positive", with_block([](auto& slot) { slot.width = kNan; })},
        Broken{"E-MODEL-005", "joints.A.direction", "finite", with_block([](auto& slot) { slot.direction = kNan; })},
        Broken{"E-MODEL-005", "joints.A.relative_angle", "finite",
               with_block([](auto& slot) { slot.relative_angle = kNan; })},
        Broken{"E-MODEL-014", "joints.A.journal_length", "it must be below the bearing_length, 0.3 m",
               with_block([](auto& slot) { slot.journal_length = 0.3; })},
        Broken{"E-MODEL-015", "joints.A.corner_radius", "at most half the block's length and height, 0.02 m",
               with_block([](auto& slot) { slot.corner_radius = 0.021; })},
        Broken{"E-MODEL-017", "joints.A.clearance", "the block could turn over",
               with_block([](auto& slot) { slot.clearance = 0.02; })},
        Broken{"E-MODEL-017", "joints.A.clearance", "pin_in_slot_clearance", with_block([](auto& slot) {
                 slot.journal_length = slot.journal_height = 2.0 * (slot.corner_radius = 0.02);
               })},
        Broken{"E-MODEL-012", "joints.A.bearing_length", "positive",
               with_pin([](auto& slot) { slot.bearing_length = 0.0; })},
        Broken{"E-MODEL-012", "joints.A.journal_radius", "positive",
               with_pin([](auto& slot) { slot.journal_radius = kNan; })},
        Broken{"E-MODEL-012", "joints.A.clearance", "positive", with_pin([](auto& slot) { slot.clearance = 0.0; })},
        Broken{"E-MODEL-005", "joints.A.direction", "finite", with_pin([](auto& slot) { slot.direction = kNan; })},
        Broken{"E-MODEL-016", "joints.A.journal_radius", "does not fit into a slot of bearing_length 0.3 m",
               with_pin([](auto& slot) { slot.journal_radius = 0.15; })},
        Broken{"E-MODEL-021", "joints.A.journal", "Did you mean 'rod'?",
               with_pin([](auto& slot) { slot.journal.body = "rood"; })},
        Broken{"E-MODEL-005", "joints.guide.direction", "finite",
               [](Model& m) {
                 m.mechanism.joints[3].kind = PinInSlot{{"frame", "G"}, {"slider", "S"}, kNan};
               }},
        Broken{"E-MODEL-036", "contacts.pin.normal_force", "a law of a round bearing, and this one is flat",
               with_block([](auto& slot) { slot.contact.normal_force = Johnson{}; })}));

}  // namespace
}  // namespace gudgeon::broken
