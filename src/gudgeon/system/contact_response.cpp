// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Unit forces through the equations of motion, and Woodbury's formula.
#include "gudgeon/system/contact_response.h"

#include <algorithm>
#include <cmath>

#include "gudgeon/base/state_archive.h"
#include "gudgeon/system/equations.h"

namespace gudgeon {

ContactResponse::ContactResponse(const Tables& tables)
    : tables_(&tables),
      n_free_(tables.counts.n_free()),
      directions_(n_free_, std::min<Eigen::Index>(kRank, 2 * static_cast<Eigen::Index>(tables.contacts.size()))),
      responses_(directions_.rows(), directions_.cols()),
      loads_(tables.points.rows().size()),
      equations_(tables.n_indices) {}

void ContactResponse::update(Workspace& workspace) noexcept {
  n_pressing_ = 0;
  for (std::size_t k = 0; k < tables_->contacts.size() && n_pressing_ < kMost; ++k) {
    if (!(workspace.contact_forces[k].normal_force > 0.0)) continue;
    const Contact& contact = tables_->contacts[k];
    const ContactGap& gap = workspace.contact_forces[k].gap;
    pressing_[n_pressing_] = k;
    add_direction(workspace, contact, 2 * n_pressing_, gap.gradient, gap.bearing_gradient, gap.journal_gradient);
    add_direction(workspace, contact, 2 * n_pressing_ + 1, perp(gap.normal), -gap.bearing_lever, gap.journal_lever);
    ++n_pressing_;
  }
  const Eigen::Index rank = 2 * n_pressing_;
  gains_.noalias() = directions_.leftCols(rank).transpose() * responses_.leftCols(rank);
}

void ContactResponse::add_direction(Workspace& workspace, const Contact& contact, Eigen::Index column, Vec2 force,
                                    double bearing_torque, double journal_torque) noexcept {
  std::ranges::fill(loads_, Vec2{});
  std::ranges::fill(equations_, 0.0);
  loads_[contact.journal_row] += force;
  loads_[contact.bearing_row] -= force;
  equations_[contact.journal_index] += journal_torque;
  equations_[contact.bearing_index] += bearing_torque;
  add_point_loads(*tables_, workspace, loads_, equations_);
  for (Eigen::Index i = 0; i < n_free_; ++i) directions_(i, column) = equations_[i];
  // Rows of closures feel no force.
  std::fill(equations_.begin() + n_free_, equations_.end(), 0.0);
  tables_->elimination.solve(workspace.values.data(), workspace.inverse_pivots.data(), equations_.data());
  for (Eigen::Index i = 0; i < n_free_; ++i) responses_(i, column) = equations_[i];
}

ContactSlopes ContactResponse::find_slopes(std::size_t contact, std::span<const ContactMode> contact_modes,
                                           const Workspace& workspace) const noexcept {
  const ContactForces& forces = workspace.contact_forces[contact];
  if (!(forces.normal_force > 0.0)) return {};
  const Contact& at = tables_->contacts[contact];
  return find_contact_slopes(at, contact_modes[contact], at.bristle < 0 ? 0.0 : workspace.bristles[at.bristle], forces);
}

void ContactResponse::weigh(double tau, std::span<const ContactMode> contact_modes,
                            const Workspace& workspace) noexcept {
  const Eigen::Index rank = 2 * n_pressing_;
  weights_.setZero(rank, rank);
  for (int p = 0; p < n_pressing_; ++p) {
    const ContactSlopes slopes = find_slopes(pressing_[p], contact_modes, workspace);
    const double pressure = tau * (slopes.force_by_rate + tau * slopes.force_by_penetration);
    weights_(2 * p, 2 * p) = pressure;
    weights_(2 * p + 1, 2 * p) = slopes.coefficient * pressure;
    weights_(2 * p + 1, 2 * p + 1) =
        tau * workspace.contact_forces[pressing_[p]].normal_force * slopes.coefficient_by_slip;
  }
  switch (n_pressing_) {
    case 0:
      break;
    case 1:
      solve_for_forces<2>();
      break;
    case 2:
      solve_for_forces<4>();
      break;
    default:
      solve_for_forces<Eigen::Dynamic>();
  }
}

// Sizes that are known while compiling are several times faster than those that are not.
template <int kSize>
void ContactResponse::solve_for_forces() noexcept {
  constexpr int kLargest = kSize == Eigen::Dynamic ? kRank : kSize;
  using Matrix = Eigen::Matrix<double, kSize, kSize, 0, kLargest, kLargest>;
  const Matrix weights = weights_;
  const Matrix gains = gains_;
  Matrix system = weights * gains;
  system.diagonal().array() += 1.0;
  if constexpr (kSize == Eigen::Dynamic) {
    forces_ = system.partialPivLu().solve(weights);
  } else {
    forces_ = system.inverse() * weights;
  }
}

void ContactResponse::correct(double* residual) const noexcept {
  const int rank = 2 * n_pressing_;
  std::array<double, kRank> lacking{};
  for (int k = 0; k < rank; ++k) {
    for (Eigen::Index i = 0; i < n_free_; ++i) lacking[k] += directions_(i, k) * residual[i];
  }
  for (int k = 0; k < rank; ++k) {
    double force = 0.0;
    for (int j = 0; j < rank; ++j) force += forces_(k, j) * lacking[j];
    for (Eigen::Index i = 0; i < n_free_; ++i) residual[i] -= force * responses_(i, k);
  }
}

double ContactResponse::find_steepest_decay(std::size_t contact, const Workspace& workspace) const noexcept {
  for (int p = 0; p < n_pressing_; ++p) {
    if (pressing_[p] != contact) continue;
    const double gain = gains_(2 * p + 1, 2 * p + 1);
    return workspace.contact_forces[contact].normal_force * tables_->contacts[contact].steepest_friction * gain;
  }
  return 0.0;
}

ContactRates ContactResponse::find_rates(std::span<const ContactMode> contact_modes,
                                         const Workspace& workspace) const noexcept {
  ContactRates rates;
  for (int p = 0; p < n_pressing_; ++p) {
    const ContactSlopes slopes = find_slopes(pressing_[p], contact_modes, workspace);
    const double normal = gains_(2 * p, 2 * p);
    const double tangential = gains_(2 * p + 1, 2 * p + 1);
    const double friction_by_slip = workspace.contact_forces[pressing_[p]].normal_force * slopes.coefficient_by_slip;
    rates.decay =
        std::max({rates.decay, std::abs(slopes.force_by_rate * normal), std::abs(friction_by_slip * tangential)});
    rates.swing = std::max(rates.swing, std::sqrt(std::abs(slopes.force_by_penetration * normal)));
  }
  return rates;
}

void ContactResponse::transfer(StateArchive& archive) {
  const auto transfer_matrix = [&](auto& matrix, Eigen::Index most_rows) {
    Eigen::Index rows = matrix.rows();
    Eigen::Index columns = matrix.cols();
    archive(rows, columns);
    if (rows > most_rows || columns > kRank) StateArchive::refuse();
    if (archive.is_loading()) matrix.resize(rows, columns);
    archive.raw(matrix.data(), static_cast<std::size_t>(matrix.size()));
  };
  archive(n_pressing_, pressing_);
  transfer_matrix(directions_, directions_.rows());
  transfer_matrix(responses_, responses_.rows());
  transfer_matrix(gains_, kRank);
  transfer_matrix(weights_, kRank);
  transfer_matrix(forces_, kRank);
}

}  // namespace gudgeon
