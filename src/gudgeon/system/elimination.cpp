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
      : n_coordinates_(n - n_constraints), neighbours_(n), waiting_for_(n, 0), eliminated_(n, false) {
    for (const auto& [row, column] : pattern) {
      assert(row != column);
      neighbours_[row].insert(column);
      neighbours_[column].insert(row);
      const auto [low, high] = std::minmax(row, column);
      if (high >= n_coordinates_ && low < n_coordinates_) {
        constraints_of_.emplace_back(low, high);
        ++waiting_for_[high];
      }
    }
  }

  [[nodiscard]] int find_next() const {
    int best = -1;
    for (int i = 0; i < static_cast<int>(neighbours_.size()); ++i) {
      if (eliminated_[i] || waiting_for_[i] > 0) continue;
      if (best < 0 || neighbours_[i].size() < neighbours_[best].size()) best = i;
    }
    return best;
  }

  std::set<int> eliminate(int index) {
    eliminated_[index] = true;
    std::set<int> front = std::move(neighbours_[index]);
    for (const int a : front) {
      neighbours_[a].erase(index);
      for (const int b : front) {
        if (a != b) neighbours_[a].insert(b);
      }
    }
    for (const auto& [coordinate, constraint] : constraints_of_) {
      if (coordinate == index) --waiting_for_[constraint];
    }
    return front;
  }

 private:
  int n_coordinates_;
  std::vector<std::set<int>> neighbours_;
  std::vector<int> waiting_for_;  // coordinates that a constraint row still waits for
  std::vector<std::pair<int, int>> constraints_of_;
  std::vector<bool> eliminated_;
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
