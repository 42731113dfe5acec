// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Motion of all bodies against finite differences of the coordinates, and the energies: values, and where they go.
#include "gudgeon/system/body_motion.h"

#include <gtest/gtest.h>

#include <random>

#include "gudgeon/system/dynamics.h"
#include "tests/oracle/mechanisms.h"

namespace gudgeon {
namespace {

// A compiled mechanism at its start, its journals pushed into their bearings, and the time path through that state.
class PressedMechanism {
 public:
  PressedMechanism(const Mechanism& mechanism, bool worn, NormalDirection direction)
      : system(compile(mechanism, assemble(mechanism))), workspace(system.tables), finder(system) {
    state_ = make_state(system, assemble(mechanism));
    contact_modes_.assign(system.tables.contacts.size(), {true, 0.07});
    for (std::size_t k = 0; k < contact_modes_.size(); ++k) {
      system.tables.contacts[k].normal_direction = direction;
      if (worn) set_surfaces(system, k, make_wear(20), make_wear(26));
    }
    const CoordinateCounts& counts = system.tables.counts;
    if (mechanism.name == "nine_bar") {
      // Bars of 326 and 497 mm whose journals move by 0.7 mm.
      state_.q[system.topology.bodies[find_body(mechanism, "rod_2")].turn] += 0.7 / 326.0;
      state_.q[system.topology.bodies[find_body(mechanism, "rod_3")].turn] -= 0.7 / 497.0;
    } else if (!contact_modes_.empty() && counts.n_free_slides == 0) {
      state_.q[0] += 2.5e-3;  // a rod of 250 mm
    } else if (!contact_modes_.empty()) {
      state_.q[counts.n_free_turns] += 0.6e-3;
      if (!system.topology.loose.empty()) state_.q[counts.n_free_turns + 1] += 0.15e-3;
    }
    eval(0.0);
    accelerations_.assign(workspace.equations.begin(), workspace.equations.begin() + counts.n_free());
  }

  // Moves t away from the start along q + v t + a t²/2 and evaluates there.
  const std::vector<BodyMotion>& eval(double t) {
    State state = state_;
    for (std::size_t k = 0; k < accelerations_.size(); ++k) {
      state.q[k] += t * state.v[k] + 0.5 * t * t * accelerations_[k];
      state.v[k] += t * accelerations_[k];
    }
    eval_dynamics(system.tables, t, state.q.data(), state.v.data(), contact_modes_, {}, workspace);
    return finder.update(workspace);
  }

  double find_energy(double t) {
    const double kinetic = find_kinetic_energy(system.mechanism, eval(t));
    return kinetic + find_potential_energy(system.tables, workspace.coordinates) + find_elastic_energy(workspace);
  }

  System system;
  Workspace workspace;
  BodyMotionFinder finder;

 private:
  static std::vector<double> make_wear(std::size_t n) {
    std::mt19937 random(static_cast<unsigned>(n));
    std::uniform_real_distribution<double> uniform(0.0, 3e-5);
    std::vector<double> depths(n);
    for (double& depth : depths) depth = uniform(random);
    return depths;
  }

