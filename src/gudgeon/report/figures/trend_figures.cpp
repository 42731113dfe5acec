// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// What becomes of wear and force as the cases' value grows.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "gudgeon/analysis/wear_summary.h"
#include "gudgeon/report/figures/case_figures.h"
#include "gudgeon/report/figures/comparison_figures.h"
#include "gudgeon/report/figures/display_unit.h"

namespace gudgeon {

namespace {

/// NaN where the run has none.
using FindMeasure = std::function<double(const RunRecord&, const std::string& joint)>;

double find_deepest_of(const RunRecord& run, const std::string& joint) {
  if (run.stages.empty() || find_wear(run.stages.back(), joint) == nullptr) return std::nan("");
  const double depth = find_deepest(find_accumulated_depth(run, run.stages.size() - 1, joint)).depth;
  return depth > 0.0 ? depth : std::nan("");
}

double find_largest_force_of(const RunRecord& run, const std::string& joint) {
  if (run.stages.empty()) return std::nan("");
  const ChannelStatistics* statistics = find_statistics(run.stages.back(), joint + ".normal_force");
  return statistics == nullptr ? std::nan("") : std::abs(statistics->peak());
}

FigureCurve make_trend(const CaseComparison& comparison, const std::string& joint, int color, const FindMeasure& find) {
  std::vector<double> x;
  std::vector<double> y;
  for (const ComparedCase& one : comparison.cases) {
    const double measure = find(*one.run, joint);
    if (!std::isfinite(one.value) || !std::isfinite(measure)) continue;
    x.push_back(one.value);
    y.push_back(measure);
  }
  FigureCurve curve;
  curve.name = joint;
  curve.group = joint;
  curve.color = color;
  curve.line = static_cast<LineStyle>((color - 1) % 4);
  curve.x = make_numbers(std::move(x));
  curve.y = make_numbers(std::move(y));
  return curve;
}

Figure make_trend_figure(const CaseComparison& comparison, const std::string& y_label, const std::string& unit,
                         const FindMeasure& find) {
  Figure figure;
  figure.topic = "comparison";
  figure.kind = FigureKind::line;
  int color = 0;
  for (const std::string& joint : find_compared_joints(comparison)) {
    FigureCurve curve = make_trend(comparison, joint, ++color, find);
    if (curve.x->size() > 1) figure.curves.push_back(std::move(curve));
  }
  figure.title = fmt::format("{} {}", y_label, comparison.title);
  figure.caption = "Of each joint, over the last stage of each case.";
  figure.x = make_x_axis(comparison.axis.label, comparison.axis.unit, figure.curves);
  figure.y = make_y_axis(y_label, unit, figure.curves);
  return figure;
}

}  // namespace

std::vector<std::string> find_compared_joints(const CaseComparison& comparison) {
  std::vector<std::string> joints;
  for (const ComparedCase& one : comparison.cases) {
    for (const std::string& joint : find_clearance_joints(*one.run)) {
      if (std::ranges::find(joints, joint) == joints.end()) joints.push_back(joint);
    }
  }
  return joints;
}

std::vector<Figure> make_trend_figures(const CaseComparison& comparison) {
  std::vector<Figure> figures;
  const auto add = [&](Figure figure, const char* what) {
    if (figure.curves.empty()) return;
    figure.id = fmt::format("{}_over_{}", what, comparison.id);
    figures.push_back(std::move(figure));
  };
  Figure wear = make_trend_figure(comparison, "Deepest wear", "m", find_deepest_of);
  wear.caption = "Of each joint, after the last stage of each case, with what that stage wears away.";
  add(std::move(wear), "deepest_wear");
  add(make_trend_figure(comparison, "Largest contact force", "N", find_largest_force_of), "largest_force");
  return figures;
}

}  // namespace gudgeon
