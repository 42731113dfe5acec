// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Writes the lines of a model file: texts with escapes, numbers with all digits, quantities in SI.
#pragma once

#include <fmt/format.h>

#include <span>
#include <string>
#include <string_view>
#include <utility>

#include "gudgeon/base/quantity.h"
#include "gudgeon/base/vec2.h"
#include "gudgeon/model/joint.h"

namespace gudgeon {

/// A text in TOML quotes.
std::string toml_text(std::string_view text);
/// A number with as few digits as give back the same double.
std::string toml_number(double value);
/// A quantity in SI, "0.0005 m"; a bare number when it has no unit.
std::string toml_quantity(double value, Dimension dimension);
/// Two quantities in an array.
std::string toml_vector(Vec2 value, Dimension dimension);
/// A point of a body, "crank.A".
std::string toml_point(const Anchor& anchor);

/// The name of a choice.
template <class Value>
std::string_view choice_name(std::span<const std::pair<std::string_view, Value>> choices, Value value) {
  for (const auto& [name, choice] : choices) {
    if (choice == value) return name;
  }
  return {};
}

/// Collects "key = value" lines.
class TomlLines {
 public:
  void header(std::string_view section, std::string_view name) { text_ += fmt::format("\n[{}.{}]\n", section, name); }
  void line(std::string_view key, std::string_view value) { text_ += fmt::format("{} = {}\n", key, value); }
  void raw(std::string_view text) { text_ += text; }
  [[nodiscard]] const std::string& text() const { return text_; }

 private:
  std::string text_;
};

}  // namespace gudgeon
