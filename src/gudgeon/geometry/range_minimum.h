// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// The least of any run of neighbouring values.
#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

namespace gudgeon {

/// A tree of minima over blocks of 1, 2, 4 … values: any run is answered from at most two blocks of each size.
class RangeMinimum {
 public:
  RangeMinimum() = default;
  explicit RangeMinimum(const std::vector<double>& values) : n_(values.size()), tree_(2 * n_) {
    std::ranges::copy(values, tree_.begin() + static_cast<std::ptrdiff_t>(n_));
    for (std::size_t k = n_; k-- > 1;) tree_[k] = std::min(tree_[2 * k], tree_[2 * k + 1]);
  }

  /// Of the values first … end − 1; infinite for none.
  [[nodiscard]] double find(std::size_t first, std::size_t end) const noexcept {
    double least = std::numeric_limits<double>::infinity();
    for (first += n_, end += n_; first < end; first /= 2, end /= 2) {
      if (first % 2 == 1) least = std::min(least, tree_[first++]);
      if (end % 2 == 1) least = std::min(least, tree_[--end]);
    }
    return least;
  }

 private:
  std::size_t n_ = 0;
  std::vector<double> tree_;  // node k stands above 2k and 2k + 1; the values are the last n
};

}  // namespace gudgeon
