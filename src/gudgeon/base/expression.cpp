// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Formulas compiled and evaluated by muParser, which no other file knows.
#include "gudgeon/base/expression.h"

#include <fmt/format.h>
#include <muParser.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace gudgeon {

namespace {

/// Letters, digits, '_' and '.', and every byte of letters beyond ASCII.
std::string list_name_characters() {
  std::string characters = "._0123456789abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ";
  for (int byte = 0x80; byte <= 0xFF; ++byte) characters += static_cast<char>(byte);
  return characters;
}

/// From 0 below `from` to 1 above `to`, twice continuously differentiable: 10 u³ − 15 u⁴ + 6 u⁵.
double smooth_step(double x, double from, double to) {
  const double u = std::clamp((x - from) / (to - from), 0.0, 1.0);
  return u * u * u * (10.0 + u * (-15.0 + 6.0 * u));
}

double whole_below(double x) { return std::floor(x); }
double whole_above(double x) { return std::ceil(x); }
double nearest_whole(double x) { return std::round(x); }
double power(double base, double exponent) { return std::pow(base, exponent); }

/// What is left of x over whole multiples of the divisor, with the divisor's sign; none for a divisor of 0.
double remainder(double x, double divisor) { return x - divisor * std::floor(x / divisor); }

/// What formulas know beyond muParser's own functions.
void define_functions(mu::Parser& parser) {
  parser.DefineFun("smooth_step", smooth_step);
  parser.DefineFun("floor", whole_below);
  parser.DefineFun("ceil", whole_above);
  parser.DefineFun("round", nearest_whole);
  parser.DefineFun("mod", remainder);
  parser.DefineFun("pow", power);
}

/// Where a single '=' stands, which would assign; npos when nowhere.
std::size_t find_assignment(const std::string& text) {
  for (std::size_t k = 0; k < text.size(); ++k) {
    if (text[k] != '=') continue;
    if (k + 1 < text.size() && text[k + 1] == '=') {
      ++k;
    } else if (k == 0 || std::string_view("<>!").find(text[k - 1]) == std::string_view::npos) {
      return k;
    }
  }
  return std::string::npos;
}

constexpr std::size_t kMostCharacters = 20000;  // what muParser takes
constexpr int kMostLevels = 200;  // of parentheses; every function around another is run through for each of its breaks

std::string describe_length() {
  return fmt::format(
      "it is too long: it may have {} characters, and fewer where it compares, or uses abs, min, max and the like; a "
      "curve can hold more",
      kMostCharacters);
}

/// Where the parentheses go deeper than that; npos when they do not.
std::size_t find_depth_excess(const std::string& text) {
  int depth = 0;
  for (std::size_t k = 0; k < text.size(); ++k) {
    depth += text[k] == '(' ? 1 : text[k] == ')' ? -1 : 0;
    if (depth > kMostLevels) return k;
  }
  return std::string::npos;
}

/// Throws an ExpressionError for what would take long to be refused, or longer than it is worth.
void check_extent(const std::string& text) {
  if (text.size() > kMostCharacters) throw ExpressionError(describe_length(), kMostCharacters);
  if (const std::size_t at = find_depth_excess(text); at != std::string::npos) {
    throw ExpressionError(fmt::format("its parentheses nest deeper than {} levels; a chain of 'a ? b : c ? d : e' "
                                      "needs none, and a curve can hold more",
                                      kMostLevels),
                          at);
  }
  const std::size_t at = find_marked_excess(text, kMostCharacters);
  if (at != std::string::npos) throw ExpressionError(describe_length(), at);
}

std::string describe(const mu::ParserError& error) {
  const std::string quoted = "'" + error.GetToken() + "'";
  switch (error.GetCode()) {
    case mu::ecUNASSIGNABLE_TOKEN:
      return "unknown name " + quoted;
    case mu::ecUNEXPECTED_EOF:
      return "unexpected end";
    case mu::ecINTERNAL_ERROR:
      return "an operator has no operand";
    case mu::ecMISSING_PARENS:
      return "a closing ')' is missing";
    case mu::ecTOO_MANY_PARAMS:
      return "function " + quoted + " has too many arguments";
    case mu::ecTOO_FEW_PARAMS:
      return "function " + quoted + " has too few arguments";
    case mu::ecMISSING_ELSE_CLAUSE:
      return "'?' has no ':'";
    case mu::ecSTRING_EXPECTED:
    case mu::ecVAL_EXPECTED:
    case mu::ecSTR_RESULT:
    case mu::ecUNTERMINATED_STRING:
      return "text in quotes has no value";
    case mu::ecEXPRESSION_TOO_LONG:
      return describe_length();
    case mu::ecIDENTIFIER_TOO_LONG:
      return "it holds a name of more than 100 characters";
    default:
      return error.GetToken().empty() ? "it cannot be understood here" : quoted + " does not fit here";
  }
}

/// muParser tells the end of some tokens and the start of others: always the start.
ExpressionError translate(const mu::ParserError& error, const std::string& text) {
  std::size_t position = error.GetPos() < 0 ? 0 : static_cast<std::size_t>(error.GetPos());
  position = std::min(position, text.size());
  const std::string& token = error.GetToken();
  const bool placeless = error.GetCode() == mu::ecINTERNAL_ERROR || error.GetCode() == mu::ecEXPRESSION_TOO_LONG;
  if (placeless) return {describe(error), 0};
  if (!token.empty() && text.compare(position, token.size(), token) != 0) {
    const std::size_t before = text.rfind(token, position);
    if (before != std::string::npos) position = before;
  }
  return {describe(error), position};
}

}  // namespace

