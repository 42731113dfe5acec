// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// The ordinary differential equations that the integrator sees: coordinates, rates, and integrals carried along.
#pragma once

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include "gudgeon/base/state_archive.h"
#include "gudgeon/system/body_motion.h"
#include "gudgeon/system/dynamics.h"
#include "gudgeon/system/system.h"

namespace gudgeon {

/// The integrals of power [J] that stand behind coordinates, rates and bristles in the integrator's vector.
enum EnergyIntegral : int {
  kDriverWork,
  kLoadWork,
  kDamperLoss,
  kContactDamping,
  kFrictionLoss,
  kSurfaceWork,
  kExchanged,
  kEnergyIntegrals
};

/// What wear needs to know of one contact at one stage of a step.
struct ContactSample {
  Vec2 normal;
  double bearing_angle = 0.0;
  double journal_angle = 0.0;
  double bearing_radius = 0.0;
  double journal_radius = 0.0;
  double bearing_position = 0.0;  ///< [m] along a slot
  int bearing_surface = 0;
  int journal_surface = 0;
  double penetration = 0.0;
  double normal_force = 0.0;
  double slip_speed = 0.0;
  double friction_force = 0.0;
  double bearing_depth = 0.0;
  double journal_depth = 0.0;
};

/// y = [q | v | bristles | energy integrals] and ẏ. Holds the contact modes and the workspace of one run.
class MotionEquations {
 public:
  MotionEquations(const System& system, Feedback feedback)
      : contact_modes(system.tables.contacts.size()),
        workspace(system.tables),
        tables_(&system.tables),
        n_free_(static_cast<std::size_t>(system.tables.counts.n_free())),
        n_bristles_(static_cast<std::size_t>(system.tables.n_bristles)),
        feedback_(feedback),
        acceleration_(n_free_),
        moved_(2 * n_free_) {}
  MotionEquations(const System&&, Feedback) = delete;  // it keeps a reference

  [[nodiscard]] const Tables& tables() const { return *tables_; }
  [[nodiscard]] std::size_t n_free() const { return n_free_; }
  /// Coordinates, rates and bristles: what the motion depends on; the integrals begin behind them.
  [[nodiscard]] std::size_t n_states() const { return 2 * n_free_ + n_bristles_; }
  [[nodiscard]] std::size_t size() const { return n_states() + kEnergyIntegrals; }
  /// Where the deflection of a contact's bristle is in y; the contact must have one.
  [[nodiscard]] std::size_t bristle_at(std::size_t contact) const {
    return 2 * n_free_ + static_cast<std::size_t>(tables_->contacts[contact].bristle);
  }

  void eval(double t, const double* y, double* slope) noexcept {
    const double* v = y + n_free_;
    eval_in(t, y, workspace);
    for (std::size_t i = 0; i < n_free_; ++i) {
      slope[i] = v[i];
      slope[n_free_ + i] = workspace.equations[i];
    }
    for (std::size_t k = 0; n_bristles_ > 0 && k < workspace.contact_forces.size(); ++k) {
      if (tables_->contacts[k].bristle >= 0) slope[bristle_at(k)] = workspace.contact_forces[k].bristle_rate;
    }
    for (std::size_t k = 0; n_bristles_ > 0 && k < workspace.friction_forces.size(); ++k) {
      const int bristle = tables_->friction_joints[k].bristle;
      if (bristle >= 0)
        slope[2 * n_free_ + static_cast<std::size_t>(bristle)] = workspace.friction_forces[k].bristle_rate;
    }
    eval_powers(slope + n_states());
  }

  /// Evaluates any workspace with the pieces that it holds of the loads' formulas.
  void eval_in(double t, const double* y, Workspace& target) noexcept { eval_in(t, y, contact_modes, target); }
  /// The same with the contact modes of that time.
  void eval_in(double t, const double* y, std::span<const ContactMode> modes, Workspace& target) noexcept {
    load_bristles(y, target);
    if (target.loads.held.n_slides > 0) {
      eval_sliding(t, y, modes, target);
    } else {
      eval_dynamics(*tables_, t, y, y + n_free_, modes, feedback_, target);
    }
  }

