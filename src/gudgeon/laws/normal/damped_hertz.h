// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Hertzian point contact with any of the damping forms: most of the laws of the literature.
#pragma once

#include <algorithm>
#include <array>

#include "gudgeon/laws/damping/damping.h"
#include "gudgeon/laws/normal/power.h"

namespace gudgeon {

/// F = K δⁿ (1 + χ δ̇/δ̇₀), never pulling; the law goes by the name of its damping form
///
/// δ [m] penetration, δ̇ [m/s] its rate (> 0 approaching), δ̇₀ [m/s] the rate at onset, K [N/mⁿ] stiffness,
/// n [1] exponent, e [1] restitution asked for, χ(e) [1] by the damping form, which says where it holds and its source.
/// δ → 0: F → 0; χ = 0: Hertz.
template <DampingForm Damping>
struct DampedHertz {
  double restitution = Damping{}.restitution;  ///< e [1]
  double exponent = 1.5;                       ///< n [1]

 private:
  static constexpr std::string_view kForce = "F = K δⁿ (1 + χ δ̇/δ̇₀), ";
  static constexpr auto kText = [] {
    std::array<char, kForce.size() + Damping::kFormula.size()> text{};
    std::ranges::copy(Damping::kFormula, std::ranges::copy(kForce, text.begin()).out);
    return text;
  }();

 public:
  static constexpr std::string_view kName = Damping::kName;
  static constexpr std::string_view kFormula{kText.data(), kText.size()};
  static constexpr std::array<Parameter<DampedHertz>, 2> kParameters{{
      {"restitution", "e", dimension::kNone, kRestitutionRange, "coefficient of restitution asked for",
       &DampedHertz::restitution},
      {"exponent", "n", dimension::kNone, kExponentRange, "exponent of the penetration", &DampedHertz::exponent},
  }};

  [[nodiscard]] double damping_factor() const { return Damping{restitution}.damping_factor(); }

  NormalForce operator()(const NormalContact& contact) const noexcept {
    return with_damping(elastic_power(contact.stiffness, contact.penetration, exponent), contact);
  }
};

}  // namespace gudgeon
