// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Dyads are peeled off loop by loop; their links are columns of the closures' Jacobian.
#include "gudgeon/system/loop_folds.h"

#include <algorithm>
#include <cmath>
#include <numeric>

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

LoopFolds::LoopFolds(const Mechanism& mechanism, const Topology& topology, const Tables& tables,
                     const std::vector<int>& known_coordinates)
    : mechanism_(&mechanism), topology_(&topology), tables_(&tables) {
  for (const ClosureTerm& term : tables.closure_terms) size_ = std::max(size_, norm(term.vector));
  std::vector<bool> known(tables.counts.n_free(), false);
  for (const int coordinate : known_coordinates) known[coordinate] = true;
  std::vector<int> left(tables.closures.size());
  std::iota(left.begin(), left.end(), 0);
  while (take_angle(left, known) || take_dyad(left, known) || take_pair(left, known)) {
  }
  add_rest(left, known);
}

// What is no group of one or two loops counts as one that closes together.
void LoopFolds::add_rest(const std::vector<int>& left, const std::vector<bool>& known) {
  if (left.empty()) return;
  LoopGroup rest{left, {}, -1, false};
  int n_rows = 0;
  for (const int c : left) {
    add_plain(c);
    n_rows += count_rows(tables_->closures[c].kind);
    for (const int coordinate : list_open(c, known)) {
      if (std::ranges::find(rest.unknowns, coordinate) == rest.unknowns.end()) rest.unknowns.push_back(coordinate);
    }
  }
  rest.is_determined = rest.unknowns.size() <= static_cast<std::size_t>(n_rows);
  groups_.push_back(rest);
}

std::vector<LoopFold> LoopFolds::list_by_closure() const {
  std::vector<LoopFold> sorted = folds_;
  std::ranges::sort(sorted, {}, &LoopFold::closure);
  return sorted;
}

// A driver's closure folds nowhere.
void LoopFolds::add_plain(int closure) {
  if (tables_->closures[closure].kind != ClosureKind::angle) folds_.push_back({closure, false, -1, -1});
}

std::vector<int> LoopFolds::list_open(int closure, const std::vector<bool>& known) const {
  std::vector<int> open = list_unknowns(tables_->closures[closure]);
  std::erase_if(open, [&](int coordinate) { return known[coordinate]; });
  return open;
}

// The first driver between two bodies of which one is known says where the other is.
bool LoopFolds::take_angle(std::vector<int>& left, std::vector<bool>& known) {
  for (const int c : left) {
    if (tables_->closures[c].kind != ClosureKind::angle) continue;
    const std::vector<int> open = list_open(c, known);
    if (open.size() > 1) continue;
    for (const int coordinate : open) known[coordinate] = true;
    groups_.push_back({{c}, open, -1, true});
    std::erase(left, c);
    return true;
  }
  return false;
}

// The first loop that leaves as many unknowns as it has rows.
bool LoopFolds::take_dyad(std::vector<int>& left, std::vector<bool>& known) {
  for (const int c : left) {
    if (tables_->closures[c].kind == ClosureKind::angle) continue;
    const bool is_line = is_on_line(tables_->closures[c]);
    const std::vector<int> open = list_open(c, known);
    if (open.size() != (is_line ? 1u : 2u)) continue;
    for (const int coordinate : open) known[coordinate] = true;
    folds_.push_back({c, true, open[0], is_line ? -1 : open[1]});
    groups_.push_back({{c}, open, static_cast<int>(folds_.size()) - 1, true});
    std::erase(left, c);
    return true;
  }
  return false;
}