  /// What a look at the gaps needs of y.
  void update_coordinates(double t, const double* y) noexcept {
    gudgeon::update_coordinates(*tables_, t, y, y + n_free_, workspace.coordinates);
  }

  /// Sets the bristles of any workspace from y.
  void load_bristles(const double* y, Workspace& target) const noexcept {
    std::copy_n(y + 2 * n_free_, n_bristles_, target.bristles.begin());
  }

  /// The rates of the energy integrals, from the last evaluation.
  void eval_powers(double* power) const noexcept {
    power[kDriverWork] = find_driver_power(workspace);
    power[kLoadWork] = workspace.loads.work_power;
    power[kDamperLoss] = workspace.loads.damper_power;
    power[kContactDamping] = power[kFrictionLoss] = power[kSurfaceWork] = 0.0;
    for (const ContactForces& forces : workspace.contact_forces) {
      power[kContactDamping] += forces.damping_power;
      power[kFrictionLoss] += forces.friction_power;
      power[kSurfaceWork] += forces.surface_power;
    }
    for (const FrictionForces& forces : workspace.friction_forces) power[kFrictionLoss] += forces.power;
    const double potential = workspace.loads.constant_power - workspace.loads.storing_power;
    power[kExchanged] = std::abs(power[kDriverWork]) + std::abs(potential) + std::abs(power[kLoadWork]) +
                        power[kDamperLoss] + std::abs(power[kContactDamping]) + std::abs(power[kFrictionLoss]);
  }

  /// Kinetic, potential and elastic energy [J] of the last evaluation.
  [[nodiscard]] double find_energy() const noexcept {
    return find_kinetic_energy(*tables_, workspace.coordinates) + find_potential_energy(*tables_, workspace) +
           find_elastic_energy(workspace);
  }

  /// What the energy balance is off by [J], Eq. E1; y's states must be those of the last evaluation.
  [[nodiscard]] double find_residual(const double* y) const noexcept {
    const double* integral = y + n_states();
    const double given = integral[kDriverWork] + integral[kLoadWork] + integral[kSurfaceWork];
    const double lost = integral[kDamperLoss] + integral[kContactDamping] + integral[kFrictionLoss];
    return find_energy() - initial_energy - given + lost;
  }

  /// The last evaluation's contact, as wear sees it.
  [[nodiscard]] ContactSample find_sample(std::size_t k) const noexcept {
    const Contact& contact = tables_->contacts[k];
    const ContactForces& forces = workspace.contact_forces[k];
    return {forces.gap.normal,
            workspace.coordinates.angle[contact.bearing_turn] + contact.bearing_offset,
            workspace.coordinates.angle[contact.journal_turn] + contact.journal_offset,
            forces.gap.bearing_radius,
            forces.gap.journal_radius,
            forces.gap.bearing_position,
            contact.bearing_surface,
            contact.journal_surface,
            forces.gap.penetration,
            forces.normal_force,
            forces.slip_speed,
            forces.friction_force,
            forces.gap.bearing_depth,
            forces.gap.journal_depth};
  }

  /// How fast the arguments of breaks of formulas change [1/s], with the accelerations that the workspace was last
  /// evaluated with, at this state. It keeps no more than the pieces it holds.
  void find_argument_rates(double t, const double* y, std::span<const int> breaks, Workspace& target,
                           double* rates) noexcept;

  void transfer(StateArchive& archive) { archive(contact_modes, workspace, initial_energy); }

  /// A motion slides along so many breaks at once.
  static constexpr int kMostSlides = 8;

  std::vector<ContactMode> contact_modes;
  Workspace workspace;
  double initial_energy = 0.0;  ///< [J] where the integrals are zero
  double time_scale = 1.0;      ///< [s] of a cycle

 private:
  void eval_sliding(double t, const double* y, std::span<const ContactMode> modes, Workspace& target) noexcept;
  void update_arguments(double t, const double* q, const double* v, Workspace& target) noexcept;

  const Tables* tables_;
  std::size_t n_free_;
  std::size_t n_bristles_;
  Feedback feedback_;
  std::vector<double> acceleration_;  // of one side of a break
  std::vector<double> moved_;         // coordinates and rates beside a state
};

}  // namespace gudgeon
