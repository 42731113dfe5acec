// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Curves to blocks and JSON.
#include "gudgeon/report/html/figure_data.h"

#include <algorithm>
#include <cmath>

#include "gudgeon/report/figures/display_unit.h"
#include "gudgeon/report/html/reduced_signal.h"

namespace gudgeon {

namespace {

const char* name_kind(FigureKind kind) {
  switch (kind) {
    case FigureKind::time:
      return "time";
    case FigureKind::line:
      return "line";
    case FigureKind::phase:
      return "phase";
    case FigureKind::plane:
      return "plane";
  }
  return "";
}

void add_axis(JsonText& json, std::string_view name, const FigureAxis& axis) {
  json.key(name);
  json.begin_object();
  json.put("label", axis.label);
  json.put("unit", axis.unit == "1" ? std::string_view{} : std::string_view(axis.unit));
  json.put("display", axis.display_unit == "1" ? std::string{} : print_unit(axis.display_unit));
  json.put("factor", axis.factor);
  json.end_object();
}

/// What makes a reduced signal one of its own: with another number of full samples it is another block.
std::size_t find_cut_key(FigureKind kind, const SignalCut& cut) {
  return 2 * cut.n_full + (kind == FigureKind::time ? 1 : 0) + 1;
}

int add_curve_x(BlockStore& blocks, FigureKind kind, const Numbers& x, const SignalCut& cut) {
  blocks.keep(x);
  return blocks.find({x.get(), find_cut_key(kind, cut)}, [&] {
    return kind == FigureKind::time ? blocks.add_times(reduce_times(*x, cut))
                                    : blocks.add_signal(std::span(*x).last(cut.n_full));
  });
}

int add_curve_y(BlockStore& blocks, FigureKind kind, const Numbers& y, const SignalCut& cut) {
  blocks.keep(y);
  return blocks.find({y.get(), find_cut_key(kind, cut)}, [&] {
    return kind == FigureKind::time ? blocks.add_signal(reduce_signal(*y, cut))
                                    : blocks.add_signal(std::span(*y).last(cut.n_full));
  });
}

void add_curve(JsonText& json, BlockStore& blocks, FigureKind kind, const FigureCurve& curve,
               const SignalDetail& detail) {
  const std::size_t n = curve.x->size();
  const std::size_t n_full =
      curve.cycle_samples == 0 ? n : std::min(n, find_full_count(detail.full_cycles, curve.cycle_samples));
  const SignalCut cut{n, n_full, detail.n_spans};
  json.begin_object();
  json.put("name", curve.name);
  json.put("group", curve.group);
  json.put("color", curve.color);
  json.put("shown", curve.shown);
  json.put("points", curve.points);
  json.put("line", static_cast<int>(curve.line));
  json.put("follows", curve.cycle_samples > 0);
  json.put("x", add_curve_x(blocks, kind, curve.x, cut));
  json.put("y", add_curve_y(blocks, kind, curve.y, cut));
  json.end_object();
}

}  // namespace

std::size_t find_full_count(double full_cycles, std::size_t cycle_samples) {
  return static_cast<std::size_t>(std::llround(full_cycles * static_cast<double>(cycle_samples))) + 1;
}

void add_figure(JsonText& json, BlockStore& blocks, const Figure& figure, const SignalDetail& detail) {
  json.begin_object();
  json.put("id", figure.id);
  json.put("topic", figure.topic);
  json.put("title", figure.title);
  json.put("caption", figure.caption);
  json.put("kind", name_kind(figure.kind));
  add_axis(json, "x", figure.x);
  add_axis(json, "y", figure.y);
  json.put("begin", figure.x_begin);
  json.put("end", figure.x_end);
  json.key("curves");
  json.begin_array();
  for (const FigureCurve& curve : figure.curves) add_curve(json, blocks, figure.kind, curve, detail);
  json.end_array();
  json.end_object();
}

}  // namespace gudgeon
