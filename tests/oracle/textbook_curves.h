// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Curves through points, written down anew: dense equations for splines, Fritsch and Butland's slopes by their formula.
#pragma once

#include <vector>

#include "gudgeon/model/function.h"

namespace gudgeon::oracle {

struct TextbookValue {
  double value = 0.0;
  double slope = 0.0;
  double curvature = 0.0;
};

/// A curve by its values and slopes at its points; between them it is the cubic that these determine.
class TextbookCurve {
 public:
  /// A spline needs four points; throws std::runtime_error for fewer.
  TextbookCurve(const SampledCurve& curve, Interpolation interpolation);
  /// As a load has it.
  static TextbookCurve of_load(const SampledCurve& curve);
  /// As a motion has it: a spline, whatever it says.
  static TextbookCurve of_motion(const SampledCurve& curve);

  [[nodiscard]] TextbookValue eval(double argument) const;
  /// ∫ of the curve from one argument to another.
  [[nodiscard]] double integrate(double from, double to) const;

 private:
  [[nodiscard]] double integrate_from_first(double to) const;
  void find_spline_slopes();
  void find_monotone_slopes();

  std::vector<double> x_;
  std::vector<double> y_;
  std::vector<double> slopes_;
  bool periodic_;
  bool linear_ = false;
};

}  // namespace gudgeon::oracle
