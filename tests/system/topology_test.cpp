// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// The spanning tree: counts of turns, slides and rows, what is driven, what is loose, and drivers that contradict.
#include "gudgeon/system/topology.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/oracle/mechanism_parts.h"
#include "tests/oracle/mechanisms.h"
#include "tests/system/model_errors.h"

namespace gudgeon {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

struct Expected {
  int free_turns;
  int driven_turns;
  int free_slides;
  int driven_slides;
  int rows;
};

void expect_counts(const Mechanism& mechanism, const Expected& expected) {
  const Topology topology = find_topology(mechanism);
  EXPECT_EQ(topology.counts.n_free_turns, expected.free_turns) << mechanism.name;
  EXPECT_EQ(topology.counts.n_driven_turns, expected.driven_turns) << mechanism.name;
  EXPECT_EQ(topology.counts.n_free_slides, expected.free_slides) << mechanism.name;
  EXPECT_EQ(topology.counts.n_driven_slides, expected.driven_slides) << mechanism.name;
  int rows = 0;
  for (const Closure& closure : topology.closures) rows += count_rows(closure.kind);
  EXPECT_EQ(rows, expected.rows) << mechanism.name;
}

TEST(Topology, HasAsFewUnknownsAsThereAre) {
  expect_counts(oracle::make_nine_bar(), {5, 2, 0, 0, 1});
  expect_counts(make_ideal(oracle::make_nine_bar()), {5, 2, 0, 0, 5});
  expect_counts(oracle::make_slider_crank(), {2, 0, 0, 0, 1});
  expect_counts(oracle::make_slider_crank_clearance(), {1, 1, 1, 0, 0});
  expect_counts(oracle::make_four_bar(), {3, 0, 0, 0, 2});
  expect_counts(oracle::make_pendulum_chain(7), {7, 0, 0, 0, 0});
  expect_counts(oracle::make_rigid_chain(), {2, 0, 0, 0, 0});
  expect_counts(oracle::make_two_slides(), {1, 0, 2, 0, 0});
  expect_counts(oracle::make_driven_slide(), {2, 0, 0, 1, 0});
  expect_counts(oracle::make_six_bar_slide(), {3, 0, 0, 0, 2});
  for (const int n : {1, 2, 5, 40}) expect_counts(oracle::make_n_four_bar(n), {2 * n + 1, 0, 0, 0, 2 * n});
}

TEST(Topology, NumbersFreeThenDrivenThenConstant) {
  const CoordinateCounts counts{3, 2, 4, 1};
  EXPECT_EQ(counts.n_turns(), 6);
  EXPECT_EQ(counts.n_slides(), 6);
  EXPECT_EQ(counts.frame_turn(), 5);
  EXPECT_EQ(counts.unit_slide(), 5);
  EXPECT_EQ(counts.n_free(), 7);
  EXPECT_EQ(counts.n_driven(), 3);
}

TEST(Topology, NineBarHangsByShortestPaths) {
  const Mechanism mechanism = oracle::make_nine_bar();
  const Topology topology = find_topology(mechanism);
  const auto parent_of = [&](const char* body) {
    const int parent = topology.bodies[find_body(mechanism, body)].parent;
    return parent < 0 ? std::string("none") : mechanism.bodies[parent].name;
  };
  EXPECT_EQ(parent_of("rod_6"), "frame");
  EXPECT_EQ(parent_of("panel_7"), "rod_6");
  EXPECT_EQ(parent_of("rod_2"), "panel_7") << "a clearance joint is no edge of the tree";
  EXPECT_EQ(parent_of("rod_3"), "panel_7");
  EXPECT_EQ(parent_of("slider_9"), "rod_8") << "a joint without a new unknown comes first";
  EXPECT_EQ(topology.bodies[find_body(mechanism, "slider_9")].turn, topology.counts.frame_turn());
  ASSERT_EQ(topology.closures.size(), 1u);
  EXPECT_EQ(mechanism.joints[topology.closures[0].joint].name, "guide");
  EXPECT_EQ(topology.closures[0].kind, ClosureKind::line);
  EXPECT_THAT(topology.loose, IsEmpty());
  ASSERT_EQ(topology.driven.size(), 2u);
  for (int d = 0; d < 2; ++d) {
    const DrivenMotion& motion = topology.driven[d];
    const Driver& driver = mechanism.drivers[motion.driver];
    const int body = find_body(mechanism, std::get<DrivenAngle>(driver.target).body);
    EXPECT_EQ(topology.bodies[body].turn, topology.counts.n_free_turns + d);
    EXPECT_EQ(motion.start, driver.start);
    EXPECT_EQ(motion.speed, driver.speed);
  }
}

TEST(Topology, LooseBodiesGetTwoSlides) {
  expect_counts(oracle::make_free_body_in_bearing(), {1, 0, 2, 0, 0});
  expect_counts(oracle::make_free_pair(), {2, 0, 4, 0, 0});
  const Topology topology = find_topology(oracle::make_free_pair());
  using Loose = std::array<int, 2>;
  EXPECT_THAT(topology.loose, ElementsAre(Loose{1, 0}, Loose{2, 2}));
  EXPECT_THAT(topology.free_slide_joint, ElementsAre(-1, -1, -1, -1));
  // The centre of mass needs the two slides only: its own vector cancels.
  const Path path = topology.find_path(1, oracle::make_free_pair().bodies[1].center_of_mass);
  ASSERT_EQ(path.size(), 3u);
  EXPECT_EQ(path[0].vector, (Vec2{1.0, 0.0}));
  EXPECT_EQ(path[1].vector, (Vec2{0.0, 1.0}));
  EXPECT_EQ(path[2].vector, (Vec2{0.0, 0.0}));
}

TEST(Topology, DriverOnATiedBodyDrivesTheGroup) {
  Mechanism mechanism = oracle::make_rigid_chain();
  mechanism.drivers.push_back({"motor", DrivenAngle{"bracket"}, 1.5, -2.0});
  const Topology topology = find_topology(mechanism);
  ASSERT_EQ(topology.driven.size(), 1u);
  // bracket = turn + offset; arm and bracket differ by 0.6 rad
  const BodyNode& bracket = topology.bodies[find_body(mechanism, "bracket")];
  const BodyNode& arm = topology.bodies[find_body(mechanism, "arm")];
  EXPECT_EQ(arm.turn, bracket.turn);
  EXPECT_DOUBLE_EQ(bracket.offset - arm.offset, 0.6);
  EXPECT_DOUBLE_EQ(topology.driven[0].start + bracket.offset, 1.5);
  EXPECT_EQ(topology.driven[0].speed, -2.0);
}

void expect_driver_error(Mechanism mechanism, std::vector<Driver> drivers, const std::string& path) {
  for (const Driver& driver : drivers) mechanism.drivers.push_back(driver);
  const auto found = catch_diagnostics([&] { find_topology(mechanism); });
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].code, "E-MODEL-061");
  EXPECT_EQ(found[0].path, path);
}

