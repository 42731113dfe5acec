// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Normal force, friction and their powers; equations are numbered as in docs/theory/contact.md.
#include "gudgeon/system/contact_force.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace gudgeon {

namespace {

// v = t·(ṙ_j − ṙ_i) + θ̇_j ℓ_j − θ̇_i ℓ_i, both bodies looked at in the middle of the overlap      (Eq. C8)
double find_slip_speed(const ContactGap& gap, const RelativeMotion& motion) noexcept {
  return dot(perp(gap.normal), motion.velocity) + motion.journal_rate * gap.journal_lever -
         motion.bearing_rate * gap.bearing_lever;
}

// Slopes are taken over this share of a law's least speed: differences then have six digits.
constexpr double kSlipShare = 1e-5;

// Those parameters of a law that are speeds, where they are not zero.
std::vector<double> list_speeds(const AnyFriction& friction) {
  return std::visit(
      []<class Law>(const Law& law) {
        std::vector<double> speeds;
        for (const auto& parameter : Law::kParameters) {
          const double value = law.*(parameter.member);
          if (parameter.dimension == dimension::kSpeed && value > 0.0) speeds.push_back(value);
        }
        return speeds;
      },
      friction);
}

NormalContact make_normal_contact(const Contact& contact, const ContactMode& mode, const ContactGap& gap) noexcept {
  constexpr double kTouching = std::numeric_limits<double>::min();  // [m] the least that counts as contact
  return {std::max(gap.penetration, kTouching),
          gap.penetration_rate,
          std::max(mode.onset_speed, contact.onset_speed_floor),
          contact.stiffness_factor * std::sqrt(gap.relative_radius),
          contact.damping_factor,
          gap.bearing_radius,
          gap.journal_radius,
          contact.width,
          contact.contact_modulus};
}

NormalForce find_normal_force(const Contact& contact, const NormalContact& kinematics) noexcept {
  return std::visit([&](const auto& law) { return law(kinematics); }, contact.normal_force);
}

Friction find_friction(const AnyFriction& friction, double slip_speed, double bristle) noexcept {
  return std::visit([&](const auto& law) { return law(FrictionContact{slip_speed, bristle}); }, friction);
}

}  // namespace

std::optional<NormalForceEnd> find_normal_force_end(const Contact& contact, const ContactGap& gap) noexcept {
  const NormalContact at = make_normal_contact(contact, {}, gap);
  return std::visit(
      [&]<class Law>(const Law& law) -> std::optional<NormalForceEnd> {
        if constexpr (EndingLaw<Law>) {
          return NormalForceEnd{Law::kName, Law::kEnd, law.find_end(at)};
        } else {
          return std::nullopt;
        }
      },
      contact.normal_force);
}

// 4/(3π (σ_i + σ_j)) with σ = (1 − ν²)/(π E)      (Eq. C5)
double find_stiffness_factor(const Material& bearing, const Material& journal) {
  return 4.0 / 3.0 * find_contact_modulus(bearing, journal);
}

bool steps_at_onset(const AnyNormalForce& normal_force) {
  return std::visit(
      []<class Law>(const Law&) {
        return requires { Law::kStepsAtOnset; };
      },
      normal_force);
}

bool has_bristle(const AnyFriction& friction) {
  return std::visit([]<class Law>(const Law&) { return Law::kHasBristle; }, friction);
}

double find_bristle_scale(const AnyFriction& friction) {
  if (!has_bristle(friction)) return 0.0;
  // Far below any bristle's deflection, where ż = v − a z for every law.
  constexpr double kDeflection = 1e-12;
  const double rate = std::visit(
      [](const auto& law) {
        return law(FrictionContact{1.0, kDeflection}).bristle_rate;
      },
      friction);
  return kDeflection / (1.0 - rate);
}

double find_slip_scale(const AnyFriction& friction) {
  const std::vector<double> speeds = list_speeds(friction);
  return speeds.empty() ? 1.0 : std::ranges::min(speeds);
}

double find_steepest_friction(const AnyFriction& friction) {
  constexpr int kParts = 8;  // of each speed
  const double step = kSlipShare * find_slip_scale(friction);
  double steepest = 0.0;
  for (const double speed : list_speeds(friction)) {
    for (int k = 0; k <= kParts; ++k) {
      const double slip = speed * k / kParts;
      const double rise =
          find_friction(friction, slip + step, 0.0).coefficient - find_friction(friction, slip, 0.0).coefficient;
      steepest = std::max(steepest, rise / step);
    }
  }
  return steepest;
}

