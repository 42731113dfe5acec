// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// From points to curves.
#include "gudgeon/model/function.h"

namespace gudgeon {

namespace {

Curve make_curve(const SampledCurve& curve, Interpolation fallback) {
  if (curve.smoothing) return make_smoothed(curve).curve;
  return {curve.arguments, curve.values, curve.periodic, curve.interpolation.value_or(fallback)};
}

}  // namespace

SmoothedCurve make_smoothed(const SampledCurve& curve) {
  const MeasuredPoints points{curve.arguments, curve.values, curve.periodic};
  return curve.smoothing->frequency > 0.0 ? smooth_at(points, curve.smoothing->frequency)
                                          : smooth_within(points, curve.smoothing->tolerance);
}

Curve make_load_curve(const SampledCurve& curve) { return make_curve(curve, kLoadInterpolation); }

Curve make_motion_curve(const SampledCurve& curve) { return make_curve(curve, kMotionInterpolation); }

}  // namespace gudgeon
