// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// The numbers of a stage by name, unit and place: one table each for writing, reading and CSV.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "gudgeon/results/run_record.h"

namespace gudgeon {

inline constexpr const char* kRunFormat = "gudgeon run";
inline constexpr std::int64_t kRunFormatVersion = 2;

/// One member of a record: its name on file, its SI unit, where it is stored.
template <class Record, class Value>
struct RecordField {
  const char* name;
  const char* unit;
  Value Record::*member;
  bool may_lack = false;  ///< files of before it was there are read with the value of a new record
};

inline constexpr std::array kStageReals{
    RecordField<StageRecord, double>{"start_time", "s", &StageRecord::start_time},
    RecordField<StageRecord, double>{"end_time", "s", &StageRecord::end_time},
    RecordField<StageRecord, double>{"cycle_time", "s", &StageRecord::cycle_time},
};

inline constexpr std::array kEnergyReals{
    RecordField<EnergyBalance, double>{"initial_energy", "J", &EnergyBalance::initial_energy},
    RecordField<EnergyBalance, double>{"kinetic", "J", &EnergyBalance::kinetic},
    RecordField<EnergyBalance, double>{"potential", "J", &EnergyBalance::potential},
    RecordField<EnergyBalance, double>{"elastic", "J", &EnergyBalance::elastic},
    RecordField<EnergyBalance, double>{"driver_work", "J", &EnergyBalance::driver_work},
    RecordField<EnergyBalance, double>{"load_work", "J", &EnergyBalance::load_work, true},
    RecordField<EnergyBalance, double>{"damper_loss", "J", &EnergyBalance::damper_loss, true},
    RecordField<EnergyBalance, double>{"contact_damping", "J", &EnergyBalance::contact_damping},
    RecordField<EnergyBalance, double>{"friction", "J", &EnergyBalance::friction},
    RecordField<EnergyBalance, double>{"surface_work", "J", &EnergyBalance::surface_work},
    RecordField<EnergyBalance, double>{"exchanged", "J", &EnergyBalance::exchanged},
    RecordField<EnergyBalance, double>{"load_reach", "J", &EnergyBalance::load_reach, true},
};

inline constexpr std::array kSolverCounts{
    RecordField<SolverStatistics, std::int64_t>{"evaluations", "1", &SolverStatistics::evaluations},
    RecordField<SolverStatistics, std::int64_t>{"accepted_steps", "1", &SolverStatistics::accepted_steps},
    RecordField<SolverStatistics, std::int64_t>{"rejected_steps", "1", &SolverStatistics::rejected_steps},
    RecordField<SolverStatistics, std::int64_t>{"onsets", "1", &SolverStatistics::onsets},
    RecordField<SolverStatistics, std::int64_t>{"separations", "1", &SolverStatistics::separations},
    RecordField<SolverStatistics, std::int64_t>{"projections", "1", &SolverStatistics::projections},
};

inline constexpr std::array kSolverReals{
    RecordField<SolverStatistics, double>{"smallest_step", "s", &SolverStatistics::smallest_step},
    RecordField<SolverStatistics, double>{"largest_step", "s", &SolverStatistics::largest_step},
    RecordField<SolverStatistics, double>{"closure_residual", "m", &SolverStatistics::closure_residual},
    RecordField<SolverStatistics, double>{"wall_time", "s", &SolverStatistics::wall_time},
};

inline constexpr std::array kWearReals{
    RecordField<JointWear, double>{"bearing_radius", "m", &JointWear::bearing_radius},
    RecordField<JointWear, double>{"journal_radius", "m", &JointWear::journal_radius},
    RecordField<JointWear, double>{"clearance", "m", &JointWear::clearance, true},
    RecordField<JointWear, double>{"slot_length", "m", &JointWear::slot_length, true},
    RecordField<JointWear, double>{"width", "m", &JointWear::width},
    RecordField<JointWear, double>{"archard_volume", "m^3", &JointWear::archard_volume},
    RecordField<JointWear, double>{"removed_volume", "m^3", &JointWear::removed_volume},
    RecordField<JointWear, double>{"sliding_distance", "m", &JointWear::sliding_distance},
    RecordField<JointWear, double>{"contact_time", "s", &JointWear::contact_time},
    RecordField<JointWear, double>{"impulse", "N s", &JointWear::impulse},
};

inline constexpr std::array kWearSeries{
    RecordField<JointWear, std::vector<double>>{"bearing_depth", "m", &JointWear::bearing_depth},
    RecordField<JointWear, std::vector<double>>{"journal_depth", "m", &JointWear::journal_depth},
    RecordField<JointWear, std::vector<double>>{"bearing_depth_added", "m", &JointWear::bearing_depth_added},
    RecordField<JointWear, std::vector<double>>{"journal_depth_added", "m", &JointWear::journal_depth_added},
    RecordField<JointWear, std::vector<double>>{"total_depth_added", "m", &JointWear::total_depth_added},
};

}  // namespace gudgeon
