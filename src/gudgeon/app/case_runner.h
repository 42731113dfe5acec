// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Runs cases side by side, each from its model to its own run file.
#pragma once

#include <filesystem>
#include <stop_token>
#include <string>
#include <vector>

#include "gudgeon/app/exit_code.h"
#include "gudgeon/app/progress_display.h"
#include "gudgeon/io/model_reader.h"

namespace gudgeon {

struct CaseRun {
  std::string name;
  ModelFile model;
  std::filesystem::path file;
  ExitCode code = ExitCode::done;
  bool is_written = false;  ///< the file holds this run
  std::string message;      ///< why it is not done, or what is wrong with it; empty when it is all right
};

/// What happens to run files that are there already.
enum class Existing {
  refuse,   ///< nothing is computed
  replace,  ///< the case is run anew
  resume,   ///< the case goes on after the last stage that its file holds as finished
};

/// Runs all cases on that many threads. A case that fails leaves the others alone. Results do not depend on the
/// number of threads. A first SIGINT or SIGTERM stops every case at its next step; returns that signal, or 0.
int run_cases(std::vector<CaseRun>& cases, int n_threads, Existing existing, ProgressDisplay& display);

}  // namespace gudgeon
