// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Figures of a made-up run whose numbers are known.
#include "gudgeon/report/figures/case_figures.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "gudgeon/report/figures/comparison_figures.h"
#include "gudgeon/report/html/full_cycles.h"
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
  // Region 97 of 100 is the deepest, 0.5 · 4 µm, in a scar that passes angle zero.
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
      {"clearance", "over clearance", {{"0.3 mm", &first}, {"0.8 mm", &second}}}};
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

TEST(FullCycles, FitTheBytesTheyMayTake) {
  const RunRecord run = make_worn_run();
  EXPECT_EQ(find_full_cycles(run, 100'000'000), kMostFullCycles);
  const double few = find_full_cycles(run, 400'000);
  const double fewer = find_full_cycles(run, 250'000);
  EXPECT_LT(fewer, few);
  EXPECT_LT(few, kMostFullCycles);
  EXPECT_GT(find_full_cycles(run, 0), 0.0);
}

TEST(StageLabels, ReadAsWords) {
  EXPECT_EQ(label_stage("no_wear"), "no wear");
  EXPECT_EQ(label_stage("wear_2"), "second wear");
  EXPECT_EQ(label_stage("wear_11"), "wear 11");
  EXPECT_EQ(label_stage("wear_x"), "wear_x");
}

}  // namespace
}  // namespace gudgeon
