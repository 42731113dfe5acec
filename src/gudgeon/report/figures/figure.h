// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// A figure as plain data, in SI: what `gudgeon plot` draws and what the report's page shows.
#pragma once

#include <memory>
#include <string>
#include <vector>

namespace gudgeon {

/// Numbers that figures share without copies.
using Numbers = std::shared_ptr<const std::vector<double>>;

inline Numbers make_numbers(std::vector<double> values) {
  return std::make_shared<const std::vector<double>>(std::move(values));
}

enum class FigureKind {
  time,   ///< signals over time
  line,   ///< y over x, such as a depth over an angle
  phase,  ///< a trajectory or points, each axis with its own scale
  plane,  ///< places in a plane, one scale for both axes
};

struct FigureAxis {
  std::string label;         ///< "Wear depth"
  std::string unit;          ///< SI, "m"; empty for none
  std::string display_unit;  ///< "µm"
  double factor = 1.0;       ///< display value = factor · SI value
};

/// Beside colour, what tells curves apart: on grey paper and to whom colours look alike.
enum class LineStyle { solid, dashed, dotted, dash_dotted };

struct FigureCurve {
  std::string name;   ///< as the legend has it, "first wear"
  std::string group;  ///< stage or case; its curves have one colour and are switched together; empty: a reference line
  Numbers x;
  Numbers y;
  int color = 0;        ///< index into the palette; 0 is the neutral one
  bool shown = true;    ///< at first
  bool points = false;  ///< dots, not a line
  LineStyle line = LineStyle::solid;
  std::size_t cycle_samples = 0;  ///< samples a cycle of a recorded signal; 0 for what is always shown whole
};

struct Figure {
  std::string id;       ///< "wear_depth.A"; also its file's name
  std::string topic;    ///< "wear", "motion", "drive", "contact", "journal", "comparison"
  std::string title;    ///< "Wear depth along the circumference of A"
  std::string caption;  ///< what one has to know to read it
  FigureKind kind = FigureKind::line;
  FigureAxis x;
  FigureAxis y;
  std::vector<FigureCurve> curves;
  double x_begin = 0.0;  ///< part of the x axis shown at first, in SI; all of it when both are equal
  double x_end = 0.0;
};

/// How a stage is called in a sentence: "ideal", "no wear", "first wear", "wear 11".
std::string label_stage(const std::string& stage);

}  // namespace gudgeon
