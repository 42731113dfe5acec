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
#include "tests/report/sample_drawings.h"

namespace gudgeon::test {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

struct Label {
  std::string text;
  Box box;
};

/// The value of an attribute in a tag; empty when the tag has none of that name.
std::string find_attribute(const std::string& tag, const std::string& name) {
  const std::size_t start = tag.find(" " + name + "=\"");
  if (start == std::string::npos) return {};
  const std::size_t value = start + name.size() + 3;
  return tag.substr(value, tag.find('"', value) - value);
}

/// Every tag of that name in a picture, and the text behind it.
std::vector<std::pair<std::string, std::string>> find_tags(const std::string& svg, const std::string& name) {
  std::vector<std::pair<std::string, std::string>> tags;
  for (std::size_t at = svg.find("<" + name + " "); at != std::string::npos; at = svg.find("<" + name + " ", at + 1)) {
    const std::size_t end = svg.find('>', at);
    tags.emplace_back(svg.substr(at, end - at), svg.substr(end + 1, svg.find('<', end) - end - 1));
  }
  return tags;
}

/// Every text of a picture with the box it takes.
std::vector<Label> find_labels(const std::string& svg) {
  std::vector<Label> labels;
  for (const auto& [tag, text] : find_tags(svg, "text")) {
    const double size = std::stod(find_attribute(tag, "font-size"));
    const double half_width = 0.5 * find_text_width(text, size, find_attribute(tag, "font-weight") == "bold");
    const std::string anchor = find_attribute(tag, "text-anchor");
    const double shift = anchor == "middle" ? 0.0 : (anchor == "start" ? half_width : -half_width);
    const Vec2 baseline{std::stod(find_attribute(tag, "x")), std::stod(find_attribute(tag, "y"))};
    labels.push_back({text, {baseline + Vec2{shift, -0.35 * size}, {half_width, 0.5 * size}}});
  }
  return labels;
}

std::vector<MechanismDrawing> make_all_samples() {
  return {make_nine_bar_drawing(), make_slider_crank_drawing(), make_four_bar_drawing(), make_quick_return_drawing(),
          make_yoke_drawing()};
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
    for (std::size_t i = 0; i < labels.size(); ++i) {
      EXPECT_GT(labels[i].box.center.x - labels[i].box.half_size.x, 0.0) << labels[i].text;
      EXPECT_LT(labels[i].box.center.x + labels[i].box.half_size.x, 800.0) << labels[i].text;
      for (std::size_t k = 0; k < i; ++k) {
        EXPECT_EQ(find_overlap(labels[i].box, labels[k].box), 0.0) << labels[i].text << " on " << labels[k].text;
      }
    }
  }
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
  ASSERT_EQ(outlines.size(), 2U);
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
  const Vec2 place = placer.place({{20, 50}, {70, 50}}, {10, 5});
  EXPECT_EQ(place, (Vec2{70, 50}));
  // The label itself is taken now.
  EXPECT_EQ(placer.place({{70, 50}, {70, 20}}, {10, 5}), (Vec2{70, 20}));
}

}  // namespace
}  // namespace gudgeon::test
