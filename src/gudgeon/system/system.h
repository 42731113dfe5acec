// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// A compiled mechanism: constant while it runs, shared by any number of threads.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "gudgeon/model/mechanism.h"
#include "gudgeon/system/assembly.h"
#include "gudgeon/system/tables.h"

namespace gudgeon {

/// Free coordinates and their rates: turns [rad, rad/s], then slides [m, m/s].
struct State {
  std::vector<double> q;
  std::vector<double> v;
};

struct System {
  Mechanism mechanism;
  Topology topology;
  Tables tables;
};

/// Compiles a mechanism. Redundant closure rows, found at the given poses, are measured but not enforced.
/// Throws ModelError when drivers and joints contradict each other.
System compile(const Mechanism& mechanism, const Assembly& assembly);

/// The state that puts every body where the assembly has it.
State make_state(const System& system, const Assembly& assembly);

/// Replaces the worn surfaces of one contact group, between stages: depths [m] a cell, surface after surface. None at
/// all leaves a body's surfaces unworn.
void set_surfaces(System& system, std::size_t group, std::span<const double> bearing_depths,
                  std::span<const double> journal_depths);

}  // namespace gudgeon
