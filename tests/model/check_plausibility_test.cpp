// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Slips of the unit are told; what machines are made of is not.
#include <gmock/gmock.h>

#include "tests/model/broken_model.h"

namespace gudgeon::broken {
namespace {

using ::testing::HasSubstr;

/// Lengths of make_good() are metres: these are its crank of 150 mm and the rest to suit.
Model make_bar() {
  Model model = make_good();
  auto& bodies = model.mechanism.bodies;
  bodies[1] = {"crank", 2.0, 2.0 * 0.15 * 0.15 / 12.0, {0.075, 0.0}, {{"O", {}}, {"A", {0.15, 0.0}}}, {}};
  bodies[2] = {"rod", 1.0, 0.01, {}, {{"A", {}}, {"S", {0.4, 0.0}}}, {}};
  return model;
}

std::string check_model(const Model& model) { return render(check(model.mechanism, model.study), {}); }

TEST(CheckPlausibility, SaysNothingOfOrdinaryBodies) {
  Model model = make_bar();
  EXPECT_EQ(check_model(model), "");
  // A flywheel of 300 mm radius on the crank.
  model.mechanism.bodies[1].inertia = 0.5 * model.mechanism.bodies[1].mass * 0.3 * 0.3;
  EXPECT_EQ(check_model(model), "");
  // A point mass on the rod's end.
  model.mechanism.bodies[2].inertia = 0.0;
  EXPECT_EQ(check_model(model), "");
}

TEST(CheckPlausibility, TellsARadiusOfGyrationBeyondTheBody) {
  Model model = make_bar();
  model.mechanism.bodies[1].inertia = 5.0;
  const std::string text = check_model(model);
  EXPECT_THAT(text, HasSubstr("remark R-MODEL-130"));
  EXPECT_THAT(text,
              HasSubstr("body 'crank': inertia is 5 kg m^2, a radius of gyration of 1.58 m for its 2 kg, while its "
                        "farthest point is 75 mm from its centre of mass"));
  EXPECT_THAT(text, HasSubstr("a slender bar of 150 mm and 2 kg has 0.0037 kg m^2"));
}

// A body that shows no size of its own is still not far larger than the largest.
TEST(CheckPlausibility, MeasuresABodyOfOnePointByTheMechanism) {
  Model model = make_bar();
  model.mechanism.joints.pop_back();  // the slider turns freely now
  model.mechanism.bodies[3].inertia = 0.6;
  EXPECT_EQ(check_model(model), "");
  model.mechanism.bodies[3].inertia = 0.7;
  EXPECT_THAT(check_model(model), HasSubstr("body 'slider': inertia is 0.7 kg m^2, a radius of gyration of 837 mm for "
                                            "its 1 kg, while the largest body is 400 mm long"));
}

TEST(CheckPlausibility, DoesNotMindTheInertiaOfWhatNeverTurns) {
  Model model = make_bar();
  model.mechanism.bodies[3].inertia = 5.0;
  EXPECT_EQ(check_model(model), "");
}

TEST(CheckPlausibility, TellsADisplacementInMillimetresTakenForMetres) {
  Model model = make_bar();
  std::get<Prismatic>(model.mechanism.joints[3].kind).start.displacement = -0.06;
  EXPECT_EQ(check_model(model), "");
  std::get<Prismatic>(model.mechanism.joints[3].kind).start.displacement = -60.0;
  const std::string text = check_model(model);
  EXPECT_THAT(text, HasSubstr("R-MODEL-131"));
  EXPECT_THAT(text, HasSubstr("joint 'guide': start displacement is 60 m, 150 times the usual length of this model, "
                              "400 mm"));
}

TEST(CheckPlausibility, TellsABodyAndASpringFarBeyondTheOthers) {
  Model model = make_bar();
  model.mechanism.bodies[2].points[1].position.x = 400.0;
  EXPECT_THAT(check_model(model), HasSubstr("body 'rod': its extent is 400 m"));
  model = make_bar();
  model.mechanism.loads.push_back({"s", Spring{{"frame", "O"}, {"rod", "S"}, 100.0, 0.0, 120.0}});
  EXPECT_THAT(check_model(model), HasSubstr("load 's': free_length is 120 m"));
}

TEST(CheckPlausibility, HasNothingToCompareASingleLengthWith) {
  Model model = make_bar();
  model.mechanism.bodies.resize(1);
  model.mechanism.bodies[0].points = {{"G", {}}};
  model.mechanism.bodies.push_back({"sled", 1.0, 0.1, {}, {{"S", {}}}, {}});
  model.mechanism.joints = {{"guide", Prismatic{{"frame", "G"}, {"sled", "S"}, 0.0, 0.0, {60.0, {}}}}};
  model.mechanism.drivers.clear();
  model.mechanism.loads.clear();
  model.study = {};
  model.study.cycle_time = 1.0;
  EXPECT_EQ(check_model(model), "");
}

}  // namespace
}  // namespace gudgeon::broken
