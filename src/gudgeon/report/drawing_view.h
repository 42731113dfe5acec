// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Where metres land on the sheet: one scale for both axes, y upwards in the world and downwards on the sheet.
#pragma once

#include "gudgeon/base/vec2.h"
#include "gudgeon/report/mechanism_drawing.h"

namespace gudgeon {

struct DrawingView {
  double width = 0.0;   ///< [px] of the sheet
  double height = 0.0;  ///< [px]
  double scale = 1.0;   ///< [px/m]
  Vec2 world_center;    ///< [m]
  Vec2 sheet_center;    ///< [px] where the world's centre lands

  [[nodiscard]] Vec2 place(Vec2 world) const {
    const Vec2 offset = scale * (world - world_center);
    return sheet_center + Vec2{offset.x, -offset.y};
  }
};

/// A world direction [rad] as a unit vector on the sheet.
inline Vec2 make_sheet_direction(double angle) { return {std::cos(angle), -std::sin(angle)}; }

/// The view that shows everything in the drawing with room for names, title and scale.
DrawingView make_view(const MechanismDrawing& drawing);

/// The round length [m] (1, 2 or 5 times a power of ten) nearest below the wanted one.
double find_round_length(double wanted);

}  // namespace gudgeon
