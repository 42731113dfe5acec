// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Figures of a made-up run whose numbers are known.
#include "gudgeon/report/figures/case_figures.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>

#include "gudgeon/report/figures/comparison_figures.h"
#include "gudgeon/report/html/signal_detail.h"
#include "gudgeon/report/plot/drawn_curves.h"
#include "gudgeon/report/plot/plot_figure.h"
#include "tests/results/synthetic_run.h"

namespace gudgeon {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

/// The made-up run, its last stage on the surfaces that the stage before left.
RunRecord make_worn_run() {
  RunRecord run = test::make_run();
  run.stages[2].wear[0].bearing_depth = run.stages[1].wear[0].bearing_depth_added;
  run.stages[2].wear[0].journal_depth = run.stages[1].wear[0].journal_depth_added;
  return run;
}

Figure find_figure(const RunRecord& run, const std::string& id) {
  Signals signals(run);
  for (Figure& figure : make_case_figures(signals)) {
    if (figure.id == id) return figure;
  }
  ADD_FAILURE() << "no figure " << id;
  return {};
}

TEST(CaseFigures, ErrorIsValueLessIdeal) {
  const RunRecord run = make_worn_run();
  const Figure figure = find_figure(run, "slider.x.error");
  ASSERT_EQ(figure.curves.size(), 2U);
  EXPECT_EQ(figure.curves[0].name, "no wear");
  for (const double error : *figure.curves[0].y) EXPECT_NEAR(error, 2e-4, 1e-15);
  EXPECT_EQ(figure.y.display_unit, "µm");
}

TEST(CaseFigures, WearDepthIsWhatTheStagesBeforeTookAway) {
  const RunRecord run = make_worn_run();
  const Figure figure = find_figure(run, "A.wear_depth");
  ASSERT_EQ(figure.curves.size(), 1U);
  EXPECT_EQ(figure.curves[0].name, "first wear");
  EXPECT_EQ(*figure.curves[0].y, run.stages[1].wear[0].total_depth_added);
  EXPECT_NEAR(figure.x_end, 2.0 * std::numbers::pi, 1e-15);
}

TEST(CaseFigures, OneStageShowsWhatItTakesAway) {
  RunRecord run = test::make_run();
  run.stages.pop_back();
  const Figure figure = find_figure(run, "A.wear_depth");
  ASSERT_EQ(figure.curves.size(), 1U);
  EXPECT_EQ(figure.curves[0].name, "after no wear");
  EXPECT_EQ(*figure.curves[0].y, run.stages[1].wear[0].total_depth_added);
}

TEST(CaseFigures, EnlargedSurfaceIsCutOpenOppositeToItsDeepestPlace) {
  const RunRecord run = make_worn_run();
  const Figure figure = find_figure(run, "A.bearing_surface");
  const FigureCurve& curve = figure.curves.front();
  // Cell 97 of 100 is the deepest, 0.5 · 4 µm, in a scar that passes angle zero.
  const auto deepest = std::ranges::max_element(*curve.y) - curve.y->begin();
  EXPECT_NEAR((*curve.y)[deepest], 2e-6, 1e-18);
  EXPECT_NEAR((*curve.x)[deepest], 2.0 * std::numbers::pi * 0.975, 1e-12);
  EXPECT_TRUE(std::ranges::is_sorted(*curve.x));
  EXPECT_LT(figure.x_begin, (*curve.x)[deepest] - 0.5);
  EXPECT_GT(figure.x_end, (*curve.x)[deepest] + 0.5);
}

TEST(CaseFigures, OutlineStatesItsExaggeration) {
  const RunRecord run = make_worn_run();
  const Figure figure = find_figure(run, "A.surfaces");
  ASSERT_EQ(figure.curves.size(), 2U);
  double farthest = 0.0;
  for (std::size_t k = 0; k < figure.curves[0].x->size(); ++k) {
    farthest = std::max(farthest, std::hypot((*figure.curves[0].x)[k], (*figure.curves[0].y)[k]));
  }
  // 2 µm on 15 mm: 0.25 · 15 mm / 2 µm = 1875, rounded down to 1000.
  EXPECT_THAT(figure.caption, HasSubstr("Depth × 1000"));
  EXPECT_NEAR(farthest, 15e-3 + 1000 * 2e-6, 1e-12);
}

TEST(CaseFigures, NothingRecordedGivesNoFigure) {
  RunRecord run = test::make_run();
  run.stages.clear();
  Signals signals(run);
  EXPECT_THAT(make_case_figures(signals), IsEmpty());
}

TEST(CaseFigures, ComparisonHasACurveACase) {
  const RunRecord first = make_worn_run();
  RunRecord second = make_worn_run();
  second.case_name = "wide";
  const std::vector<CaseComparison> comparisons{
      {"clearance", "over clearance", {}, {{.label = "0.3 mm", .run = &first}, {.label = "0.8 mm", .run = &second}}}};
  const std::vector<Figure> figures = make_comparison_figures(comparisons);
  ASSERT_FALSE(figures.empty());
  EXPECT_EQ(figures[0].id, "A.wear_depth_over_clearance");
  ASSERT_EQ(figures[0].curves.size(), 2U);
  EXPECT_EQ(figures[0].curves[1].name, "0.8 mm: first wear");
  EXPECT_NE(figures[0].curves[0].color, figures[0].curves[1].color);
}

TEST(PlotFigure, HasTitleAxesWithUnitsAndLegend) {
  const RunRecord run = make_worn_run();
  const std::string svg = plot_figure(find_figure(run, "slider.x_acceleration"), {});
  for (const char* text :
       {">Acceleration of slider in x<", ">Acceleration in x (m/s²)<", ">Time (s)<", ">ideal<", ">first wear<"}) {
    EXPECT_THAT(svg, HasSubstr(text));
  }
  EXPECT_THAT(svg, Not(HasSubstr("nan")));
}

TEST(PlotFigure, ThinningKeepsPeaksAndShape) {
  std::vector<Vec2> points;
  for (int k = 0; k < 100'000; ++k) points.push_back({static_cast<double>(k), std::sin(0.01 * k)});
  points[54'321].y = 9.0;
  const std::vector<Vec2> kept = reduce_columns(points, 0.0, 100'000.0, 500);
  EXPECT_LE(kept.size(), 4U * 501U);
  EXPECT_THAT(kept, Contains(::testing::Field(&Vec2::y, 9.0)));
  EXPECT_TRUE(std::ranges::is_sorted(kept, {}, &Vec2::x));
}

/// The made-up run with a joint whose journal is a block of four corners in a slot, or a pin.
RunRecord make_slot_run(std::size_t n_corners) {
  RunRecord run = test::make_run();
  for (StageRecord& stage : run.stages) {
    for (JointWear& wear : stage.wear) {
      wear.bearing_radius = std::numeric_limits<double>::infinity();
      wear.slot_length = 0.18;
      wear.bearing_depth.assign(2 * test::kCells, 0.0);
      wear.journal_depth.assign(n_corners * test::kCells, 0.0);
      wear.total_depth_added = wear.bearing_depth_added = wear.bearing_depth;
      wear.journal_depth_added = wear.journal_depth;
      for (const char* part : {".displacement", ".height"}) {
        stage.channels.push_back({wear.joint + part, "", "m", "of a block"});
        stage.values.emplace_back(stage.time.size(), 1e-4);
      }
    }
  }
  for (std::size_t side = 0; side < 2; ++side) run.stages[1].wear[0].total_depth_added[side * test::kCells + 7] = 1e-6;
  JointWear& last = run.stages[2].wear[0];
  for (std::size_t c = 0; c < n_corners; ++c) last.journal_depth[c * test::kCells + 11 * c] = 1e-6;
  for (std::size_t side = 0; side < 2; ++side) last.bearing_depth[side * test::kCells + 7] = 1e-6;
  return run;
}

/// Colour, line, name and group of each curve, which all differ.
void expect_all_differ(const Figure& figure) {
  for (std::size_t k = 0; k < figure.curves.size(); ++k) {
    for (std::size_t i = 0; i < k; ++i) {
      EXPECT_NE(figure.curves[i].color, figure.curves[k].color) << figure.id;
      EXPECT_NE(figure.curves[i].name, figure.curves[k].name) << figure.id;
      EXPECT_NE(figure.curves[i].group, figure.curves[k].group) << figure.id;
    }
  }
}

TEST(CaseFigures, SidesAndCornersOfASlotAreToldApart) {
  const RunRecord run = make_slot_run(4);
  const Figure depth = find_figure(run, "A.wear_depth");
  ASSERT_EQ(depth.curves.size(), 2U);
  EXPECT_EQ(depth.curves[0].name, "first wear, left side");
  EXPECT_EQ(depth.curves[1].name, "first wear, right side");
  expect_all_differ(depth);
  Figure corners = find_figure(run, "A.journal_surface");
  ASSERT_EQ(corners.curves.size(), 5U);
  EXPECT_EQ(corners.curves[2].name, "first wear, right rear corner");
  expect_all_differ(corners);
  EXPECT_NE(corners.curves[1].line, corners.curves[2].line);
  // All four scars, 0 to 33 cells of 3.6 degrees along the circumference, are within the enlarged part.
  const std::string svg = plot_figure(corners, {});
  for (const char* corner : {"left rear", "left front", "right rear", "right front"})
    EXPECT_THAT(svg, HasSubstr(corner));
  for (const FigureCurve& curve : corners.curves) {
    if (curve.group.empty()) continue;
    const auto deepest = std::ranges::min_element(*curve.y) - curve.y->begin();
    EXPECT_GT((*curve.x)[deepest], corners.x_begin);
    EXPECT_LT((*curve.x)[deepest], corners.x_end);
  }
}

TEST(CaseFigures, PathInASlotRunsBetweenItsWalls) {
  const Figure figure = find_figure(make_slot_run(1), "A.orbit");
  std::vector<double> walls;
  for (const FigureCurve& curve : figure.curves) {
    if (curve.group.empty()) walls.push_back(curve.y->front());
  }
  EXPECT_THAT(walls, ::testing::ElementsAre(0.5e-3, -0.5e-3));
  EXPECT_EQ(figure.curves.front().x->front(), 1e-4);
}

TEST(CaseFigures, ComparisonOfManyCasesTakesSomeAtEqualSteps) {
  const RunRecord run = make_worn_run();
  CaseComparison comparison{"clearance", "over clearance", {}, {}};
  for (int k = 0; k < 40; ++k) comparison.cases.push_back({.label = std::to_string(k), .run = &run});
  const std::vector<Figure> figures = make_comparison_figures(std::vector{comparison});
  ASSERT_EQ(figures[0].curves.size(), 7U);
  EXPECT_THAT(figures[0].curves.front().name, ::testing::StartsWith("0:"));
  EXPECT_THAT(figures[0].curves.back().name, ::testing::StartsWith("39:"));
  EXPECT_THAT(figures[0].caption, HasSubstr("7 of 40 cases"));
}

TEST(CaseFigures, TrendsRunOverTheValuesThatCasesDifferIn) {
  const RunRecord small = make_worn_run();
  RunRecord large = make_worn_run();
  large.stages.back().wear[0].bearing_depth_added.assign(test::kCells, 0.0);
  large.stages.back().wear[0].total_depth_added.assign(test::kCells, 3e-6);
  ChannelStatistics& force =
      *std::ranges::find(large.stages.back().statistics, "A.normal_force", &ChannelStatistics::channel);
  force.maximum = 4321.0;
  const CaseComparison comparison{"clearance",
                                  "over clearance",
                                  {"Clearance", "m", "m", 1.0},
                                  {{"0.3 mm", 0.3e-3, &small}, {"0.8 mm", 0.8e-3, &large}}};
  const std::vector<Figure> figures = make_trend_figures(comparison);
  ASSERT_EQ(figures.size(), 2U);
  EXPECT_EQ(figures[0].id, "deepest_wear_over_clearance");
  EXPECT_EQ(figures[0].curves[0].name, "A");
  EXPECT_THAT(*figures[0].curves[0].x, ::testing::ElementsAre(0.3e-3, 0.8e-3));
  const std::vector<double>& before = large.stages[1].wear[0].total_depth_added;
  EXPECT_NEAR(figures[0].curves[0].y->back(), *std::ranges::max_element(before) + 3e-6, 1e-15);
  EXPECT_EQ(figures[1].id, "largest_force_over_clearance");
  EXPECT_EQ(figures[1].curves[0].y->back(), 4321.0);
  CaseComparison named = comparison;
  for (ComparedCase& one : named.cases) one.value = std::nan("");
  EXPECT_THAT(make_trend_figures(named), IsEmpty());
}

TEST(SignalDetail, FitsTheBytesItMayTake) {
  const RunRecord run = make_worn_run();
  EXPECT_EQ(find_signal_detail(run, 100'000'000).full_cycles, kMostFullCycles);
  const double few = find_signal_detail(run, 400'000).full_cycles;
  const double fewer = find_signal_detail(run, 250'000).full_cycles;
  EXPECT_LT(fewer, few);
  EXPECT_LT(few, kMostFullCycles);
  EXPECT_GT(find_signal_detail(run, 0).full_cycles, 0.0);
  EXPECT_LT(find_signal_detail(run, 0).n_spans, find_signal_detail(run, 400'000).n_spans);
}

TEST(StageLabels, ReadAsWords) {
  EXPECT_EQ(label_stage("no_wear"), "no wear");
  EXPECT_EQ(label_stage("wear_2"), "second wear");
  EXPECT_EQ(label_stage("wear_11"), "wear 11");
  EXPECT_EQ(label_stage("wear_x"), "wear_x");
}

}  // namespace
}  // namespace gudgeon
