// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Constrained minimum-degree order, symbolic and numeric elimination.
#include "gudgeon/system/elimination.h"

#include <algorithm>
#include <cassert>
#include <iterator>
#include <set>

namespace gudgeon {

namespace {

// The graph of what is not yet eliminated; eliminating an index joins its neighbours pairwise.
class EliminationGraph {
 public:
  EliminationGraph(int n, int n_constraints, const std::vector<std::pair<int, int>>& pattern)
      : neighbours_(n), waiting_for_(n, 0), constraints_of_(n) {
    const int n_coordinates = n - n_constraints;
    for (const auto& [row, column] : pattern) {
      assert(row != column);
      neighbours_[row].push_back(column);
      neighbours_[column].push_back(row);
      const auto [low, high] = std::minmax(row, column);
      if (high >= n_coordinates && low < n_coordinates) {
        constraints_of_[low].push_back(high);
        ++waiting_for_[high];
      }
    }
    for (int i = 0; i < n; ++i) {
      std::ranges::sort(neighbours_[i]);
      if (waiting_for_[i] == 0) ready_.emplace(neighbours_[i].size(), i);
    }
  }

  // The first one with the fewest neighbours.
  [[nodiscard]] int find_next() const { return ready_.begin()->second; }

  // The neighbours it had, in order.
  std::vector<int> eliminate(int index) {
    ready_.erase({neighbours_[index].size(), index});
    std::vector<int> front = std::move(neighbours_[index]);
    for (const int a : front) {
      const bool is_ready = waiting_for_[a] == 0;
      if (is_ready) ready_.erase({neighbours_[a].size(), a});
      join(neighbours_[a], front);
      std::erase_if(neighbours_[a], [&](int b) { return b == a || b == index; });
      if (is_ready) ready_.emplace(neighbours_[a].size(), a);
    }
    for (const int constraint : constraints_of_[index]) {
      if (--waiting_for_[constraint] == 0) ready_.emplace(neighbours_[constraint].size(), constraint);
    }
    return front;
  }

 private:
  void join(std::vector<int>& sorted, const std::vector<int>& others) {
    joined_.clear();
    std::ranges::set_union(sorted, others, std::back_inserter(joined_));
    sorted.swap(joined_);
  }

  std::vector<std::vector<int>> neighbours_;      // each list in order
  std::vector<int> joined_;                       // scratch
  std::vector<int> waiting_for_;                  // coordinates that a constraint row still waits for
  std::vector<std::vector<int>> constraints_of_;  // one list a coordinate
  std::set<std::pair<std::size_t, int>> ready_;   // neighbours, and index, of what waits for nothing
};

}  // namespace

Elimination::Elimination(int n, int n_constraints, const std::vector<std::pair<int, int>>& pattern) : n_(n) {
  EliminationGraph graph(n, n_constraints, pattern);
  std::vector<std::vector<int>> fronts(n);
  position_.assign(n, 0);
  for (int k = 0; k < n; ++k) {
    const int index = graph.find_next();
    position_[index] = k;
    order_.push_back(index);
    fronts[k] = graph.eliminate(index);
  }

  // Columns hold their rows in the order of elimination, so that an update of (a, b), a before b, is in column a.
  begin_.push_back(n);
  for (int k = 0; k < n; ++k) {
    std::vector<int>& rows = fronts[k];
    std::ranges::sort(rows, {}, [&](int row) { return position_[row]; });
    rows_.insert(rows_.end(), rows.begin(), rows.end());
    begin_.push_back(n + static_cast<std::int32_t>(rows_.size()));
  }
  n_values_ = static_cast<std::size_t>(begin_.back());
  find_targets();
}

// The rows behind a in its column are rows of column a, too, in the same order.
void Elimination::find_targets() {
  for (int k = 0; k < n_; ++k) {
    for (int a = begin_[k]; a < begin_[k + 1]; ++a) {
      const int column = position_[rows_[a - n_]];
      targets_.push_back(column);
      int target = begin_[column];
      for (int b = a + 1; b < begin_[k + 1]; ++b) {
        while (rows_[target - n_] != rows_[b - n_]) ++target;
        targets_.push_back(target);
      }
    }
  }
}

int Elimination::find_slot(int row, int column) const {
  if (row == column) return position_[row];
  const auto [first, second] = std::minmax(position_[row], position_[column]);
  const auto begin = rows_.begin() + (begin_[first] - n_);
  const auto end = rows_.begin() + (begin_[first + 1] - n_);
  const auto place = std::ranges::lower_bound(begin, end, second, {}, [&](int other) { return position_[other]; });
  return place != end && position_[*place] == second ? n_ + static_cast<int>(place - rows_.begin()) : -1;
}

void Elimination::solve(const double* values, const double* inverse_pivots, double* x) const noexcept {
  for (int k = 0; k < n_; ++k) {
    const double pivot_value = x[order_[k]];
    for (int a = begin_[k]; a < begin_[k + 1]; ++a) x[rows_[a - n_]] -= values[a] * pivot_value;
  }
  substitute_back(values, inverse_pivots, x);
}

void Elimination::factor_and_solve(double* values, double* inverse_pivots, double* x) const noexcept {
  const std::int32_t* target = targets_.data();
  for (int k = 0; k < n_; ++k) {
    const double inverse = 1.0 / values[k];
    inverse_pivots[k] = inverse;
    const double pivot_value = x[order_[k]];
    const int end = begin_[k + 1];
    for (int a = begin_[k]; a < end; ++a) {
      const double factor = values[a] * inverse;
      x[rows_[a - n_]] -= factor * pivot_value;
      for (int b = a; b < end; ++b) values[*target++] -= factor * values[b];
      values[a] = factor;
    }
  }
  substitute_back(values, inverse_pivots, x);
}

void Elimination::substitute_back(const double* values, const double* inverse_pivots, double* x) const noexcept {
  for (int k = n_ - 1; k >= 0; --k) {
    double sum = x[order_[k]] * inverse_pivots[k];
    for (int a = begin_[k]; a < begin_[k + 1]; ++a) sum -= values[a] * x[rows_[a - n_]];
    x[order_[k]] = sum;
  }
}

void Elimination::subtract_product(const double* values, const double* x, double* y) const noexcept {
  for (int k = 0; k < n_; ++k) {
    const int i = order_[k];
    y[i] -= values[k] * x[i];
    for (int a = begin_[k]; a < begin_[k + 1]; ++a) {
      const int j = rows_[a - n_];
      y[i] -= values[a] * x[j];
      y[j] -= values[a] * x[i];
    }
  }
}

}  // namespace gudgeon
