// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Parts of a formula that other programs, or people, read otherwise.
#pragma once

#include <string>
#include <vector>

namespace gudgeon {

struct FormulaReading {
  enum class Kind {
    chained_powers,       ///< a^b^c is a^(b^c)
    chained_comparisons,  ///< a < b < c compares the truth of a < b with c
  };
  Kind kind = Kind::chained_powers;
  std::string text;  ///< "2^3^2", as it stands in the formula
  int position = 0;  ///< [bytes] where it begins
};

/// All of them, in the order of the formula, which must be a sound one.
std::vector<FormulaReading> find_readings(const std::string& formula);

}  // namespace gudgeon
