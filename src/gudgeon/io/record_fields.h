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
struct Field {
  const char* name;
  const char* unit;
  Value Record::*member;
  bool may_lack = false;  ///< files of before it was there are read with the value of a new record
};

inline constexpr std::array kStageReals{
    Field<StageRecord, double>{"start_time", "s", &StageRecord::start_time},
    Field<StageRecord, double>{"end_time", "s", &StageRecord::end_time},
    Field<StageRecord, double>{"cycle_time", "s", &StageRecord::cycle_time},
};

inline constexpr std::array kEnergyReals{
    Field<EnergyBalance, double>{"initial_energy", "J", &EnergyBalance::initial_energy},
    Field<EnergyBalance, double>{"kinetic", "J", &EnergyBalance::kinetic},
    Field<EnergyBalance, double>{"potential", "J", &EnergyBalance::potential},
    Field<EnergyBalance, double>{"elastic", "J", &EnergyBalance::elastic},
    Field<EnergyBalance, double>{"driver_work", "J", &EnergyBalance::driver_work},
    Field<EnergyBalance, double>{"load_work", "J", &EnergyBalance::load_work, true},
    Field<EnergyBalance, double>{"damper_loss", "J", &EnergyBalance::damper_loss, true},
    Field<EnergyBalance, double>{"contact_damping", "J", &EnergyBalance::contact_damping},
    Field<EnergyBalance, double>{"friction", "J", &EnergyBalance::friction},
    Field<EnergyBalance, double>{"surface_work", "J", &EnergyBalance::surface_work},
    Field<EnergyBalance, double>{"exchanged", "J", &EnergyBalance::exchanged},
    Field<EnergyBalance, double>{"load_reach", "J", &EnergyBalance::load_reach, true},
};

inline constexpr std::array kSolverCounts{
    Field<SolverStatistics, std::int64_t>{"evaluations", "1", &SolverStatistics::evaluations},
    Field<SolverStatistics, std::int64_t>{"accepted_steps", "1", &SolverStatistics::accepted_steps},
    Field<SolverStatistics, std::int64_t>{"rejected_steps", "1", &SolverStatistics::rejected_steps},
    Field<SolverStatistics, std::int64_t>{"onsets", "1", &SolverStatistics::onsets},
    Field<SolverStatistics, std::int64_t>{"separations", "1", &SolverStatistics::separations},
    Field<SolverStatistics, std::int64_t>{"projections", "1", &SolverStatistics::projections},
};

inline constexpr std::array kSolverReals{
    Field<SolverStatistics, double>{"smallest_step", "s", &SolverStatistics::smallest_step},
    Field<SolverStatistics, double>{"largest_step", "s", &SolverStatistics::largest_step},
    Field<SolverStatistics, double>{"closure_residual", "m", &SolverStatistics::closure_residual},
    Field<SolverStatistics, double>{"wall_time", "s", &SolverStatistics::wall_time},
};

inline constexpr std::array kWearReals{
    Field<JointWear, double>{"bearing_radius", "m", &JointWear::bearing_radius},
    Field<JointWear, double>{"journal_radius", "m", &JointWear::journal_radius},
    Field<JointWear, double>{"clearance", "m", &JointWear::clearance, true},
    Field<JointWear, double>{"slot_length", "m", &JointWear::slot_length, true},
    Field<JointWear, double>{"width", "m", &JointWear::width},
    Field<JointWear, double>{"archard_volume", "m^3", &JointWear::archard_volume},
    Field<JointWear, double>{"removed_volume", "m^3", &JointWear::removed_volume},
    Field<JointWear, double>{"sliding_distance", "m", &JointWear::sliding_distance},
    Field<JointWear, double>{"contact_time", "s", &JointWear::contact_time},
    Field<JointWear, double>{"impulse", "N s", &JointWear::impulse},
};

inline constexpr std::array kWearSeries{
    Field<JointWear, std::vector<double>>{"bearing_depth", "m", &JointWear::bearing_depth},
    Field<JointWear, std::vector<double>>{"journal_depth", "m", &JointWear::journal_depth},
    Field<JointWear, std::vector<double>>{"bearing_depth_added", "m", &JointWear::bearing_depth_added},
    Field<JointWear, std::vector<double>>{"journal_depth_added", "m", &JointWear::journal_depth_added},
    Field<JointWear, std::vector<double>>{"total_depth_added", "m", &JointWear::total_depth_added},
};

}  // namespace gudgeon
