// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Finding the operands of comparisons, and the pieces of each kind of break.
#include "gudgeon/base/formula_breaks.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <optional>
#include <span>
#include <string_view>
#include <utility>

#include "gudgeon/base/formula_tokens.h"

namespace gudgeon {

namespace {

constexpr int kInserted = -1;

/// A word of the marked formula.
struct Token {
  std::string text;
  int origin = kInserted;  ///< place of the word that it stands for in the formula as written
};
using Tokens = std::vector<Token>;

constexpr double kInfinity = std::numeric_limits<double>::infinity();
// Whole numbers beyond this are not told apart as pieces; the function's value is then simply that of its argument.
constexpr double kMostPieces = 1e9;

constexpr std::pair<std::string_view, BreakKind> kComparisons[] = {
    {"<", BreakKind::less},           {"<=", BreakKind::less_equal}, {">", BreakKind::greater},
    {">=", BreakKind::greater_equal}, {"==", BreakKind::equal},      {"!=", BreakKind::unequal}};
constexpr std::pair<std::string_view, BreakKind> kFunctions[] = {
    {"sign", BreakKind::sign},       {"abs", BreakKind::absolute},
    {"min", BreakKind::least},       {"max", BreakKind::greatest},
    {"floor", BreakKind::floor},     {"ceil", BreakKind::ceiling},
    {"rint", BreakKind::nearest_up}, {"round", BreakKind::nearest},
    {"mod", BreakKind::remainder},   {"smooth_step", BreakKind::smooth_step}};

template <std::size_t kSize>
std::optional<BreakKind> find_kind(const std::pair<std::string_view, BreakKind> (&table)[kSize], std::string_view t) {
  for (const auto& [name, kind] : table) {
    if (name == t) return kind;
  }
  return std::nullopt;
}

Tokens split(std::span<const FormulaToken> written) {
  Tokens tokens;
  for (const FormulaToken& token : written) {
    tokens.push_back({std::string(token.text), static_cast<int>(tokens.size())});
  }
  return tokens;
}

// What binds weaker than a comparison ends its operands.
bool ends_operand(const std::string& token) {
  static constexpr std::string_view kEnds[] = {",", "?", ":", "&&", "||"};
  return std::ranges::find(kEnds, token) != std::end(kEnds) || find_kind(kComparisons, token).has_value();
}

std::size_t find_left_start(const Tokens& tokens, std::size_t comparison) {
  int depth = 0;
  std::size_t start = comparison;
  for (; start > 0; --start) {
    const std::string& token = tokens[start - 1].text;
    if (token == ")") ++depth;
    if (token == "(" && depth-- == 0) break;
    if (depth == 0 && ends_operand(token)) break;
  }
  return start;
}

std::size_t find_right_end(const Tokens& tokens, std::size_t comparison) {
  int depth = 0;
  std::size_t end = comparison + 1;
  for (; end < tokens.size(); ++end) {
    const std::string& token = tokens[end].text;
    if (token == "(") ++depth;
    if (token == ")" && depth-- == 0) break;
    if (depth == 0 && ends_operand(token)) break;
  }
  return end;
}

// As the parser is told it: it takes no space before a function's parenthesis.
std::string join(const Tokens& tokens) {
  std::string text;
  for (const Token& token : tokens) text += token.text;
  return text;
}

bool is_name(std::string_view token) {
  const auto first = static_cast<unsigned char>(token.front());
  return std::isalpha(first) != 0 || first == '_' || first >= 0x80;
}

// As it was written.
std::string spell(std::span<const FormulaToken> written, const Tokens& tokens, std::size_t from, std::size_t to) {
  while (tokens[from].origin == kInserted) ++from;
  while (tokens[to - 1].origin == kInserted) --to;
  const auto first = static_cast<std::size_t>(tokens[from].origin);
  const auto last = static_cast<std::size_t>(tokens[to - 1].origin);
  std::string text;
  for (std::size_t k = first; k <= last; ++k) {
    const std::string_view token = written[k].text;
    const bool joins = k == first || token == ")" || token == "," || written[k - 1].text == "(" ||
                       (token == "(" && is_name(written[k - 1].text));
    if (!joins) text += ' ';
    text += token;
  }
  return text;
}

std::string name_break(std::size_t index) { return "__break_" + std::to_string(index); }

// Comparisons of one rank are read from the left: the first one's operands hold no other at their own depth.
void mark_comparisons(std::span<const FormulaToken> written, Tokens& tokens, std::vector<FormulaBreak>& breaks) {
  for (std::size_t at = 0; at < tokens.size(); ++at) {
    const std::optional<BreakKind> kind = find_kind(kComparisons, tokens[at].text);
    if (!kind) continue;
    const std::size_t start = find_left_start(tokens, at);
    const std::size_t end = find_right_end(tokens, at);
    breaks.push_back({*kind, name_break(breaks.size()), spell(written, tokens, start, end)});
    tokens[at].text = ",";
    tokens.insert(tokens.begin() + static_cast<std::ptrdiff_t>(end), Token{")"});
    tokens.insert(tokens.begin() + static_cast<std::ptrdiff_t>(start), {Token{breaks.back().name}, Token{"("}});
    at = start;  // look again: within the operands there may be others
  }
}

void mark_functions(std::span<const FormulaToken> written, Tokens& tokens, std::vector<FormulaBreak>& breaks) {
  for (std::size_t at = 0; at + 1 < tokens.size(); ++at) {
    const std::optional<BreakKind> kind = find_kind(kFunctions, tokens[at].text);
    if (!kind || tokens[at + 1].text != "(") continue;
    int depth = 0;
    std::size_t end = at + 1;
    do {
      depth += tokens[end].text == "(" ? 1 : tokens[end].text == ")" ? -1 : 0;
      ++end;
    } while (depth > 0 && end < tokens.size());
    breaks.push_back({*kind, name_break(breaks.size()), spell(written, tokens, at, end)});
    tokens[at].text = breaks.back().name;
  }
}

int find_sign(double x) { return x < 0.0 ? -1 : (x > 0.0 ? 1 : 0); }

// Which argument is the least; of the negative ones with sign −1, the greatest.
int find_least(const double* x, int n, double sign) {
  int least = 0;
  for (int k = 1; k < n; ++k) {
    if (sign * x[k] < sign * x[least]) least = k;
  }
  return least;
}

// How far the chosen argument is above the least of the others.
double find_lead(const double* x, int n, int chosen, double sign) {
  double others = kInfinity;
  for (int k = 0; k < n; ++k) {
    if (k != chosen) others = std::min(others, sign * x[k]);
  }
  return sign * x[chosen] - others;
}

int find_whole(double x) { return std::isnan(x) ? 0 : static_cast<int>(std::clamp(x, -kMostPieces, kMostPieces)); }

// How far along its rise a smooth step is, not bounded.
double find_rise(const double* x) { return (x[0] - x[1]) / (x[2] - x[1]); }

// The whole number that a function of rounding gives.
double round_whole(BreakKind kind, double x) {
  switch (kind) {
    case BreakKind::floor:
      return std::floor(x);
    case BreakKind::ceiling:
      return std::ceil(x);
    case BreakKind::nearest_up:
      return std::floor(x + 0.5);
    default:
      return std::round(x);
  }
}

int find_piece(BreakKind kind, const double* x, int n) {
  switch (kind) {
    case BreakKind::sign:
    case BreakKind::absolute:
      return find_sign(x[0]);
    case BreakKind::least:
      return find_least(x, n, 1.0);
    case BreakKind::greatest:
      return find_least(x, n, -1.0);
    case BreakKind::floor:
    case BreakKind::ceiling:
    case BreakKind::nearest_up:
    case BreakKind::nearest:
      return find_whole(round_whole(kind, x[0]));
    case BreakKind::remainder:
      return find_whole(std::floor(x[0] / x[1]));
    case BreakKind::smooth_step: {
      const double u = find_rise(x);
      return u < 0.0 ? -1 : (u > 1.0 ? 1 : 0);
    }
    default:
      return x[0] < x[1] ? -1 : (x[0] > x[1] ? 1 : 0);
  }
}

double find_value(BreakKind kind, const double* x, int piece) {
  switch (kind) {
    case BreakKind::less:
      return piece < 0 ? 1.0 : 0.0;
    case BreakKind::less_equal:
      return piece <= 0 ? 1.0 : 0.0;
    case BreakKind::greater:
      return piece > 0 ? 1.0 : 0.0;
    case BreakKind::greater_equal:
      return piece >= 0 ? 1.0 : 0.0;
    case BreakKind::equal:
      return piece == 0 ? 1.0 : 0.0;
    case BreakKind::unequal:
      return piece != 0 ? 1.0 : 0.0;
    case BreakKind::absolute:
      return piece < 0 ? -x[0] : x[0];
    case BreakKind::least:
    case BreakKind::greatest:
      return x[piece];
    case BreakKind::smooth_step: {
      if (piece != 0) return piece < 0 ? 0.0 : 1.0;
      const double u = find_rise(x);
      return u * u * u * (10.0 + u * (-15.0 + 6.0 * u));
    }
    case BreakKind::remainder:
      if (std::abs(x[0] / x[1]) < kMostPieces) return x[0] - x[1] * piece;
      return x[0] - x[1] * std::floor(x[0] / x[1]);
    case BreakKind::sign:
      return piece;
    default:
      return std::abs(x[0]) < kMostPieces ? piece : round_whole(kind, x[0]);
  }
}

void note_bounds(BreakKind kind, const double* x, int n, BreakState& state) {
  const double piece = state.piece;
  switch (kind) {
    case BreakKind::least:
    case BreakKind::greatest:
      state.argument = find_lead(x, n, state.piece, kind == BreakKind::least ? 1.0 : -1.0);
      state.low = -kInfinity;
      state.high = 0.0;
      return;
    case BreakKind::floor:
    case BreakKind::ceiling:
      state.argument = x[0];
      state.low = kind == BreakKind::floor ? piece : piece - 1.0;
      state.high = state.low + 1.0;
      return;
    case BreakKind::nearest_up:
    case BreakKind::nearest:
      state.argument = x[0];
      state.low = piece - 0.5;
      state.high = piece + 0.5;
      return;
    case BreakKind::remainder:
      state.argument = x[0] / x[1];
      state.low = piece;
      state.high = piece + 1.0;
      return;
    case BreakKind::smooth_step:
      state.argument = find_rise(x);
      state.low = piece < 0 ? -kInfinity : (piece > 0 ? 1.0 : 0.0);
      state.high = piece < 0 ? 0.0 : (piece > 0 ? kInfinity : 1.0);
      return;
    case BreakKind::sign:
    case BreakKind::absolute:
      state.argument = x[0];
      break;
    default:
      state.argument = x[0] - x[1];
      break;
  }
  state.low = state.piece < 0 ? -kInfinity : 0.0;
  state.high = state.piece > 0 ? kInfinity : 0.0;
}

}  // namespace

MarkedFormula mark_breaks(const std::string& text) {
  MarkedFormula marked;
  const std::vector<FormulaToken> written = split_formula(text);
  Tokens tokens = split(written);
  mark_functions(written, tokens, marked.breaks);
  mark_comparisons(written, tokens, marked.breaks);
  marked.text = join(tokens);
  return marked;
}

std::size_t find_marked_excess(const std::string& text, std::size_t most) {
  constexpr std::size_t kAround = 3;  // of a comparison that becomes a function: "(", "," and ")"
  const std::vector<FormulaToken> tokens = split_formula(text);
  std::size_t size = 0;
  std::size_t n_breaks = 0;
  for (std::size_t k = 0; k < tokens.size(); ++k) {
    const bool compares = find_kind(kComparisons, tokens[k].text).has_value();
    const bool bends = k + 1 < tokens.size() && tokens[k + 1].text == "(" && find_kind(kFunctions, tokens[k].text);
    size += compares || bends ? name_break(n_breaks++).size() : tokens[k].text.size();
    size += compares ? kAround : 0;
    if (size > most) return static_cast<std::size_t>(tokens[k].position);
  }
  return std::string::npos;
}

double eval_break(BreakKind kind, const double* arguments, int n_arguments, int held, BreakState& state) noexcept {
  state.met = true;
  state.piece = held == kFreePiece ? find_piece(kind, arguments, n_arguments) : held;
  note_bounds(kind, arguments, n_arguments, state);
  for (int k = 0; k < n_arguments; ++k) {
    if (std::isnan(arguments[k])) return arguments[k];
  }
  return find_value(kind, arguments, state.piece);
}

}  // namespace gudgeon
