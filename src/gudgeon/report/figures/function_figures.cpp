// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// A line, its points, and what is held.
#include "gudgeon/report/figures/function_figures.h"

#include <fmt/format.h>

#include "gudgeon/report/figures/display_unit.h"

namespace gudgeon {

namespace {

Figure make_function_figure(const FunctionSamples& function) {
  Figure figure;
  const std::string over = function.over == "t" ? "time" : function.over;
  figure.id = fmt::format("{}.over.{}", function.id, over);
  figure.topic = "given";
  figure.title = fmt::format("{}: {} over {}", capitalize(function.subject), function.what, over);
  if (function.holds_others) figure.caption = "What else the formula depends on has its value at the start.";
  FigureCurve line;
  line.name = function.is_formula ? "formula" : "curve";
  line.group = line.name;
  line.x = make_numbers(function.arguments);
  line.y = make_numbers(function.values);
  line.color = 1;
  figure.curves.push_back(std::move(line));
  if (!function.point_arguments.empty()) {
    FigureCurve points;
    points.name = points.group = "points";
    points.x = make_numbers(function.point_arguments);
    points.y = make_numbers(function.point_values);
    points.points = true;
    figure.curves.push_back(std::move(points));
  }
  figure.x = make_x_axis(function.over == "t" ? "Time" : function.over, function.over_unit, figure.curves);
  figure.y = make_y_axis(capitalize(function.what), function.unit, figure.curves);
  return figure;
}

}  // namespace

std::vector<Figure> make_function_figures(std::span<const FunctionSamples> functions) {
  std::vector<Figure> figures;
  for (const FunctionSamples& function : functions) figures.push_back(make_function_figure(function));
  return figures;
}

}  // namespace gudgeon
