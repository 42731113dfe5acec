// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Gram and Schmidt's process in the free directions of one part after the other.
#include "gudgeon/system/free_gradients.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

namespace gudgeon {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// A gradient counts as free when so much of it lies in the directions that the closures leave.
constexpr double kFreeShare = 1e-6;

/// Coordinates joined into parts.
class Parts {
 public:
  explicit Parts(Index n_coordinates) : joined_to_(static_cast<std::size_t>(n_coordinates)) {
    std::iota(joined_to_.begin(), joined_to_.end(), 0);
  }

  void join(int a, int b) { joined_to_[find(a)] = find(b); }

  /// A coordinate that stands for the part.
  int find(int coordinate) {
    while (joined_to_[coordinate] != coordinate) {
      joined_to_[coordinate] = joined_to_[joined_to_[coordinate]];
      coordinate = joined_to_[coordinate];
    }
    return coordinate;
  }

 private:
  std::vector<int> joined_to_;
};

/// One part with what there is of closures and gradients in it.
struct Part {
  std::vector<int> coordinates;
  std::vector<int> gradients;  // indices
};

class FreeSearch {
 public:
  FreeSearch(const SparseMatrix& closures, const std::vector<Gradient>& gradients)
      : closures_(closures),
        gradients_(gradients),
        longest_(find_longest_row(closures)),
        local_(static_cast<std::size_t>(closures.cols())) {}

  FreeGradients run() {
    for (const Part& part : list_parts()) search(part);
    std::ranges::sort(found_.free);
    return std::move(found_);
  }

 private:
  std::vector<Part> list_parts() {
    Parts parts(closures_.cols());
    std::vector<int> first_of_closure(static_cast<std::size_t>(closures_.rows()) / 2, -1);
    for (int column = 0; column < closures_.cols(); ++column) {
      for (SparseMatrix::InnerIterator entry(closures_, column); entry; ++entry) {
        int& first = first_of_closure[static_cast<std::size_t>(entry.row()) / 2];
        if (first < 0) first = column;
        parts.join(column, first);
      }
    }
    for (const Gradient& gradient : gradients_) {
      for (const auto& [coordinate, derivative] : gradient) parts.join(coordinate, gradient.front().first);
    }
    std::vector<Part> listed(static_cast<std::size_t>(closures_.cols()));
    for (int column = 0; column < closures_.cols(); ++column) listed[parts.find(column)].coordinates.push_back(column);
    for (int k = 0; k < static_cast<int>(gradients_.size()); ++k) {
      if (!gradients_[k].empty()) listed[parts.find(gradients_[k].front().first)].gradients.push_back(k);
    }
    std::erase_if(listed, [](const Part& part) { return part.coordinates.empty(); });
    return listed;
  }

  void search(const Part& part) {
    for (std::size_t k = 0; k < part.coordinates.size(); ++k) local_[part.coordinates[k]] = static_cast<int>(k);
    // Orthonormal directions that keep the loops closed.
    const MatrixXd kernel = RowSpace(select_rows(part), longest_).find_free_basis();
    found_.n_free += static_cast<int>(kernel.cols());
    MatrixXd taken(kernel.cols(), kernel.cols());
    Index n_taken = 0;
    for (const int k : part.gradients) {
      if (n_taken == kernel.cols()) break;
      VectorXd rest = VectorXd::Zero(kernel.cols());
      double length = 0.0;
      for (const auto& [coordinate, derivative] : gradients_[k]) {
        rest += derivative * kernel.row(local_[coordinate]).transpose();
        length = std::hypot(length, derivative);
      }
      const auto before = taken.leftCols(n_taken);
      for (int pass = 0; pass < 2; ++pass) rest -= before * (before.transpose() * rest);
      if (!(rest.norm() > kFreeShare * length)) continue;
      taken.col(n_taken++) = rest.normalized();
      found_.free.push_back(k);
    }
  }

  // The closure rows of one part, in their order.
  [[nodiscard]] SparseMatrix select_rows(const Part& part) const {
    std::map<Index, int> rows;
    for (const int column : part.coordinates) {
      for (SparseMatrix::InnerIterator entry(closures_, column); entry; ++entry) rows.emplace(entry.row(), 0);
    }
    int next = 0;
    for (auto& [row, local] : rows) local = next++;
    std::vector<Eigen::Triplet<double>> entries;
    for (const int column : part.coordinates) {
      for (SparseMatrix::InnerIterator entry(closures_, column); entry; ++entry) {
        entries.emplace_back(rows.at(entry.row()), local_[column], entry.value());
      }
    }
    SparseMatrix selected(next, static_cast<Index>(part.coordinates.size()));
    selected.setFromTriplets(entries.begin(), entries.end());
    return selected;
  }

  const SparseMatrix& closures_;
  const std::vector<Gradient>& gradients_;
  double longest_;
  std::vector<int> local_;  // one a coordinate: where it stands in its part
  FreeGradients found_;
};

}  // namespace

FreeGradients find_free_gradients(const SparseMatrix& closures, const std::vector<Gradient>& gradients) {
  return FreeSearch(closures, gradients).run();
}

}  // namespace gudgeon