TEST(Topology, DriversThatContradictAreErrors) {
  const Mechanism chain = oracle::make_rigid_chain();
  expect_driver_error(chain, {{"one", DrivenAngle{"arm"}, 0.0, 1.0}, {"two", DrivenAngle{"bracket"}, 0.0, 1.0}},
                      "drivers.two");
  expect_driver_error(chain, {{"one", DrivenAngle{"arm"}, 0.0, 1.0}, {"two", DrivenAngle{"arm"}, 0.0, 1.0}},
                      "drivers.two");
  expect_driver_error(oracle::make_slider_crank(), {{"tilt", DrivenAngle{"slider"}, 0.0, 1.0}}, "drivers.tilt");
  expect_driver_error(oracle::make_driven_slide(), {{"again", DrivenSlide{"rail"}, 0.0, 1.0}}, "drivers.again");
}

TEST(Topology, ConflictingAngleRingIsAnError) {
  Mechanism mechanism = oracle::make_two_slides();
  mechanism.joints.push_back({"extra", Rigid{{kFrameName, "guide"}, {"carriage", "foot"}, 0.41}});  // holds 0.40
  const auto found = catch_diagnostics([&] { find_topology(mechanism); });
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].code, "E-MODEL-060");
}

}  // namespace
}  // namespace gudgeon
