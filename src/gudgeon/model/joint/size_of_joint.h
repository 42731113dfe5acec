// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// The sizes of joints with clearance.
#pragma once

#include "gudgeon/model/field.h"

namespace gudgeon {

/// A length that the model file must give, above zero.
constexpr FieldTraits size_of_joint(std::string_view symbol, std::string_view meaning) {
  return {.required = true,
          .dimension = dimension::kLength,
          .symbol = symbol,
          .range = kPositive,
          .code = "E-MODEL-012",
          .meaning = meaning};
}

}  // namespace gudgeon
