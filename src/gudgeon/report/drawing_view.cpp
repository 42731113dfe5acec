// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// The view of a drawing.
#include "gudgeon/report/drawing_view.h"

#include <algorithm>
#include <limits>

namespace gudgeon {
namespace {

constexpr double kSheetWidth = 800.0;
constexpr double kSidePadding = 90.0;
constexpr double kHeader = 110.0;  // title above, names of the topmost points below
constexpr double kFooter = 125.0;  // ground signs and names above, scale bar below
constexpr double kMinContentHeight = 110.0;
constexpr double kMaxContentHeight = 620.0;

struct Extent {
  Vec2 low{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  Vec2 high{-std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};

  void include(Vec2 point) {
    low = {std::min(low.x, point.x), std::min(low.y, point.y)};
    high = {std::max(high.x, point.x), std::max(high.y, point.y)};
  }
};

Extent find_extent(const MechanismDrawing& drawing) {
  Extent extent;
  for (const DrawnBody& body : drawing.bodies) {
    if (body.is_frame) continue;  // the frame shows only where a joint holds on to it
    for (const Vec2 point : body.points) extent.include(point);
    if (body.points.size() <= 1) extent.include(body.center_of_mass);
  }
  for (const DrawnJoint& joint : drawing.joints) {
    const Vec2 reach = 0.5 * joint.length * Vec2{std::cos(joint.direction), std::sin(joint.direction)};
    extent.include(joint.first - reach), extent.include(joint.first + reach), extent.include(joint.second);
  }
  for (const DrawnTrace& trace : drawing.traces) {
    for (const Vec2 point : trace.points) extent.include(point);
  }
  if (!(extent.low.x <= extent.high.x)) return {{0.0, 0.0}, {0.0, 0.0}};
  return extent;
}

}  // namespace

DrawingView make_view(const MechanismDrawing& drawing) {
  const Extent extent = find_extent(drawing);
  const Vec2 size = extent.high - extent.low;
  const double content_width = kSheetWidth - 2.0 * kSidePadding;
  DrawingView view;
  view.width = kSheetWidth;
  // A mechanism without extent still needs a scale: a metre across.
  view.scale =
      size.x > 0.0 || size.y > 0.0 ? std::min(content_width / size.x, kMaxContentHeight / size.y) : content_width;
  const double content_height = std::clamp(view.scale * size.y, kMinContentHeight, kMaxContentHeight);
  view.height = kHeader + content_height + kFooter;
  view.world_center = 0.5 * (extent.low + extent.high);
  view.sheet_center = {0.5 * kSheetWidth, kHeader + 0.5 * content_height};
  return view;
}

double find_round_length(double wanted) {
  const double power = std::pow(10.0, std::floor(std::log10(wanted)));
  for (const double factor : {5.0, 2.0}) {
    if (factor * power <= wanted) return factor * power;
  }
  return power;
}

}  // namespace gudgeon
