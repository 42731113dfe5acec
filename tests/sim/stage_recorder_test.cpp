// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Names, order and values of the channels, against the poses and motions of the bodies.
#include "gudgeon/sim/stage_recorder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <set>
#include <tuple>

#include "gudgeon/sim/motion_equations.h"
#include "gudgeon/system/poses.h"
#include "tests/oracle/mechanisms.h"

namespace gudgeon {
namespace {

constexpr double kTime = 0.003;
// Positions and velocities by two routes through sines of the same angles: a few roundings of numbers up to ten.
constexpr double kRounding = 1e-13;

// A mechanism moved on a little, and one sample of it.
struct Recorded {
  explicit Recorded(const Mechanism& mechanism)
      : assembly(assemble(mechanism)),
        system(compile(mechanism, assembly)),
        equations(system, {}),
        recorder(system),
        state(make_state(system, assembly)),
        slope(equations.size()) {
    for (double& q : state.q) q += 1e-3;
    std::vector<double> y(equations.size(), 0.0);
    std::ranges::copy(state.q, y.begin());
    std::ranges::copy(state.v, y.begin() + static_cast<std::ptrdiff_t>(equations.n_free()));
    for (ContactMode& mode : equations.contact_modes) mode = {true, 0.1};
    equations.eval(kTime, y.data(), slope.data());
    update_point_motions(system.tables, equations.workspace);
    gaps.resize(system.tables.contacts.size());
    ContactEvents(system.tables).find_gaps(equations.workspace, gaps);
  }

  void sample(double time = kTime) {
    recorder.sample(time, equations.workspace, equations.contact_modes, initial_energy, integrals.data());
  }
  void watch(double time) { recorder.watch(time, equations.workspace, gaps); }
  StageRecord finish() {
    StageRecord stage;
    recorder.finish(stage);
    return stage;
  }

