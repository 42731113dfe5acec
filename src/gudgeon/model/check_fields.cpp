// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// One rule a kind of value.
#include "gudgeon/model/check_fields.h"

#include <fmt/format.h>

namespace gudgeon {

namespace {

bool is_unbounded(const ParameterRange& range) { return range.minimum == -kUnbounded && range.maximum == kUnbounded; }

}  // namespace

void FieldCheck::check_value(const std::string& key, const FieldTraits& traits, const double& value) {
  rules_.check_range(traits.code, {subject_, path_ + "." + key, value, traits.dimension}, traits.range);
}

void FieldCheck::check_value(const std::string& key, const FieldTraits& traits, const int& value) {
  check_value(key, traits, static_cast<double>(value));
}

void FieldCheck::check_value(const std::string& key, const FieldTraits& traits, const Vec2& value) {
  if (is_unbounded(traits.range)) {
    rules_.check_finite(subject_, path_ + "." + key, value);
    return;
  }
  const std::string subject = fmt::format("{}: {}", subject_, key);
  rules_.check_range(traits.code, {subject, fmt::format("{}.{}.0", path_, key), value.x, traits.dimension},
                     traits.range);
  rules_.check_range(traits.code, {subject, fmt::format("{}.{}.1", path_, key), value.y, traits.dimension},
                     traits.range);
}

void FieldCheck::check_value(const std::string& key, const FieldTraits& /*traits*/, const Anchor& value) {
  check_anchor(rules_, subject_, path_ + "." + key, value);
}

void FieldCheck::check_value(const std::string& key, const FieldTraits& traits, const Function& value) {
  // "force.0" is the x of the force.
  const auto dot = key.find('.');
  const std::string name =
      dot == std::string::npos ? key : fmt::format("{} of {}", key.back() == '0' ? "x" : "y", key.substr(0, dot));
  check_function(rules_, {subject_ + ": " + name, path_, key, traits.dimension}, value);
}

void FieldCheck::check_value(const std::string& key, const FieldTraits& traits, const std::vector<Point>& value) {
  for (const Point& point : value) check_value(fmt::format("{}.{}", key, point.name), traits, point.position);
}

}  // namespace gudgeon
