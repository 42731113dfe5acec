// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// A surface that does not wear.
#pragma once

#include <array>

#include "gudgeon/laws/wear/wear.h"

namespace gudgeon {

/// ḣ = 0
struct NoWear {
  static constexpr std::string_view kName = "no_wear";
  static constexpr std::string_view kFormula = "ḣ = 0";
  static constexpr std::array<Parameter<NoWear>, 0> kParameters{};

  [[nodiscard]] NoWear share_of(double /*share*/) const { return {}; }

  double operator()(const WearContact& /*contact*/) const noexcept { return 0.0; }
};
static_assert(WearLaw<NoWear>);

}  // namespace gudgeon