  Assembly assembly;
  System system;
  MotionEquations equations;
  StageRecorder recorder;
  State state;
  std::vector<double> slope;
  std::vector<GapState> gaps;
  double initial_energy = 11.0;
  std::array<double, kEnergyIntegrals> integrals{1.0, 0.5, 0.06, 0.2, 0.03, 0.004, 5.0};
};

double value(const StageRecord& stage, const std::string& channel) { return find_values(stage, channel)->at(0); }

TEST(StageRecorder, EveryChannelHasItsOwnNameAValueASampleAndStatistics) {
  for (const Mechanism& mechanism : oracle::make_all_mechanisms()) {
    Recorded at(mechanism);
    const std::size_t n_channels = at.recorder.channels().size();
    for (const double time : {0.1, 0.2, 0.4}) at.sample(time), at.watch(time);
    const StageRecord stage = at.finish();
    std::set<std::string> names;
    for (const Channel& channel : stage.channels) {
      names.insert(channel.name);
      EXPECT_FALSE(channel.unit.empty()) << channel.name;
      EXPECT_FALSE(channel.description.empty()) << channel.name;
    }
    EXPECT_EQ(names.size(), n_channels) << mechanism.name;
    EXPECT_EQ(stage.time, (std::vector<double>{0.1, 0.2, 0.4}));
    ASSERT_EQ(stage.values.size(), n_channels);
    ASSERT_EQ(stage.statistics.size(), n_channels);
    for (std::size_t k = 0; k < n_channels; ++k) {
      ASSERT_EQ(stage.values[k].size(), 3U);
      EXPECT_EQ(stage.statistics[k].channel, stage.channels[k].name);
      // Nothing moves between these: sampled or watched, the extremes are the value.
      EXPECT_EQ(stage.statistics[k].minimum, stage.values[k][0]) << mechanism.name << " " << stage.channels[k].name;
      EXPECT_EQ(stage.statistics[k].maximum, stage.values[k][2]) << mechanism.name << " " << stage.channels[k].name;
    }
  }
}

TEST(StageRecorder, BodiesAreWhereTheirPosesAre) {
  for (const Mechanism& mechanism : oracle::make_all_mechanisms()) {
    Recorded at(mechanism);
    const auto poses = find_poses(mechanism, at.system.topology, at.equations.workspace.coordinates);
    at.sample();
    const StageRecord stage = at.finish();
    for (std::size_t b = 1; b < poses.size(); ++b) {
      const std::string& name = mechanism.bodies[b].name;
      const Vec2 arm = make_rotation(poses[b].angle) * mechanism.bodies[b].center_of_mass;
      const Vec2 velocity = poses[b].velocity + poses[b].angle_rate * perp(arm);
      EXPECT_NEAR(value(stage, name + ".x"), poses[b].position.x + arm.x, kRounding) << name;
      EXPECT_NEAR(value(stage, name + ".y"), poses[b].position.y + arm.y, kRounding) << name;
      EXPECT_NEAR(value(stage, name + ".angle"), poses[b].angle, kRounding) << name;
      EXPECT_NEAR(value(stage, name + ".x_velocity"), velocity.x, 100.0 * kRounding) << name;
      EXPECT_NEAR(value(stage, name + ".y_velocity"), velocity.y, 100.0 * kRounding) << name;
      EXPECT_NEAR(value(stage, name + ".angle_rate"), poses[b].angle_rate, 100.0 * kRounding) << name;
    }
  }
}

TEST(StageRecorder, AccelerationsAreThoseOfTheBodies) {
  for (const Mechanism& mechanism : oracle::make_all_mechanisms()) {
    Recorded at(mechanism);
    BodyMotionFinder finder(at.system);
    const auto motions = finder.update(at.equations.workspace);
    at.sample();
    const StageRecord stage = at.finish();
    for (std::size_t b = 1; b < motions.size(); ++b) {
      const std::string& name = mechanism.bodies[b].name;
      EXPECT_EQ(value(stage, name + ".x_acceleration"), motions[b].acceleration.x) << name;
      EXPECT_EQ(value(stage, name + ".y_acceleration"), motions[b].acceleration.y) << name;
      EXPECT_EQ(value(stage, name + ".angle_acceleration"), motions[b].angle_acceleration) << name;
    }
  }
}

TEST(StageRecorder, ClearancesAreTheOffsetsOfTheirPoints) {
  const Mechanism mechanism = oracle::make_nine_bar();
  Recorded at(mechanism);
  const auto poses = find_poses(mechanism, at.system.topology, at.equations.workspace.coordinates);
  at.sample();
  const StageRecord stage = at.finish();
  for (const auto& [joint, bearing, journal] : {std::tuple{"A", "crank_1", "rod_2"}, {"B", "crank_4", "rod_3"}}) {
    const std::string name = joint;
    const int i = find_body(mechanism, bearing);
    const int j = find_body(mechanism, journal);
    const Vec2 offset = poses[j].position - poses[i].find_point(find_point(mechanism.bodies[i], "b")->position);
    EXPECT_NEAR(value(stage, name + ".x_offset"), offset.x, kRounding);
    EXPECT_NEAR(value(stage, name + ".y_offset"), offset.y, kRounding);
    EXPECT_NEAR(value(stage, name + ".penetration"), norm(offset) - 0.5e-3, kRounding);
    // Directions of offsets of 1e-4 m: their rounding is that much larger.
    const double direction = std::atan2(offset.y, offset.x) - poses[i].angle;
    EXPECT_NEAR(std::remainder(value(stage, name + ".contact_angle") - direction, 2.0 * std::numbers::pi), 0.0, 1e-9);
    EXPECT_LE(std::abs(value(stage, name + ".contact_angle")), std::numbers::pi);
    EXPECT_EQ(value(stage, name + ".in_contact"), 1.0) << "by its contact mode";
  }
}

TEST(StageRecorder, SlotsAreReadAlongTheirAxes) {
  const Mechanism mechanism = oracle::make_block_in_turning_slot();
  Recorded at(mechanism);
  const auto& joint = std::get<PrismaticClearance>(mechanism.joints[find_joint(mechanism, "slot")].kind);
  const auto poses = find_poses(mechanism, at.system.topology, at.equations.workspace.coordinates);
  at.sample();
  const StageRecord stage = at.finish();
  const auto place = [&](const Anchor& anchor) {
    const int b = find_body(mechanism, anchor.body);
    const Vec2 local = find_point(mechanism.bodies[b], anchor.point)->position;
    const Vec2 arm = make_rotation(poses[b].angle) * local;
    return std::pair{poses[b].position + arm, poses[b].velocity + poses[b].angle_rate * perp(arm)};
  };
  const auto [middle, middle_velocity] = place(joint.bearing);
  const auto [block, block_velocity] = place(joint.journal);
  const BodyPose& arm = poses[find_body(mechanism, "arm")];
  const BodyPose& journal = poses[find_body(mechanism, "block")];
  const double slot = arm.angle + joint.direction;
  const Vec2 along{std::cos(slot), std::sin(slot)};
  const Vec2 seen = block_velocity - middle_velocity - arm.angle_rate * perp(block - middle);
  EXPECT_NEAR(value(stage, "slot.displacement"), dot(along, block - middle), kRounding);
  EXPECT_NEAR(value(stage, "slot.height"), dot(perp(along), block - middle), kRounding);
  EXPECT_NEAR(value(stage, "slot.speed"), dot(along, seen), kRounding);
  EXPECT_NEAR(value(stage, "slot.height_rate"), dot(perp(along), seen), kRounding);
  EXPECT_NEAR(value(stage, "slot.tilt"), journal.angle - arm.angle - joint.relative_angle, kRounding);
  EXPECT_NEAR(value(stage, "slot.tilt_rate"), journal.angle_rate - arm.angle_rate, kRounding);
  EXPECT_NEAR(value(stage, "slot.left_force") + value(stage, "slot.right_force"), value(stage, "slot.normal_force"),
              1e-12 * value(stage, "slot.normal_force"));
}

TEST(StageRecorder, JointForcesHaveTheirMagnitude) {
  for (const Mechanism& mechanism : oracle::make_all_mechanisms()) {
    Recorded at(mechanism);
    at.sample();
    const StageRecord stage = at.finish();
    for (const Joint& joint : mechanism.joints) {
      const double x = value(stage, joint.name + ".x_force");
      const double y = value(stage, joint.name + ".y_force");
      EXPECT_DOUBLE_EQ(value(stage, joint.name + ".force"), std::hypot(x, y)) << mechanism.name << joint.name;
    }
  }
}

TEST(StageRecorder, EnergiesAreThoseOfTheBalance) {
  Recorded at(oracle::make_slider_crank());
  const auto energies = at.recorder.find_energies(at.equations.workspace);
  double kinetic = 0.0;
  at.sample();
  const StageRecord stage = at.finish();
  for (std::size_t b = 1; b < at.system.mechanism.bodies.size(); ++b) {
    const Body& body = at.system.mechanism.bodies[b];
    const double vx = value(stage, body.name + ".x_velocity");
    const double vy = value(stage, body.name + ".y_velocity");
    const double rate = value(stage, body.name + ".angle_rate");
    kinetic += 0.5 * body.mass * (vx * vx + vy * vy) + 0.5 * body.inertia * rate * rate;
  }
  EXPECT_NEAR(value(stage, "energy.kinetic"), kinetic, 1e-14);  // roundings of a fraction of a joule
  EXPECT_EQ(value(stage, "energy.kinetic"), energies.kinetic);
  EXPECT_EQ(value(stage, "energy.potential"), energies.potential);
  EXPECT_EQ(value(stage, "energy.elastic"), 0.0);
  EXPECT_EQ(value(stage, "energy.driver_work"), 1.0);
  EXPECT_EQ(value(stage, "energy.load_work"), 0.5);
  EXPECT_EQ(value(stage, "energy.damper_loss"), 0.06);
  EXPECT_EQ(value(stage, "energy.contact_damping"), 0.2);
  EXPECT_EQ(value(stage, "energy.friction"), 0.03);
  // now − start − driver work − load work + dampers + damping + friction − surface work
  EXPECT_NEAR(value(stage, "energy.residual"), energies.total() - 11.0 - 1.0 - 0.5 + 0.06 + 0.2 + 0.03 - 0.004, 1e-14);
}

TEST(StageRecorder, LoadsShowWhatTheyDo) {
  Mechanism mechanism = oracle::make_sprung_four_bar();
  mechanism.loads.push_back({"mount", Bushing{{"crank", "b"}, {"rocker", "b"}, {9.0, 4.0}, {}, 2.0, 0.0, 0.1}});
  mechanism.loads.push_back({"fan", VariableTorque{"rocker", "crank", Expression{"-2 * rocker.angle_rate", {}}}});
  mechanism.loads.push_back({"left", VariableForce{{"coupler", "tool"}, 3.0, 4.0, "coupler"}});  // a joint's name
  Recorded at(mechanism);
  const auto poses = find_poses(mechanism, at.system.topology, at.equations.workspace.coordinates);
  at.sample();
  const StageRecord stage = at.finish();
  const Vec2 tool = poses[2].find_point({0.21, 0.09});
  EXPECT_NEAR(value(stage, "return.length"), norm(tool - Vec2{0.11, 0.42}), kRounding);
  EXPECT_NEAR(value(stage, "strut.force"), 90.0 * (value(stage, "strut.length") - 0.3), 100.0 * kRounding);
  EXPECT_EQ(value(stage, "torque.torque"), -0.7) << "a constant one";
  EXPECT_EQ(value(stage, "force.y_force"), 4.7);
  EXPECT_NEAR(value(stage, "mount.twist"), poses[3].angle - poses[1].angle, kRounding);
  EXPECT_NEAR(value(stage, "mount.torque"), -2.0 * (value(stage, "mount.twist") - 0.1), kRounding);
  EXPECT_NEAR(value(stage, "mount.force"),
              std::hypot(9.0 * value(stage, "mount.x_offset"), 4.0 * value(stage, "mount.y_offset")), kRounding);
  EXPECT_EQ(value(stage, "fan.torque"), -2.0 * value(stage, "rocker.angle_rate"));
  EXPECT_NEAR(value(stage, "fan.power"),
              value(stage, "fan.torque") * (value(stage, "rocker.angle_rate") - value(stage, "crank.angle_rate")),
              1e-10);  // of some ten watts
  EXPECT_NEAR(value(stage, "left.load.force"), 5.0, kRounding);
  const Vec2 force = make_rotation(poses[2].angle) * Vec2{3.0, 4.0};
  EXPECT_NEAR(value(stage, "left.load.x_force"), force.x, kRounding);
  EXPECT_NE(value(stage, "left.force"), 5.0) << "the joint's";
}

TEST(StageRecorder, WatchedChannelsTakeTheirStatisticsFromSteps) {
  Recorded at(oracle::make_nine_bar());
  at.sample(0.0);
  const std::vector<std::string> watched{"rod_2.x_acceleration", "A.penetration", "A.normal_force", "motor_1.effort"};
  at.watch(1.0);
  at.gaps[0].penetration += 2.0;  // a peak between samples
  at.watch(2.0);
  at.sample(3.0);
  const StageRecord stage = at.finish();
  for (const std::string& channel : watched) EXPECT_EQ(find_statistics(stage, channel)->minimum_time, 1.0) << channel;
  EXPECT_EQ(find_statistics(stage, "A.penetration")->maximum, at.gaps[0].penetration);
  EXPECT_EQ(find_statistics(stage, "A.penetration")->maximum_time, 2.0);
  EXPECT_EQ(find_statistics(stage, "rod_2.x")->minimum_time, 0.0) << "sampled";
}

TEST(StageRecorder, EffortsStandInTheModelsOrderOfDrivers) {
  // Slides, a relative driver and a turn, written in the order opposite to that of the coordinates.
  Mechanism mechanism = oracle::make_moved_slides();
  mechanism.bodies.back().start = {};
  mechanism.drivers.push_back({"wag", DrivenAngle{"tail", "pendulum"}, 0.4, 0.0});
  std::ranges::reverse(mechanism.drivers);
  std::swap(mechanism.drivers[1], mechanism.drivers[2]);
  Recorded run(mechanism);
  run.sample();
  run.watch(0.0);
  run.watch(1.0);
  const StageRecord stage = run.finish();
  std::vector<std::string> order;
  for (const Channel& channel : stage.channels) {
    if (channel.name.ends_with(".effort")) order.push_back(channel.name);
  }
  ASSERT_EQ(order.size(), 4u);
  std::set<double> distinct;
  for (std::size_t d = 0; d < order.size(); ++d) {
    EXPECT_EQ(order[d], mechanism.drivers[d].name + ".effort");
    const auto& driven = run.system.tables.driven;
    const auto at = std::ranges::find(driven, static_cast<int>(d), &DrivenMotion::driver) - driven.begin();
    const double effort = run.equations.workspace.effort[static_cast<std::size_t>(at)];
    EXPECT_EQ((*find_values(stage, order[d]))[0], effort) << order[d];
    EXPECT_EQ(find_statistics(stage, order[d])->maximum, effort) << order[d];
    distinct.insert(effort);
  }
  EXPECT_EQ(distinct.size(), 4u) << "efforts that do not differ cannot tell their order";
  EXPECT_NE(run.system.tables.driven[0].driver, 0) << "the coordinates must not happen to be in the model's order";
}

}  // namespace
}  // namespace gudgeon
