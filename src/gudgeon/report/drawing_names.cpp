// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// The writing on a mechanism's picture.
#include "gudgeon/report/drawing_names.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

namespace gudgeon {
namespace {

constexpr double kMargin = 28.0;
constexpr double kBodyTextSize = 13.0;
constexpr double kJointTextSize = 15.0;
constexpr double kSmallTextSize = 13.0;

Vec2 find_half_size(std::string_view text, const TextStyle& style) {
  return {0.5 * find_text_width(text, style.size, style.bold), 0.5 * style.size};
}

/// Finds places for names and writes them when all have one: lines to what they name lie below all texts.
class NameWriter {
 public:
  NameWriter(SvgCanvas& canvas, LabelPlacer& placer) : canvas_(canvas), placer_(placer) {}

  /// The target is what a line leads to from a name that found no place near it. A name without any place is left out.
  void add(std::string_view text, const std::vector<Vec2>& candidates, Vec2 target, TextStyle style) {
    style.anchor = TextAnchor::middle;
    const Vec2 half_size = find_half_size(text, style);
    if (const auto place = placer_.place(candidates, half_size))
      names_.push_back({text, style, *place, half_size, target});
  }

  void write() {
    for (const Name& name : names_) {
      if (name.place.is_far) draw_leader(name);
    }
    // Capitals and digits reach about 0.7 em above the baseline.
    for (const Name& name : names_) {
      canvas_.add_text(name.place.center + Vec2{0.0, 0.35 * name.style.size}, name.text, name.style);
    }
  }

  [[nodiscard]] LabelPlacer& placer() { return placer_; }

 private:
  struct Name {
    std::string_view text;
    TextStyle style;
    LabelPlace place;
    Vec2 half_size;
    Vec2 target;
  };

  void draw_leader(const Name& name) {
    const Vec2 low = name.place.center - name.half_size;
    const Vec2 high = name.place.center + name.half_size;
    const Vec2 edge{std::clamp(name.target.x, low.x, high.x), std::clamp(name.target.y, low.y, high.y)};
    canvas_.add_line(edge, name.target, {.stroke = name.style.color, .width = 0.9});
    canvas_.add_circle(name.target, 2.0, {.fill = name.style.color});
  }

