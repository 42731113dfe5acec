// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// What the summary and the info page say.
#include "gudgeon/report/run_summary.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "gudgeon/report/comparison_section.h"
#include "gudgeon/report/joint_section.h"
#include "gudgeon/report/table.h"
#include "tests/results/synthetic_run.h"

namespace gudgeon {
namespace {

using testing::ContainsRegex;
using testing::HasSubstr;
using testing::Not;

const std::vector<ReferenceRow> kReference{
    {"largest wear depth, A", "A", "wear_depth", {std::nan(""), 5.0e-6, 1.0e-5}, "m"},
    {"peak contact force A", "A.normal_force", "peak", {2072.0, 2741.0, 3885.0}, ""},
    {"peak torque", "crank.effort", "peak", {-50.0, std::nan(""), -79.0}, "N m"},
};

TEST(RunSummary, HasEverySection) {
  const std::string text = render_summary(test::make_run(), kReference, false);
  EXPECT_THAT(text, testing::StartsWith("press.toml, case 'base'\n  written by gudgeon 0.1.0\n"));
  EXPECT_THAT(text, HasSubstr("joints.A.radial_clearance = 0.3 mm"));
  EXPECT_THAT(text, ContainsRegex("ideal +finished +2 +2.000 s +2.500 s +1 234 567 +200 000 +345 +3"));
  EXPECT_THAT(text, ContainsRegex("A.normal_force +– +2.000 kN +2.500 kN"));
  EXPECT_THAT(text, ContainsRegex("crank.effort +52.33 N m +52.33 N m"));
  EXPECT_THAT(text, ContainsRegex("slider.x_acceleration +3.948 m/s.2"));
  EXPECT_THAT(text, Not(HasSubstr("crank.angle_rate")));
  EXPECT_THAT(text, ContainsRegex("wear_1 +A +6.000 µm +351° +330.0 nm +10.00 µm +351° .*342–18°"));
  EXPECT_THAT(text, ContainsRegex("no_wear +A +3 +30.0 % +70.0 % +99.2 % +0.8 % +100.0 N +2.000 kN"));
  EXPECT_THAT(text, ContainsRegex("no_wear +slider.x +200.0 µm"));
  EXPECT_THAT(text, ContainsRegex("work of forces and torques +2.500 J"));
  EXPECT_THAT(text, ContainsRegex("lost in dampers +1.750 J"));
  EXPECT_THAT(text, Not(HasSubstr("work of worn surfaces"))) << "no stage has any";
  EXPECT_THAT(text, ContainsRegex("energy exchanged +23.25 J"));
  EXPECT_THAT(text, ContainsRegex("scale: exchanged and held +23.55 J"));
  EXPECT_THAT(text, ContainsRegex("residual / scale +0.0e.00"));
  EXPECT_THAT(text, ContainsRegex("balanced +yes +yes +yes"));
  EXPECT_THAT(text, HasSubstr("What differs by nature"));
}

TEST(RunSummary, TellsAStageThatDoesNotAddUp) {
  RunRecord run = test::make_run();
  EXPECT_THAT(render_info(run, false), Not(HasSubstr("E-NUM-020")));
  run.stages[1].energy.friction += 1.0;
  const std::string summary = render_summary(run, kReference, false);
  EXPECT_THAT(summary, HasSubstr("no_wear: E-NUM-020: its energy balance does not close"));
  EXPECT_THAT(summary, ContainsRegex("balanced +yes +NO +yes"));
  const std::string info = render_info(run, false);
  EXPECT_THAT(info, HasSubstr("no_wear: E-NUM-020: its energy balance does not close"));
  EXPECT_THAT(info, ContainsRegex("no_wear [^\n]* NO +A"));
  EXPECT_THAT(info, ContainsRegex("wear_1 [^\n]* yes +A"));
}

TEST(RunSummary, SetsReferenceValuesBesideOurs) {
  const std::string text = render_reference(test::make_run(), kReference, false);
  EXPECT_THAT(text, ContainsRegex("quantity +no_wear +ours +ratio +wear_1 +ours +ratio +wear_2 +ours +ratio"));
  EXPECT_THAT(text, ContainsRegex("peak contact force A +2.072 kN +2.000 kN +0.97 +2.741 kN +2.500 kN +0.91 +"
                                  "3.885 kN +– +–"));
  EXPECT_THAT(text, ContainsRegex("peak torque +-50.00 N m +52.33 N m +1.05 +– +52.33 N m +–"));
  EXPECT_THAT(text,
              ContainsRegex("largest wear depth, A +– +– +– +5.000 µm +4.000 µm +0.80 +10.00 µm +10.00 µm +1.00"));
  EXPECT_EQ(render_reference(test::make_run(), {}, false), "");
}

TEST(RunSummary, WorksOnAnOutlineAndOnAnEmptyRun) {
  RunRecord run = test::make_run();
  for (StageRecord& stage : run.stages) {
    stage.time.clear();
    stage.values.assign(stage.channels.size(), {});
  }
  const std::string text = render_summary(run, {}, false);
  EXPECT_THAT(text, HasSubstr("slider.x_acceleration"));
  EXPECT_THAT(text, Not(HasSubstr("Error of the slider motion")));
  EXPECT_EQ(find_ideal_channels(run),
            (std::vector<std::string>{"slider.x", "slider.x_velocity", "slider.x_acceleration"}));
  EXPECT_THAT(render_summary(RunRecord{}, kReference, false), HasSubstr("No stage was run"));
}

TEST(RunSummary, SaysWhyAStageFailedAndWhyItIsNotCompared) {
  RunRecord run = test::make_run();
  run.stages[2].status = StageStatus::failed;
  run.stages[2].message = "step below 1e-12 s";
  run.stages[2].time[3] += 0.001;
  const std::string text = render_summary(run, {}, false);
  EXPECT_THAT(text, ContainsRegex("wear_1 +failed"));
  EXPECT_THAT(text, HasSubstr("  wear_1: step below 1e-12 s\n"));
  EXPECT_THAT(text, HasSubstr("not compared: stages 'wear_1' and 'ideal' are not recorded at the same times"));
}

TEST(RunSummary, RemarksOnWhatNoBearingHas) {
  RunRecord run = test::make_run();
  EXPECT_THAT(render_summary(run, {}, false), Not(HasSubstr("Remarks")));
  run.stages[2].wear[0].bearing_depth_added[0] = 0.7e-3;
  EXPECT_THAT(render_summary(run, {}, false),
              HasSubstr("Remarks\n  stage 'wear_1', joint 'A': bearing worn 700 um deep, more than the clearance"));
}

TEST(RunSummary, ColorIsForTerminals) {
  EXPECT_THAT(render_summary(test::make_run(), kReference, false), Not(HasSubstr("\033")));
  EXPECT_THAT(render_summary(test::make_run(), kReference, true), HasSubstr("\033[1m"));
}

TEST(RunSummary, ScatteredRangesAreCounted) {
  std::vector<AngleRange> ranges{{350, 372}};
  EXPECT_EQ(render_ranges(ranges), "350–12°");
  EXPECT_EQ(render_ranges({}), "none");
  ranges = {{0, 10}, {20, 30}, {40, 50}, {60, 70}, {80, 90}, {100, 110}};
  EXPECT_EQ(render_ranges(ranges), "0–10°, 20–30°, 40–50°, 60–70° and 2 more");
}

TEST(RunInfo, TellsWhatTheFileHolds) {
  const std::string text = render_info(test::make_run(), false);
  EXPECT_THAT(text, ContainsRegex("no_wear +0 s +2.000 s +201 +4 +3 +0.0e.00 +yes +A .100."));
  EXPECT_THAT(text, HasSubstr("6 channels from stage 'ideal' on"));
  EXPECT_THAT(text, HasSubstr("7 channels from stage 'no_wear' on"));
  EXPECT_THAT(text, Not(HasSubstr("from stage 'wear_1' on")));
  EXPECT_THAT(text, HasSubstr("x [m], x_velocity [m/s], x_acceleration [m/s^2], angle_rate [rad/s]"));
}

}  // namespace
}  // namespace gudgeon
