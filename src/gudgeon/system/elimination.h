// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Sparse symmetric elimination with an order that is found once.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

namespace gudgeon {

/// L D Lᵀ of [H Jᵀ; J 0] without pivoting.
///
/// The order is found from the pattern alone: least fill first, a constraint row only after every coordinate it
/// constrains. Pivots of coordinates are then positive and pivots of constraint rows negative whenever the rows are
/// independent; a vanishing pivot means a singular position. A tree of bodies is eliminated leaves first, without fill.
class Elimination {
 public:
  Elimination() = default;

  /// The pattern of an n x n symmetric matrix: pairs (row, column) off the diagonal, each once. The last n_constraints
  /// indices are constraint rows.
  Elimination(int n, int n_constraints, const std::vector<std::pair<int, int>>& pattern);

  [[nodiscard]] int size() const { return n_; }
  /// How many values a matrix of this pattern has, fill included.
  [[nodiscard]] int n_values() const { return static_cast<int>(n_values_); }
  /// Where an entry of the pattern, or of the diagonal, is stored; -1 outside the pattern.
  [[nodiscard]] int find_slot(int row, int column) const;

  /// Replaces the matrix values by their factors and the right-hand side by the solution. inverse_pivots and x have
  /// size() entries.
  void factor_and_solve(double* values, double* inverse_pivots, double* x) const noexcept;
  /// The same for another right-hand side, with the factors that are there.
  void solve(const double* values, const double* inverse_pivots, double* x) const noexcept;
  /// y −= A x for matrix values that are not factored.
  void subtract_product(const double* values, const double* x, double* y) const noexcept;

 private:
  void find_targets();
  void substitute_back(const double* values, const double* inverse_pivots, double* x) const noexcept;

  int n_ = 0;
  std::size_t n_values_ = 0;
  std::vector<std::int32_t> order_;     // index eliminated k-th
  std::vector<std::int32_t> position_;  // when an index is eliminated: the inverse of order_
  std::vector<std::int32_t> begin_;     // first off-diagonal value of the k-th column; the diagonals come first of all
  std::vector<std::int32_t> rows_;      // row index of each off-diagonal value
  std::vector<std::int32_t> targets_;   // values updated by the k-th elimination, in order of use
};

}  // namespace gudgeon
