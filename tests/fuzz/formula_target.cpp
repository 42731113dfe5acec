// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Any text as a formula: it is evaluated or refused at a place within it.
#include <array>
#include <string>

#include "gudgeon/base/expression.h"
#include "gudgeon/base/formula_readings.h"
#include "gudgeon/base/formula_tokens.h"
#include "tests/fuzz/target.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace gudgeon;
  const std::string text{fuzz::make_text(data, size)};
  for (const FormulaToken& token : split_formula(text)) {
    fuzz::require(!token.text.empty() && text.compare(token.position, token.text.size(), token.text) == 0,
                  "a token is part of the text");
  }
  try {
    ExpressionEvaluator evaluator(text, {{"k", 2.0}, {"half", 0.5}}, {"t", "crank.angle", "x"});
    find_readings(text);
    for (const std::array<double, 3>& values : {std::array{0.0, 0.0, 0.0}, {1.0, -1.5, 1e9}, {-0.0, 1e-300, 1e300}}) {
      const double value = evaluator.eval(values.data());
      fuzz::require(value - value == 0.0 || value != value, "a value is finite or none");
    }
  } catch (const ExpressionError& error) {
    fuzz::require(error.position() <= text.size(), "an error has its place in the text");
  }
  return 0;
}
