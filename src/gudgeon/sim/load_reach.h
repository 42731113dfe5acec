// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// What rounding of places is worth as energy.
#pragma once

#include "gudgeon/base/state_archive.h"
#include "gudgeon/model/mechanism.h"
#include "gudgeon/system/workspace.h"

namespace gudgeon {

/// Follows R = (Σ|F| + Σ m|g|) L + Σ|M| [J] of all loads and weights, with the characteristic length L: their work over
/// the size of the mechanism. Energies are known to a rounding of it, wherever the origin is and however little moves.
class LoadReach {
 public:
  explicit LoadReach(const Mechanism& mechanism);

  /// Loads as they are at an evaluated state.
  void note(const Workspace& workspace) noexcept;
  [[nodiscard]] double largest() const { return largest_; }

  void transfer(StateArchive& archive) { archive(largest_); }

 private:
  double length_;   // [m]
  double weights_;  // [J]
  double largest_;  // [J]
};

}  // namespace gudgeon
