// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Coefficients of the implicit Runge-Kutta pair ESDIRK5(4)7L[2]SA2.
#pragma once

#include <array>

namespace gudgeon {

/// Order 5 with an estimate of order 4; the first stage is explicit, the others share the diagonal γ; L-stable, stage
/// order 2, and the last stage is the end of the step. C. A. Kennedy, M. H. Carpenter, Applied Numerical Mathematics
/// 146 (2019) 221.
struct Esdirk {
  static constexpr int kStages = 7;
  static constexpr double kDiagonal = 0.184;
  static constexpr std::array<double, kStages> kNodes{
      0.0, 0.368, 0.62821529547664945, 0.13881019830028329, 0.69995861940457471, 0.90837696335078533, 1.0};
  /// Below the diagonal.
  static constexpr std::array<std::array<double, kStages - 1>, kStages> kCoefficients{{
      {},
      {0.184},
      {0.2221076477383247, 0.22210764773832475},
      {-0.014049475381926274, -0.014049475381926283, -0.017090850935864151},
      {-0.40838859254931487, -0.40838859254931464, 0.16646399821362964, 1.1662718062895745},
      {-0.53929072355881114, -0.53929072355881136, -0.24223442884542501, 1.4888806111225146, 0.55631222819131843},
      {-0.039466069109740348, -0.039466069109740258, 0.27263649025024267, 0.43216517252028819, 0.35241608623288911,
       -0.16228561078393952},
  }};
  /// The last row: also the weights of what is integrated along.
  static constexpr std::array<double, kStages> kWeights{-0.039466069109740348,
                                                        -0.039466069109740258,
                                                        0.27263649025024267,
                                                        0.43216517252028819,
                                                        0.35241608623288911,
                                                        -0.16228561078393952,
                                                        kDiagonal};
  /// Weights of the fourth order against those of the fifth.
  static constexpr std::array<double, kStages> kErrorWeights{
      -0.041223397456906924, -0.041223397456907181, -0.089736805636807138, 0.084848701245942793,
      0.074183645069565207,  0.057958752816804543,  -0.04480749858169103};
  /// Weights of a rule of second order that are not negative: for what may nowhere become so.
  static constexpr std::array<double, kStages> kShares{0.0, 0.5 / 0.632, 0.0, 0.0, 0.0, 0.0, 0.132 / 0.632};
};

}  // namespace gudgeon
