// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// The page's numbers: blocks of bytes in base64, each stored once and decoded where it is first shown.
#pragma once

#include <cstddef>
#include <map>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "gudgeon/report/figures/figure.h"

namespace gudgeon {

class BlockStore {
 public:
  /// The first block's number.
  explicit BlockStore(int first = 0) : end_(first) {}

  /// Single precision, 7 digits: signals.
  int add_signal(std::span<const double> values);
  /// Double precision: times, whose last digits matter after many cycles.
  int add_times(std::span<const double> values);

  /// The block that key names, made when it is first asked for.
  template <class Make>
  int find(const std::pair<const void*, std::size_t>& key, Make make) {
    const auto [known, is_new] = known_.emplace(key, 0);
    if (is_new) known->second = make();
    return known->second;
  }
  /// Keeps numbers alive, so that no others take their place in memory and are taken for them.
  void keep(Numbers numbers) { kept_.push_back(std::move(numbers)); }
  /// The blocks as script elements "block-0", "block-1" …
  [[nodiscard]] const std::string& html() const { return html_; }
  /// The number after the last block's.
  [[nodiscard]] int end() const { return end_; }

 private:
  int add_block(const char* type, std::span<const unsigned char> bytes);
  std::string html_;
  std::map<std::pair<const void*, std::size_t>, int> known_;
  std::vector<Numbers> kept_;
  int end_;
};

}  // namespace gudgeon
