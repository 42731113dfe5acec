// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Where the pieces of a formula meet: comparisons, and functions that jump or bend.
#pragma once

#include <limits>
#include <string>
#include <vector>

namespace gudgeon {

/// What a formula is pieced together by.
enum class BreakKind {
  less,           ///< a < b; like the next five a jump where a − b changes its sign
  less_equal,     ///< a <= b
  greater,        ///< a > b
  greater_equal,  ///< a >= b
  equal,          ///< a == b
  unequal,        ///< a != b
  sign,           ///< jumps at 0
  absolute,       ///< bends at 0
  least,          ///< min, bends where another argument becomes the least one
  greatest,       ///< max
  floor,          ///< jumps at whole numbers
  ceiling,
  nearest_up,  ///< rint: floor(x + 0.5)
  nearest,     ///< round: halves go away from zero
  remainder,   ///< mod(a, b), jumps where a/b is whole
  smooth_step  ///< its third derivative jumps at both ends
};

/// One place of a formula where pieces meet.
struct FormulaBreak {
  BreakKind kind = BreakKind::less;
  std::string name;  ///< of the function that stands for it in MarkedFormula::text
  std::string text;  ///< as the user wrote it
};

/// A formula in which every break is a function of its own name.
struct MarkedFormula {
  std::string text;
  std::vector<FormulaBreak> breaks;
};

/// The formula's text must be one that can be understood.
MarkedFormula mark_breaks(const std::string& text);

/// Where the marked formula goes beyond so many characters [bytes in the text]; npos when it does not. In one pass:
/// marking takes far longer where many breaks lie in one another.
std::size_t find_marked_excess(const std::string& text, std::size_t most);

/// No piece is held: the argument decides.
inline constexpr int kFreePiece = std::numeric_limits<int>::min();

/// One break at one evaluation: its piece holds while its argument stays between low and high.
struct BreakState {
  bool met = false;  ///< the evaluation came by it; one in the branch of a condition that is not taken stays unmet
  int piece = kFreePiece;
  double argument = 0.0;
  double low = 0.0;
  double high = 0.0;
};

/// The value of a break's function, of the held piece wherever the argument is, or of the one it is in.
double eval_break(BreakKind kind, const double* arguments, int n_arguments, int held, BreakState& state) noexcept;

}  // namespace gudgeon
