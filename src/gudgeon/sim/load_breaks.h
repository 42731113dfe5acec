// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Where, along a motion, loads and drivers go from one piece of a formula or curve to the next.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "gudgeon/results/run_record.h"
#include "gudgeon/sim/dense_step.h"
#include "gudgeon/sim/motion_equations.h"

namespace gudgeon {

/// Watches the arguments of all breaks: conditions and bends in the formulas of loads, points of their curves, and the
/// same of drivers' motions. Formulas of loads are held on one piece over a step, so that forces are smooth within it;
/// the step ends where an argument leaves its piece, and the next begins on the piece that the motion goes into. Where
/// the pieces on both sides push the motion back, it slides along the break (Filippov 1988). Allocates nothing after
/// construction.
class LoadBreaks {
 public:
  /// Evaluations are counted in the statistics.
  /// Keeps references to system and statistics.
  LoadBreaks(const System& system, double cycle_time, SolverStatistics& statistics);
  LoadBreaks(const System&&, double, SolverStatistics&) = delete;

  [[nodiscard]] bool empty() const { return watched_.empty() && clocks_.empty(); }
  /// The next time [s] at which a curve over the time comes to one of its points; infinite when none does.
  [[nodiscard]] double find_next_point(double time) const noexcept;
  /// A change of piece is found to this time [s].
  [[nodiscard]] double find_window(double time) const noexcept;

  /// Holds the pieces that the motion goes into from this state on, and evaluates there. The slope that it comes with
  /// is that of the pieces held until now. False when no piece can be gone into; stall() then tells of which break.
  bool hold(double t, const std::vector<double>& y, std::vector<double>& slope, MotionEquations& equations);
  /// Whether hold() has gone to other pieces of formulas of loads: forces may have jumped.
  [[nodiscard]] bool has_changed() const { return has_changed_; }

  struct Leave {
    std::size_t watched = 0;
    double share = 1.0;  ///< of the step, by dense output; zero where it is out of its piece from the start on
    double rate = 0.0;   ///< [1/s] at which its argument leaves
  };
  /// The earliest argument that leaves its piece within the step.
  std::optional<Leave> find_first_leave(const DenseStep& step, MotionEquations& equations);
  /// How far an argument is out of its piece at the end of a step; negative inside.
  double find_excess(std::size_t watched, const DenseStep& step, MotionEquations& equations) noexcept {
    return look_at(watched, 1.0, step, equations);
  }
  /// Whether no argument is out of its piece at a state.
  bool is_inside(double t, const std::vector<double>& y, MotionEquations& equations) noexcept;

  struct Stall {
    struct Place {
      std::string owner;  ///< "load 'rub'"
      std::string text;   ///< of the break
    };
    std::vector<Place> places;
  };
  /// Why hold() failed: all breaks that it could not get past together.
  [[nodiscard]] Stall find_stall() const;
  /// How often pieces were chosen.
  [[nodiscard]] std::int64_t n_changes() const { return n_changes_; }

  void transfer(StateArchive& archive);

 private:
  enum class Kind { formula, curve, motion, share };
  struct Watched {
    Kind kind;
    std::size_t index;  // of the break in LoadScratch::breaks or motion_states_, the curve in curves_, the slide
    double low;
    double high;
  };
  struct WatchedCurve {
    const Curve* curve;
    int channel;
    int load;
  };
  // A formula of a driver's motion: smooth to its second derivative, so it is watched and not held.
  struct WatchedMotion {
    ExpressionEvaluator evaluator;
    std::size_t first_break;
    int driver;
  };
  struct Change {
    double time;  // [s]
    std::int64_t evaluations;
  };
  using Pieces = std::vector<int>;