  SvgCanvas& canvas_;
  LabelPlacer& placer_;
  std::vector<Name> names_;
};

/// A length in the unit a designer would read it in.
std::string format_length(double meters) {
  if (meters >= 10.0) return fmt::format("{:g} m", meters);
  if (meters >= 0.9e-3) return fmt::format("{:g} mm", 1e3 * meters);
  return fmt::format("{:g} µm", 1e6 * meters);
}

void draw_title(SvgCanvas& canvas, LabelPlacer& placer, const MechanismDrawing& drawing) {
  canvas.add_text({kMargin, 38.0}, drawing.title, {.color = ink::kLine, .size = 19.0, .bold = true});
  canvas.add_text({kMargin, 59.0}, drawing.subtitle, {.color = ink::kGround, .size = kSmallTextSize});
  const double width =
      std::max(find_text_width(drawing.title, 19.0, true), find_text_width(drawing.subtitle, kSmallTextSize));
  placer.add_label({{kMargin + 0.5 * width, 42.0}, {0.5 * width, 24.0}});
}

void draw_scale_bar(SvgCanvas& canvas, LabelPlacer& placer, const DrawingView& view) {
  constexpr double kLongest = 170.0;
  constexpr double kTick = 4.0;
  const double meters = find_round_length(kLongest / view.scale);
  const Vec2 start{kMargin, view.height - 26.0};
  const Vec2 end = start + Vec2{meters * view.scale, 0.0};
  const Paint paint{.stroke = ink::kLine, .width = 1.8};
  canvas.add_line(start, end, paint);
  for (const Vec2 tip : {start, end}) canvas.add_line(tip - Vec2{0.0, kTick}, tip + Vec2{0.0, kTick}, paint);
  canvas.add_text(0.5 * (start + end) + Vec2{0.0, -8.0}, format_length(meters),
                  {.color = ink::kLine, .size = kSmallTextSize, .anchor = TextAnchor::middle});
  placer.add_label({0.5 * (start + end) + Vec2{0.0, -8.0}, {0.5 * (end.x - start.x), 14.0}});
}

void draw_gravity(SvgCanvas& canvas, LabelPlacer& placer, const DrawingPlan& plan) {
  const Vec2 gravity = plan.drawing.gravity;
  if (gravity == Vec2{}) return;
  constexpr double kHalfLength = 22.0;
  const Vec2 center{plan.view.width - kMargin - kHalfLength, 46.0};
  const Vec2 way = (1.0 / norm(gravity)) * Vec2{gravity.x, -gravity.y};
  draw_arrow(canvas, center - kHalfLength * way, center + kHalfLength * way, ink::kGround);
  // The letter stands beside the arrow, on the side away from the sheet's edge.
  const Vec2 side = perp(way).x > 1e-9 || (std::abs(perp(way).x) <= 1e-9 && perp(way).y > 0.0) ? -perp(way) : perp(way);
  canvas.add_text(center + 13.0 * side + Vec2{0.0, 5.0}, "g",
                  {.color = ink::kGround, .size = 16.0, .bold = true, .italic = true, .anchor = TextAnchor::middle});
  placer.add_label({center, {kHalfLength + 6.0, kHalfLength + 6.0}});
}

void draw_legend(SvgCanvas& canvas, LabelPlacer& placer, const DrawingPlan& plan) {
  // Entries from the right edge leftwards, only for what the picture shows.
  double right = plan.view.width - kMargin;
  const double baseline = plan.view.height - 22.0;
  const auto add_entry = [&](std::string_view text, double symbol_width, const auto& draw_symbol) {
    const double left = right - find_text_width(text, kSmallTextSize);
    canvas.add_text({right, baseline}, text,
                    {.color = ink::kGround, .size = kSmallTextSize, .anchor = TextAnchor::end});
    draw_symbol(Vec2{left - 6.0 - 0.5 * symbol_width, baseline - 5.0});
    placer.add_label({{0.5 * (left + right) - 0.5 * symbol_width, baseline - 5.0},
                      {0.5 * (right - left + symbol_width) + 6.0, 12.0}});
    right = left - symbol_width - 26.0;
  };
  const auto is_clearance = [](const DrawnJoint& joint) { return shows_clearance(joint.kind); };
  if (std::ranges::any_of(plan.drawing.joints, is_clearance)) {
    add_entry("clearance joint", 2.0 * kClearanceRadius, [&](Vec2 center) { draw_clearance(canvas, center); });
  }
  if (!plan.drawing.drivers.empty()) {
    add_entry("driven", 30.0, [&](Vec2 center) {
      draw_arrow(canvas, center - Vec2{15.0, 0.0}, center + Vec2{15.0, 0.0}, ink::kDriver);
    });
  }
}

Vec2 find_middle(const std::vector<Vec2>& shape) {
  Vec2 middle;
  for (const Vec2 corner : shape) middle += (1.0 / static_cast<double>(shape.size())) * corner;
  return middle;
}

/// Names go inside a plate when they fit, else beside one of its edges.
std::vector<Vec2> make_plate_candidates(const std::vector<Vec2>& shape, Vec2 half_size) {
  const Vec2 middle = find_middle(shape);
  std::vector<Vec2> candidates = {middle, middle + Vec2{0.0, -16.0}, middle + Vec2{0.0, 16.0}};
  for (std::size_t i = 0; i < shape.size(); ++i) {
    const std::vector<Vec2> beside =
        make_candidates_beside(shape[i], shape[(i + 1) % shape.size()], kBarWidth, half_size);
    candidates.insert(candidates.end(), beside.begin(), beside.end());
  }
  return candidates;
}

/// Keeps later names out of a plate that has got its own.
void block_interior(LabelPlacer& placer, const std::vector<Vec2>& shape) {
  for (std::size_t i = 1; i + 1 < shape.size(); ++i) {
    for (const double share : {0.2, 0.4, 0.6, 0.8}) {
      const Vec2 from = shape[0] + share * (shape[i] - shape[0]);
      placer.add_obstacle_line(from, shape[0] + share * (shape[i + 1] - shape[0]), 12.0);
    }
  }
}

void add_body_name(NameWriter& names, const DrawingPlan& plan, int body) {
  const std::vector<Vec2>& shape = plan.shapes[body];
  const std::string& name = plan.drawing.bodies[body].name;
  const bool is_plate = shape.size() > 2;
  const TextStyle style{.color = find_colors(body).outline,
                        .size = kBodyTextSize,
                        .halo = is_plate ? find_colors(body).fill : ink::kPaper};
  const Vec2 half_size = find_half_size(name, style);
  if (plan.is_block[body]) {
    for (const DrawnJoint& joint : plan.drawing.joints) {
      if (!is_slide(joint.kind) || find_block_body(plan, joint) != body) continue;
      const Vec2 along = kBlockHalfSize.x * make_sheet_direction(joint.direction);
      const Vec2 center = find_block_center(plan, joint);
      return names.add(name, make_candidates_beside(center - along, center + along, 2.0 * kBlockHalfSize.y, half_size),
                       center, style);
    }
  }
  if (is_plate) {
    names.add(name, make_plate_candidates(shape, half_size), find_middle(shape), style);
    return block_interior(names.placer(), shape);
  }
  // Of a bar, the line ends where joints and other bars are least likely to be.
  if (shape.size() == 2) {
    return names.add(name, make_candidates_beside(shape[0], shape[1], kBarWidth + 3.0, half_size),
                     shape[0] + 0.42 * (shape[1] - shape[0]), style);
  }
  if (!shape.empty()) names.add(name, make_candidates_around(shape[0], 12.0, half_size), shape[0], style);
}

void add_joint_name(NameWriter& names, const JointSpot& spot) {
  const bool has_clearance = shows_clearance(spot.kind);
  const TextStyle style{.color = has_clearance ? ink::kClearance : ink::kLine, .size = kJointTextSize, .bold = true};
  const double radius = has_clearance ? kClearanceRadius : kJointRadius + 2.0;
  names.add(spot.names, make_candidates_around(spot.center, radius, find_half_size(spot.names, style)), spot.center,
            style);
}

void add_guide_name(NameWriter& names, const DrawingPlan& plan, const DrawnJoint& joint) {
  const TextStyle style{
      .color = shows_clearance(joint.kind) ? ink::kClearance : ink::kGround, .size = kBodyTextSize, .italic = true};
  const Vec2 center = find_block_center(plan, joint);
  const Vec2 reach = 0.8 * kGuideHalfLength * make_sheet_direction(joint.direction);
  std::vector<Vec2> candidates = make_candidates_around(center + reach, 8.0, find_half_size(joint.name, style));
  std::ranges::copy(make_candidates_around(center - reach, 8.0, find_half_size(joint.name, style)),
                    std::back_inserter(candidates));
  names.add(joint.name, candidates, center + reach, style);
}

}  // namespace

void draw_margins(SvgCanvas& canvas, LabelPlacer& placer, const DrawingPlan& plan) {
  canvas.begin_group("margins");
  draw_title(canvas, placer, plan.drawing);
  draw_scale_bar(canvas, placer, plan.view);
  draw_gravity(canvas, placer, plan);
  draw_legend(canvas, placer, plan);
  canvas.end_group();
}

void draw_names(SvgCanvas& canvas, LabelPlacer& placer, const DrawingPlan& plan) {
  canvas.begin_group("names");
  NameWriter names(canvas, placer);
  // Plates first, for their inside; joints next, which have the least choice; then bars.
  const auto add_bodies = [&](bool plates) {
    for (int i = 0; i < std::ssize(plan.shapes); ++i) {
      if (!plan.is_frame(i) && (plan.shapes[i].size() > 2) == plates) add_body_name(names, plan, i);
    }
  };
  add_bodies(true);
  for (const JointSpot& spot : plan.spots) add_joint_name(names, spot);
  add_bodies(false);
  for (const DrawnJoint& joint : plan.drawing.joints) {
    if (is_slide(joint.kind)) add_guide_name(names, plan, joint);
  }
  names.write();
  canvas.end_group();
}

}  // namespace gudgeon
