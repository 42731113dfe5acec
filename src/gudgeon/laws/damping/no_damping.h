// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// No damping: an elastic contact.
#pragma once

#include <array>

#include "gudgeon/laws/damping/damping.h"

namespace gudgeon {

/// χ = 0: the contact returns all of its energy.
struct NoDamping {
  static constexpr std::string_view kName = "no_damping";
  static constexpr std::string_view kFormula = "χ = 0";
  static constexpr std::array<Parameter<NoDamping>, 0> kParameters{};

  [[nodiscard]] double damping_factor() const { return 0.0; }
};
static_assert(DampingForm<NoDamping>);

}  // namespace gudgeon
