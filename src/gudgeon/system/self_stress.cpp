// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Unit loads on what is open, balanced by the rest, and least squares over them with side conditions: shares z of all
// states s with Σ_joints |F + Σ z_s F_s|² + (M + Σ z_s M_s)²/ℓ² least (docs/theory/dynamics.md, Eq. D14a).
#include "gudgeon/system/self_stress.h"

#include <algorithm>
#include <utility>

#include "gudgeon/system/characteristic_length.h"
#include "gudgeon/system/closure_entries.h"

namespace gudgeon {

namespace {

using Eigen::Index;

// Pivots below this share of the largest are rounding of zero: the forces of unit loads are of order one.
constexpr double kNoPivot = 1e-11;

}  // namespace

SelfStress::SelfStress(const System& system)
    : system_(&system), sweep_(system), length_(find_characteristic_length(system.mechanism)) {
  find_states();
  if (states_.empty()) return;
  const Topology& topology = system.topology;
  for (const AngleTie& tie : topology.angle_ties) {
    if (std::holds_alternative<Revolute>(system.mechanism.joints[tie.joint].kind)) pin_ties_.push_back(tie.joint);
  }
  for (std::size_t j = 0; j < topology.joint_slide.size(); ++j) {
    if (topology.joint_slide[j] >= topology.counts.n_free_slides) driven_slides_.push_back(static_cast<int>(j));
  }
  for (std::size_t c = 0; c < system.tables.closures.size(); ++c) {
    if (system.tables.closures[c].kind == ClosureKind::angle) driver_rows_.push_back(static_cast<int>(c));
  }
  const auto n_states = static_cast<Index>(states_.size());
  const auto n_conditions = static_cast<Index>(pin_ties_.size() + driven_slides_.size() + driver_rows_.size()) +
                            static_cast<Index>(topology.counts.n_driven_turns);
  driver_moments_.resize(driver_rows_.size());
  row_forces_.resize(static_cast<std::size_t>(system.tables.n_indices));
  stress_.assign(states_.size(), std::vector<JointReaction>(system.mechanism.joints.size()));
  matrix_.resize(n_states + n_conditions, n_states + n_conditions);
  right_.resize(n_states + n_conditions);
  shares_.resize(n_states + n_conditions);
  conditions_.resize(n_conditions);
  factors_ = Eigen::FullPivLU<Eigen::MatrixXd>(matrix_.rows(), matrix_.cols());
  factors_.setThreshold(kNoPivot);
}

void SelfStress::find_states() {
  list_rows();
  for (const int joint : system_->topology.implied) {
    for (const int axis : {0, 1}) states_.push_back({State::Kind::pin, joint, axis});
  }
  for (const int joint : system_->topology.redundant_ties) {
    if (std::holds_alternative<Revolute>(system_->mechanism.joints[joint].kind)) continue;
    states_.push_back({State::Kind::tie, joint, 0});
  }
}

// Rows may be exchanged, but stay as many.
void SelfStress::list_rows() noexcept {
  std::size_t next = 0;
  const auto& closures = system_->tables.closures;
  for (std::size_t c = 0; c < closures.size(); ++c) {
    for (int k = 0; k < count_rows(closures[c].kind); ++k) {
      if (closures[c].active[k]) continue;
      if (next == states_.size()) states_.emplace_back();
      states_[next++] = {State::Kind::row, static_cast<int>(c), k};
    }
  }
}

// The rows that are enforced take the opposite of what the row does to the coordinates: H x + J_aᵀ c = J_dᵀ, J_a x = 0.
void SelfStress::apply_row(const State& state, const Workspace& workspace) noexcept {
  const Tables& tables = system_->tables;
  std::ranges::fill(row_forces_, 0.0);
  visit_closure_entries(tables, workspace.coordinates, tables.closures[state.at], [&](int k, int index, double value) {
    if (k == state.row && index < tables.counts.n_free()) row_forces_[index] += value;
  });
  tables.elimination.solve(workspace.values.data(), workspace.inverse_pivots.data(), row_forces_.data());
  for (std::size_t c = 0; c < tables.closures.size(); ++c) {
    const ClosureRows& rows = tables.closures[c];
    if (rows.kind == ClosureKind::angle) continue;  // no driver is left to do anything
    Vec2 force;
    if (rows.active[0]) force.x = -row_forces_[rows.row[0]];
    if (rows.active[1]) force.y = -row_forces_[rows.row[1]];
    if (static_cast<int>(c) == state.at) (state.row == 0 ? force.x : force.y) = 1.0;
    if (rows.kind == ClosureKind::line) {
      force = force.x * (workspace.coordinates.rotation[rows.line_turn] * rows.normal);
    }
    sweep_.apply_joint_force(rows.joint, force);
  }
  for (std::size_t d = 0; d < driver_rows_.size(); ++d) {
    const ClosureRows& rows = tables.closures[driver_rows_[d]];
    const double own = driver_rows_[d] == state.at ? 1.0 : 0.0;
    driver_moments_[d] = rows.active[0] ? -row_forces_[rows.row[0]] : own;
  }
}

void SelfStress::apply(const State& state, const Workspace& workspace) noexcept {
  std::ranges::fill(driver_moments_, 0.0);
  switch (state.kind) {
    case State::Kind::row:
      apply_row(state, workspace);
      break;
    case State::Kind::pin:
      sweep_.apply_joint_force(state.at, state.row == 0 ? Vec2{1.0, 0.0} : Vec2{0.0, 1.0});
      break;
    case State::Kind::tie:
      sweep_.apply_joint_moment(state.at, length_);
      break;
  }
  sweep_.finish();
}

// What must vanish: moments in pins, and changes of drivers' efforts.
void SelfStress::find_conditions(const std::vector<BodyMotion>& motions) noexcept {
  Index next = 0;
  for (const int joint : pin_ties_) conditions_(next++) = sweep_.reactions()[joint].moment / length_;
  const CoordinateCounts& counts = system_->topology.counts;
  for (int d = 0; d < counts.n_driven_turns; ++d) {
    conditions_(next++) = sweep_.root_moments()[counts.n_free_turns + d] / length_;
  }
  for (const int joint : driven_slides_) {
    const auto& slide = std::get<Prismatic>(system_->mechanism.joints[joint].kind);
    const Rotation along = make_rotation(motions[sweep_.first(joint).body].angle + slide.direction);
    conditions_(next++) = dot(sweep_.reactions()[joint].force, {along.c, along.s});
  }
  for (const double moment : driver_moments_) conditions_(next++) = moment / length_;
}

double SelfStress::multiply(const std::vector<JointReaction>& a, const std::vector<JointReaction>& b) const noexcept {
  double sum = 0.0;
  for (std::size_t j = 0; j < a.size(); ++j) {
    sum += dot(a[j].force, b[j].force) + a[j].moment * b[j].moment / (length_ * length_);
  }
  return sum;
}

// The system is consistent, though its side conditions may repeat each other.
bool SelfStress::solve() noexcept {
  factors_.compute(matrix_);
  const Index rank = factors_.rank();
  const Index n = right_.size();
  const auto& lu = factors_.matrixLU();
  shares_.noalias() = factors_.permutationP() * right_;
  for (Index i = 1; i < rank; ++i) shares_(i) -= lu.row(i).head(i).dot(shares_.head(i));
  shares_.tail(n - rank).setZero();
  for (Index i = rank - 1; i >= 0; --i) {
    const Index behind = rank - 1 - i;
    shares_(i) = (shares_(i) - lu.row(i).segment(i + 1, behind).dot(shares_.segment(i + 1, behind))) / lu(i, i);
  }
  right_.noalias() = factors_.permutationQ() * shares_;
  return right_.allFinite();
}

// One column a state: its products with the others, and what it does to the side conditions.
void SelfStress::find_matrix(const Workspace& workspace, const std::vector<BodyMotion>& motions) noexcept {
  list_rows();
  matrix_.setZero();
  for (std::size_t s = 0; s < states_.size(); ++s) {
    sweep_.begin(motions);
    apply(states_[s], workspace);
    find_conditions(motions);
    for (const int joint : pin_ties_) sweep_.reactions()[joint].moment = 0.0;
    stress_[s] = sweep_.reactions();
    const auto column = static_cast<Index>(s);
    matrix_.col(column).tail(conditions_.size()) = conditions_;
    matrix_.row(column).tail(conditions_.size()) = conditions_.transpose();
    for (std::size_t other = 0; other <= s; ++other) {
      const double product = multiply(stress_[s], stress_[other]);
      matrix_(column, static_cast<Index>(other)) = matrix_(static_cast<Index>(other), column) = product;
    }
  }
}

std::vector<JointReaction> SelfStress::find_openness(const Workspace& workspace,
                                                     const std::vector<BodyMotion>& motions) {
  std::vector<JointReaction> openness(system_->mechanism.joints.size());
  if (states_.empty()) return openness;
  find_matrix(workspace, motions);
  const auto n = static_cast<Index>(states_.size());
  Eigen::MatrixXd shares = Eigen::MatrixXd::Identity(n, n);
  if (conditions_.size() > 0) {
    Eigen::FullPivLU<Eigen::MatrixXd> conditions(matrix_.bottomLeftCorner(conditions_.size(), n));
    conditions.setThreshold(kNoPivot);
    if (conditions.dimensionOfKernel() == 0) return openness;
    shares = conditions.kernel();
  }
  for (Index way = 0; way < shares.cols(); ++way) {
    for (std::size_t j = 0; j < openness.size(); ++j) {
      JointReaction sum;
      for (Index s = 0; s < n; ++s) {
        sum.force += shares(s, way) * stress_[static_cast<std::size_t>(s)][j].force;
        sum.moment += shares(s, way) * stress_[static_cast<std::size_t>(s)][j].moment / length_;
      }
      openness[j].force.x = std::max(openness[j].force.x, std::abs(sum.force.x));
      openness[j].force.y = std::max(openness[j].force.y, std::abs(sum.force.y));
      openness[j].moment = std::max(openness[j].moment, std::abs(sum.moment));
    }
  }
  return openness;
}

void SelfStress::relax(const Workspace& workspace, const std::vector<BodyMotion>& motions,
                       std::vector<JointReaction>& reactions) noexcept {
  if (states_.empty()) return;
  find_matrix(workspace, motions);
  right_.setZero();
  auto next = static_cast<Index>(states_.size());
  for (const int joint : pin_ties_) right_(next++) = -std::exchange(reactions[joint].moment, 0.0) / length_;
  for (std::size_t s = 0; s < states_.size(); ++s) right_(static_cast<Index>(s)) = -multiply(stress_[s], reactions);
  if (!solve()) return;
  for (std::size_t s = 0; s < states_.size(); ++s) {
    const double share = right_(static_cast<Index>(s));
    for (std::size_t j = 0; j < reactions.size(); ++j) {
      reactions[j].force += share * stress_[s][j].force;
      reactions[j].moment += share * stress_[s][j].moment;
    }
  }
}

}  // namespace gudgeon
