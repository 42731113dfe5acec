// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Numbers that a driven mechanism has at a time, and the times at which they are special.
#pragma once

#include <functional>

#include "gudgeon/results/kinematic_record.h"
#include "gudgeon/system/kinematics.h"
#include "gudgeon/system/slide_motion.h"

namespace gudgeon {

/// Looks at the current point of a solver, and at points near it.
class MotionProbe {
 public:
  MotionProbe(KinematicSolver& solver, int driver);

  /// Takes over the solver's current point.
  void update() { motion_.update(solver_->workspace()); }

  /// A coordinate that may turn back: the angle of a body or the displacement of a joint with a line.
  struct Coordinate {
    int body = -1;
    int joint = -1;
  };
  /// Every angle that no driver prescribes and every line, each once.
  [[nodiscard]] std::vector<Coordinate> list_coordinates() const;
  [[nodiscard]] double find_value(Coordinate coordinate) const;
  [[nodiscard]] double find_rate(Coordinate coordinate) const;
  [[nodiscard]] SlideMotion find_slide(int joint) const;
  [[nodiscard]] double find_driver_value(int driver) const;
  /// Transmission angle, or pressure angle, of a dyad [rad].
  [[nodiscard]] double find_transmission(const LoopFold& fold) const;
  [[nodiscard]] DriverTime find_time() const;

  /// The sine of a loop's fold; its sign names the branch.
  [[nodiscard]] double find_fold(const LoopFold& fold) const;

  /// A number that the probe finds at the point where it is.
  using Quantity = std::function<double()>;
  /// Follows the motion from `low` to the time in (low, high] at which a quantity changes its sign, and stays there.
  /// False when the motion cannot be followed.
  bool move_to_zero(const Quantity& quantity, const MotionPoint& low, double high);
  /// Follows the motion from `low` to the time up to `high` at which sign × transmission is least, and stays there.
  bool move_to_least_transmission(const LoopFold& fold, double sign, const MotionPoint& low, double high);

 private:
  bool move_to(const MotionPoint& from, double time);

  KinematicSolver* solver_;
  int driver_;
  BodyMotionFinder motion_;
};

}  // namespace gudgeon
