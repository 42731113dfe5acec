// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// A figure as SVG for print.
#pragma once

#include <string>

#include "gudgeon/report/figures/figure.h"

namespace gudgeon {

struct PlotSettings {
  double cycles = 2.0;    ///< of a recorded signal, the last ones; 0 for all
  double width = 720.0;   ///< [px]
  double height = 440.0;  ///< [px]; a plane figure is as high as wide
};

/// The figure on a white sheet: title, axes with units, legend of what is shown.
std::string plot_figure(const Figure& figure, const PlotSettings& settings);

}  // namespace gudgeon
