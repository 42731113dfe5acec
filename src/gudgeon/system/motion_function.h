// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// The motion that a driver asks for, with its rate and acceleration.
#pragma once

#include <variant>

#include "gudgeon/base/curve.h"
#include "gudgeon/base/expression.h"
#include "gudgeon/system/topology.h"

namespace gudgeon {

/// A driven value at one instant.
struct DrivenValue {
  double value = 0.0;         ///< [rad] or [m]
  double rate = 0.0;          ///< [rad/s] or [m/s]
  double acceleration = 0.0;  ///< [rad/s^2] or [m/s^2]
};

/// Evaluates one DrivenMotion. A table is differentiated exactly; an expression, which has only values, by central
/// differences of eighth order. Not to be shared by threads.
class MotionFunction {
 public:
  explicit MotionFunction(const DrivenMotion& motion);

  /// NaN where the motion has no value. Allocates nothing.
  [[nodiscard]] DrivenValue eval(double t) noexcept;

 private:
  double start_;
  double speed_;
  double difference_step_;
  std::variant<std::monostate, ExpressionEvaluator, Curve> function_;
};

/// Chooses the difference steps of all motions that are expressions. Throws ModelError, with one entry a driver, where
/// a text cannot be read and where a motion is not smooth enough to be differentiated.
void choose_difference_steps(const Mechanism& mechanism, std::vector<DrivenMotion>& motions);

}  // namespace gudgeon
