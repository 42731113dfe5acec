// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// A line, its points, and what is held.
#include "gudgeon/report/figures/function_figures.h"

#include <fmt/format.h>

#include <array>

#include "gudgeon/report/figures/display_unit.h"

namespace gudgeon {

namespace {

void add_line(Figure& figure, const FunctionSamples& function) {
  static constexpr std::array kStyles{LineStyle::solid, LineStyle::dashed, LineStyle::dotted};
  const std::size_t n_before = figure.curves.size();
  FigureCurve line;
  line.name = !function.is_formula ? "curve" : function.others.empty() ? "formula" : "others " + function.others;
  line.group = line.name;
  line.x = make_numbers(function.arguments);
  line.y = make_numbers(function.values);
  line.color = static_cast<int>(n_before) + 1;
  line.line = kStyles[n_before % kStyles.size()];
  figure.curves.push_back(std::move(line));
}

Figure make_function_figure(const FunctionSamples& function) {
  Figure figure;
  const std::string over = function.over == "t" ? "time" : function.over;
  figure.id = fmt::format("{}.over.{}", function.id, over);
  figure.topic = "given";
  figure.title = fmt::format("{}: {} over {}", capitalize(function.subject), function.what, over);
  if (!function.others.empty()) {
    figure.caption =
        "What else the formula depends on is held where the mechanism starts, or half as far below or above as figures "
        "over it show.";
  }
  add_line(figure, function);
  if (!function.point_arguments.empty()) {
    FigureCurve points;
    points.name = points.group = "points";
    points.x = make_numbers(function.point_arguments);
    points.y = make_numbers(function.point_values);
    points.points = true;
    figure.curves.push_back(std::move(points));
  }
  return figure;
}

void set_axes(Figure& figure, const FunctionSamples& function) {
  figure.x = make_x_axis(function.over == "t" ? "Time" : function.over, function.over_unit, figure.curves);
  figure.y = make_y_axis(capitalize(function.what), function.unit, figure.curves);
}

}  // namespace

std::vector<Figure> make_function_figures(std::span<const FunctionSamples> functions) {
  std::vector<Figure> figures;
  const FunctionSamples* before = nullptr;
  for (const FunctionSamples& function : functions) {
    if (before != nullptr && before->id == function.id && before->over == function.over) {
      add_line(figures.back(), function);
    } else {
      figures.push_back(make_function_figure(function));
    }
    set_axes(figures.back(), function);
    before = &function;
  }
  return figures;
}

}  // namespace gudgeon
