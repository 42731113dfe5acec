// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Finds places for labels where they cover neither each other nor what they name.
#pragma once

#include <optional>
#include <vector>

#include "gudgeon/base/vec2.h"

namespace gudgeon {

/// An upright rectangle in pixels.
struct Box {
  Vec2 center;
  Vec2 half_size;

  [[nodiscard]] constexpr Box grown(double margin) const { return {center, half_size + Vec2{margin, margin}}; }
};

/// The area two boxes share [px^2].
double find_overlap(const Box& a, const Box& b);

/// Where a label goes.
struct LabelPlace {
  Vec2 center;
  bool is_far = false;  ///< none of the places asked for would do: a line must lead from the label to what it names
};

/// Keeps what is already on the sheet and puts labels, one after the other, where least is covered; labels themselves
/// are never covered.
class LabelPlacer {
 public:
  /// The sheet's part that labels may use.
  explicit LabelPlacer(const Box& sheet) : sheet_(sheet) {}

  void add_obstacle(const Box& box) { obstacles_.push_back(box); }
  /// A line of the given width, kept as a row of boxes.
  void add_obstacle_line(Vec2 from, Vec2 to, double width);

  /// A text that stands already.
  void add_label(const Box& box) { labels_.push_back(box); }

  /// The best of the candidate centres for a label of that size, the earlier ones preferred. Where other labels take
  /// all of them, or it would cover much, the best place on the sheet not far from the first candidate. Nothing when
  /// the sheet is full.
  std::optional<LabelPlace> place(const std::vector<Vec2>& candidates, Vec2 half_size);

 private:
  [[nodiscard]] bool is_free(const Box& label) const;
  [[nodiscard]] double find_covered(const Box& label) const;
  struct Choice {
    Vec2 center;
    double cost = 0.0;  // [px^2]
  };
  [[nodiscard]] std::optional<Choice> find_candidate(const std::vector<Vec2>& candidates, Vec2 half_size) const;
  [[nodiscard]] std::optional<Choice> find_far_place(Vec2 around, Vec2 half_size) const;

  Box sheet_;
  std::vector<Box> obstacles_;
  std::vector<Box> labels_;
};

/// Centres around a spot, nearest first: eight directions at growing distance from its edge.
std::vector<Vec2> make_candidates_around(Vec2 spot, double radius, Vec2 half_size);
/// Centres beside a line, the middle first, on both sides.
std::vector<Vec2> make_candidates_beside(Vec2 from, Vec2 to, double width, Vec2 half_size);

}  // namespace gudgeon
