// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// An end without bound is never part of an interval.
#include "gudgeon/app/interval_text.h"

#include <fmt/format.h>

#include <cmath>

namespace gudgeon {

std::string interval_text(const ParameterRange& range) {
  const auto bound = [](double value) { return std::isinf(value) ? std::string{"∞"} : fmt::format("{:g}", value); };
  const bool below = std::isinf(range.minimum);
  return fmt::format("{}{}{}, {}{}", range.open_minimum || below ? "(" : "[", below ? "-" : "", bound(range.minimum),
                     bound(range.maximum), range.open_maximum || std::isinf(range.maximum) ? ")" : "]");
}

}  // namespace gudgeon
