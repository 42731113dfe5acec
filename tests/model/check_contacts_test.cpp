// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Rules of guides and slots with clearance, each broken alone.
#include "tests/model/broken_model.h"

namespace gudgeon::broken {
namespace {

/// A slot with clearance in place of the good model's guide.
std::function<void(Model&)> with_slot(double bearing_length, double journal_radius, double clearance) {
  return [=](Model& m) {
    m.mechanism.joints[3].kind = PinInSlotClearance{{"frame", "G"}, {"slider", "S"}, 0.0,  bearing_length,
                                                    journal_radius, clearance,       0.01, m.pin().contact};
  };
}

class CheckContactsFinds : public testing::TestWithParam<Broken> {};

TEST_P(CheckContactsFinds, TheBrokenRule) { expect_found(GetParam()); }

INSTANTIATE_TEST_SUITE_P(
    Guides, CheckContactsFinds,
    testing::Values(Broken{"E-MODEL-012", "joints.guide.bearing_length",
                           "error E-MODEL-012: joint 'guide': bearing_length is 0 m; it must be positive\n",
                           with_guide(0.0, 0.03, 0.001, 0.0001)},
                    Broken{"E-MODEL-012", "joints.guide.clearance", "clearance is 0 m; it must be positive",
                           with_guide(0.2, 0.03, 0.001, 0.0)},
                    Broken{"E-MODEL-014", "joints.guide.journal_length", "below the bearing_length, 0.2 m",
                           with_guide(0.2, 0.2, 0.001, 0.0001)},
                    Broken{"E-MODEL-015", "joints.guide.corner_radius", "0.01 m", with_guide(0.2, 0.03, 0.011, 0.0001)},
                    Broken{"E-MODEL-012", "joints.guide.journal_radius", "positive", with_slot(0.2, -0.01, 0.0001)},
                    Broken{"E-MODEL-016", "joints.guide.journal_radius", "does not fit", with_slot(0.02, 0.01, 0.0001)},
                    Broken{"E-MODEL-005", "joints.guide.direction", "finite", [](Model& m) {
                             m.mechanism.joints[3].kind = PinInSlot{{"frame", "G"}, {"slider", "S"}, kNan};
                           }}));

}  // namespace
}  // namespace gudgeon::broken
