// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// To which side each loop of a mechanism folds, and its mirror image.
#pragma once

#include <array>
#include <vector>

#include "gudgeon/base/vec2.h"
#include "gudgeon/system/coordinates.h"
#include "gudgeon/system/loop_groups.h"
#include "gudgeon/system/tables.h"
#include "gudgeon/system/topology.h"

namespace gudgeon {

/// The two links between which the loop that a joint closes folds. A loop that leaves exactly as many unknowns as it
/// has rows, once the loops before it are closed, is a dyad and folds between these; any other folds where it closes.
struct LoopFold {
  int closure = 0;       ///< index into Tables::closures
  bool is_dyad = false;  ///< the sign of its sine changes only at a singular position
  int first = -1;        ///< free coordinate of the dyad's first link (a turn, or n_free_turns + slide)
  int second = -1;       ///< of its second link; -1: the guide that closes the loop
};

/// The turn from the first link to the second, walking round the loop from the frame over the joint's first body. A
/// guide counts as a link across its line.
struct FoldAngle {
  double sine = 0.0;  ///< positive to the left; zero without two sides
  double cosine = 0.0;
};

/// Finds folds; keeps references to what it was made of.
class LoopFolds {
 public:
  /// Coordinates may be known beforehand.
  LoopFolds(const Topology& topology, const Tables& tables, const std::vector<int>& known_coordinates = {});
  LoopFolds(const Topology&&, const Tables&, const std::vector<int>& = {}) = delete;
  LoopFolds(const Topology&, const Tables&&, const std::vector<int>& = {}) = delete;

  /// In an order in which they can be closed.
  [[nodiscard]] const std::vector<LoopGroup>& groups() const { return groups_; }
  /// One a closure by a joint, in the order in which they can be closed; those for which none is known come last.
  [[nodiscard]] const std::vector<LoopFold>& folds() const { return folds_; }
  /// The same in the order of the closures.
  [[nodiscard]] std::vector<LoopFold> list_by_closure() const;
  /// That of a group that is a dyad.
  [[nodiscard]] LoopFold find_fold(const LoopGroup& dyad) const;
  /// A slide or a guide is one of the two links.
  [[nodiscard]] bool has_guide(const LoopFold& fold) const;
  [[nodiscard]] FoldAngle find_angle(const LoopFold& fold, const Coordinates& coordinates) const;
  /// Changes the free coordinates q to those of the mirror image, the rest of the loop staying where it is; exact for a
  /// dyad. False when there is none.
  bool mirror(const LoopFold& fold, const Coordinates& coordinates, double* q) const;

 private:
  struct Link {
    int turn = -1;  // -1: no link
    Vec2 vector;    // in the frame's axes, along the walk
  };

  [[nodiscard]] std::vector<int> list_unknowns(const ClosureRows& rows) const;
  [[nodiscard]] Vec2 find_place(const JointEnd& end, const Coordinates& coordinates) const;
  [[nodiscard]] std::vector<int> find_walk(int joint) const;
  [[nodiscard]] Vec2 find_column(const ClosureRows& rows, int coordinate, const Coordinates& coordinates) const;
  [[nodiscard]] Vec2 find_gap(const ClosureRows& rows, const Coordinates& coordinates) const;
  [[nodiscard]] std::array<Link, 2> find_closing_links(const ClosureRows& rows, const Coordinates& coordinates) const;
  void mirror_dyad(const LoopFold& fold, const Coordinates& coordinates, double* q) const;
  bool mirror_closing(const LoopFold& fold, const Coordinates& coordinates, double* q) const;

  const Topology* topology_;
  const Tables* tables_;
  std::vector<LoopFold> folds_;
  std::vector<LoopGroup> groups_;
  double size_ = 0.0;  // longest vector of any closure [m]
};

}  // namespace gudgeon