const std::vector<std::string>& list_formula_functions() {
  static const std::vector<std::string> kNames = [] {
    std::vector<std::string> names;
    mu::Parser parser;
    define_functions(parser);
    for (const auto& [name, callback] : parser.GetFunDef()) names.push_back(name);
    std::ranges::sort(names);
    return names;
  }();
  return kNames;
}

struct ExpressionEvaluator::Implementation {
  // What muParser hands back when it comes by a break.
  struct MarkedBreak {
    const Implementation* owner;
    BreakKind kind;
    std::size_t index;
  };

  mu::Parser parser;
  std::vector<double> values;  // of all variables, then of all constants; the parser points into it
  std::vector<int> used;
  MarkedFormula marked;
  std::vector<MarkedBreak> breaks;  // the parser points into it
  const int* held = nullptr;        // of the evaluation at hand
  BreakState* found = nullptr;

  static double eval_marked(void* data, const double* arguments, int n_arguments) {
    const auto& at = *static_cast<const MarkedBreak*>(data);
    BreakState unseen;
    return eval_break(at.kind, arguments, n_arguments,
                      at.owner->held == nullptr ? kFreePiece : at.owner->held[at.index],
                      at.owner->found == nullptr ? unseen : at.owner->found[at.index]);
  }

  double eval(const int* pieces, BreakState* states) noexcept {
    constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
    held = pieces;
    found = states;
    try {
      const double value = parser.Eval();
      return std::isfinite(value) ? value : kNone;
    } catch (...) {
      return kNone;
    }
  }

  // From now on the parser evaluates the formula whose breaks are functions.
  void mark(const std::string& text) {
    marked = mark_breaks(text);
    if (marked.breaks.empty()) return;
    breaks.reserve(marked.breaks.size());
    for (const FormulaBreak& at : marked.breaks) {
      breaks.push_back({this, at.kind, breaks.size()});
      parser.DefineFunUserData(at.name, eval_marked, &breaks.back(), false);
    }
    parser.SetExpr(marked.text);
    parser.Eval();
    parser.Eval();
  }
};

ExpressionEvaluator::ExpressionEvaluator(const std::string& text,
                                         const std::vector<std::pair<std::string, double>>& constants,
                                         const std::vector<std::string>& variables)
    : implementation_(std::make_unique<Implementation>()) {
  if (text.find_first_not_of(" \t\r\n") == std::string::npos) throw ExpressionError("it is empty", 0);
  const std::size_t assignment = find_assignment(text);
  if (assignment != std::string::npos) {
    throw ExpressionError("'=' would assign; write '==' to compare", assignment);
  }
  check_extent(text);
  mu::Parser& parser = implementation_->parser;
  std::vector<double>& values = implementation_->values;
  values.assign(variables.size() + constants.size(), 0.0);
  try {
    static const std::string kNameCharacters = list_name_characters();
    parser.DefineNameChars(kNameCharacters.c_str());
    parser.ClearConst();
    parser.DefineConst("pi", std::numbers::pi);
    define_functions(parser);
    // muParser cuts numbers to whole ones where it folds && and || at compile time, so it must fold none there; what a
    // model calls constants are variables to it.
    parser.EnableOptimizer(text.find("&&") == std::string::npos && text.find("||") == std::string::npos);
    // Names that do not occur need not be legal ones.
    for (std::size_t k = 0; k < constants.size(); ++k) {
      double& place = values[variables.size() + k];
      place = constants[k].second;
      if (text.find(constants[k].first) != std::string::npos) parser.DefineVar(constants[k].first, &place);
    }
    for (std::size_t k = 0; k < variables.size(); ++k) {
      if (text.find(variables[k]) != std::string::npos) parser.DefineVar(variables[k], &values[k]);
    }
    parser.SetExpr(text);
    parser.Eval();  // finds unknown names, which the next line would pass over
    const auto used = parser.GetUsedVar();
    for (std::size_t k = 0; k < variables.size(); ++k) {
      if (used.contains(variables[k])) implementation_->used.push_back(static_cast<int>(k));
    }
    parser.Eval();  // compiles; from now on only the compiled formula is run
  } catch (const mu::ParserError& error) {
    throw translate(error, text);
  }
  if (parser.GetNumResults() != 1) {
    throw ExpressionError("',' outside a function's parentheses: a formula has one value",
                          std::min(text.find(','), text.size()));
  }
  try {
    implementation_->mark(text);
  } catch (const mu::ParserError& error) {
    throw translate(error, text);  // marked, it may be too long
  }
}

ExpressionEvaluator::ExpressionEvaluator(ExpressionEvaluator&& other) noexcept = default;
ExpressionEvaluator& ExpressionEvaluator::operator=(ExpressionEvaluator&& other) noexcept = default;
ExpressionEvaluator::~ExpressionEvaluator() = default;

const std::vector<int>& ExpressionEvaluator::used_variables() const { return implementation_->used; }

const std::vector<FormulaBreak>& ExpressionEvaluator::breaks() const { return implementation_->marked.breaks; }

double ExpressionEvaluator::eval(const double* values) noexcept { return eval(values, nullptr, nullptr); }

double ExpressionEvaluator::eval(const double* values, const int* held, BreakState* found) noexcept {
  for (std::size_t k = 0; found != nullptr && k < implementation_->breaks.size(); ++k) found[k].met = false;
  for (const int k : implementation_->used) implementation_->values[k] = values[k];
  const double value = implementation_->eval(held, found);
  // Off its piece a formula may have no value, abs(x)^0.5 with abs held at x: there it is that of the piece it is in.
  return std::isnan(value) && held != nullptr ? implementation_->eval(nullptr, nullptr) : value;
}

}  // namespace gudgeon
