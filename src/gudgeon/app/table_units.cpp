// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Numbers with a fixed count of decimals.
#include "gudgeon/app/table_units.h"

#include <fmt/format.h>

namespace gudgeon {

std::string render_fixed(double value, int digits) {
  std::string text = fmt::format("{:.{}f}", value, digits);
  if (text.find_first_of("123456789") == std::string::npos && text.starts_with('-')) text.erase(0, 1);
  return text;
}

}  // namespace gudgeon
