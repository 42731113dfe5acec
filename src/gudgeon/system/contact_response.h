// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// How accelerations answer to the forces of pressing contacts, and these to the motion.
#pragma once

#include <Eigen/Dense>
#include <array>
#include <span>
#include <vector>

#include "gudgeon/base/state_archive.h"
#include "gudgeon/system/tables.h"
#include "gudgeon/system/workspace.h"

namespace gudgeon {

/// How fast contacts make a motion change.
struct ContactRates {
  double decay = 0.0;  ///< [1/s] of a slip or a penetration that comes to rest
  double swing = 0.0;  ///< [rad/s] of a penetration about where it rests
};

/// The stiff part of the Jacobian, of two directions a contact. With b the generalized force of a unit pressure or unit
/// friction, by virtual work also what makes δ̇ and v of the rates, and S the solution of the equations of motion, a
/// change Δa of the accelerations that acts for a time τ changes the accelerations by
///   J Δa = −S B C Bᵀ Δa,   C = [F_δ̇ τ + F_δ τ², 0; μ (F_δ̇ τ + F_δ τ²), F μ' τ] of each contact.
/// As J has the rank of B, (I − J)⁻¹ costs a system of two equations a contact (Woodbury). Contacts that press beyond
/// kMost are left out. Allocates nothing after construction.
class ContactResponse {
 public:
  static constexpr int kMost = 32;  ///< contacts

  explicit ContactResponse(const Tables& tables);

  /// B and S B where the workspace was last evaluated, for the contacts that press there.
  void update(Workspace& workspace) noexcept;
  /// C for the time τ [s], with the forces of the workspace's last evaluation.
  void weigh(double tau, std::span<const ContactMode> contact_modes, const Workspace& workspace) noexcept;
  /// Replaces what an acceleration lacks, f(a) − a, by (I − J)⁻¹ (f(a) − a); n_free components.
  void correct(double* residual) const noexcept;

  /// How fast [1/s] slip of a contact that pressed at the last update comes to rest where its friction is steepest.
  [[nodiscard]] double find_steepest_decay(std::size_t contact, const Workspace& workspace) const noexcept;

  /// How many contacts pressed at the last update.
  [[nodiscard]] int n_pressing() const { return n_pressing_; }

  /// The fastest rates of the contacts that press, at the forces of the workspace.
  [[nodiscard]] ContactRates find_rates(std::span<const ContactMode> contact_modes,
                                        const Workspace& workspace) const noexcept;

  void transfer(StateArchive& archive);

 private:
  static constexpr int kRank = 2 * kMost;
  using Square = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, kRank, kRank>;

  template <int kSize>
  void solve_for_forces() noexcept;
  void add_direction(Workspace& workspace, const Contact& contact, Eigen::Index column, Vec2 force,
                     double bearing_torque, double journal_torque) noexcept;
  [[nodiscard]] ContactSlopes find_slopes(std::size_t contact, std::span<const ContactMode> contact_modes,
                                          const Workspace& workspace) const noexcept;

  const Tables* tables_;
  Eigen::Index n_free_;
  int n_pressing_ = 0;
  std::array<std::size_t, kMost> pressing_{};
  Eigen::MatrixXd directions_;  // B, a column a direction: pressure and friction of the first contact ...
  Eigen::MatrixXd responses_;   // S B
  Square gains_;                // Bᵀ S B
  Square weights_;              // C
  Square forces_;               // (I + C Bᵀ S B)⁻¹ C: forces that answer to what is lacking along B
  std::vector<Vec2> loads_;
  std::vector<double> equations_;
};

}  // namespace gudgeon
