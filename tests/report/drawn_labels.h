// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// What a picture says, and where: read back from its SVG.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "gudgeon/report/label_placement.h"
#include "gudgeon/report/svg_canvas.h"

namespace gudgeon::test {

struct Label {
  std::string text;
  Box box;
};

/// The value of an attribute in a tag; empty when the tag has none of that name.
inline std::string find_attribute(const std::string& tag, const std::string& name) {
  const std::size_t start = tag.find(" " + name + "=\"");
  if (start == std::string::npos) return {};
  const std::size_t value = start + name.size() + 3;
  return tag.substr(value, tag.find('"', value) - value);
}

/// Every tag of that name in a picture, and the text behind it.
inline std::vector<std::pair<std::string, std::string>> find_tags(const std::string& svg, const std::string& name) {
  std::vector<std::pair<std::string, std::string>> tags;
  for (std::size_t at = svg.find("<" + name + " "); at != std::string::npos; at = svg.find("<" + name + " ", at + 1)) {
    const std::size_t end = svg.find('>', at);
    tags.emplace_back(svg.substr(at, end - at), svg.substr(end + 1, svg.find('<', end) - end - 1));
  }
  return tags;
}

/// Every text of a picture with the box it takes.
inline std::vector<Label> find_labels(const std::string& svg) {
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

/// "rod on A, B on crank": texts that cover another one; empty when none does.
inline std::string find_covered_labels(const std::vector<Label>& labels) {
  std::string found;
  for (std::size_t i = 0; i < labels.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      if (find_overlap(labels[i].box, labels[k].box) == 0.0) continue;
      found += (found.empty() ? "" : ", ") + labels[i].text + " on " + labels[k].text;
    }
  }
  return found;
}

}  // namespace gudgeon::test
