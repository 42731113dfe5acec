// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Chains are operators of one kind with nothing looser between them, at one depth of parentheses.
#include "gudgeon/base/formula_readings.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <string_view>

#include "gudgeon/base/formula_tokens.h"

namespace gudgeon {

namespace {

using Names = std::array<std::string_view, 6>;
constexpr Names kRelations{"<", ">", "<=", ">=", "==", "!="};
constexpr Names kLooser{"?", ":", ",", "&&", "||", ""};  // than comparisons
constexpr std::array<std::string_view, 4> kSums{"+", "-", "*", "/"};

template <class List>
bool holds(const List& list, std::string_view word) {
  return std::ranges::find(list, word) != list.end();
}

class ReadingFinder {
 public:
  explicit ReadingFinder(const std::string& formula) : formula_(formula), tokens_(split_formula(formula)) {}

  std::vector<FormulaReading> find() {
    levels_.emplace_back();
    for (at_ = 0; at_ < tokens_.size(); ++at_) read(tokens_[at_].text);
    while (!levels_.empty()) close_level();
    std::ranges::stable_sort(found_, {}, &FormulaReading::position);
    return std::move(found_);
  }

 private:
  using Kind = FormulaReading::Kind;

  /// Operators of one kind since something looser came.
  struct Chain {
    std::size_t begin = 0;  // token of its first operand
    int n_operators = 0;
  };
  struct Level {
    Chain powers;
    Chain comparisons;
  };

  void read(std::string_view word) {
    Level& level = levels_.back();
    if (word == "(") {
      levels_.push_back({{at_ + 1}, {at_ + 1}});
    } else if (word == ")") {
      close_level();
      if (levels_.empty()) levels_.emplace_back();
    } else if (word == "^") {
      ++level.powers.n_operators;
    } else if (holds(kSums, word)) {
      if (!is_sign()) restart(level.powers, Kind::chained_powers);
    } else if (holds(kRelations, word)) {
      restart(level.powers, Kind::chained_powers);
      ++level.comparisons.n_operators;
    } else if (holds(kLooser, word)) {
      restart(level.powers, Kind::chained_powers);
      restart(level.comparisons, Kind::chained_comparisons);
    }
  }

  // A sign behind '^' belongs to the exponent.
  [[nodiscard]] bool is_sign() const {
    std::size_t before = at_;
    while (before > 0 && (tokens_[before - 1].text == "-" || tokens_[before - 1].text == "+")) --before;
    return before > 0 && tokens_[before - 1].text == "^";
  }

  void restart(Chain& chain, Kind kind) {
    add(chain, kind);
    chain = {at_ + 1, 0};
  }

  void close_level() {
    add(levels_.back().powers, Kind::chained_powers);
    add(levels_.back().comparisons, Kind::chained_comparisons);
    levels_.pop_back();
  }

  // The tokens from the chain's first operand to before this one.
  void add(const Chain& chain, Kind kind) {
    if (chain.n_operators < 2 || chain.begin >= at_) return;
    const FormulaToken& first = tokens_[chain.begin];
    const FormulaToken& last = tokens_[at_ - 1];
    const auto length = static_cast<std::size_t>(last.position - first.position) + last.text.size();
    found_.push_back({kind, formula_.substr(static_cast<std::size_t>(first.position), length), first.position});
  }

  const std::string& formula_;
  std::vector<FormulaToken> tokens_;
  std::size_t at_ = 0;
  std::vector<Level> levels_;
  std::vector<FormulaReading> found_;
};

}  // namespace

std::vector<FormulaReading> find_readings(const std::string& formula) { return ReadingFinder(formula).find(); }

}  // namespace gudgeon
