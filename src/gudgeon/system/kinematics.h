// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Motion that the drivers prescribe completely, followed from position to position, and the efforts it takes.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "gudgeon/system/loop_folds.h"
#include "gudgeon/system/row_choice.h"
#include "gudgeon/system/system.h"
#include "gudgeon/system/workspace.h"

namespace gudgeon {

/// Why a motion cannot be followed further.
struct MotionFailure {
  enum class Kind {
    singular,      ///< two branches meet: the drivers do not say how it goes on
    out_of_reach,  ///< the drivers ask for more than the joints permit
    lost_load,     ///< a load has no finite value
    jammed,        ///< friction of an ideal joint has no solution, or no single one
  };
  Kind kind = Kind::singular;
  double time = 0.0;  ///< [s]
  std::string where;  ///< "joint 'A'", "driver 'elbow'": what closes the loop nearest to it; or "load 'press'"
};

/// Positions, velocities and accelerations at one time.
struct MotionPoint {
  double time = 0.0;      ///< [s]
  std::vector<double> q;  ///< free coordinates [rad, m]
  std::vector<double> v;
  std::vector<double> a;
};

/// Follows the motion of the ideal mechanism from its start, step by step, so that every loop keeps its branch.
class KinematicSolver {
 public:
  /// Throws ModelError as assemble() does, and when drivers leave degrees of freedom or contradict each other.
  explicit KinematicSolver(const Mechanism& mechanism);
  KinematicSolver(const KinematicSolver&) = delete;
  KinematicSolver& operator=(const KinematicSolver&) = delete;

  [[nodiscard]] const System& system() const { return system_; }
  [[nodiscard]] const LoopFolds& folds() const { return folds_; }
  /// Evaluated at the current point: accelerations, forces of the closures, efforts of the drivers.
  [[nodiscard]] Workspace& workspace() { return workspace_; }
  [[nodiscard]] const MotionPoint& point() const { return point_; }
  /// Set when the start is singular or the last move did not arrive.
  [[nodiscard]] const std::optional<MotionFailure>& failure() const { return failure_; }

  /// Follows the motion to another time; false when it cannot be followed, the point being the last one reached.
  bool move_to(double time);
  /// Goes back to a point that was reached before.
  void return_to(const MotionPoint& point);

 private:
  bool try_step(double time);
  bool close_nearby(double time);
  [[nodiscard]] bool has_kink();
  [[nodiscard]] bool closes_beyond(double direction);
  bool close_loops();
  bool find_motion();
  void evaluate_point();
  void choose_rows();
  void update(double time);
  [[nodiscard]] double find_orientation() const;
  [[nodiscard]] double find_largest_rate(const MotionPoint& point) const;
  [[nodiscard]] double find_unit(std::size_t coordinate) const;
  void fail(MotionFailure::Kind kind);

  System system_;
  LoopFolds folds_;
  Workspace workspace_;
  std::optional<RowChoice> row_choice_;  // where constraints imply each other
  MotionPoint point_;
  MotionPoint next_;
  double size_ = 1.0;         // longest vector of any closure [m]
  double orientation_ = 0.0;  // sign of the closures' determinant, kept along the whole motion
  std::optional<MotionFailure> failure_;
};

}  // namespace gudgeon
