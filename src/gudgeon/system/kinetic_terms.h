// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Mass, inertia and constant loads of all bodies, summed over the terms that their centres of mass share.
#pragma once

#include <array>
#include <map>
#include <vector>

#include "gudgeon/system/topology.h"

namespace gudgeon {

/// Which coordinates a term moves with.
struct TermKey {
  int turn;
  int slide;
  friend auto operator<=>(const TermKey&, const TermKey&) = default;
};

/// Dot and cross product of two vectors, summed over bodies with a weight.
struct Products {
  double dot = 0.0;
  double cross = 0.0;

  void add(double weight, Vec2 a, Vec2 b) {
    dot += weight * gudgeon::dot(a, b);
    cross += weight * gudgeon::cross(a, b);
  }
};

struct KineticTerms {
  std::map<std::array<TermKey, 2>, Products> pairs;  ///< mass-weighted, first key <= second
  std::vector<double> turn_inertia;                  ///< Σ I [kg m^2], one a turn
  std::map<TermKey, Products> fields;                ///< a with gravity and constant forces
  std::vector<double> turn_torque;                   ///< constant torques [N m], one a turn
};

KineticTerms sum_kinetic_terms(const Mechanism& mechanism, const Topology& topology);

/// A path with terms of the same turn and slide added up, in the order of the keys.
std::map<TermKey, Vec2> merge_terms(const Path& path);

}  // namespace gudgeon
