// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// A run as CSV files, for spreadsheets and scripts.
#pragma once

#include <cstddef>
#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "gudgeon/results/run_record.h"

namespace gudgeon {

/// A unit that takes the place of an SI unit.
struct CsvUnit {
  std::string si;      ///< "m"
  std::string text;    ///< "mm"
  double in_si = 1.0;  ///< one of it
};

struct CsvOptions {
  std::size_t every = 1;       ///< one sample of so many; the first is always there
  std::vector<CsvUnit> units;  ///< all others are SI and radians
  bool decimal_comma = false;  ///< "0,5", and semicolons between cells
};

/// The SI units of the columns that export_csv() writes.
std::set<std::string> list_csv_units(const RunRecord& run);

/// Writes into the directory, which is made when missing, for every stage
///   STAGE_channels.csv    time and every channel whose values were read, a row a sample
///   STAGE_statistics.csv  a row a channel
///   STAGE_wear.csv        a row a cell of each joint, with the angle of the cell's middle
///   STAGE_events.csv      a row a stay in contact
///   STAGE_energy.csv      a row a term of the energy balance
/// in SI and radians unless other units are asked for; numbers as short as they still read back to the same double, an
/// empty cell where there is no number; columns of text are the last. Wear and events are left out of a stage without
/// clearance joints. Returns what was written. FileError when a file cannot be written, or one of them exists and may
/// not be replaced (then none is written).
std::vector<std::filesystem::path> export_csv(const RunRecord& run, const std::filesystem::path& directory,
                                              bool overwrite, const CsvOptions& options = {});

/// Writes STAGE_channels.csv and STAGE_statistics.csv of one stage in the same way.
std::vector<std::filesystem::path> export_motion(const StageRecord& stage, const std::filesystem::path& directory,
                                                 bool overwrite);

}  // namespace gudgeon
