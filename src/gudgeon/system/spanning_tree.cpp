// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Prim's algorithm.
#include "gudgeon/system/spanning_tree.h"

#include <functional>
#include <optional>
#include <queue>
#include <tuple>

namespace gudgeon {

namespace {

// An edge out of the tree.
struct OpenEdge {
  std::array<bool, 2> cost;
  int depth;
  int joint;
  int parent;
  int child;

  friend bool operator>(const OpenEdge& a, const OpenEdge& b) {
    return std::tie(a.cost, a.depth, a.joint) > std::tie(b.cost, b.depth, b.joint);
  }
};

class TreeGrower {
 public:
  TreeGrower(std::size_t n_bodies, const std::vector<TreeEdge>& edges) : edges_at_(n_bodies), in_tree_(n_bodies) {
    tree_.links.resize(n_bodies);
    for (const TreeEdge& edge : edges) {
      for (const int body : {edge.first, edge.second}) edges_at_[static_cast<std::size_t>(body)].push_back(&edge);
    }
  }

  SpanningTree grow() {
    for (std::size_t root = 0; root < in_tree_.size(); ++root) {
      if (in_tree_[root]) continue;
      tree_.roots.push_back(static_cast<int>(root));
      add(static_cast<int>(root));
      while (const std::optional<OpenEdge> edge = take()) {
        tree_.links[edge->child] = {edge->parent, edge->joint, edge->depth + 1};
        add(edge->child);
      }
    }
    return std::move(tree_);
  }

 private:
  void add(int body) {
    in_tree_[body] = true;
    tree_.order.push_back(body);
    for (const TreeEdge* edge : edges_at_[body]) {
      const int child = edge->first == body ? edge->second : edge->first;
      if (!in_tree_[child]) open_.push({edge->cost, tree_.links[body].depth, edge->joint, body, child});
    }
  }

  std::optional<OpenEdge> take() {
    while (!open_.empty()) {
      const OpenEdge edge = open_.top();
      open_.pop();
      if (!in_tree_[edge.child]) return edge;
    }
    return std::nullopt;
  }

  std::vector<std::vector<const TreeEdge*>> edges_at_;  // one list a body
  std::vector<bool> in_tree_;
  std::priority_queue<OpenEdge, std::vector<OpenEdge>, std::greater<>> open_;
  SpanningTree tree_;
};

}  // namespace

SpanningTree grow_spanning_tree(std::size_t n_bodies, const std::vector<TreeEdge>& edges) {
  return TreeGrower(n_bodies, edges).grow();
}

}  // namespace gudgeon
