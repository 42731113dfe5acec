// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Dyads are peeled off loop by loop; their links are columns of the closures' Jacobian.
#include "gudgeon/system/loop_folds.h"

#include <algorithm>
#include <cmath>
#include <unordered_set>
#include <utility>

#include "gudgeon/system/poses.h"

namespace gudgeon {

namespace {

// Links shorter than this share of the mechanism have no direction.
constexpr double kNoLink = 1e-8;

bool is_on_line(const ClosureRows& rows) { return rows.kind == ClosureKind::line; }

double find_link_direction(Vec2 vector) { return std::atan2(vector.y, vector.x); }

/// What turns a vector onto its mirror image on an axis.
double find_mirror_turn(Vec2 vector, Vec2 axis) {
  return 2.0 * (find_link_direction(axis) - find_link_direction(vector));
}

FoldAngle find_turn(Vec2 first, Vec2 second) {
  const double lengths = norm(first) * norm(second);
  if (!(lengths > 0.0)) return {};
  return {cross(first, second) / lengths, dot(first, second) / lengths};
}

}  // namespace

LoopFolds::LoopFolds(const Topology& topology, const Tables& tables, const std::vector<int>& known_coordinates)
    : topology_(&topology), tables_(&tables) {
  for (const ClosureTerm& term : tables.closure_terms) size_ = std::max(size_, norm(term.vector));
  std::vector<std::vector<int>> unknowns;
  for (const ClosureRows& rows : tables.closures) unknowns.push_back(list_unknowns(rows));
  groups_ = find_loop_groups(tables, std::move(unknowns), known_coordinates);
  for (const LoopGroup& group : groups_) {
    if (group.is_dyad) {
      folds_.push_back(find_fold(group));
      continue;
    }
    for (const int c : group.closures) {
      // A driver's closure folds nowhere.
      if (tables.closures[c].kind != ClosureKind::angle) folds_.push_back({c, false, -1, -1});
    }
  }
}

LoopFold LoopFolds::find_fold(const LoopGroup& dyad) const {
  const int c = dyad.closures.front();
  return {c, true, dyad.unknowns.front(), is_on_line(tables_->closures[c]) ? -1 : dyad.unknowns.back()};
}

std::vector<LoopFold> LoopFolds::list_by_closure() const {
  std::vector<LoopFold> sorted = folds_;
  std::ranges::sort(sorted, {}, &LoopFold::closure);
  return sorted;
}

// The free coordinates of a loop in the order of the walk.
std::vector<int> LoopFolds::list_unknowns(const ClosureRows& rows) const {
  if (rows.kind == ClosureKind::angle) {
    std::vector<int> turns{rows.angle_turn[0], rows.angle_turn[1]};
    std::erase_if(turns, [&](int turn) { return turn >= tables_->counts.n_free_turns; });
    return turns;
  }
  std::unordered_set<int> present;
  for (int t = rows.first_term; t < rows.end_term; ++t) {
    present.insert(tables_->find_turn_index(tables_->closure_terms[t].turn));
    present.insert(tables_->find_slide_index(tables_->closure_terms[t].slide));
  }
  if (is_on_line(rows)) present.insert(tables_->find_turn_index(rows.line_turn));
  std::vector<int> unknowns;
  for (const int coordinate : find_walk(rows.joint)) {
    if (present.erase(coordinate) > 0) unknowns.push_back(coordinate);
  }
  return unknowns;
}

// Free coordinates met from the frame over the joint's first body to the joint and back over its second one.
std::vector<int> LoopFolds::find_walk(int joint) const {
  const auto& [first, second] = topology_->ends[joint];
  const auto list = [&](const JointEnd& end) {
    std::vector<int> met;
    for (const Term& term : topology_->find_path(end.body, end.point)) {
      met.push_back(tables_->find_slide_index(term.slide));
      met.push_back(tables_->find_turn_index(term.turn));
    }
    met.push_back(tables_->find_turn_index(topology_->bodies[end.body].turn));
    return met;
  };
  std::vector<int> walk = list(first);
  const std::vector<int> back = list(second);
  walk.insert(walk.end(), back.rbegin(), back.rend());
  std::erase_if(walk, [&](int index) { return index >= tables_->counts.n_free(); });
  return walk;
}

Vec2 LoopFolds::find_gap(const ClosureRows& rows, const Coordinates& at) const {
  Vec2 gap;
  for (int t = rows.first_term; t < rows.end_term; ++t) {
    const ClosureTerm& term = tables_->closure_terms[t];
    gap += at.slide[term.slide] * (at.rotation[term.turn] * term.vector);
  }
  return gap;
}

// How the loop's gap moves with one coordinate; on a guide, as seen from the body with the guide's line.
Vec2 LoopFolds::find_column(const ClosureRows& rows, int coordinate, const Coordinates& at) const {
  Vec2 column;
  for (int t = rows.first_term; t < rows.end_term; ++t) {
    const ClosureTerm& term = tables_->closure_terms[t];
    const Vec2 arm = at.rotation[term.turn] * term.vector;
    if (tables_->find_turn_index(term.turn) == coordinate) column += at.slide[term.slide] * perp(arm);
    if (tables_->find_slide_index(term.slide) == coordinate) column += arm;
  }
  if (is_on_line(rows) && tables_->find_turn_index(rows.line_turn) == coordinate) column += -perp(find_gap(rows, at));
  return column;
}

bool LoopFolds::has_guide(const LoopFold& fold) const {
  const int n_turns = tables_->counts.n_free_turns;
  return is_on_line(tables_->closures[fold.closure]) || fold.first >= n_turns || fold.second >= n_turns;
}

FoldAngle LoopFolds::find_angle(const LoopFold& fold, const Coordinates& at) const {
  const ClosureRows& rows = tables_->closures[fold.closure];
  if (!fold.is_dyad) {
    const auto [first, second] = find_closing_links(rows, at);
    return find_turn(first.vector, second.vector);
  }
  // A link turns with the column perp(link); both columns are turned alike, so the angle between them is the links'.
  const Vec2 column = find_column(rows, fold.first, at);
  if (!is_on_line(rows)) return find_turn(column, find_column(rows, fold.second, at));
  return find_turn(perp(column), at.rotation[rows.line_turn] * rows.normal);
}

Vec2 LoopFolds::find_place(const JointEnd& end, const Coordinates& at) const {
  return find_pose(topology_->bodies[end.body], at).find_point(end.point);
}

// The two links that meet where a loop closes run from the nearest joints inboard that lie elsewhere; on a guide the
// first one is the guide's line.
std::array<LoopFolds::Link, 2> LoopFolds::find_closing_links(const ClosureRows& rows, const Coordinates& at) const {
  const auto& [first, second] = topology_->ends[rows.joint];
  const Vec2 place = find_place(second, at);
  const auto find_link = [&](int body) {
    for (; topology_->bodies[body].joint >= 0; body = topology_->bodies[body].parent) {
      const auto& [a, b] = topology_->ends[topology_->bodies[body].joint];
      const Vec2 link = place - find_place(a.body == body ? a : b, at);
      if (norm(link) > kNoLink * size_) return Link{topology_->bodies[body].turn, link};
    }
    return Link{};
  };
  const Link back = find_link(second.body);
  if (is_on_line(rows)) {
    const Vec2 along = -perp(at.rotation[rows.line_turn] * rows.normal);
    return {Link{rows.line_turn, along}, back};
  }
  return {find_link(first.body), Link{back.turn, -back.vector}};
}

bool LoopFolds::mirror(const LoopFold& fold, const Coordinates& at, double* q) const {
  if (!fold.is_dyad) return mirror_closing(fold, at, q);
  const int n_turns = tables_->counts.n_free_turns;
  if (fold.first >= n_turns && (fold.second < 0 || fold.second >= n_turns)) return false;  // two guides
  mirror_dyad(fold, at, q);
  return true;
}

void LoopFolds::mirror_dyad(const LoopFold& fold, const Coordinates& at, double* q) const {
  const ClosureRows& rows = tables_->closures[fold.closure];
  const int n_turns = tables_->counts.n_free_turns;
  const int turning = fold.first < n_turns ? fold.first : fold.second;
  const Vec2 link = -perp(find_column(rows, turning, at));
  if (is_on_line(rows)) {
    // Its part across the guide's line stays; a link that carries the line turns it the other way.
    const double turn = find_mirror_turn(link, at.rotation[rows.line_turn] * rows.normal);
    q[turning] += rows.line_turn == turning ? -turn : turn;
    return;
  }
  const int other = turning == fold.first ? fold.second : fold.first;
  if (other < n_turns) {
    // Two links span the rest of the loop from either side of it.
    const Vec2 second = -perp(find_column(rows, other, at));
    const Vec2 span = link + second;
    q[turning] += find_mirror_turn(link, span);
    q[other] += find_mirror_turn(second, span);
    return;
  }
  // The link's part along the slide changes its sign, and the slide makes up for it; a link that carries the slide
  // turns the other way.
  const Vec2 along = find_column(rows, other, at);
  const auto first_term = tables_->closure_terms.begin() + rows.first_term;
  const auto end_term = tables_->closure_terms.begin() + rows.end_term;
  const bool carries = std::any_of(first_term, end_term, [&](const ClosureTerm& term) {
    return term.turn == turning && tables_->find_slide_index(term.slide) == other;
  });
  const double sign = carries ? -1.0 : 1.0;
  q[other] += sign * 2.0 * dot(link, along) / dot(along, along);
  q[turning] += sign * find_mirror_turn(link, perp(along));
}

bool LoopFolds::mirror_closing(const LoopFold& fold, const Coordinates& at, double* q) const {
  const ClosureRows& rows = tables_->closures[fold.closure];
  const int n_turns = tables_->counts.n_free_turns;
  const auto [first, second] = find_closing_links(rows, at);
  if (second.turn < 0 || second.turn >= n_turns) return false;
  if (is_on_line(rows)) {
    q[second.turn] += find_mirror_turn(second.vector, first.vector);
    return true;
  }
  if (first.turn < 0 || first.turn >= n_turns || first.turn == second.turn) return false;
  const Vec2 span = first.vector + second.vector;
  q[first.turn] += find_mirror_turn(first.vector, span);
  q[second.turn] += find_mirror_turn(second.vector, span);
  return true;
}

}  // namespace gudgeon