// The first two loops that share as many unknowns as they have rows: no dyads, but those beyond them may be.
bool LoopFolds::take_pair(std::vector<int>& left, std::vector<bool>& known) {
  for (const int one : left) {
    for (const int other : left) {
      if (other <= one) continue;
      std::vector<int> open = list_open(one, known);
      for (const int coordinate : list_open(other, known)) {
        if (std::ranges::find(open, coordinate) == open.end()) open.push_back(coordinate);
      }
      const int n_rows = count_rows(tables_->closures[one].kind) + count_rows(tables_->closures[other].kind);
      if (open.size() != static_cast<std::size_t>(n_rows)) continue;
      for (const int coordinate : open) known[coordinate] = true;
      for (const int c : {one, other}) add_plain(c);
      groups_.push_back({{one, other}, open, -1, true});
      std::erase_if(left, [&, one, other](int c) { return c == one || c == other; });
      return true;
    }
  }
  return false;
}

// The free coordinates of a loop in the order of the walk.
std::vector<int> LoopFolds::list_unknowns(const ClosureRows& rows) const {
  std::vector<bool> present(tables_->counts.n_free(), false);
  const auto mark = [&](int index) {
    if (index < tables_->counts.n_free()) present[index] = true;
  };
  if (rows.kind == ClosureKind::angle) {
    std::vector<int> turns{rows.angle_turn[0], rows.angle_turn[1]};
    std::erase_if(turns, [&](int turn) { return turn >= tables_->counts.n_free_turns; });
    return turns;
  }
  for (int t = rows.first_term; t < rows.end_term; ++t) {
    mark(tables_->find_turn_index(tables_->closure_terms[t].turn));
    mark(tables_->find_slide_index(tables_->closure_terms[t].slide));
  }
  if (is_on_line(rows)) mark(tables_->find_turn_index(rows.line_turn));
  std::vector<int> unknowns;
  for (const int coordinate : find_walk(rows.joint)) {
    if (!present[coordinate]) continue;
    unknowns.push_back(coordinate);
    present[coordinate] = false;
  }
  return unknowns;
}

// Free coordinates met from the frame over the joint's first body to the joint and back over its second one.
std::vector<int> LoopFolds::find_walk(int joint) const {
  const auto [first, second] = anchors(mechanism_->joints[joint].kind);
  const auto list = [&](const Anchor& anchor) {
    const int body = find_body(*mechanism_, anchor.body);
    std::vector<int> met;
    for (const Term& term : topology_->find_path(body, find_point(mechanism_->bodies[body], anchor.point)->position)) {
      met.push_back(tables_->find_slide_index(term.slide));
      met.push_back(tables_->find_turn_index(term.turn));
    }
    met.push_back(tables_->find_turn_index(topology_->bodies[body].turn));
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

// The two links that meet where a loop closes run from the nearest joints inboard that lie elsewhere; on a guide the
// first one is the guide's line.
std::array<LoopFolds::Link, 2> LoopFolds::find_closing_links(const ClosureRows& rows, const Coordinates& at) const {
  const std::vector<BodyPose> poses = find_poses(*mechanism_, *topology_, at);
  const auto find_place = [&](int body, const Anchor& anchor) {
    return poses[body].find_point(find_point(mechanism_->bodies[body], anchor.point)->position);
  };
  const auto [first, second] = anchors(mechanism_->joints[rows.joint].kind);
  const int second_body = find_body(*mechanism_, second.body);
  const Vec2 place = find_place(second_body, second);
  const auto find_link = [&](int body) {
    for (; topology_->bodies[body].joint >= 0; body = topology_->bodies[body].parent) {
      const auto [a, b] = anchors(mechanism_->joints[topology_->bodies[body].joint].kind);
      const Vec2 link = place - find_place(body, find_body(*mechanism_, a.body) == body ? a : b);
      if (norm(link) > kNoLink * size_) return Link{topology_->bodies[body].turn, link};
    }
    return Link{};
  };
  const Link back = find_link(second_body);
  if (is_on_line(rows)) {
    const Vec2 along = -perp(at.rotation[rows.line_turn] * rows.normal);
    return {Link{rows.line_turn, along}, back};
  }
  return {find_link(find_body(*mechanism_, first.body)), Link{back.turn, -back.vector}};
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
