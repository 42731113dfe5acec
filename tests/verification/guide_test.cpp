// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Blocks and pins in slots: the limit of no clearance, statics of a twisted block, wear along a side, ledgers,
// momentum.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>

#include "gudgeon/sim/run_study.h"
#include "tests/oracle/mechanism_parts.h"
#include "tests/oracle/mechanisms.h"
#include "tests/verification/book/recorder.h"
#include "tests/verification/momenta.h"

namespace gudgeon {
namespace {

const std::string kGuides = "Clearance in guides";

Study make_guide_study(double cycle_time, int cycles, double tolerance) {
  Study study;
  study.cycle_time = cycle_time;
  study.cycles = cycles;
  study.outputs_per_cycle = 200;
  study.relative_tolerance = tolerance;
  study.absolute_tolerance = 1e-2 * tolerance;
  study.compare_ideal = false;
  return study;
}

StageRecord run_last(const Mechanism& mechanism, const Study& study) {
  const auto stages = run_study(mechanism, study);
  EXPECT_EQ(stages.back().status, StageStatus::finished) << mechanism.name << ": " << stages.back().message;
  return stages.back();
}

double find_distance(const StageRecord& a, const StageRecord& b, const std::string& channel) {
  const auto& first = *find_values(a, channel);
  const auto& second = *find_values(b, channel);
  double largest = 0.0;
  for (std::size_t k = 0; k < first.size(); ++k) largest = std::max(largest, std::abs(first[k] - second[k]));
  return largest;
}

// Runs a mechanism with smaller and smaller clearances beside its ideal one; the errors are of order one in them.
template <class Kind, class Bound>
void verify_limit(const Mechanism& loose, const std::string& joint, const std::string& channel, double turn,
                  Bound&& find_bound, book::Recorder& recorder) {
  const StageRecord ideal = run_last(make_ideal(loose), make_guide_study(turn, 1, 1e-9));
  double before = 0.0;
  double clearance_before = 0.0;
  for (const double clearance : {4e-4, 1e-4, 2.5e-5, 6.25e-6}) {
    Mechanism mechanism = loose;
    std::get<Kind>(mechanism.joints[find_joint(mechanism, joint)].kind).clearance = clearance;
    const StageRecord stage = run_last(mechanism, make_guide_study(turn, 1, 1e-9));
    EXPECT_GE(stage.solver.onsets, 4) << "it knocks";
    const double deepest = find_statistics(stage, joint + ".penetration")->maximum;
    const double error = find_distance(stage, ideal, channel);
    recorder.verify(fmt::format("{} for a clearance of {:g} um", channel, 1e6 * clearance), 0.0, error,
                    find_bound(clearance, deepest));
    if (before > 0.0) {
      recorder.verify(fmt::format("order between {:g} and {:g} um [1]", 1e6 * clearance_before, 1e6 * clearance), 1.0,
                      std::log(before / error) / std::log(clearance_before / clearance), 0.3);
    }
    before = error;
    clearance_before = clearance;
  }
}

TEST(Guides, VanishingClearanceIsTheIdealGuide) {
  constexpr double kTurn = 2.0 * std::numbers::pi / 25.0;
  book::Recorder recorder({kGuides, "Slider-crank: clearance in the guide to zero", "the same with an ideal guide",
                           "Largest difference of the slider's position [m] and angle [rad] over a turn of the crank, "
                           "and the order in the clearance.",
                           "2 clearances for the position; for the angle the tilt at which two opposite corners "
                           "stand in their sides as deep as they ever did; where it knocks within them is left to each "
                           "clearance, and takes its share of the order"});
  const Mechanism loose = oracle::make_slider_crank_guide();
  verify_limit<PrismaticClearance>(
      loose, "guide", "slider.x", kTurn, [](double clearance, double) { return 2.0 * clearance; }, recorder);
  // Corners' centres 23 and 13 mm from the middle: 23 mm sin α = c + δ + 13 mm (1 − cos α).
  const auto find_tilt = [](double clearance, double deepest) {
    const double tilt = (clearance + deepest) / 23e-3;
    return std::asin((clearance + deepest + 13e-3 * (1.0 - std::cos(1.1 * tilt))) / 23e-3);
  };
  verify_limit<PrismaticClearance>(loose, "guide", "slider.angle", kTurn, find_tilt, recorder);
}

TEST(Guides, VanishingClearanceIsTheIdealSlot) {
  book::Recorder recorder(
      {kGuides, "Scotch yoke: clearance in the slot to zero", "the same with an ideal pin in a slot",
       "Largest difference of the yoke's position [m] over a turn of the driven crank, and the order in the clearance.",
       "as far as the pin ever stood in its sides, seen along the yoke's guide; where it knocks within them is left to "
       "each clearance"});
  Mechanism loose = oracle::make_scotch_yoke_clearance();
  loose.drivers.push_back({"motor", DrivenAngle{"crank"}, 0.8, 12.0});
  // The slot lies 1.4 rad against the guide.
  const auto find_bound = [](double clearance, double deepest) { return (clearance + deepest) / std::sin(1.4); };
  verify_limit<PinInSlotClearance>(loose, "pin", "yoke.x", 2.0 * std::numbers::pi / 12.0, find_bound, recorder);
}

// A torque presses two opposite corners against the two sides: forces and tilt by statics and Hertz.
TEST(Guides, TwistedBlockRestsOnTwoCorners) {
  book::Recorder recorder({kGuides, "Block twisted in its slot", "statics: a couple of forces on two corners",
                           "A torque of 2 N m tilts a block until two opposite corners stand on both sides at once; "
                           "when it has come to rest.",
                           "what the damping has left after 0.2 s"});
  constexpr double kTorque = 2.0;
  Mechanism mechanism = oracle::make_loose_block({}, 100e9);
  auto& slot = std::get<PrismaticClearance>(mechanism.joints[0].kind);
  slot.contact.normal_force = DampedHertz<ExactRestitutionDamping>{0.1, 1.5};
  mechanism.loads.push_back({"twist", ConstantTorque{"block", kTorque}});
  const StageRecord stage = run_last(mechanism, make_guide_study(0.2, 1, 1e-10));

  // Corners' centres 45 and 20 mm from the middle, 5 mm round; sides at 26 mm. The force grows with the tilt.
  const double stiffness = 4.0 / 3.0 * 0.5 * 100e9 / (1.0 - 0.27 * 0.27) * std::sqrt(5e-3);
  const auto find_lever = [](double tilt) { return 2.0 * (45e-3 * std::cos(tilt) - 20e-3 * std::sin(tilt)); };
  double low = 0.0;
  double high = 0.1;
  for (int k = 0; k < 60; ++k) {
    const double tilt = 0.5 * (low + high);
    const double penetration = 45e-3 * std::sin(tilt) + 20e-3 * std::cos(tilt) + 5e-3 - 26e-3;
    const double force = penetration > 0.0 ? stiffness * std::pow(penetration, 1.5) : 0.0;
    (force * find_lever(tilt) > kTorque ? high : low) = tilt;
  }
  const double force = kTorque / find_lever(low);
  const auto last = [&](const char* channel) { return find_values(stage, channel)->back(); };
  recorder.verify("tilt [rad]", low, last("slot.tilt"), 1e-9);
  recorder.verify("force on the left side [N]", force, last("slot.left_force"), 1e-6 * force);
  recorder.verify("force on the right side [N]", force, last("slot.right_force"), 1e-6 * force);
  recorder.verify("corners that touch [1]", 2.0, last("slot.n_contacts"), 0.0);
  recorder.verify("moment of the slot on the block [N m]", -kTorque, last("slot.moment"), 1e-6 * kTorque);
}

// A block of weight W glides along the lower side: either corner carries W/2 and wears k_d W/(2 w) off each region.
TEST(Guides, DraggedBlockWearsEveryRegionEvenly) {
  book::Recorder recorder(
      {"Wear", "Block dragged along a slot", "closed form h = k_d F/w, V = k_d F s",
       "A block of 20 N glides along one side of its slot at 0.5 m/s on two corners, each of which "
       "wears every region of the side that it passes by the same depth.",
       "what the damping has left of the first swing; steps of 10 um overlap each other on regions of 10 mm"});
  BodyStart start;
  start.position = {-0.42, -1e-3};
  start.velocity = {0.5, 0.0};
  Mechanism mechanism = oracle::make_loose_block(start, 100e9);
  mechanism.gravity = {0.0, -10.0};
  auto& slot = std::get<PrismaticClearance>(mechanism.joints[0].kind);
  slot.contact.normal_force = LankaraniNikravesh{0.8, 1.5};
  Study study = make_guide_study(0.1, 10, 1e-9);
  study.warm_up_cycles = 1;
  study.cells = 100;
  study.max_step = 2e-5;
  const JointWear wear = run_last(mechanism, study).wear.at(0);
  const double pass = 3e-14 * 10.0 / 0.02;  // k_d of the bearing, W/2, w
  // Counted from -370 mm to 130 mm: where both corners passed, only the rear one, only the front one; within 10 mm.
  const auto at = [&](double position) {
    return wear.bearing_depth_added[100 + static_cast<std::size_t>(std::floor((position + 0.5) * 100.0))] / pass;
  };
  for (const auto& [what, from, to, passes] :
       {std::tuple{"the rear corner", -0.405, -0.335, 1.0}, std::tuple{"both corners", -0.315, 0.075, 2.0},
        std::tuple{"the front corner", 0.095, 0.165, 1.0}}) {
    double least = 1e9;
    double most = 0.0;
    for (double position = from; position < to + 1e-6; position += 0.01) {
      least = std::min(least, at(position));
      most = std::max(most, at(position));
    }
    recorder.verify(fmt::format("least depth / (k_d F/w) where {} passed [1]", what), passes, least, 1e-6);
    recorder.verify(fmt::format("largest depth / (k_d F/w) where {} passed [1]", what), passes, most, 1e-6);
  }
  const std::span<const double> left = std::span(wear.bearing_depth_added).first(100);
  recorder.verify("depth of the other side [m]", 0.0, std::ranges::max(left), 0.0);
  recorder.verify("k_d F s / (k_d W s) of both bodies [1]", 1.0, wear.archard_volume / (4e-14 * 20.0 * 0.5), 1e-6);
  recorder.verify("removed / worn volume [1]", 1.0, wear.removed_volume / wear.archard_volume, 1e-9);
}

TEST(Guides, LedgersClose) {
  book::Recorder recorder({"Energy", "Ledgers of slots", "zero in exact arithmetic",
                           "Blocks that tilt, corners and pins that knock on both sides; unworn, and on surfaces worn "
                           "before.",
                           "the goal of the project; a contact entered unseen would break it by orders of magnitude"});
  struct Run {
    Mechanism mechanism;
    double duration;
    double magnification;
  };
  for (const Run& run :
       {Run{oracle::make_slider_crank_guide(), 0.5, 2e4}, Run{oracle::make_block_in_turning_slot(), 0.15, 1e5},
        Run{oracle::make_scotch_yoke_clearance(), 1.0, 1e4}}) {
    Study study = make_guide_study(run.duration, 1, 1e-7);
    study.wear_stages = 1;
    study.wear_acceleration = run.magnification;
    study.cells = 400;
    const auto stages = run_study(run.mechanism, study);
    ASSERT_EQ(stages.size(), 2U);
    for (const StageRecord& stage : stages) {
      ASSERT_EQ(stage.status, StageStatus::finished) << run.mechanism.name << ": " << stage.message;
      recorder.verify(fmt::format("{}, {}: residual / exchanged [1]", run.mechanism.name, stage.name), 0.0,
                      stage.energy.residual() / stage.energy.exchanged, 1e-6);
      EXPECT_GE(stage.solver.onsets, 4) << run.mechanism.name;
      EXPECT_GT(stage.energy.contact_damping, 0.0);
      EXPECT_GT(stage.energy.friction, 0.0);
    }
    EXPECT_NE(stages[1].energy.surface_work, 0.0) << run.mechanism.name;
  }
}

TEST(Guides, LeaveAFreePairItsMomentum) {
  book::Recorder recorder(
      {kGuides, "Momentum of a block in a free slot", "conservation of momentum and angular momentum",
       "Two bodies loose from everything, one a block in a slot of the other.", "the run's tolerance is 1e-9"});
  const Mechanism mechanism = oracle::make_free_pair_in_slot();
  const StageRecord stage = run_last(mechanism, make_guide_study(0.3, 1, 1e-9));
  EXPECT_GE(stage.solver.onsets, 1);
  const auto before = find_momenta(mechanism, stage, 0);
  const auto after = find_momenta(mechanism, stage, stage.time.size() - 1);
  recorder.verify("momentum along x [N s]", before[0], after[0], 1e-7);
  recorder.verify("momentum along y [N s]", before[1], after[1], 1e-7);
  recorder.verify("angular momentum [N m s]", before[2], after[2], 1e-7);
}

}  // namespace
}  // namespace gudgeon
