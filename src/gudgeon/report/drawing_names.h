// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// The writing on a mechanism's picture: title, scale, legend, and the names of bodies and joints.
#pragma once

#include "gudgeon/report/drawing_plan.h"
#include "gudgeon/report/label_placement.h"
#include "gudgeon/report/svg_canvas.h"

namespace gudgeon {

/// Title, scale bar, gravity and legend, each kept free of names.
void draw_margins(SvgCanvas& canvas, LabelPlacer& placer, const DrawingPlan& plan);
/// Names, where they cover least; everything drawn before must be an obstacle of the placer.
void draw_names(SvgCanvas& canvas, LabelPlacer& placer, const DrawingPlan& plan);

}  // namespace gudgeon
