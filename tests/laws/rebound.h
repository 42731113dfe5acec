// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// A mass that hits a contact law and comes back, integrated in time: the oracle for every closed form of an impact.
#pragma once

#include <algorithm>
#include <array>
#include <limits>

#include "gudgeon/laws/normal/normal.h"

namespace gudgeon {

struct Rebound {
  double restitution = 0.0;       ///< e_out [1]
  double peak_penetration = 0.0;  ///< δ_max [m]
  double peak_force = 0.0;        ///< [N]
  double duration = 0.0;          ///< [s] until δ is zero again
};

/// Radii, stiffness and modulus of a contact; its motion is filled in.
inline constexpr NormalContact kReboundContact{0.0, 0.0, 3.0, 1e6, 0.0, 15e-3, 14e-3, 20e-3, 1.1e11};
inline constexpr double kReboundMass = 2.0;  ///< [kg], hits at 3 m/s

template <class Law>
Rebound run_rebound(const Law& law) {
  NormalContact contact = kReboundContact;
  contact.damping_factor = law.damping_factor();
  // Where the elastic force has taken all of the energy: the scale of the motion.
  double low = 0.0;
  double high = 1.0;
  while (high - low > 1e-3 * high) {
    contact.penetration = 0.5 * (low + high);
    const bool short_of = law(contact).elastic_energy < 0.5 * kReboundMass * contact.onset_speed * contact.onset_speed;
    (short_of ? low : high) = contact.penetration;
  }
  const double step = high / contact.onset_speed / 2000.0;  // errors fall with its fourth power, by exit its square
  const auto find_rates = [&](std::array<double, 2> state) -> std::array<double, 2> {
    contact.penetration = state[0];
    contact.penetration_rate = state[1];
    return {state[1], -law(contact).force / kReboundMass};
  };
  // Just inside, where a force that starts with a step has it.
  std::array<double, 2> state{1e-12 * high, contact.onset_speed};
  std::array<double, 2> before{};
  Rebound rebound;
  double time = 0.0;
  for (int i = 0; i < 1000000 && (i == 0 || state[0] > 0.0); ++i, time += step) {  // far more than any needs
    before = state;
    const auto moved = [&](const std::array<double, 2>& rates, double by) -> std::array<double, 2> {
      return {before[0] + by * rates[0], before[1] + by * rates[1]};
    };
    const auto k1 = find_rates(before);
    const auto k2 = find_rates(moved(k1, 0.5 * step));
    const auto k3 = find_rates(moved(k2, 0.5 * step));
    const auto k4 = find_rates(moved(k3, step));
    for (std::size_t j = 0; j < 2; ++j) state[j] += step / 6.0 * (k1[j] + 2.0 * (k2[j] + k3[j]) + k4[j]);
    rebound.peak_penetration = std::max(rebound.peak_penetration, state[0]);
    rebound.peak_force = std::max(rebound.peak_force, -kReboundMass * k1[1]);
  }
  if (!(state[0] <= 0.0)) return {std::numeric_limits<double>::quiet_NaN()};
  rebound.restitution = -state[1] / contact.onset_speed;
  rebound.duration = time - step * state[0] / (state[0] - before[0]);
  return rebound;
}

}  // namespace gudgeon
