// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Which joints carry the bodies from the frame outward.
#pragma once

#include <array>
#include <vector>

namespace gudgeon {

/// A joint that the tree may use.
struct TreeEdge {
  int joint = 0;
  int first = 0;
  int second = 0;
  std::array<bool, 2> cost{};  ///< it leaves a rigid body; it adds an unknown, where outside the tree it adds one row
};

/// How a body hangs in the tree; roots have neither parent nor joint.
struct TreeLink {
  int parent = -1;
  int joint = -1;
  int depth = 0;
};

struct SpanningTree {
  std::vector<TreeLink> links;  ///< one a body
  std::vector<int> roots;       ///< the frame, then bodies that no edge reaches, the first of each group
  std::vector<int> order;       ///< bodies, parents before children
};

/// Takes the edge of least cost that reaches a new body, of equal ones that with the shortest path to the root, then
/// that of the first joint. Edges are given in the order of their joints.
SpanningTree grow_spanning_tree(std::size_t n_bodies, const std::vector<TreeEdge>& edges);

}  // namespace gudgeon
