// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// A table of words, and a look at neighbouring tokens.
#include "gudgeon/model/formula_hints.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <span>
#include <utility>

#include "gudgeon/base/expression.h"
#include "gudgeon/base/formula_tokens.h"

namespace gudgeon {

namespace {

using Hint = std::pair<std::string_view, std::string_view>;

constexpr std::array<Hint, 16> kWords{{
    {"if", "a choice is written condition ? value : other"},
    {"else", "a choice is written condition ? value : other"},
    {"and", "'and' is written &&"},
    {"or", "'or' is written ||"},
    {"not", "'not x' is written x == 0"},
    {"time", "the time is t"},
    {"Pi", "π is written pi"},
    {"PI", "π is written pi"},
    {"e", "Euler's number is exp(1)"},
    {"fabs", "the magnitude is abs(x)"},
    {"arcsin", "the inverse functions are asin, acos, atan and atan2"},
    {"arccos", "the inverse functions are asin, acos, atan and atan2"},
    {"arctan", "the inverse functions are asin, acos, atan and atan2"},
    {"sgn", "the sign is sign(x)"},
    {"step", "a step is written t > t0 ? 1 : 0, a smooth one smooth_step(t, t0, t1)"},
    {"heaviside", "a step is written t > t0 ? 1 : 0, a smooth one smooth_step(t, t0, t1)"},
}};

constexpr std::array<Hint, 6> kSymbols{{
    {"**", "a power is written ^, x^2"},
    {"%", "the remainder is mod(a, b)"},
    {"&", "'and' is written &&"},
    {"|", "'or' is written ||"},
    {"!", "'not x' is written x == 0"},
    {";", "a formula has one value and no ';'"},
}};

std::string_view look_up(std::span<const Hint> hints, std::string_view word) {
  const auto found = std::ranges::find(hints, word, &Hint::first);
  return found == hints.end() ? std::string_view{} : found->second;
}

bool is_whole(std::string_view text) {
  return std::ranges::all_of(text, [](char c) { return c >= '0' && c <= '9'; });
}

}  // namespace

std::string find_word_hint(std::string_view name) { return std::string{look_up(kWords, name)}; }

std::vector<std::string> list_symbol_hints(const std::string& formula) {
  std::vector<std::string> hints;
  const auto add = [&](std::string hint) {
    if (!hint.empty() && std::ranges::find(hints, hint) == hints.end()) hints.push_back(std::move(hint));
  };
  const std::vector<FormulaToken> tokens = split_formula(formula);
  const std::vector<std::string>& functions = list_formula_functions();
  for (std::size_t k = 0; k < tokens.size(); ++k) {
    const FormulaToken& token = tokens[k];
    const FormulaToken* next = k + 1 < tokens.size() ? &tokens[k + 1] : nullptr;
    if (token.kind == FormulaToken::Kind::symbol) add(std::string{look_up(kSymbols, token.text)});
    const bool is_function = std::ranges::find(functions, token.text) != functions.end();
    if (is_function && next != nullptr && next->text != "(") {
      add(fmt::format("a function's arguments stand in parentheses: {}({})", token.text, next->text));
    }
    // Digits on both sides without a blank.
    if (token.text != "," || k == 0 || next == nullptr || next->kind != FormulaToken::Kind::number) continue;
    const FormulaToken& before = tokens[k - 1];
    const bool close = before.position + static_cast<int>(before.text.size()) == token.position &&
                       next->position == token.position + 1;
    if (close && before.kind == FormulaToken::Kind::number && is_whole(before.text) && is_whole(next->text)) {
      add(fmt::format("a number has a decimal point: {}.{}", before.text, next->text));
    }
  }
  return hints;
}

}  // namespace gudgeon
