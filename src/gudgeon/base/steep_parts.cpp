// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// By parentheses, powers and slashes.
#include "gudgeon/base/steep_parts.h"

#include <algorithm>
#include <array>
#include <string_view>

#include "gudgeon/base/formula_tokens.h"

namespace gudgeon {

namespace {

using Kind = FormulaToken::Kind;

// As steep as their arguments, or pieces that are watched as such.
constexpr std::array<std::string_view, 14> kGentle{"sin", "cos",   "abs",  "sign",  "min",  "max", "sum",
                                                   "avg", "floor", "ceil", "round", "rint", "mod", "smooth_step"};
constexpr std::array<std::string_view, 4> kGentlePowers{"1", "2", "3", "4"};

template <std::size_t kSize>
bool contains(const std::array<std::string_view, kSize>& list, std::string_view text) {
  return std::ranges::find(list, text) != list.end();
}

class SteepParts {
 public:
  explicit SteepParts(const std::string& text) : text_(text), tokens_(split_formula(text)) {}

  std::vector<std::string> list() {
    for (std::size_t at = 0; at < tokens_.size(); ++at) {
      if (is(at, "(")) add_arguments(at);
      if (is(at, "^")) add_base(at);
      if (is(at, "/")) add_denominator(at + 1);
    }
    return std::move(parts_);
  }

 private:
  [[nodiscard]] bool is(std::size_t at, std::string_view symbol) const {
    return at < tokens_.size() && tokens_[at].text == symbol;
  }
  [[nodiscard]] bool is_name(std::size_t at) const { return at < tokens_.size() && tokens_[at].kind == Kind::name; }

  // Behind the parenthesis that closes the one there.
  [[nodiscard]] std::size_t skip_group(std::size_t at) const {
    int depth = 0;
    do {
      depth += is(at, "(") ? 1 : is(at, ")") ? -1 : 0;
      ++at;
    } while (depth > 0 && at < tokens_.size());
    return at;
  }

  // Behind the number, name, call or group that begins there.
  [[nodiscard]] std::size_t skip_primary(std::size_t at) const {
    while (is(at, "-") || is(at, "+")) ++at;
    if (is_name(at) && is(at + 1, "(")) return skip_group(at + 1);
    return is(at, "(") ? skip_group(at) : at + 1;
  }

  void add(std::size_t from, std::size_t to) {
    if (from >= to || to > tokens_.size()) return;
    if (to - from == 1 && tokens_[from].kind == Kind::number) return;
    const int begin = tokens_[from].position;
    const int end = tokens_[to - 1].position + static_cast<int>(tokens_[to - 1].text.size());
    std::string part = text_.substr(static_cast<std::size_t>(begin), static_cast<std::size_t>(end - begin));
    if (std::ranges::find(parts_, part) == parts_.end()) parts_.push_back(std::move(part));
  }

  void add_arguments(std::size_t open) {
    if (open == 0 || !is_name(open - 1) || contains(kGentle, tokens_[open - 1].text)) return;
    const std::size_t end = skip_group(open) - 1;
    std::size_t from = open + 1;
    for (std::size_t at = from; at < end; ++at) {
      if (is(at, "(")) at = skip_group(at) - 1;
      if (!is(at, ",")) continue;
      add(from, at);
      from = at + 1;
    }
    add(from, end);
  }

  void add_base(std::size_t power) {
    const std::size_t behind = skip_primary(power + 1);
    if (behind == power + 2 && contains(kGentlePowers, tokens_[power + 1].text) && !is(behind, "^")) return;
    std::size_t from = power - 1;
    if (is(from, ")")) {
      for (int depth = 1; depth > 0 && from > 0;) {
        --from;
        depth += is(from, ")") ? 1 : is(from, "(") ? -1 : 0;
      }
      if (from > 0 && is_name(from - 1)) --from;
    }
    add(from, power);
  }

  void add_denominator(std::size_t at) { add(at, skip_primary(at)); }

  const std::string& text_;
  std::vector<FormulaToken> tokens_;
  std::vector<std::string> parts_;
};

}  // namespace

std::vector<std::string> list_steep_parts(const std::string& text) { return SteepParts(text).list(); }

}  // namespace gudgeon
