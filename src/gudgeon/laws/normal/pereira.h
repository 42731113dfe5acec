// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Pereira et al.: a fit to finite elements of a journal in a bearing.
#pragma once

#include <array>

#include "gudgeon/laws/normal/cylindrical.h"

namespace gudgeon {

/// ΔR [m] over which the law was fitted.
inline constexpr ParameterRange kPereiraClearance{5e-6, 10e-3, false, false};

/// F = (a ΔR + b) w E*/ΔR · δⁿ, n = Y ΔR^(−0.005), in N and mm
///
/// δ [mm] penetration, w [mm] width, E* [MPa] contact modulus, ΔR [mm] clearance, a = 0.965, b = 0.0965 mm, and
///   Y = 1.51 [ln(1000 ΔR)]^(−0.151)   0.005 mm <= ΔR < 0.34954 mm
///   Y = 0.0151 ΔR + 1.151             0.34954 mm <= ΔR <= 10 mm
/// all converted from and to SI here. The two branches of Y differ by 1e-4 where they meet; outside 0.005 to 10 mm they
/// are extended as they stand, NaN below 1 µm. A fit: its dimensions do not agree. Internal contact only.
/// Pereira, Ramalho & Ambrósio 2015.
struct Pereira : CylindricalLaw {
  static constexpr std::string_view kName = "pereira";
  static constexpr std::string_view kFormula = "F = (a ΔR + b) w E*/ΔR · δⁿ, n = Y ΔR^(−0.005), in N and mm";
  static constexpr std::array<Parameter<Pereira>, 0> kParameters{};

  NormalForce operator()(const NormalContact& contact) const noexcept {
    if (contact.penetration <= 0.0) return {};
    constexpr double kMillimetres = 1e3;  // of a metre
    constexpr double kMegapascals = 1e-6;
    constexpr double kBranch = 0.34954;  // [mm]
    const double clearance = kMillimetres * find_clearance(contact);
    const double depth = kMillimetres * contact.penetration;
    const double log_clearance = std::log(1e3 * clearance);
    const bool tight = clearance < kBranch;
    const double y = tight ? 1.51 * std::pow(log_clearance, -0.151) : 0.0151 * clearance + 1.151;
    const double y_slope = tight ? -0.151 * y / log_clearance : 0.0151 * clearance;  // dY/d ln ΔR
    const double scale = std::pow(clearance, -0.005);
    const double exponent = scale * y;
    const double sum = 0.965 * clearance + 0.0965;
    const double force = sum * kMillimetres * contact.width * kMegapascals * contact.contact_modulus / clearance *
                         std::pow(depth, exponent);
    NormalForce elastic{force, force, force * contact.penetration / (exponent + 1.0)};
    // ∂U/∂ln ΔR through the factor and through the exponent
    const double exponent_slope = scale * (y_slope - 0.005 * y);
    elastic.energy_by_clearance =
        elastic.elastic_energy * (-0.0965 / sum + exponent_slope * (std::log(depth) - 1.0 / (exponent + 1.0)));
    return with_damping(elastic, contact);
  }
};
static_assert(NormalForceLaw<Pereira>);

}  // namespace gudgeon
