// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// The paper's press, run for real: energy, convergence, the limit of vanishing clearance, repeatability, wear.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <future>

#include "gudgeon/sim/run_study.h"
#include "tests/oracle/mechanisms.h"
#include "tests/verification/book/recorder.h"

namespace gudgeon {
namespace {

Mechanism make_press(double clearance) {
  Mechanism press = oracle::make_nine_bar();
  for (Joint& joint : press.joints) {
    if (auto* gap = std::get_if<RevoluteClearance>(&joint.kind)) gap->radial_clearance = clearance;
  }
  return press;
}

Study make_study(int cycles) {
  Study study;
  study.cycles = cycles;
  study.compare_ideal = false;
  study.outputs_per_cycle = 200;
  return study;
}

// The first tenth of a second, with the first contacts; chaos has not yet pulled neighbouring runs apart.
StageRecord run_start(const Mechanism& press, double tolerance, bool ideal = false) {
  Study study = make_study(1);
  study.cycle_time = 0.1;
  study.cycle_driver.clear();
  study.relative_tolerance = tolerance;
  study.absolute_tolerance = 1e-2 * tolerance;
  auto stages = run_study(ideal ? make_ideal(press) : press, study);
  EXPECT_EQ(stages.back().status, StageStatus::finished) << stages.back().message;
  return stages.back();
}

double find_largest_difference(const StageRecord& a, const StageRecord& b, const std::string& channel) {
  const auto& first = *find_values(a, channel);
  const auto& second = *find_values(b, channel);
  double largest = 0.0;
  for (std::size_t k = 0; k < first.size(); ++k) largest = std::max(largest, std::abs(first[k] - second[k]));
  return largest;
}

TEST(NineBar, EnergyIsBalancedOverTenCycles) {
  book::Recorder recorder(
      {"Energy", "Nine-bar press, ten cycles", "conservation of energy",
       "What the ledger lacks to balance, as a share of the energy exchanged, over some 800 impacts.",
       "the goal of the project; a contact entered unseen would break it by orders of magnitude"});
  const auto stages = run_study(oracle::make_nine_bar(), make_study(10));
  ASSERT_EQ(stages.back().status, StageStatus::finished) << stages.back().message;
  const EnergyBalance& balance = stages.back().energy;
  EXPECT_GT(balance.exchanged, 100.0);
  recorder.verify("residual / exchanged [1]", 0.0, balance.residual() / balance.exchanged, 1e-6);
  EXPECT_GT(balance.contact_damping, 0.0);
  EXPECT_GT(balance.friction, 0.0);
}

TEST(NineBar, WornSurfacesKeepTheLedger) {
  book::Recorder recorder({"Energy", "Nine-bar press on worn surfaces", "conservation of energy",
                           "The same on surfaces rebuilt after a stage of wear, smooth (spread) and ragged (point).",
                           "the goal of the project; rough surfaces are the hardest to step over"});
  for (const auto deposition : {WearDistribution::spread, WearDistribution::point}) {
    Study study = make_study(4);
    study.wear_stages = 1;
    study.wear_acceleration = deposition == WearDistribution::spread ? 2e3 : 5e4;
    study.wear_distribution = deposition;
    const auto stages = run_study(oracle::make_nine_bar(), study);
    ASSERT_EQ(stages.size(), 2U);
    ASSERT_EQ(stages[1].status, StageStatus::finished) << stages[1].message;
    EXPECT_GT(stages[1].solver.onsets, stages[0].solver.onsets);
    const EnergyBalance& balance = stages[1].energy;
    const char* rule = deposition == WearDistribution::spread ? "spread" : "point";
    recorder.verify(fmt::format("residual / exchanged, {} deposition [1]", rule), 0.0,
                    balance.residual() / balance.exchanged, 1e-6);
  }
}

TEST(NineBar, VanishingClearanceIsTheIdealJoint) {
  book::Recorder recorder({"Motion", "Nine-bar press: clearance to zero", "the same press with ideal joints",
                           "Largest distance of the slider from that of the ideal mechanism over 0.1 s.",
                           "five clearances: the journals stay within theirs, and levers enlarge it a few times"});
  const StageRecord ideal = run_start(oracle::make_nine_bar(), 1e-9, true);
  double before = 1.0;
  for (const double clearance : {5e-4, 5e-5, 5e-6}) {
    const StageRecord stage = run_start(make_press(clearance), 1e-9);
    const double error = find_largest_difference(stage, ideal, "slider_9.x");
    recorder.verify(fmt::format("distance for a clearance of {:g} mm [m]", 1e3 * clearance), 0.0, error,
                    5.0 * clearance);
    EXPECT_LT(error, 0.5 * before) << clearance;
    before = error;
  }
}

TEST(NineBar, SameBitsOnAnyThread) {
  const auto run = [] {
    Study study = make_study(1);
    study.wear_stages = 1;
    study.wear_acceleration = 1e4;
    return run_study(oracle::make_nine_bar(), study);
  };
  const auto alone = run();
  auto first = std::async(std::launch::async, run);
  auto second = std::async(std::launch::async, run);
  for (const auto& other : {first.get(), second.get()}) {
    ASSERT_EQ(other.size(), alone.size());
    for (std::size_t s = 0; s < alone.size(); ++s) {
      EXPECT_EQ(other[s].values, alone[s].values);
      EXPECT_EQ(other[s].wear[0].total_depth_added, alone[s].wear[0].total_depth_added);
      EXPECT_EQ(other[s].solver.evaluations, alone[s].solver.evaluations);
    }
  }
}

TEST(NineBar, VolumeDoesNotDependOnRegions) {
  book::Recorder recorder({"Wear", "Volume of the nine-bar's joint B", "Archard: V = k_d ∫F ds",
                           "Volume of the depths laid down over a cycle against the integral along the motion, for any "
                           "number of regions.",
                           "rounding of some 1e5 deposits"});
  std::vector<double> volumes;
  for (const int regions : {100, 1000, 4000}) {
    Study study = make_study(1);
    study.cells = regions;
    const auto stages = run_study(oracle::make_nine_bar(), study);
    const JointWear& wear = stages.back().wear.at(1);
    recorder.verify(fmt::format("removed / worn volume, {} regions [1]", regions), 1.0,
                    wear.removed_volume / wear.archard_volume, 1e-9);
    volumes.push_back(wear.removed_volume);
  }
  EXPECT_NEAR(volumes[0] / volumes[1], 1.0, 1e-9);
  EXPECT_NEAR(volumes[2] / volumes[1], 1.0, 1e-9);
}

TEST(NineBar, StopsOnRequestAndSaysWhere) {
  std::stop_source source;
  RunHooks hooks;
  hooks.stop = source.get_token();
  hooks.progress = [&](const Progress& progress) {
    if (progress.fraction > 0.3) source.request_stop();
  };
  const auto stages = run_study(oracle::make_nine_bar(), make_study(2), hooks);
  ASSERT_EQ(stages.size(), 1U);
  EXPECT_EQ(stages[0].status, StageStatus::stopped);
  EXPECT_NEAR(stages[0].end_time, 0.6, 0.05);
  EXPECT_EQ(stages[0].time.size(), static_cast<std::size_t>(stages[0].end_time * 200.0) + 1);
  EXPECT_NE(stages[0].message.find("stopped on request"), std::string::npos);
}

TEST(NineBar, BaumgarteHoldsTheClosures) {
  Study study = make_study(1);
  study.stabilization = Stabilization::baumgarte;
  const auto stages = run_study(oracle::make_nine_bar(), study);
  ASSERT_EQ(stages.back().status, StageStatus::finished);
  EXPECT_EQ(stages.back().solver.projections, 0);
  EXPECT_LT(stages.back().solver.closure_residual, 1e-7);
}

}  // namespace
}  // namespace gudgeon
