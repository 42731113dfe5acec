// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// A formula's text cut into words, for those who ask what it is made of. Its value is found by expression.cpp.
#pragma once

#include <string_view>
#include <vector>

namespace gudgeon {

struct FormulaToken {
  enum class Kind { number, name, symbol };
  Kind kind = Kind::symbol;
  std::string_view text;  ///< part of the formula's text; names may contain dots
  int position = 0;       ///< [bytes] where it begins
};

/// Letters of names: A-Z, a-z, '_' and every byte of letters beyond ASCII.
bool is_formula_letter(char c);

/// Numbers with their exponents, names, symbols ("<=", "&&", "?"); blanks are left out. Any text can be cut.
std::vector<FormulaToken> split_formula(std::string_view text);

}  // namespace gudgeon
