// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Bai-Zhao: the stiffness of a journal in its bearing with hysteresis damping.
#pragma once

#include <array>

#include "gudgeon/laws/damping/zhiying_qishao.h"
#include "gudgeon/laws/normal/liu.h"

namespace gudgeon {

/// F = F_el (1 + χ δ̇/δ̇₀),  dF_el/dδ = K_n = π/8 · E* w √(2δ (3ΔR + 2δ)²/(ΔR + δ)³),  χ = 3(1 − e²)/4 · exp(2(1 − e))
///
/// δ [m] penetration, δ̇ [m/s] its rate (> 0 approaching), δ̇₀ [m/s] the rate at onset, w [m] width, ΔR [m] clearance,
/// E* [Pa] contact modulus, e [1] restitution asked for. K_n [N/m] is the slope of Liu's force, so the elastic force is
/// Liu's: the only one whose stiffness K_n is. Printed is K_n δⁿ: with n = 1 its slope is not K_n and it presses up to
/// half as hard again, with another n it is no force. δ → 0: F → 0; e = 1: Liu. Delivers what zhiying_qishao does:
/// 0.896 for e = 0.9. Bai & Zhao 2012, 2013.
struct BaiZhao {
  double restitution = 0.9;  ///< e [1]

  static constexpr bool kNeedsRoundBearing = true;
  static constexpr std::string_view kName = "bai_zhao";
  static constexpr std::string_view kFormula =
      "F = π/2 · E* w δ √(δ/(2(ΔR + δ))) (1 + χ δ̇/δ̇₀), χ = 3(1 − e²)/4 · exp(2(1 − e))";
  static constexpr std::array<Parameter<BaiZhao>, 1> kParameters{{
      {"restitution", "e", dimension::kNone, kRestitutionRange, "coefficient of restitution asked for",
       &BaiZhao::restitution},
  }};

  [[nodiscard]] double damping_factor() const { return ZhiyingQishaoDamping{restitution}.damping_factor(); }

  NormalForce operator()(const NormalContact& contact) const noexcept {
    return with_clearance_and_damping(eval_liu(contact), contact);
  }
};
static_assert(NormalForceLaw<BaiZhao>);

}  // namespace gudgeon
