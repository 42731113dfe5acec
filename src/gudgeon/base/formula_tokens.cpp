// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// One pass from left to right.
#include "gudgeon/base/formula_tokens.h"

#include <algorithm>
#include <array>

namespace gudgeon {

namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// Behind the number that begins there: digits with a point, and an exponent.
std::size_t skip_number(std::string_view text, std::size_t at) {
  while (at < text.size() && (is_digit(text[at]) || text[at] == '.')) ++at;
  if (at >= text.size() || (text[at] != 'e' && text[at] != 'E')) return at;
  std::size_t exponent = at + 1;
  if (exponent < text.size() && (text[exponent] == '+' || text[exponent] == '-')) ++exponent;
  if (exponent >= text.size() || !is_digit(text[exponent])) return at;
  while (exponent < text.size() && is_digit(text[exponent])) ++exponent;
  return exponent;
}

std::size_t skip_name(std::string_view text, std::size_t at) {
  while (at < text.size() && (is_formula_letter(text[at]) || is_digit(text[at]) || text[at] == '.')) ++at;
  return at;
}

std::size_t skip_symbol(std::string_view text, std::size_t at) {
  static constexpr std::array<std::string_view, 7> kPairs{"<=", ">=", "==", "!=", "&&", "||", "**"};
  const bool pair = std::ranges::find(kPairs, text.substr(at, 2)) != kPairs.end();
  return at + (pair ? 2 : 1);
}

}  // namespace

bool is_formula_letter(char c) {
  return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || c == '_' || (static_cast<unsigned char>(c) & 0x80U) != 0;
}

std::vector<FormulaToken> split_formula(std::string_view text) {
  using enum FormulaToken::Kind;
  std::vector<FormulaToken> tokens;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t begin = at;
    if (std::string_view{" \t\r\n"}.find(text[at]) != std::string_view::npos) {
      ++at;
      continue;
    }
    FormulaToken::Kind kind = symbol;
    if (is_digit(text[at]) || text[at] == '.') {
      kind = number;
      at = skip_number(text, at);
    } else if (is_formula_letter(text[at])) {
      kind = name;
      at = skip_name(text, at);
    } else {
      at = skip_symbol(text, at);
    }
    tokens.push_back({kind, text.substr(begin, at - begin), static_cast<int>(begin)});
  }
  return tokens;
}

}  // namespace gudgeon
