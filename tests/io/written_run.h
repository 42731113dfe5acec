// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// A run as a file, written stage by stage.
#pragma once

#include <filesystem>

#include "gudgeon/io/run_writer.h"

namespace gudgeon::test {

inline void write_run(const std::filesystem::path& file, const RunRecord& run) {
  RunWriter writer(file, run, true);
  for (const StageRecord& stage : run.stages) writer.append(stage);
}

}  // namespace gudgeon::test
