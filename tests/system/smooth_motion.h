// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Smooth motions of all turns and slides of a tree, closed or not, to take finite differences along.
#pragma once

#include <cmath>
#include <random>

#include "gudgeon/system/coordinates.h"

namespace gudgeon {

/// Every coordinate, free or driven, is its own mean + swing sin(w t + p); the frame and the unit slide stay.
class SmoothMotion {
 public:
  SmoothMotion(const CoordinateCounts& counts, unsigned seed) : counts_(counts) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> uniform(-1.0, 1.0);
    for (int k = 0; k < counts.n_turns() + counts.n_slides(); ++k) {
      waves_.push_back({2.0 * uniform(random), 0.6 + 0.3 * uniform(random), 3.0 * uniform(random), uniform(random)});
    }
  }

  [[nodiscard]] Coordinates eval(double t) const {
    Coordinates at(counts_);
    for (int k = 0; k < counts_.frame_turn(); ++k) {
      at.angle[k] = waves_[k].value(t);
      at.angle_rate[k] = waves_[k].rate(t);
      at.rotation[k] = make_rotation(at.angle[k]);
    }
    for (int k = 0; k < counts_.unit_slide(); ++k) {
      at.slide[k] = slide_wave(k).value(t);
      at.slide_rate[k] = slide_wave(k).rate(t);
    }
    return at;
  }

  [[nodiscard]] std::vector<double> find_angle_accelerations(double t) const {
    std::vector<double> accelerations(counts_.n_turns(), 0.0);
    for (int k = 0; k < counts_.frame_turn(); ++k) accelerations[k] = waves_[k].acceleration(t);
    return accelerations;
  }

  [[nodiscard]] std::vector<double> find_slide_accelerations(double t) const {
    std::vector<double> accelerations(counts_.n_slides(), 0.0);
    for (int k = 0; k < counts_.unit_slide(); ++k) accelerations[k] = slide_wave(k).acceleration(t);
    return accelerations;
  }

 private:
  struct Wave {
    double mean;
    double swing;
    double frequency;
    double phase;
    [[nodiscard]] double value(double t) const { return mean + swing * std::sin(frequency * t + phase); }
    [[nodiscard]] double rate(double t) const { return swing * frequency * std::cos(frequency * t + phase); }
    [[nodiscard]] double acceleration(double t) const {
      return -swing * frequency * frequency * std::sin(frequency * t + phase);
    }
  };

  [[nodiscard]] const Wave& slide_wave(int k) const { return waves_[counts_.n_turns() + k]; }

  CoordinateCounts counts_;
  std::vector<Wave> waves_;
};

}  // namespace gudgeon
