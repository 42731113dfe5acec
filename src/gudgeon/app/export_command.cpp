// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// gudgeon export.
#include "gudgeon/app/export_command.h"

#include <fmt/format.h>

#include <filesystem>
#include <memory>

#include "gudgeon/app/text_output.h"
#include "gudgeon/io/csv_export.h"
#include "gudgeon/io/run_reader.h"

namespace gudgeon {
namespace {

struct ExportOptions {
  std::filesystem::path file;
  std::filesystem::path directory;
  bool overwrite = false;
};

ExitCode run_export(const ExportOptions& options) {
  for (const std::filesystem::path& path : export_csv(read_run(options.file), options.directory, options.overwrite)) {
    write_receipt(fmt::format("{}\n", path.string()));
  }
  return ExitCode::done;
}

}  // namespace

void add_export_command(CLI::App& program, Action& action) {
  const auto options = std::make_shared<ExportOptions>();
  CLI::App* command = program.add_subcommand("export", "Write a run file's channels and wear profiles as CSV");
  command->add_option("RUN", options->file, "Run file (HDF5)")->required();
  command->add_option("-o,--output", options->directory, "Directory to write to; it is made when missing")->required();
  command->add_flag("--overwrite", options->overwrite, "Replace existing files");
  command->footer("\nExample:\n  gudgeon export runs/press/base.h5 -o csv\n");
  command->callback([options, &action] { action = [options] { return run_export(*options); }; });
}

}  // namespace gudgeon
