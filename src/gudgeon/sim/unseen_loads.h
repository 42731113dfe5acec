// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Narrow peaks of loads that lie between the places at which a step looked.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "gudgeon/base/state_archive.h"
#include "gudgeon/sim/dense_step.h"
#include "gudgeon/sim/motion_equations.h"

namespace gudgeon {

/// A formula of a load can be narrow only where one of its steep parts turns or passes zero (base/steep_parts.h). Such
/// parts are smooth where the formula is not, so a few looks within a step find these places however narrow the peak
/// is; there the formula is compared with what the looks around say. Parts that depend on speeds are left to the step
/// control: bodies come to rest where they pass zero. Allocates nothing after construction.
class UnseenLoads {
 public:
  /// Keeps a reference.
  explicit UnseenLoads(const System& system);
  explicit UnseenLoads(const System&&) = delete;

  [[nodiscard]] bool empty() const { return formulas_.empty(); }
  /// The time [s] within the step at which a load is quite other than around it.
  std::optional<double> find(const DenseStep& step, MotionEquations& equations);

  void transfer(StateArchive& archive) {
    for (Formula& formula : formulas_) archive(formula.largest);
  }

 private:
  static constexpr int kParts = 8;
  static constexpr int kLooks = kParts + 1;

  struct Formula {
    std::size_t expression;
    ExpressionEvaluator whole;
    std::vector<ExpressionEvaluator> parts;
    std::vector<std::array<double, kLooks>> looks;  // of its parts
    std::vector<BreakState> breaks;
    double largest = 0.0;  // magnitude ever looked at
  };

  double* look(double share, const DenseStep& step, MotionEquations& equations) noexcept;
  double eval_whole(Formula& formula, const double* channels, const MotionEquations& equations) noexcept;
  std::optional<double> find_in(Formula& formula, const DenseStep& step, MotionEquations& equations);
  std::optional<double> judge(Formula& formula, double share, const DenseStep& step, MotionEquations& equations);
  void look_around(Formula& formula, MotionEquations& equations) noexcept;
  [[nodiscard]] double expect(double share) const noexcept;

  const System* system_;
  Workspace scratch_;
  std::vector<Formula> formulas_;
  std::vector<double> state_;
  std::array<std::vector<double>, kLooks> channels_;  // at each look
  std::array<double, kLooks> around_{};               // the formula at hand at each look
  bool is_looked_ = false;                            // around_ is known
  double scale_ = 0.0;                                // its largest magnitude
};

}  // namespace gudgeon
