// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Bristles that stick, through the whole engine: the stick-slip of Canudas de Wit et al. 1995, and a loaded joint at
// rest.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

#include "gudgeon/analysis/energy_audit.h"
#include "tests/verification/book/recorder.h"
#include "tests/verification/brake.h"

namespace gudgeon {
namespace {

StageRecord run_brake(const Mechanism& mechanism, double duration, int outputs, double tolerance) {
  Study study;
  study.cycle_time = duration;
  study.cycles = 1;
  study.outputs_per_cycle = outputs;
  study.relative_tolerance = tolerance;
  study.absolute_tolerance = 1e-2 * tolerance;
  study.compare_ideal = false;
  const auto stages = run_study(mechanism, study);
  EXPECT_EQ(stages.back().status, StageStatus::finished) << stages.back().message;
  return stages.back();
}

Mechanism make_dragged_brake() {
  Lugre law;
  law.static_coefficient = 1.5;
  law.kinetic_coefficient = 1.0;
  law.stribeck_speed = 1e-3;
  law.bristle_stiffness = 1e5;
  law.bristle_damping = std::sqrt(1e5);
  law.viscous_coefficient = 0.4;
  Mechanism mechanism = make_brake({1.0, 1.0, 0.0, law});
  mechanism.bodies.push_back({"hand", 1.0, 1.0, {}, {{"axle", {0.0, 0.0}}}, {}});
  oracle::add_revolute(mechanism, "hand", {kFrameName, "axle"}, {"hand", "axle"});
  mechanism.drivers.push_back({"motor", DrivenAngle{"hand"}, 0.0, 0.1});
  mechanism.loads.push_back({"spring", TorsionSpring{"hand", "wheel", 2.0, 0.0, 0.0}});
  return mechanism;
}

struct SampledSlip {
  double begin = 0.0;
  double end = 0.0;
  double distance = 0.0;
};

// A slip has begun at 1 cm/s and ended at 1 mm/s: the times of the reference are those.
std::vector<SampledSlip> find_slips(const StageRecord& stage) {
  const auto& x = *find_values(stage, "wheel.angle");
  const auto& v = *find_values(stage, "wheel.angle_rate");
  std::vector<SampledSlip> slips;
  bool slides = false;
  for (std::size_t k = 1; k < x.size(); ++k) {
    const double threshold = slides ? 1e-3 : 1e-2;
    if (slides == (v[k] > threshold)) continue;
    slides = !slides;
    const double share = (threshold - v[k - 1]) / (v[k] - v[k - 1]);
    const double time = stage.time[k - 1] + share * (stage.time[k] - stage.time[k - 1]);
    const double place = x[k - 1] + share * (x[k] - x[k - 1]);
    if (slides) {
      slips.push_back({time, 0.0, -place});
    } else {
      slips.back().end = time;
      slips.back().distance += place;
    }
  }
  return slips;
}

TEST(Stick, DraggedBlockSticksAndSlips) {
  book::Recorder recorder(
      {"Friction", "Stick-slip over LuGre bristles",
       "Canudas de Wit et al. 1995; numbers by an independent integration at 1e-13",
       "A block of 1 kg is dragged through a spring of 2 N/m whose end moves at 0.1 m/s, as a wheel "
       "under a brake shoe that presses with 1 N.",
       "place and bristle: ten digits are given, and the shoe settles in the first milliseconds; "
       "times and distances: one unit of the last digit given"});
  const StageRecord stage = run_brake(make_dragged_brake(), 25.0, 50000, 1e-10);
  recorder.verify("place at 25 s [m]", 1.908839199, find_values(stage, "wheel.angle")->back(), 1e-8);
  recorder.verify("bristle at 25 s [m]", 1.181679546e-5, find_values(stage, "pad.bristle")->back(), 1e-13);
  double fastest = 0.0;
  for (const double v : *find_values(stage, "wheel.angle_rate")) fastest = std::max(fastest, v);
  recorder.verify("top speed [m/s]", 0.369816, fastest, 1e-6);
  const auto slips = find_slips(stage);
  ASSERT_EQ(slips.size(), 3U);
  constexpr std::array kBegins{7.458, 13.821, 20.183};
  constexpr std::array kEnds{10.263, 16.626, 22.988};
  for (std::size_t k = 0; k < 3; ++k) {
    recorder.verify(fmt::format("slip {} begins [s]", k + 1), kBegins[k], slips[k].begin, 1e-3);
    recorder.verify(fmt::format("slip {} ends [s]", k + 1), kEnds[k], slips[k].end, 1e-3);
    recorder.verify(fmt::format("slip {} moves [m]", k + 1), 0.6361, slips[k].distance, 1e-4);
  }
  EXPECT_LE(check_energy(stage.energy).relative, kEnergyTolerance);
}

// A steel shaft of 14.5 mm in its bearing, pressed with 100 N, and a torque on it of half of what slips.
Mechanism make_held_shaft() {
  Lugre law;
  law.static_coefficient = 0.15;
  law.kinetic_coefficient = 0.1;
  law.bristle_damping = 316.0;
  Mechanism mechanism = make_brake({1e-3, 100.0, 0.0, law});
  mechanism.bodies.back().mass = 1.0;
  auto& joint = std::get<RevoluteClearance>(mechanism.joints.back().kind);
  joint.bearing_radius = 15e-3;
  joint.radial_clearance = 0.5e-3;
  joint.contact.bearing_material = joint.contact.journal_material = {"steel", 200e9, 0.3};
  joint.contact.normal_force = LankaraniNikravesh{0.9, 1.5};
  mechanism.loads.push_back({"torque", ConstantTorque{"wheel", 0.5 * 0.1 * 100.0 * 14.5e-3}});
  return mechanism;
}

TEST(Stick, HoldsALoadedJointForAThousandSeconds) {
  book::Recorder recorder(
      {"Friction", "A loaded joint at rest for 1000 s", "statics: the bristle holds T = σ₀ z F (R_j − δ/2)",
       "The bearing drops onto a shaft with half the torque that would make it slip, bounces, and rests. The shaft "
       "then "
       "stays where it is: what it turned after 100 s, and after 500 s, until 1000 s.",
       "drift: an implicit step at rest has rates of rounding, 1e-15 of a radian a second; 1e-12 rad is a millionth of "
       "the bristle's own deflection"});
  const StageRecord stage = run_brake(make_held_shaft(), 1000.0, 1000, 1e-7);
  const auto at = [&](const char* channel, std::size_t k) { return find_values(stage, channel)->at(k); };
  const double lever = 14.5e-3 - 0.5 * at("pad.penetration", 1000);
  recorder.verify("normal force [N]", 100.0, at("pad.normal_force", 1000), 1e-6);
  recorder.verify("bristle [m]", 0.5 * 0.1 * 14.5e-3 / (1e5 * lever), at("pad.bristle", 1000), 1e-14);
  recorder.verify("turned from 100 to 1000 s [rad]", 0.0, at("wheel.angle", 1000) - at("wheel.angle", 100), 1e-12);
  recorder.verify("turned from 500 to 1000 s [rad]", 0.0, at("wheel.angle", 1000) - at("wheel.angle", 500), 1e-12);
  recorder.verify("rate at 1000 s [rad/s]", 0.0, at("wheel.angle_rate", 1000), 1e-14);
  // From 1 s on it has settled but for swings at the run's tolerance; what it moves since is far below the bristle's
  // bend.
  EXPECT_LE(std::abs(at("wheel.angle", 1000) - at("wheel.angle", 1)) * lever, 0.1 * at("pad.bristle", 1000));
  EXPECT_LT(stage.solver.evaluations, 1000000) << "explicit steps alone take 30 million";
  EXPECT_LE(check_energy(stage.energy).relative, kEnergyTolerance);
}

}  // namespace
}  // namespace gudgeon
