// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Formulas in text, "-k * (piston.x - 0.2)". Only expression.cpp knows the library that evaluates them.
#pragma once

#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "gudgeon/base/formula_breaks.h"

namespace gudgeon {

/// A formula that cannot be understood: what() says why and names the offending part; position [characters] is where.
class ExpressionError : public std::runtime_error {
 public:
  ExpressionError(const std::string& message, std::size_t position)
      : std::runtime_error(message), position_(position) {}
  [[nodiscard]] std::size_t position() const { return position_; }

 private:
  std::size_t position_;
};

/// The names of all functions that a formula may use: "abs", "sin", "smooth_step" …
const std::vector<std::string>& list_formula_functions();

/// A compiled formula of named variables; names may contain dots ("crank.angle"). Not to be shared by threads: each
/// makes its own. Movable.
class ExpressionEvaluator {
 public:
  /// Throws ExpressionError for bad syntax and for names that are neither variable, constant, "pi" nor function.
  ExpressionEvaluator(const std::string& text, const std::vector<std::pair<std::string, double>>& constants,
                      const std::vector<std::string>& variables);
  ExpressionEvaluator(ExpressionEvaluator&& other) noexcept;
  ExpressionEvaluator& operator=(ExpressionEvaluator&& other) noexcept;
  ~ExpressionEvaluator();

  /// Indices into `variables` of those that the formula uses.
  [[nodiscard]] const std::vector<int>& used_variables() const;

  /// The value for the variables' values, one a variable, in their order. NaN where it has none. Allocates nothing.
  [[nodiscard]] double eval(const double* values) noexcept;

  /// Where the pieces of the formula meet.
  [[nodiscard]] const std::vector<FormulaBreak>& breaks() const;
  /// The value with the held pieces, one a break or none at all; where they give none, that of the pieces that the
  /// arguments are in. What each break was like is written to `found`, where there is one. Allocates nothing.
  [[nodiscard]] double eval(const double* values, const int* held, BreakState* found) noexcept;

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace gudgeon
