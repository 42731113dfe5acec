// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Run files as the report and the plots need them.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "gudgeon/io/model_reader.h"
#include "gudgeon/report/html/report_case.h"

namespace gudgeon {

/// A run file's outline and its model, which is read from the text in it.
struct ReadRun {
  std::filesystem::path file;
  RunRecord outline;
  std::optional<ModelFile> model;  ///< nothing when this program cannot use it
};

struct ReadRuns {
  std::vector<ReadRun> runs;        ///< the base case first, then in the order of the model's cases
  std::vector<std::string> errors;  ///< one line a file that could not be read
};

/// The run files of a directory, or the one that is named. FileError when there is none that can be read.
ReadRuns read_runs(const std::filesystem::path& path);

/// All that a case's page needs, with the samples its figures show unless they are not wanted.
ReportCase read_report_case(const ReadRun& one, bool with_samples);

/// The formulas and curves of a run's model; none when the model cannot be used.
std::vector<FunctionSamples> read_functions(const ReadRun& one);

/// The run with the samples that its figures show.
RunRecord read_figure_channels(const ReadRun& one);

}  // namespace gudgeon
