// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Everything one run of one case produced: plain data, the same in memory and read back from disk.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "gudgeon/results/channel.h"

namespace gudgeon {

/// Statistics of one channel over the counted cycles of a stage, taken at every accepted step.
struct ChannelStatistics {
  std::string channel;
  double minimum = 0.0;
  double minimum_time = 0.0;  ///< [s]
  double maximum = 0.0;
  double maximum_time = 0.0;  ///< [s]
  double mean = 0.0;          ///< over time
  double rms = 0.0;           ///< over time

  /// The signed value of largest magnitude.
  [[nodiscard]] double peak() const { return maximum >= -minimum ? maximum : minimum; }
};

/// One stay in contact.
struct ContactEvent {
  std::int32_t joint = 0;    ///< index into StageRecord::wear
  double onset_time = 0.0;   ///< [s]
  double duration = 0.0;     ///< [s]; up to the end of the stage when still in contact
  double onset_speed = 0.0;  ///< [m/s] penetration rate there
  double angle = 0.0;        ///< [rad] of the contact at onset, in the bearing body
  double peak_force = 0.0;   ///< [N]
  double position = 0.0;     ///< [m] of the contact at onset along a slot, from its middle
  std::int32_t contact = 0;  ///< which of the joint's: corners of a block left rear, left front, right rear, right
                             ///< front; sides of a pin's slot left, right
};

/// Energies of a stage from its start, all in J. The residual would be zero in exact arithmetic.
struct EnergyBalance {
  double initial_energy = 0.0;   ///< kinetic + potential + elastic at the start
  double kinetic = 0.0;          ///< at the end
  double potential = 0.0;        ///< of gravity, constant loads and springs, at the end
  double elastic = 0.0;          ///< stored in contacts, at the end
  double driver_work = 0.0;      ///< done by the drivers
  double load_work = 0.0;        ///< done by variable forces and torques
  double damper_loss = 0.0;      ///< lost in dampers
  double contact_damping = 0.0;  ///< lost in contacts along their normal
  double friction = 0.0;         ///< lost in contacts along their slip
  double surface_work = 0.0;     ///< done by worn surfaces whose law is not conservative
  double exchanged = 0.0;   ///< time integral of the magnitudes of the powers of drivers, loads, damping and friction
  double load_reach = 0.0;  ///< largest sum of loads and weights over the characteristic length, and of torques

  /// What is missing: energy now − energy at the start − work done on the mechanism.
  [[nodiscard]] double residual() const {
    return (kinetic + potential + elastic) - initial_energy - driver_work - load_work - surface_work + damper_loss +
           contact_damping + friction;
  }
};

/// Work of the integrator in one stage.
struct SolverStatistics {
  std::int64_t evaluations = 0;
  std::int64_t accepted_steps = 0;
  std::int64_t rejected_steps = 0;
  std::int64_t onsets = 0;
  std::int64_t separations = 0;
  std::int64_t projections = 0;
  double smallest_step = 0.0;     ///< [s]
  double largest_step = 0.0;      ///< [s]
  double closure_residual = 0.0;  ///< [m] largest after an accepted step
  double wall_time = 0.0;         ///< [s]; the only number that differs from run to run
};

/// Wear of one clearance joint: where the stage started and what it added. Depths stand surface after surface, each
/// with its cells: of a slot the left side, then the right, from rear to front; of a block its corners left rear,
/// left front, right rear, right front; one surface of a round bearing or pin.
struct JointWear {
  std::string joint;
  double bearing_radius = 0.0;              ///< R_i [m], unworn; infinite for a slot
  double journal_radius = 0.0;              ///< R_j [m], unworn
  double clearance = 0.0;                   ///< c [m], unworn
  double slot_length = 0.0;                 ///< [m] of either side of a slot; 0 for a round bearing
  double width = 0.0;                       ///< w [m]
  std::vector<double> bearing_depth;        ///< [m] a cell, of the surface this stage ran on
  std::vector<double> journal_depth;        ///< [m]
  std::vector<double> bearing_depth_added;  ///< [m] a cell, times the wear acceleration, lost after this stage
  std::vector<double> journal_depth_added;  ///< [m]
  std::vector<double> total_depth_added;    ///< [m] bearing and journal together, over the bearing's circumference
  double archard_volume = 0.0;              ///< [m^3] ∫ k_d F ds of both surfaces, times the wear acceleration
  double removed_volume = 0.0;              ///< [m^3] of the added depths
  double sliding_distance = 0.0;            ///< [m] in contact, not accelerated; that of all contacts added
  double contact_time = 0.0;                ///< [s] in contact
  double impulse = 0.0;                     ///< [N s] ∫ F dt

  [[nodiscard]] std::size_t n_bearing_surfaces() const { return slot_length > 0.0 ? 2 : 1; }
  /// [m] a cell, of the surfaces that the stage leaves.
  [[nodiscard]] std::vector<double> bearing_depth_after() const;
  [[nodiscard]] std::vector<double> journal_depth_after() const;
  /// Of each surface.
  [[nodiscard]] std::size_t n_cells() const { return bearing_depth.size() / n_bearing_surfaces(); }
};

enum class StageStatus { finished, stopped, failed };

/// One stage: the mechanism run over its cycles on fixed surfaces.
struct StageRecord {
  std::string name;  ///< "ideal", "no_wear", "wear_1", "wear_2" …
  StageStatus status = StageStatus::finished;
  std::string message;      ///< why it stopped or failed
  double start_time = 0.0;  ///< [s] of the first counted cycle
  double end_time = 0.0;    ///< [s] reached
  double cycle_time = 0.0;  ///< [s]
  int cycles = 0;           ///< counted cycles reached
  std::vector<Channel> channels;
  std::vector<double> time;                 ///< [s] of each recorded sample
  std::vector<std::vector<double>> values;  ///< values[channel][sample]
  std::vector<ChannelStatistics> statistics;
  std::vector<JointWear> wear;  ///< one a clearance joint
  std::vector<ContactEvent> events;
  EnergyBalance energy;
  SolverStatistics solver;
};

/// One case of a study.
struct RunRecord {
  std::string model_file;  ///< as the user named it
  std::string model_text;  ///< verbatim
  std::string case_name;
  std::vector<std::pair<std::string, std::string>> overrides;  ///< path and text, in the order applied
  std::string resolved_model;                                  ///< the model in SI with every default
  std::string program_version;
  std::vector<StageRecord> stages;
};

/// The channel's recorded values; nullptr when the stage has no such channel.
const std::vector<double>* find_values(const StageRecord& stage, std::string_view channel);
/// The channel's statistics; nullptr when none were taken.
const ChannelStatistics* find_statistics(const StageRecord& stage, std::string_view channel);
/// The stage of that name; nullptr when there is none.
const StageRecord* find_stage(const RunRecord& run, std::string_view name);

}  // namespace gudgeon
