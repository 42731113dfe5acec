// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Constrained minimum-degree order, symbolic and numeric elimination.
#include "gudgeon/system/elimination.h"

#include <algorithm>
#include <cassert>
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
      neighbours_[row].insert(column);
      neighbours_[column].insert(row);
      const auto [low, high] = std::minmax(row, column);
      if (high >= n_coordinates && low < n_coordinates) {
        constraints_of_[low].push_back(high);
        ++waiting_for_[high];
      }
    }
    for (int i = 0; i < n; ++i) {
      if (waiting_for_[i] == 0) ready_.emplace(neighbours_[i].size(), i);
    }
  }

  // The first one with the fewest neighbours.
  [[nodiscard]] int find_next() const { return ready_.begin()->second; }

  std::set<int> eliminate(int index) {
    ready_.erase({neighbours_[index].size(), index});
    std::set<int> front = std::move(neighbours_[index]);
    for (const int a : front) {
      const bool is_ready = waiting_for_[a] == 0;
      if (is_ready) ready_.erase({neighbours_[a].size(), a});
      neighbours_[a].erase(index);
      for (const int b : front) {
        if (a != b) neighbours_[a].insert(b);
      }
      if (is_ready) ready_.emplace(neighbours_[a].size(), a);
    }
    for (const int constraint : constraints_of_[index]) {
      if (--waiting_for_[constraint] == 0) ready_.emplace(neighbours_[constraint].size(), constraint);
    }
    return front;
  }

 private:
  std::vector<std::set<int>> neighbours_;
  std::vector<int> waiting_for_;                  // coordinates that a constraint row still waits for
  std::vector<std::vector<int>> constraints_of_;  // one list a coordinate
  std::set<std::pair<std::size_t, int>> ready_;   // neighbours, and index, of what waits for nothing
};

}  // namespace

Elimination::Elimination(int n, int n_constraints, const std::vector<std::pair<int, int>>& pattern) : n_(n) {
  EliminationGraph graph(n, n_constraints, pattern);
  std::vector<std::set<int>> fronts(n);
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
    std::vector<int> rows(fronts[k].begin(), fronts[k].end());
    std::ranges::sort(rows, {}, [&](int row) { return position_[row]; });
    rows_.insert(rows_.end(), rows.begin(), rows.end());
    begin_.push_back(n + static_cast<std::int32_t>(rows_.size()));
  }
  n_values_ = static_cast<std::size_t>(begin_.back());
  for (int k = 0; k < n; ++k) {
    for (int a = begin_[k]; a < begin_[k + 1]; ++a) {
      for (int b = a; b < begin_[k + 1]; ++b) targets_.push_back(find_slot(rows_[a - n], rows_[b - n]));
    }
  }
}

int Elimination::find_slot(int row, int column) const {
  if (row == column) return position_[row];
  for (const auto& [i, j] : {std::pair{row, column}, std::pair{column, row}}) {
    const int k = position_[i];
    for (int a = begin_[k]; a < begin_[k + 1]; ++a) {
      if (rows_[a - n_] == j) return a;
    }
  }
  return -1;
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
