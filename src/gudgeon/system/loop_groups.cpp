// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Loops are peeled off one after the other; what becomes known is struck from the loops that have it.
#include "gudgeon/system/loop_groups.h"

#include <algorithm>
#include <iterator>
#include <set>
#include <utility>

namespace gudgeon {

namespace {

class LoopPeeler {
 public:
  LoopPeeler(const Tables& tables, std::vector<std::vector<int>> unknowns, const std::vector<int>& known)
      : tables_(tables), open_(std::move(unknowns)), loops_with_(static_cast<std::size_t>(tables.counts.n_free())) {
    for (int c = 0; c < static_cast<int>(open_.size()); ++c) {
      left_.insert(c);
      unpaired_.insert(c);
      for (const int coordinate : open_[c]) loops_with_[coordinate].push_back(c);
      note(c);
    }
    learn(known);
  }

  std::vector<LoopGroup> peel() {
    while (take_angle() || take_dyad() || take_pair()) {
    }
    if (!left_.empty()) take({left_.begin(), left_.end()}, false);
    return std::move(groups_);
  }

 private:
  // The first driver between two bodies of which one is known says where the other is.
  bool take_angle() {
    if (angles_.empty()) return false;
    take({*angles_.begin()}, false);
    return true;
  }

  // The first loop that leaves as many unknowns as it has rows.
  bool take_dyad() {
    if (dyads_.empty()) return false;
    take({*dyads_.begin()}, true);
    return true;
  }

  // The first two loops that share unknowns and have as many as they have rows: no dyads, but those beyond them may be.
  bool take_pair() {
    while (!unpaired_.empty()) {
      const int one = *unpaired_.begin();
      for (const int other : list_neighbours(one)) {
        if (other < one || std::ssize(list_open({one, other})) != count_rows_of({one, other})) continue;
        take({one, other}, false);
        return true;
      }
      unpaired_.erase(one);
    }
    return false;
  }

  void take(const std::vector<int>& loops, bool is_dyad) {
    const std::vector<int> open = list_open(loops);
    groups_.push_back({loops, open, is_dyad, std::ssize(open) <= count_rows_of(loops)});
    for (const int c : loops) {
      for (std::set<int>* loops_left : {&left_, &angles_, &dyads_, &unpaired_}) loops_left->erase(c);
    }
    learn(open);
  }

  void learn(const std::vector<int>& coordinates) {
    for (const int coordinate : coordinates) {
      for (const int c : std::exchange(loops_with_[coordinate], {})) {
        if (!left_.contains(c)) continue;
        std::erase(open_[c], coordinate);
        note(c);
        unpaired_.insert(c);
        for (const int other : list_neighbours(c)) {
          if (other < c) unpaired_.insert(other);
        }
      }
    }
  }

  // Whether a loop can be closed by itself.
  void note(int c) {
    const std::size_t n_open = open_[c].size();
    const auto n_rows = static_cast<std::size_t>(count_rows(tables_.closures[c].kind));
    const bool is_angle = tables_.closures[c].kind == ClosureKind::angle;
    std::set<int>& ready = is_angle ? angles_ : dyads_;
    if (n_open == n_rows || (is_angle && n_open < n_rows)) {
      ready.insert(c);
    } else {
      ready.erase(c);
    }
  }

  // Loops left that share an open unknown with one.
  [[nodiscard]] std::set<int> list_neighbours(int c) const {
    std::set<int> neighbours;
    for (const int coordinate : open_[c]) {
      for (const int other : loops_with_[coordinate]) {
        if (other != c && left_.contains(other)) neighbours.insert(other);
      }
    }
    return neighbours;
  }

  [[nodiscard]] std::vector<int> list_open(const std::vector<int>& loops) const {
    std::vector<int> open;
    std::set<int> met;
    for (const int c : loops) {
      for (const int coordinate : open_[c]) {
        if (met.insert(coordinate).second) open.push_back(coordinate);
      }
    }
    return open;
  }

  [[nodiscard]] int count_rows_of(const std::vector<int>& loops) const {
    int n_rows = 0;
    for (const int c : loops) n_rows += count_rows(tables_.closures[c].kind);
    return n_rows;
  }

  const Tables& tables_;
  std::vector<std::vector<int>> open_;        // unknowns, one list a loop
  std::vector<std::vector<int>> loops_with_;  // one list an unknown
  std::set<int> left_;
  std::set<int> angles_;    // of those left, drivers that say where a body is
  std::set<int> dyads_;     // of those left
  std::set<int> unpaired_;  // of those left, loops whose later neighbours are to be looked at
  std::vector<LoopGroup> groups_;
};

}  // namespace

std::vector<LoopGroup> find_loop_groups(const Tables& tables, std::vector<std::vector<int>> unknowns,
                                        const std::vector<int>& known) {
  return LoopPeeler(tables, std::move(unknowns), known).peel();
}

}  // namespace gudgeon
