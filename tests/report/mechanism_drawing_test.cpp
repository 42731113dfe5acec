// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// The picture of a linkage.
#include "gudgeon/report/mechanism_drawing.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "gudgeon/report/label_placement.h"
#include "gudgeon/report/mechanism_symbols.h"
#include "gudgeon/report/svg_canvas.h"
#include "tests/report/drawn_labels.h"
#include "tests/report/sample_drawings.h"

namespace gudgeon::test {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

std::vector<MechanismDrawing> make_all_samples() {
  return {make_nine_bar_drawing(), make_slider_crank_drawing(), make_four_bar_drawing(),  make_quick_return_drawing(),
          make_yoke_drawing(),     make_scissors_drawing(5),    make_scissors_drawing(12)};
}

TEST(MechanismDrawing, NamesEveryMovingBodyAndJoint) {
  for (const MechanismDrawing& drawing : make_all_samples()) {
    const std::string svg = render_svg(drawing);
    for (const DrawnBody& body : drawing.bodies) {
      if (body.is_frame) continue;
      EXPECT_THAT(svg, HasSubstr(">" + body.name + "</text>"));
    }
    for (const DrawnJoint& joint : drawing.joints) EXPECT_THAT(svg, HasSubstr(joint.name));
  }
}

TEST(MechanismDrawing, LabelsOverlapNeitherEachOtherNorTheEdge) {
  for (const MechanismDrawing& drawing : make_all_samples()) {
    const std::vector<Label> labels = find_labels(render_svg(drawing));
    ASSERT_GT(labels.size(), 5U);
    for (const Label& label : labels) {
      EXPECT_GT(label.box.center.x - label.box.half_size.x, 0.0) << label.text;
      EXPECT_LT(label.box.center.x + label.box.half_size.x, 800.0) << label.text;
    }
    EXPECT_EQ(find_covered_labels(labels), "");
  }
}

/// A bar with a pin on the frame in its slot, and one with a pin in a slot of the frame.
MechanismDrawing make_fixed_drawing(double direction) {
  const Vec2 along{0.1 * std::cos(direction), 0.1 * std::sin(direction)};
  MechanismDrawing drawing;
  drawing.bodies = {{"frame", true, {{0, 0}, {0.5, 0}}, {}},
                    {"slotted", false, {{0, 0}, along, {0.1, 0.3}}, {}},
                    {"pinned", false, {{0.5, 0}, {0.3, 0.3}}, {}}};
  drawing.joints = {{"pin", DrawnJointKind::pin_in_slot, 1, 0, along, {0, 0}, direction},
                    {"slot", DrawnJointKind::pin_in_slot, 0, 2, {0.5, 0}, {0.5, 0}, direction}};
  return drawing;
}

std::string find_group(const std::string& svg, const std::string& name) {
  const std::size_t begin = svg.find("class=\"" + name + "\"");
  return svg.substr(begin, svg.find("</g>", begin) - begin);
}

TEST(MechanismDrawing, PinsAndSlotsOfTheFrameAreMarkedAsFixed) {
  for (const double direction : {0.0, 0.6, 1.5707963267948966}) {
    const std::string svg = render_svg(make_fixed_drawing(direction));
    // The pin's support: a triangle and its hatching.
    EXPECT_EQ(find_tags(find_group(svg, "frame"), "polygon").size(), 1U);
    EXPECT_GT(find_tags(find_group(svg, "frame"), "line").size(), 4U);
    // The slot's hatching beside it; the other slot moves and has none.
    EXPECT_GT(find_tags(find_group(svg, "slots"), "line").size(), 4U);
    EXPECT_EQ(find_tags(find_group(svg, "slots"), "polygon").size(), 4U);
  }
  MechanismDrawing moving = make_fixed_drawing(0.0);
  for (DrawnJoint& joint : moving.joints) joint.first_body = 1, joint.second_body = 2;
  const std::string svg = render_svg(moving);
  EXPECT_TRUE(find_tags(find_group(svg, "frame"), "polygon").empty());
  EXPECT_TRUE(find_tags(find_group(svg, "slots"), "line").empty());
}

// Two slots of one line are one slot: no end of one shows within the other.
TEST(MechanismDrawing, InsidesOfSlotsLieAboveAllOutlines) {
  const std::string slots = find_group(render_svg(make_fixed_drawing(0.0)), "slots");
  const auto shapes = find_tags(slots, "polygon");
  ASSERT_EQ(shapes.size(), 4U);
  for (std::size_t k = 0; k < 4; ++k) {
    EXPECT_EQ(find_attribute(shapes[k].first, "stroke") == ink::kPaper, k >= 2) << k;
  }
}

TEST(MechanismDrawing, ALineLeadsToWhatANameFoundNoPlaceAt) {
  const std::string names = find_group(render_svg(make_scissors_drawing(12)), "names");
  const auto leaders = find_tags(names, "line");
  EXPECT_FALSE(leaders.empty());
  EXPECT_EQ(leaders.size(), find_tags(names, "circle").size());
  // Lines lie below all texts.
  EXPECT_LT(names.rfind("<line "), names.find("<text "));
  EXPECT_TRUE(find_tags(find_group(render_svg(make_four_bar_drawing()), "names"), "line").empty());
}

TEST(MechanismDrawing, ScaleIsTheSameAlongBothAxes) {
  MechanismDrawing drawing;
  drawing.bodies = {{"frame", true, {}, {}}, {"plate", false, {{0, 0}, {1, 0}, {1, 1}, {0, 1}}, {}}};
  const auto plates = find_tags(render_svg(drawing), "polygon");
  ASSERT_FALSE(plates.empty());
  std::istringstream text(find_attribute(plates[0].first, "points"));
  std::vector<Vec2> corners(3);
  char comma = 0;
  for (Vec2& corner : corners) text >> corner.x >> comma >> corner.y;
  const Vec2 first = corners[1] - corners[0];
  const Vec2 second = corners[2] - corners[1];
  EXPECT_GT(norm(first), 100.0);
  EXPECT_NEAR(norm(first), norm(second), 0.02);  // two decimals are written
  EXPECT_NEAR(dot(first, second), 0.0, 1.0);
}

TEST(MechanismDrawing, MarksClearanceOnlyWhereThereIsAny) {
  EXPECT_THAT(render_svg(make_nine_bar_drawing()), HasSubstr("clearance joint"));
  EXPECT_THAT(render_svg(make_four_bar_drawing()), Not(HasSubstr(std::string(ink::kClearance))));
}

// The slot is 80 mm long, which is drawn longer than the crank and within the sheet.
TEST(MechanismDrawing, SlotsAreAsLongAsTheyAre) {
  const std::string svg = render_svg(make_yoke_drawing());
  const std::string slots =
      svg.substr(svg.find("class=\"slots\""), svg.find("class=\"joints\"") - svg.find("class=\"slots\""));
  const auto outlines = find_tags(slots, "polygon");
  ASSERT_EQ(outlines.size(), 2U);  // and what is inside
  std::istringstream text(find_attribute(outlines[0].first, "points"));
  Vec2 low, high;
  char comma = 0;
  text >> low.x >> comma >> low.y >> high.x >> comma >> high.y;
  const double width = std::stod(find_attribute(outlines[0].first, "stroke-width"));
  const double height = std::stod(svg.substr(svg.find("height=\"") + 8));
  EXPECT_GT(std::min(low.y, high.y) - 0.5 * width, 0.0);
  EXPECT_LT(std::max(low.y, high.y) + 0.5 * width, height);
  // 80 mm, its round ends within it, beside the 140 mm of the guide, which has straight ends.
  double guide = 0.0;
  for (const auto& [tag, unused] : find_tags(svg, "line")) {
    if (find_attribute(tag, "y1") != find_attribute(tag, "y2")) continue;
    guide = std::max(guide, std::abs(std::stod(find_attribute(tag, "x2")) - std::stod(find_attribute(tag, "x1"))));
  }
  EXPECT_NEAR((norm(high - low) + width) / guide, 80.0 / 140.0, 0.02);  // the outline stands around it
}

TEST(MechanismDrawing, JointsAtOnePointShareACircle) {
  EXPECT_THAT(render_svg(make_nine_bar_drawing()), HasSubstr(">D2, D3</text>"));
}

TEST(MechanismDrawing, BringsItsOwnGroundAndEscapesNames) {
  const std::string svg = render_svg(make_quick_return_drawing());
  EXPECT_THAT(svg, HasSubstr("<rect width=\"800\""));
  EXPECT_THAT(svg, HasSubstr("Quick return &lt;&amp;&gt;"));
}

TEST(MechanismDrawing, NothingAtAllStillHasAPicture) {
  const std::string svg = render_svg({});
  EXPECT_THAT(svg, HasSubstr("</svg>"));
  EXPECT_THAT(svg, Not(HasSubstr("nan")));
  EXPECT_THAT(svg, Not(HasSubstr("inf")));
}

TEST(MechanismDrawing, SameInputSamePicture) {
  EXPECT_EQ(render_svg(make_nine_bar_drawing()), render_svg(make_nine_bar_drawing()));
}

TEST(ConvexHull, KeepsCornersOnly) {
  const std::vector<Vec2> hull = find_convex_hull({{0, 0}, {1, 0}, {0.5, 0.5}, {1, 1}, {0, 1}, {0.5, 0.0}});
  EXPECT_EQ(hull.size(), 4U);
  EXPECT_EQ(find_convex_hull({{0, 0}, {1, 1}, {2, 2}}).size(), 2U);
  EXPECT_EQ(find_convex_hull({{1, 2}, {1, 2}}).size(), 1U);
  EXPECT_TRUE(find_convex_hull({}).empty());
}

TEST(LabelPlacer, AvoidsWhatIsTaken) {
  LabelPlacer placer({{50, 50}, {50, 50}});
  placer.add_obstacle({{20, 50}, {15, 15}});
  const Vec2 place = placer.place({{20, 50}, {70, 50}}, {10, 5})->center;
  EXPECT_EQ(place, (Vec2{70, 50}));
  // The label itself is taken now.
  EXPECT_EQ(placer.place({{70, 50}, {70, 20}}, {10, 5})->center, (Vec2{70, 20}));
}

// A label is worth more than any line.
TEST(LabelPlacer, CoversLinesRatherThanLabels) {
  LabelPlacer placer({{50, 50}, {50, 50}});
  placer.add_obstacle({{70, 20}, {5, 5}});
  placer.add_label({{20, 50}, {15, 15}});
  EXPECT_EQ(placer.place({{20, 50}, {70, 20}}, {10, 5})->center, (Vec2{70, 20}));
  // But it rather goes elsewhere than to hide much.
  placer.add_obstacle({{70, 80}, {20, 15}});
  EXPECT_TRUE(placer.place({{70, 80}}, {10, 5})->is_far);
}

TEST(LabelPlacer, GoesFarWhereAllIsTakenAndGivesUpOnAFullSheet) {
  LabelPlacer placer({{50, 50}, {50, 50}});
  placer.add_label({{50, 40}, {50, 40}});
  const auto far = placer.place({{50, 50}}, {10, 5});
  ASSERT_TRUE(far);
  EXPECT_TRUE(far->is_far);
  EXPECT_GT(far->center.y, 86.9);
  EXPECT_LT(far->center.y, 93.1);
  placer.add_label({{50, 50}, {50, 50}});
  EXPECT_FALSE(placer.place({{50, 50}}, {10, 5}));
}

}  // namespace
}  // namespace gudgeon::test
