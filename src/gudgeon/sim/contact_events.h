// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// When, within a step, surfaces meet or part.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "gudgeon/sim/dense_step.h"
#include "gudgeon/system/dynamics.h"

namespace gudgeon {

/// What the gap of one contact needs to be watched over a step.
struct GapState {
  double reach = 0.0;        ///< [m] the penetration that the least wear depths would leave, never below δ; in flight
  double reach_rate = 0.0;   ///< [m/s]
  double cell_rate = 0.0;    ///< [1/s] cells of wear passed, on the surface where they pass faster; in flight
  double penetration = 0.0;  ///< δ [m]
  double penetration_rate = 0.0;  ///< δ̇ [m/s]
  double overrun = 0.0;           ///< [m] past the end of a slot; <= 0 within it and in a round bearing
  double overrun_rate = 0.0;      ///< [m/s]
};

/// The first change of contact in a step.
struct ContactChange {
  std::size_t contact = 0;
  double share = 1.0;  ///< of the step, by dense output
};

/// Watches the gaps of all contacts over steps. Holds its own scratch memory.
class ContactEvents {
 public:
  explicit ContactEvents(const Tables& tables);

  /// Gaps at coordinates that the workspace was last updated for.
  void find_gaps(Workspace& workspace, std::vector<GapState>& gaps) const noexcept;
  /// The same where the workspace was evaluated with these contact modes: what an active contact pressed with is known,
  /// and no more than that is found of its gap (no reach and no cell rate, which only matter in flight).
  void find_gaps(Workspace& workspace, std::span<const ContactMode> contact_modes,
                 std::vector<GapState>& gaps) const noexcept;
  /// All of one gap, at points that are up to date.
  [[nodiscard]] GapState find_gap(std::size_t contact, const Workspace& workspace) const noexcept;
  /// What rounding leaves uncertain of a gap [m] at coordinates that are up to date for this time [s].
  [[nodiscard]] double find_gap_rounding(std::size_t contact, double time, const Workspace& workspace) const noexcept;

  /// The earliest change of any contact between start and end of the attempted step: a gap that closes in free flight,
  /// or a contact that opens. Also finds those that begin and end inside the step. start and end are the gaps at the
  /// step's ends. Uses the workspace for interpolated states.
  std::optional<ContactChange> find_first_change(const DenseStep& step, std::span<const ContactMode> contact_modes,
                                                 const std::vector<GapState>& start, const std::vector<GapState>& end,
                                                 Workspace& workspace);

  /// The share of the step at which a journal is farthest past the end of its slot, where it leaves and comes back
  /// between start and end.
  std::optional<double> find_hidden_overrun(const DenseStep& step, const std::vector<GapState>& start,
                                            const std::vector<GapState>& end, Workspace& workspace);

 private:
  GapState find_gap_at(double share, std::size_t contact, const DenseStep& step, Workspace& workspace);
  std::optional<double> find_crossing(std::size_t contact, double sign, double limit, int n_parts,
                                      const GapState& start, const DenseStep& step, Workspace& workspace);
  int find_clear_part(std::size_t contact, double limit, int n_parts, int part, const DenseStep& step,
                      Workspace& workspace);
  int count_parts(std::size_t contact, bool in_contact, double h, const GapState& start, const GapState& end) const;

  const Tables* tables_;
  std::vector<double> interpolated_;
};

}  // namespace gudgeon
