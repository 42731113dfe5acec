// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// The family of wear laws: how fast a sliding surface loses depth.
#pragma once

#include <concepts>

#include "gudgeon/laws/law.h"

namespace gudgeon {

/// A wear law maps contact pressure p [Pa] and slip speed |v| [m/s] to the rate of depth loss ḣ [m/s], >= 0.
template <class Law>
concept WearLaw = LawValue<Law> && requires(const Law law, double pressure, double slip_speed) {
  { law(pressure, slip_speed) } noexcept -> std::same_as<double>;
};

}  // namespace gudgeon
