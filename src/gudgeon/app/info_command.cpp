// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// gudgeon info.
#include "gudgeon/app/info_command.h"

#include <filesystem>
#include <memory>

#include "gudgeon/app/text_output.h"
#include "gudgeon/io/run_reader.h"
#include "gudgeon/report/run_summary.h"

namespace gudgeon {

void add_info_command(CLI::App& program, Action& action) {
  const auto file = std::make_shared<std::filesystem::path>();
  CLI::App* command = program.add_subcommand("info", "Say what is in a run file");
  command->add_option("RUN", *file, "Run file (HDF5)")->required();
  command->footer("\nExample:\n  gudgeon info runs/press/base.h5\n");
  command->callback([file, &action] {
    action = [file] {
      RunRecord run = read_run_outline(*file);
      for (StageRecord& stage : run.stages) read_channels(*file, stage, {});  // times only: samples are counted
      write_stdout(render_info(run, find_color_wanted()));
      return ExitCode::done;
    };
  });
}

}  // namespace gudgeon
