// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// What the laws of cylinders in line contact share: the geometry they need, and a damping form of the user's choice.
#pragma once

#include <array>
#include <cmath>
#include <concepts>
#include <limits>
#include <numbers>

#include "gudgeon/laws/damping/any.h"
#include "gudgeon/laws/normal/normal.h"

namespace gudgeon {

/// An elastic law of a journal inside a round bearing, damped by a form of its own: { law = "johnson", damping = { law
/// = "exact_restitution", restitution = 0.8 } }.
struct CylindricalLaw {
  AnyDamping damping = NoDamping{};

  [[nodiscard]] double damping_factor() const { return find_damping_factor(damping); }
};

/// A law that needs the radii of both surfaces.
template <class Law>
concept NeedsRoundBearing = Law::kNeedsRoundBearing || std::derived_from<Law, CylindricalLaw>;

/// ΔR [m]
inline double find_clearance(const NormalContact& contact) noexcept {
  return contact.bearing_radius - contact.journal_radius;
}

/// What a law answers beyond its range: never a guess.
inline constexpr NormalForce kNoForceKnown{
    std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN(),
    std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN(),
    std::numeric_limits<double>::quiet_NaN()};

/// t − ln t = L for t > 1, given L > 1; −t is the lower branch of Lambert's W at −exp(−L). To rounding in t − ln t.
inline double solve_log_difference(double level) noexcept {
  const double p = std::sqrt(2.0 * (level - 1.0));
  double t = level < 2.0 ? 1.0 + p + p * p / 3.0 : level + std::log(level + std::log(level));
  // Both starts are within 6 %; each of Halley's steps triples the digits.
  for (int i = 0; i < 3; ++i) {
    const double excess = t - std::log(t) - level;
    const double slope = 1.0 - 1.0 / t;
    t -= 2.0 * excess * slope / (2.0 * slope * slope - excess / (t * t));
  }
  return t;
}

/// Elastic line contact whose penetration is known over the force per width f = F/w:
/// δ = f/(π E*) ln(A/f), A [N/m] the law's own reference. f grows with δ as far as δ = A/(e π E*); NaN beyond.
/// With t = ln(A/f): f = π E* δ/t, U = F δ (1/2 − 1/(4t)), and by the complementary energy ∂U/∂ln A = 2U − F δ.
inline NormalForce eval_logarithmic(const NormalContact& contact, double reference) noexcept {
  if (contact.penetration <= 0.0) return {};
  const double modulus = std::numbers::pi * contact.contact_modulus;
  const double level = -std::log(modulus * contact.penetration / reference);
  if (!(level > 1.0)) return kNoForceKnown;
  const double t = solve_log_difference(level);
  const double force = contact.width * modulus * contact.penetration / t;
  return {force, force, force * contact.penetration * (0.5 - 0.25 / t)};
}

/// Where it ends: t = 1.
inline LawEnd find_logarithmic_end(const NormalContact& contact, double reference) noexcept {
  return {reference / (std::numbers::e * std::numbers::pi * contact.contact_modulus),
          contact.width * reference / std::numbers::e};
}

/// ∂U/∂ln L of an elastic energy U = L² u(δ/L), or of a logarithmic law whose reference A is proportional to L.
inline double energy_by_length(const NormalForce& elastic, const NormalContact& contact) noexcept {
  return 2.0 * elastic.elastic_energy - elastic.elastic_force * contact.penetration;
}

/// A law whose only length is the clearance, complete with damping.
inline NormalForce with_clearance_and_damping(NormalForce elastic, const NormalContact& contact) noexcept {
  elastic.energy_by_clearance = energy_by_length(elastic, contact);
  return with_damping(elastic, contact);
}

}  // namespace gudgeon