  State state_;
  std::vector<ContactMode> contact_modes_;
  std::vector<double> accelerations_;
};

TEST(BodyMotion, VelocitiesAndAccelerationsAreDerivatives) {
  for (const Mechanism& mechanism : oracle::make_all_mechanisms()) {
    PressedMechanism pressed(mechanism, false, NormalDirection::gap_gradient);
    // Speeds up to 1e3 rad/s in the driven slider-crank; hard contacts give accelerations up to 1e6.
    constexpr double kStep = 1e-7;
    const auto before = pressed.eval(-kStep);
    const auto after = pressed.eval(kStep);
    const auto at = pressed.eval(0.0);
    for (std::size_t b = 0; b < at.size(); ++b) {
      const std::string name = mechanism.name + "." + mechanism.bodies[b].name;
      const Vec2 velocity = (0.5 / kStep) * (after[b].position - before[b].position);
      const Vec2 acceleration = (0.5 / kStep) * (after[b].velocity - before[b].velocity);
      // Rounding of positions and velocities over the step, and the step squared times the third derivatives.
      EXPECT_NEAR(norm(at[b].velocity - velocity), 0.0, 1e-8 + 1e-8 * norm(at[b].acceleration)) << name;
      EXPECT_NEAR(norm(at[b].acceleration - acceleration), 0.0, 1e-6 + 1e-6 * norm(at[b].acceleration)) << name;
      EXPECT_NEAR(at[b].angle_rate, (after[b].angle - before[b].angle) * 0.5 / kStep, 1e-7) << name;
      EXPECT_NEAR(at[b].angle_acceleration, (after[b].angle_rate - before[b].angle_rate) * 0.5 / kStep,
                  1e-6 + 1e-6 * std::abs(at[b].angle_acceleration))
          << name;
    }
  }
}

// d/dt (T + V + U) = drivers + surfaces − damping − friction.
void expect_energy_balance(const Mechanism& mechanism, bool worn, NormalDirection direction) {
  PressedMechanism pressed(mechanism, worn, direction);
  constexpr double kStep = 1e-8;
  const double stored = (pressed.find_energy(kStep) - pressed.find_energy(-kStep)) / (2.0 * kStep);
  const double energy = pressed.find_energy(0.0);
  double expected = find_driver_power(pressed.workspace);
  double scale = std::abs(expected);
  for (const ContactForces& forces : pressed.workspace.contact_forces) {
    EXPECT_GT(forces.normal_force, 0.0) << mechanism.name;
    expected += forces.surface_power - forces.damping_power - forces.friction_power;
    scale += forces.normal_force * std::abs(forces.gap.penetration_rate) + std::abs(forces.surface_power) +
             forces.friction_power;
  }
  // The step squared times contact frequencies squared (5e4 rad/s), and rounding of the energy over the step.
  EXPECT_NEAR(stored, expected, 1e-6 * scale + 1e-15 * std::abs(energy) / kStep) << mechanism.name;
}

TEST(BodyMotion, EnergyGoesWhereTheContactsSay) {
  for (const Mechanism& mechanism : {oracle::make_nine_bar(), oracle::make_free_pair(),
                                     oracle::make_free_body_in_bearing(), oracle::make_slider_crank_clearance()}) {
    expect_energy_balance(mechanism, false, NormalDirection::gap_gradient);
    expect_energy_balance(mechanism, true, NormalDirection::gap_gradient);
    expect_energy_balance(mechanism, true, NormalDirection::eccentricity);
  }
}

TEST(BodyMotion, PotentialEnergyIsMinusTheWorkOfWeightsAndLoads) {
  for (Mechanism mechanism : oracle::make_all_mechanisms()) {
    mechanism.loads.push_back({"twist", ConstantTorque{mechanism.bodies[1].name, 0.37}});
    PressedMechanism pressed(mechanism, false, NormalDirection::gap_gradient);
    const auto& motions = pressed.eval(0.0);
    double expected = 0.0;
    for (std::size_t b = 1; b < motions.size(); ++b) {
      expected -= mechanism.bodies[b].mass * dot(mechanism.gravity, motions[b].position);
    }
    for (const Load& load : mechanism.loads) {
      if (const auto* torque = std::get_if<ConstantTorque>(&load.kind)) {
        const BodyNode& node = pressed.system.topology.bodies[find_body(mechanism, torque->body)];
        expected -= torque->torque * pressed.workspace.coordinates.angle[node.turn];
        continue;
      }
      const auto& force = std::get<ConstantForce>(load.kind);
      const int b = find_body(mechanism, force.point.body);
      const Body& body = mechanism.bodies[b];
      const Vec2 arm = find_point(body, force.point.point)->position - body.center_of_mass;
      expected -= dot(force.force, motions[b].position + make_rotation(motions[b].angle) * arm);
    }
    EXPECT_NEAR(find_potential_energy(pressed.system.tables, pressed.workspace.coordinates), expected,
                1e-13 * (1.0 + std::abs(expected)))  // rounding of a sum
        << mechanism.name;
  }
}

TEST(BodyMotion, KineticEnergyCountsMassAndInertia) {
  Mechanism mechanism = oracle::make_rigid_chain();
  std::vector<BodyMotion> motions(mechanism.bodies.size());
  motions[0].velocity = {9.0, 9.0};  // the frame does not count
  motions[1].velocity = {3.0, 4.0};
  motions[2].angle_rate = -10.0;
  EXPECT_DOUBLE_EQ(find_kinetic_energy(mechanism, motions), 0.5 * 0.9 * 25.0 + 0.5 * 0.004 * 100.0);
}

}  // namespace
}  // namespace gudgeon
