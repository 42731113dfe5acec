// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Texts and numbers as TOML spells them.
#include "gudgeon/io/toml_lines.h"

#include <cmath>

namespace gudgeon {

std::string toml_text(std::string_view text) {
  std::string quoted = "\"";
  for (const char c : text) {
    const auto code = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\') quoted += '\\';
    if (c == '\n')
      quoted += "\\n";
    else if (code < 0x20 || code == 0x7F)
      quoted += fmt::format("\\u{:04X}", code);
    else
      quoted += c;
  }
  return quoted + "\"";
}

std::string toml_number(double value) {
  if (std::isnan(value)) return "nan";
  if (std::isinf(value)) return value > 0.0 ? "inf" : "-inf";
  return fmt::format("{}", value);
}

std::string toml_quantity(double value, Dimension dimension) {
  if (dimension == dimension::kNone || !std::isfinite(value)) return toml_number(value);
  const std::string unit = si_unit(dimension);
  return fmt::format("\"{} {}\"", value, unit);
}

std::string toml_point(const Anchor& anchor) { return toml_text(anchor.body + "." + anchor.point); }

std::string toml_vector(Vec2 value, Dimension dimension) {
  return fmt::format("[{}, {}]", toml_quantity(value.x, dimension), toml_quantity(value.y, dimension));
}

}  // namespace gudgeon
