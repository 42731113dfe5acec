// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// The integrator's vector against the workspace it is made of.
#include "gudgeon/sim/motion_equations.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "gudgeon/results/run_record.h"
#include "gudgeon/system/body_motion.h"
#include "tests/oracle/mechanisms.h"

namespace gudgeon {
namespace {

// A mechanism at its start, its journals pressed into their bearings and in contact.
struct Evaluated {
  explicit Evaluated(const Mechanism& mechanism)
      : assembly(assemble(mechanism)), system(compile(mechanism, assembly)), equations(system, {}) {
    const State state = make_state(system, assembly);
    y.assign(equations.size(), 0.0);
    slope.assign(equations.size(), std::nan(""));
    std::ranges::copy(state.q, y.begin());
    std::ranges::copy(state.v, y.begin() + static_cast<std::ptrdiff_t>(equations.n_free()));
    // Clearances of next to nothing: a small move of every coordinate is then a penetration.
    for (Contact& contact : system.tables.contacts) {
      if (auto* round = std::get_if<RevoluteSurfaces>(&contact.surfaces)) {
        round->journal_radius = round->bearing_radius - 1e-6;
      } else {
        auto& flat = std::get<GuideSurfaces>(contact.surfaces);
        flat.half_height -= find_clearance(mechanism.joints[contact.joint].kind) - 1e-6;
      }
    }
    for (ContactMode& mode : equations.contact_modes) mode = {true, 0.05};
    for (std::size_t i = 0; i < equations.n_free(); ++i) y[i] += 1e-4 * (1.0 + static_cast<double>(i % 3));
    eval();
  }

  void eval() { equations.eval(0.0, y.data(), slope.data()); }
  [[nodiscard]] double power(EnergyIntegral integral) const { return slope[equations.n_states() + integral]; }
  // Kinetic, potential and elastic energy.
  double find_energy() {
    BodyMotionFinder motion(system);
    return find_kinetic_energy(system.mechanism, motion.update(equations.workspace)) +
           find_potential_energy(system.tables, equations.workspace) + find_elastic_energy(equations.workspace);
  }
  // What gravity and constant loads deliver, from how their potential falls along the motion.
  [[nodiscard]] double find_load_power() const {
    constexpr double kStep = 1e-6;
    const auto potential = [&](double t) {
      std::vector<double> moved = y;
      for (std::size_t i = 0; i < equations.n_free(); ++i) moved[i] += t * y[equations.n_free() + i];
      Coordinates coordinates(system.tables.counts, system.tables.driven);
      update_coordinates(system.tables, t, moved.data(), moved.data() + equations.n_free(), coordinates);
      return find_potential_energy(system.tables, coordinates);
    };
    return (potential(-kStep) - potential(kStep)) / (2.0 * kStep);
  }

