// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Motions of drivers whose derivatives can be written down, so that none is taken from the engine.
#pragma once

#include "gudgeon/model/driver.h"

namespace gudgeon::oracle {

/// a + c t + b sin(w t + p)
struct Wave {
  double a = 0.0;
  double c = 0.0;
  double b = 0.0;
  double w = 0.0;
  double p = 0.0;
};

/// The wave as an expression of the time.
Expression make_wave(const Wave& wave);

/// Samples of c0 + c1 t + c2 t² + c3 t³ at uneven times from −0.5 s to 1.5 s: a spline through them is that cubic.
SampledCurve make_cubic_curve(double c0, double c1, double c2, double c3);

struct TextbookMotion {
  double value = 0.0;
  double rate = 0.0;
  double acceleration = 0.0;
};

/// What a driver asks for: uniform, an expression of make_wave() or a curve.
/// Throws std::runtime_error for any
/// other.
TextbookMotion eval_motion(const Driver& driver, double time);

}  // namespace gudgeon::oracle
