// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Wear of one clearance joint, distributed cell by cell while a stage runs.
#pragma once

#include <initializer_list>
#include <span>

#include "gudgeon/base/state_archive.h"
#include "gudgeon/geometry/arc_accumulator.h"
#include "gudgeon/model/study.h"
#include "gudgeon/results/run_record.h"
#include "gudgeon/sim/motion_equations.h"

namespace gudgeon {

/// dh = ḣ dt for both surfaces of one joint; eqs. (26) to (32) of the paper. The laws are asked once for an arc, with
/// its mean pressure F/(w L) and with what holds at its middle; as they are proportional to the pressure, its
/// distribution is that of the depth, and the volume is that of a unit length under F/w. Spread distribution spreads
/// the depth over the arc as it moves and grows over the step, so that neither the removed volume nor a cell's depth
/// depends on the number of cells or of steps; point distribution gives the depth at the middle to the one cell of
/// the contact point. Each side of a slot is laid out as a circumference of its length whose ends do not meet; a
/// contact that reaches past an end wears the last part of the side.
class WearAccumulator {
 public:
  /// The contacts of one joint. What the stage wears is handed out times the wear acceleration, and the laws see the
  /// sliding distance so.
  WearAccumulator(std::span<const Contact> contacts, WearDistribution distribution, int n_cells,
                  double wear_acceleration = 1.0);

  /// One contact at one stage of an accepted step.
  struct StepSample {
    const ContactSample* contact;
    double node;    ///< [1] when, in shares of the step
    double weight;  ///< [s] in integrals over the step; may be negative
    double share;   ///< [1] weight of a place where the contact was, never negative; 0 for stages that tell of none
  };
  /// One contact over an accepted step. How much it wears is integrated over all stages, where it is distributed is
  /// told by those with a share: so the amount is as accurate as the motion, and no place gets less than nothing unless
  /// the whole step is given less, as an integration rule may where a force sets in within it.
  void add(std::span<const StepSample> samples) noexcept;
  /// The same of a step seen at its middle.
  void add(const ContactSample& sample, double weight) noexcept { add({{StepSample{&sample, 0.5, weight, 1.0}}}); }
  /// Time spent in contact.
  void add_contact_time(double time) noexcept { contact_time_ += time; }

  /// What the stage wore, times the wear acceleration. The surfaces it ran on are taken from the contact.
  [[nodiscard]] JointWear summarize(const std::string& joint) const;

  void transfer(StateArchive& archive) {
    archive(bearing_, journal_, total_, volume_, length_sum_, sliding_distance_, impulse_, contact_time_);
  }

 private:
  // Depth times length of arc [m^2].
  struct Amounts {
    double bearing = 0.0;
    double journal = 0.0;
  };
  [[nodiscard]] double find_length(const ContactSample& sample) const noexcept;
  [[nodiscard]] Amounts find_rates(const ContactSample& sample, double distance) const noexcept;
  // Where a contact was at one instant of a step.
  struct Place {
    const ContactSample* sample;
    double node;        // [1]
    double intensity;   // [W]
    double length;      // [m]
    double bearing_at;  // [rad] middle of the arc
    double journal_at;  // [rad]
  };
  [[nodiscard]] Place find_place(const StepSample& at) const noexcept;
  void distribute_points(std::span<const StepSample> places, const Amounts& worn) noexcept;
  void distribute_path(std::span<const StepSample> places, const Amounts& worn) noexcept;
  void distribute_turning_path(std::span<const StepSample> samples, const Amounts& worn) noexcept;
  [[nodiscard]] static Place interpolate(std::span<const Place> places, double node) noexcept;
  [[nodiscard]] double find_turning_factor(std::span<const StepSample> samples,
                                           std::span<const StepSample> known) const noexcept;
  [[nodiscard]] std::span<const Place> find_turning_places(std::span<const StepSample> samples,
                                                           std::span<Place> places) const noexcept;
  [[nodiscard]] static Place find_way(std::span<const Place> places, int way) noexcept;
  [[nodiscard]] static double sum_ways(std::span<const Place> places) noexcept;
  void distribute_at(const Place& place, const Amounts& amounts) noexcept;
  [[nodiscard]] double find_movement(const Place& from, const Place& to) const noexcept;
  void distribute_between(const Place& from, const Place& to, const Amounts& amounts) noexcept;
  void distribute(std::initializer_list<ArcAccumulator::Increment> increments, double angle, double width, double turn,
                  double end_width) const noexcept;
  [[nodiscard]] double find_side_angle(double position, double width) const noexcept;
  [[nodiscard]] double find_finest_length() const noexcept;

  std::span<const Contact> contacts_;
  WearDistribution distribution_;
  double wear_acceleration_;
  double slot_length_ = 0.0;             // [m]; 0 for a round bearing
  double bearing_radius_ = 0.0;          // [m] of the circumference its cells stand for
  double journal_radius_ = 0.0;          // [m]
  std::vector<ArcAccumulator> bearing_;  // one a surface
  std::vector<ArcAccumulator> journal_;  // one a surface
  std::vector<ArcAccumulator> total_;    // both bodies, over the bearing's surfaces
  double volume_ = 0.0;
  double length_sum_ = 0.0;  // [m^3] of contacts, each times the depth times length that it wore
  double sliding_distance_ = 0.0;
  double impulse_ = 0.0;
  double contact_time_ = 0.0;
};

}  // namespace gudgeon