  Assembly assembly;
  System system;
  MotionEquations equations;
  std::vector<double> y;
  std::vector<double> slope;
};

TEST(MotionEquations, CoordinatesRatesAndIntegrals) {
  const Evaluated press(oracle::make_nine_bar());
  EXPECT_EQ(press.equations.n_free(), 5U) << "five angles";
  EXPECT_EQ(press.equations.size(), 10U + kEnergyIntegrals);
  EXPECT_EQ(press.equations.contact_modes.size(), 2U);
  EXPECT_EQ(Evaluated(oracle::make_free_pair()).equations.n_free(), 6U);
  EXPECT_EQ(Evaluated(make_ideal(oracle::make_nine_bar())).equations.contact_modes.size(), 0U);
}

TEST(MotionEquations, SlopesAreRatesAccelerationsAndPowers) {
  for (const Mechanism& mechanism : oracle::make_all_mechanisms()) {
    const Evaluated at(mechanism);
    const Workspace& ws = at.equations.workspace;
    const std::size_t n = at.equations.n_free();
    for (std::size_t i = 0; i < n; ++i) {
      EXPECT_EQ(at.slope[i], at.y[n + i]) << mechanism.name;
      EXPECT_EQ(at.slope[n + i], ws.equations[i]) << mechanism.name;
    }
    double driver = 0.0;
    for (std::size_t d = 0; d < ws.effort.size(); ++d) driver += ws.effort[d] * ws.coordinates.driven[d].rate;
    double damping = 0.0;
    double friction = 0.0;
    double surface = 0.0;
    for (const ContactGroup& group : at.system.tables.contact_groups) {
      double pressed = 0.0;  // not on every side of a slot at once
      for (int k = group.first_contact; k < group.end_contact; ++k) pressed += ws.contact_forces[k].normal_force;
      EXPECT_GT(pressed, 0.0) << mechanism.name << ": the test wants contact";
    }
    for (const ContactForces& forces : ws.contact_forces) {
      damping += forces.damping_power;
      friction += forces.friction_power;
      surface += forces.surface_power;
    }
    EXPECT_EQ(at.power(kDriverWork), driver) << mechanism.name;
    EXPECT_EQ(at.power(kContactDamping), damping) << mechanism.name;
    EXPECT_EQ(at.power(kFrictionLoss), friction) << mechanism.name;
    EXPECT_EQ(at.power(kSurfaceWork), surface) << mechanism.name;
    EXPECT_NEAR(ws.loads.constant_power, at.find_load_power(), 1e-7 * std::max(std::abs(driver), 1.0));
    const double exchanged = std::abs(driver) + std::abs(at.find_load_power()) + std::abs(damping) + friction;
    // 1e-7: what central differences lose of some ten joules.
    EXPECT_NEAR(at.power(kExchanged), exchanged, 1e-7 * std::max(exchanged, 1.0)) << mechanism.name;
  }
}

// Along the flow the energy changes by the powers, worn surfaces and all.
TEST(MotionEquations, PowersBalanceTheChangeOfEnergy) {
  std::vector<Mechanism> mechanisms = oracle::make_loaded_mechanisms();
  mechanisms.insert(mechanisms.end(), {oracle::make_slider_crank_clearance(), oracle::make_free_body_in_bearing(),
                                       oracle::make_free_pair(), oracle::make_driven_slide()});
  for (const Mechanism& mechanism : mechanisms) {
    Evaluated at(mechanism);
    if (!at.system.tables.closures.empty()) continue;  // moved off its closures, which then do work
    for (std::size_t k = 0; k < at.system.tables.contacts.size(); ++k) {
      set_surfaces(at.system, k, std::vector{1e-7, 3e-7, 2e-7, 0.0, 1e-7, 2e-7}, {});
    }
    at.eval();
    const double expected = at.power(kDriverWork) + at.power(kLoadWork) - at.power(kDamperLoss) -
                            at.power(kContactDamping) - at.power(kFrictionLoss) + at.power(kSurfaceWork);
    const double exchanged = at.power(kExchanged) + std::abs(at.power(kSurfaceWork));
    const std::vector<double> y = at.y;
    const std::vector<double> slope = at.slope;
    const double dt = 1e-9;  // central difference: rounding 1e-16/1e-9 and curvature stay below 1e-5 of the powers
    const auto energy_after = [&](double t) {
      for (std::size_t i = 0; i < y.size(); ++i) at.y[i] = y[i] + t * slope[i];
      at.equations.eval(t, at.y.data(), at.slope.data());
      return at.find_energy();
    };
    const double rate = (energy_after(dt) - energy_after(-dt)) / (2.0 * dt);
    EXPECT_NEAR(rate, expected, 1e-5 * exchanged) << mechanism.name;
  }
}

// From the bodies' own motion, with the signs of the energy balance.
TEST(MotionEquations, ResidualIsWhatTheEnergyBalanceIsOffBy) {
  for (const Mechanism& mechanism : oracle::make_all_mechanisms()) {
    Evaluated at(mechanism);
    const double energy = at.find_energy();
    EXPECT_NEAR(at.equations.find_energy(), energy, 1e-12 * (1.0 + std::abs(energy))) << mechanism.name;
    EnergyBalance balance;
    balance.kinetic = energy;
    balance.initial_energy = at.equations.initial_energy = 0.25 * energy + 3.0;
    double* integral = at.y.data() + at.equations.n_states();
    balance.driver_work = integral[kDriverWork] = 1.0;
    balance.load_work = integral[kLoadWork] = 20.0;
    balance.damper_loss = integral[kDamperLoss] = 300.0;
    balance.contact_damping = integral[kContactDamping] = 4e3;
    balance.friction = integral[kFrictionLoss] = 5e4;
    balance.surface_work = integral[kSurfaceWork] = 6e5;
    integral[kExchanged] = 7e6;
    const double rounding = 1e-12 * (1e6 + std::abs(energy));
    EXPECT_NEAR(at.equations.find_residual(at.y.data()), balance.residual(), rounding) << mechanism.name;
  }
}

TEST(MotionEquations, SampleIsTheContactInItsBodies) {
  const Evaluated at(oracle::make_nine_bar());
  for (std::size_t k = 0; k < 2; ++k) {
    const ContactSample sample = at.equations.find_sample(k);
    const ContactForces& forces = at.equations.workspace.contact_forces[k];
    EXPECT_EQ(sample.normal, forces.gap.normal);
    EXPECT_EQ(sample.bearing_radius, forces.gap.bearing_radius);
    EXPECT_EQ(sample.journal_radius, forces.gap.journal_radius);
    EXPECT_EQ(sample.penetration, forces.gap.penetration);
    EXPECT_EQ(sample.normal_force, forces.normal_force);
    EXPECT_EQ(sample.slip_speed, forces.slip_speed);
    BodyMotionFinder finder(at.system);
    const auto& motions = finder.update(at.equations.workspace);
    const std::string bearing = k == 0 ? "crank_1" : "crank_4";
    const std::string journal = k == 0 ? "rod_2" : "rod_3";
    EXPECT_DOUBLE_EQ(sample.bearing_angle, motions[find_body(at.system.mechanism, bearing)].angle);
    EXPECT_DOUBLE_EQ(sample.journal_angle, motions[find_body(at.system.mechanism, journal)].angle);
  }
}

TEST(MotionEquations, OpenContactsHaveNeitherForceNorPower) {
  Evaluated at(oracle::make_nine_bar());
  at.equations.contact_modes.assign(2, {});
  at.eval();
  EXPECT_EQ(at.power(kContactDamping), 0.0);
  EXPECT_EQ(at.power(kFrictionLoss), 0.0);
  EXPECT_EQ(at.power(kSurfaceWork), 0.0);
  EXPECT_EQ(at.equations.find_sample(0).normal_force, 0.0);
}

}  // namespace
}  // namespace gudgeon