  void eval(double t, const std::vector<double>& y, std::vector<double>& slope, MotionEquations& equations) noexcept;
  void watch_loads(const System& system);
  [[nodiscard]] Stall::Place describe(std::size_t at) const;
  void watch_motions(const System& system);
  bool is_crowded(double t) noexcept;
  void release(double t, const std::vector<double>& y, std::vector<double>& slope, MotionEquations& equations) noexcept;
  void move_ahead(const std::vector<double>& y, const std::vector<double>& slope) noexcept;
  void read_pieces(double t, const std::vector<double>& y, const std::vector<double>& slope, MotionEquations& equations,
                   Pieces& pieces) noexcept;
  bool choose_pieces(double t, const std::vector<double>& y, std::vector<double>& slope, MotionEquations& equations);
  [[nodiscard]] bool agree(const Pieces& one, const Pieces& other, const HeldPieces& held) const noexcept;
  bool end_slides(double t, const std::vector<double>& y, std::vector<double>& slope, MotionEquations& equations,
                  int n_new);
  void end_slide(int slide, HeldPieces& held) noexcept;
  bool begin_slides(double t, const std::vector<double>& y, std::vector<double>& slope, MotionEquations& equations,
                    const Pieces& one, const Pieces& other);
  [[nodiscard]] bool meets_others(const HeldPieces& held) const noexcept;
  void forget_slides(HeldPieces& held) noexcept;
  bool list_turned(const Pieces& one, const Pieces& other, const HeldPieces& held) noexcept;
  bool join_slides(HeldPieces& held) noexcept;
  [[nodiscard]] bool has_drifted(double t, const std::vector<double>& y, MotionEquations& equations) noexcept;
  void bound_pieces(double t, const std::vector<double>& y, const std::vector<double>& slope,
                    MotionEquations& equations) noexcept;
  void measure(double t, const double* y, MotionEquations& equations) noexcept;
  void look(double share, const DenseStep& step, MotionEquations& equations) noexcept;
  double look_at(std::size_t k, double share, const DenseStep& step, MotionEquations& equations) noexcept;
  [[nodiscard]] double find_excess(std::size_t k) const noexcept;
  std::optional<double> find_crossing(std::size_t k, double limit, const DenseStep& step, MotionEquations& equations);
  std::optional<double> find_peak(std::size_t k, int part, const DenseStep& step, MotionEquations& equations);
  double refine(std::size_t k, double inside, double outside, const DenseStep& step, MotionEquations& equations);

  static constexpr int kParts = 8;
  static constexpr int kMostTries = 12;
  static constexpr std::size_t kCrowd = 32;  // changes

  const System* system_;
  SolverStatistics* statistics_;
  double cycle_time_;
  std::vector<Watched> watched_;
  std::vector<WatchedCurve> curves_;
  std::vector<WatchedMotion> motions_;
  std::vector<BreakState> motion_states_;
  std::vector<int> motion_pieces_;
  std::vector<Curve> clocks_;  // curves over the time
  Workspace scratch_;
  bool is_searched_ = false;  // some argument can leave its piece
  std::vector<double> arguments_;
  std::vector<double> excess_;  // of all watched, part after part
  std::vector<double> state_;
  std::vector<double> later_slope_;
  std::array<Pieces, kMostTries + 1> tried_;
  Pieces next_;
  HeldPieces last_;                      // before the last hold()
  std::vector<std::size_t> formula_of_;  // of each break
  std::vector<int> turned_;              // breaks whose pieces on both sides lead to each other
  std::vector<int> turned_formulas_;     // those that hold them
  std::vector<double> turned_rates_;  // of their arguments: all as they are, then with each formula on the other side
  std::vector<double> reach_;         // of each break's argument while it is slid along with another
  std::vector<char> is_restless_;     // breaks that went to other pieces while no time passed
  std::vector<char> is_decided_;      // breaks whose slide has ended in the choice at hand
  std::size_t last_left_ = 0;         // watched
  bool has_changed_ = false;
  double ahead_ = 0.0;     // [s] how far ahead the piece that a motion goes into is read
  double held_at_ = -1.0;  // [s] time of the last hold()
  int n_stalls_ = 0;       // holds in a row between which no time passed
  std::int64_t n_changes_ = 0;
  std::array<Change, kCrowd> recent_;  // the last ones
  double release_ = 0.0;               // [s] how long nothing was held the last time
  double released_until_;              // [s]
};

}  // namespace gudgeon
