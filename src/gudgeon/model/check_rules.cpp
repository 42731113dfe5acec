// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Judges single values and words the complaint.
#include "gudgeon/model/check_rules.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace gudgeon {

namespace {

bool is_name_letter(char c) {
  return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_';
}

}  // namespace

std::string with_unit(double value, Dimension dimension) {
  return dimension == dimension::kNone ? fmt::format("{:.6g}", value)
                                       : fmt::format("{:.6g} {}", value, si_unit(dimension));
}

std::string describe_range(const ParameterRange& range, Dimension dimension) {
  const bool below = range.maximum < kUnbounded;
  if (range.minimum == 0.0 && !below) return range.open_minimum ? "positive" : "not negative";
  std::string text;
  if (range.minimum > -kUnbounded) {
    text = (range.open_minimum ? "above " : "at least ") + with_unit(range.minimum, dimension);
  }
  if (below) {
    text += text.empty() ? "" : " and ";
    text += (range.open_maximum ? "below " : "at most ") + with_unit(range.maximum, dimension);
  }
  return text.empty() ? "finite" : text;
}

std::string CheckRules::describe(const Value& value) const {
  const std::string si = with_unit(value.value, value.dimension);
  if (source_ == nullptr) return si;
  const auto written = source_->written.find(value.path);
  const bool quoted = written != source_->written.end() && written->second.find_first_of("\"'") == 0;
  return quoted ? fmt::format("{} ({})", written->second, si) : si;
}

void CheckRules::check_range(std::string_view code, const Value& value, const ParameterRange& range) {
  if (std::isfinite(value.value) && range.contains(value.value)) return;
  if (read_with_errors_ && std::isnan(value.value)) return;
  std::string key = value.path.substr(value.path.rfind('.') + 1);
  if (key == "0") key = "x";  // of a vector
  if (key == "1") key = "y";
  diagnostics.error(std::string{code}, value.path,
                    fmt::format("{}: {} is {}; it must be {}", value.subject, key, describe(value),
                                describe_range(range, value.dimension)));
}

void CheckRules::check_finite(const std::string& subject, const std::string& path, Vec2 value) {
  if (std::isfinite(value.x) && std::isfinite(value.y)) return;
  if (read_with_errors_ && (std::isnan(value.x) || std::isnan(value.y))) return;
  diagnostics.error("E-MODEL-005", path,
                    fmt::format("{}: {} is ({}, {}); it must be finite", subject, path.substr(path.rfind('.') + 1),
                                value.x, value.y));
}

void CheckRules::check_name(const std::string& what, const std::string& path, const std::string& name) {
  if (!name.empty() && std::ranges::all_of(name, is_name_letter)) return;
  diagnostics.error(
      "E-MODEL-001", path,
      fmt::format("{} has the name '{}'; a name is made of the letters A-Z and a-z, digits and '_'", what, name));
}

void CheckRules::report_unknown(std::string_view code, const std::string& path, const std::string& message,
                                std::string_view name, std::string_view kind, const std::vector<std::string>& known) {
  std::string note =
      known.empty() ? fmt::format("there are no {}", kind) : fmt::format("{} are: {}", kind, join_names(known));
  const std::string suggestion = suggest(name, known);
  if (!suggestion.empty()) note += "   " + suggestion;
  diagnostics.error(std::string{code}, path, message, {note});
}

}  // namespace gudgeon
