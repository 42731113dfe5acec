// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// No friction at all.
#pragma once

#include <array>

#include "gudgeon/laws/friction/friction.h"

namespace gudgeon {

/// μ = 0
struct Frictionless {
  static constexpr bool kHasBristle = false;
  static constexpr std::string_view kName = "frictionless";
  static constexpr std::string_view kFormula = "μ = 0";
  static constexpr std::array<Parameter<Frictionless>, 0> kParameters{};

  Friction operator()(const FrictionContact& /*contact*/) const noexcept { return {0.0}; }
};
static_assert(FrictionLaw<Frictionless>);

}  // namespace gudgeon
