// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// The units that a model file may use, and the SI prefixes before them.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "gudgeon/base/quantity.h"

namespace gudgeon {

/// One unit of a factor times a power of ten in SI; kept apart so that "0.5 mm" is 0.5/1000 exactly rounded.
struct Unit {
  std::string_view symbol;
  Dimension dimension;
  double factor = 1.0;
  int power_of_ten = 0;
  bool takes_prefix = false;
};

/// The unit of a symbol with or without a prefix: "mm", "GPa", "rev".
std::optional<Unit> find_unit(std::string_view symbol);

/// The known unit that an unknown symbol was probably meant to be; empty when none is near.
std::string find_nearest_unit(std::string_view symbol);

}  // namespace gudgeon
