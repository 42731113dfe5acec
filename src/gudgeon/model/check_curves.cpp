// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Rules for tables of points that a curve goes through.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "gudgeon/model/channel_names.h"
#include "gudgeon/model/check_rules.h"

namespace gudgeon {

namespace {

// Ends that differ by less, of the largest value, are the same number written twice.
constexpr double kSameValue = 1e-9;

bool check_over(CheckRules& rules, const FunctionUse& use, const SampledCurve& curve) {
  const bool known = rules.channels().find(curve.over) >= 0;
  const std::string path = use.path() + ".over";
  if (use.of_time_only && curve.over != "t") {
    rules.diagnostics.error(
        "E-MODEL-083", path,
        fmt::format("{} is over '{}'; a motion may depend on the time t only", use.subject, curve.over));
    return false;
  }
  if (known) return true;
  rules.report_unknown("E-MODEL-082", path, fmt::format("{} is over unknown channel '{}'", use.subject, curve.over),
                       curve.over, "channels", rules.channels().names());
  return false;
}

bool check_entries(CheckRules& rules, const FunctionUse& use, const char* key, const std::vector<double>& entries) {
  bool good = true;
  for (std::size_t k = 0; k < entries.size(); ++k) {
    if (std::isfinite(entries[k])) continue;
    rules.diagnostics.error(
        "E-MODEL-005", fmt::format("{}.{}.{}", use.path(), key, k),
        fmt::format("{}: entry {} of {} is {}; it must be finite", use.subject, k + 1, key, entries[k]));
    good = false;
  }
  return good;
}

bool check_order(CheckRules& rules, const FunctionUse& use, const std::vector<double>& arguments) {
  bool good = true;
  for (std::size_t k = 1; k < arguments.size(); ++k) {
    if (!(arguments[k] <= arguments[k - 1])) continue;
    rules.diagnostics.error("E-MODEL-085", fmt::format("{}.arguments.{}", use.path(), k),
                            fmt::format("{}: arguments must increase; entry {} is {:.6g} and entry {} is {:.6g}",
                                        use.subject, k, arguments[k - 1], k + 1, arguments[k]));
    good = false;
  }
  return good;
}

bool check_size(CheckRules& rules, const FunctionUse& use, const SampledCurve& curve) {
  const std::size_t least = curve.periodic ? 3 : 2;
  if (curve.arguments.size() != curve.values.size()) {
    rules.diagnostics.error("E-MODEL-084", use.path() + (curve.arguments.empty() ? ".arguments" : ".values"),
                            fmt::format("{} has {} arguments and {} values; there must be one value an argument",
                                        use.subject, curve.arguments.size(), curve.values.size()));
    return false;
  }
  if (curve.arguments.size() >= least) return true;
  rules.diagnostics.error("E-MODEL-084", use.path() + ".arguments",
                          fmt::format("{} has {} points; a {} needs at least {}", use.subject, curve.arguments.size(),
                                      curve.periodic ? "periodic curve" : "curve", least));
  return false;
}

bool check_period(CheckRules& rules, const FunctionUse& use, const std::vector<double>& values) {
  double largest = 0.0;
  for (const double value : values) largest = std::max(largest, std::abs(value));
  if (std::abs(values.back() - values.front()) <= kSameValue * largest) return true;
  rules.diagnostics.error("E-MODEL-086", fmt::format("{}.values.{}", use.path(), values.size() - 1),
                          fmt::format("{} is periodic, but begins with {:.6g} and ends with {:.6g}", use.subject,
                                      values.front(), values.back()),
                          {"the last point is the first one of the next period and needs the same value"});
  return false;
}

/// A motion's acceleration must not jump.
bool check_interpolation(CheckRules& rules, const FunctionUse& use, const SampledCurve& curve) {
  if (!use.of_time_only || curve.interpolation.value_or(kMotionInterpolation) == Interpolation::spline) return true;
  const bool linear = *curve.interpolation == Interpolation::linear;
  rules.diagnostics.error("E-MODEL-090", use.path() + ".interpolation",
                          fmt::format("{}: with interpolation = \"{}\" the {} would jump at the points", use.subject,
                                      linear ? "linear" : "monotone", linear ? "speed" : "acceleration"),
                          {"a motion runs as a spline: leave the key out, and add points where it must be held"});
  return false;
}

}  // namespace

bool check_curve(CheckRules& rules, const FunctionUse& use, const SampledCurve& curve) {
  const bool over = check_over(rules, use, curve);
  const bool arguments = check_entries(rules, use, "arguments", curve.arguments);
  const bool values = check_entries(rules, use, "values", curve.values);
  const bool order = check_order(rules, use, curve.arguments);
  const bool size = check_size(rules, use, curve);
  if (!over || !arguments || !values || !order || !size) return false;
  if (curve.periodic && !check_period(rules, use, curve.values)) return false;
  if (!check_interpolation(rules, use, curve) || !check_smoothing(rules, use, curve)) return false;
  remark_curve(rules, use, curve);
  return true;
}

}  // namespace gudgeon