double find_contact_modulus(const Material& bearing, const Material& journal) {
  const auto compliance = [](const Material& m) { return (1.0 - m.poisson_ratio * m.poisson_ratio) / m.young_modulus; };
  return 1.0 / (compliance(bearing) + compliance(journal));
}

void update_contact_forces(const Contact& contact, const RelativeMotion& motion, const ContactMode& mode,
                           double bristle, ContactForces& forces) noexcept {
  const ContactGap& gap = forces.gap;
  const bool presses = mode.in_contact && (contact.steps_at_onset || !(gap.penetration <= 0.0));  // NaN goes on
  if (!presses) {
    forces = ContactForces{.gap = gap};
    if (mode.in_contact && contact.bristle >= 0) {
      forces.bristle_rate = find_friction(contact.friction, find_slip_speed(gap, motion), bristle).bristle_rate;
    }
    return;
  }

  // Along the normal: F of the law, P_D = (F − F_el) δ̇      (Eqs. C6, C7, C12)
  const NormalForce normal = find_normal_force(contact, make_normal_contact(contact, mode, gap));
  forces.normal_force = normal.force;
  forces.elastic_energy = normal.elastic_energy;
  forces.damping_power = (normal.force - normal.elastic_force) * gap.penetration_rate;

  // Along the slip: −μF t on the journal, torques −μF ℓ_j and μF ℓ_i, P_f = μF v      (Eqs. C9, C12)
  const Vec2 tangent = perp(gap.normal);
  forces.slip_speed = find_slip_speed(gap, motion);
  const Friction friction = find_friction(contact.friction, forces.slip_speed, bristle);
  forces.friction_force = friction.coefficient * normal.force;
  forces.bristle_rate = friction.bristle_rate;
  forces.friction_power = forces.friction_force * forces.slip_speed;
  forces.force_on_journal = -forces.friction_force * tangent;
  forces.torque_on_journal = -forces.friction_force * gap.journal_lever;
  forces.torque_on_bearing = forces.friction_force * gap.bearing_lever;

  // Energy stored at one place of a worn surface is given back at another, where the same penetration holds another:
  // P_s = ∂U/∂ln R_r · d(ln R_r)/dt + ∂U/∂ln ΔR · d(ln ΔR)/dt      (Eq. C12)
  forces.surface_power =
      normal.energy_by_radius * gap.relative_radius_rate + normal.energy_by_clearance * gap.clearance_rate;
  if (contact.normal_direction == NormalDirection::gap_gradient) {
    // −F ∂δ/∂r_j, −F ∂δ/∂θ_i, −F ∂δ/∂θ_j      (Eq. C10)
    forces.force_on_journal -= normal.force * gap.gradient;
    forces.torque_on_bearing -= normal.force * gap.bearing_gradient;
    forces.torque_on_journal -= normal.force * gap.journal_gradient;
  } else {
    // −F n through the journal's centre (Eq. C11); about the bearing's point none where n is the line of centres.
    const double torque = normal.force * cross(motion.offset, gap.normal);
    forces.force_on_journal -= normal.force * gap.normal;
    forces.torque_on_bearing += torque;
    forces.surface_power +=
        torque * motion.bearing_rate - normal.force * (dot(gap.normal, motion.velocity) - gap.penetration_rate);
  }
}

ContactSlopes find_contact_slopes(const Contact& contact, const ContactMode& mode, double bristle,
                                  const ContactForces& forces) noexcept {
  // Of the penetration and of the onset speed: differences then have eight digits.
  constexpr double kShare = 1e-6;
  const double slip = kSlipShare * contact.slip_scale;
  const NormalContact at = make_normal_contact(contact, mode, forces.gap);
  NormalContact deeper = at;
  NormalContact faster = at;
  deeper.penetration *= 1.0 + kShare;
  faster.penetration_rate += kShare * at.onset_speed;
  const double coefficient = find_friction(contact.friction, forces.slip_speed, bristle).coefficient;
  const double next = find_friction(contact.friction, forces.slip_speed + slip, bristle).coefficient;
  return {(find_normal_force(contact, deeper).force - forces.normal_force) / (deeper.penetration - at.penetration),
          (find_normal_force(contact, faster).force - forces.normal_force) / (kShare * at.onset_speed), coefficient,
          (next - coefficient) / slip};
}

}  // namespace gudgeon
