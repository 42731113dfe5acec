// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Runs cases side by side, each from its model to its own run file.
#pragma once

#include <filesystem>
#include <functional>
#include <stop_token>
#include <string>
#include <vector>

#include "gudgeon/app/exit_code.h"
#include "gudgeon/app/progress_display.h"
#include "gudgeon/io/model_reader.h"

namespace gudgeon {

struct CaseRun {
  std::string name;
  std::filesystem::path file;
  std::vector<ReferenceValue> reference;  ///< known once it has run
  ExitCode code = ExitCode::done;
  bool wants_summary = true;
  bool is_written = false;  ///< the file holds this run
  std::string summary;      ///< of all its stages; empty when it was not wanted, or something went wrong before
  std::string message;      ///< why it is not done, or what is wrong with it; empty when it is all right
};

/// What happens to run files that are there already.
enum class Existing {
  refuse,   ///< nothing is computed
  replace,  ///< the case is run anew
  resume,   ///< the case goes on from its checkpoint, or after the last stage that its file holds as finished
};

/// Makes the model of a case, "base" or one of the file's; called from several threads. Its errors end that case alone.
using ReadCase = std::function<ModelFile(const std::string& name)>;

/// Runs all cases on that many threads. A case that fails leaves the others alone. Results do not depend on the
/// number of threads. Every checkpoint_interval [s] each case saves the stage under way. A first SIGINT or SIGTERM
/// stops every case at its next step; returns that signal, or 0.
int run_cases(std::vector<CaseRun>& cases, const ReadCase& read_case, int n_threads, Existing existing,
              double checkpoint_interval, ProgressDisplay& display);

}  // namespace gudgeon
