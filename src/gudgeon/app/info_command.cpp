// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// gudgeon info.
#include "gudgeon/app/info_command.h"

#include <fmt/format.h>

#include <filesystem>
#include <memory>

#include "gudgeon/app/text_output.h"
#include "gudgeon/base/diagnostics.h"
#include "gudgeon/io/run_reader.h"
#include "gudgeon/io/run_verifier.h"
#include "gudgeon/report/run_summary.h"

namespace gudgeon {

namespace {

struct InfoOptions {
  std::filesystem::path file;
  bool verify = false;
};

ExitCode show_content(const std::filesystem::path& file) {
  RunRecord run = read_run_outline(file);
  const auto none = [](const StageRecord&) { return std::vector<std::string>{}; };
  read_channels(file, run.stages, none);  // times only: samples are counted
  write_stdout(render_info(run, find_color_wanted()));
  return ExitCode::done;
}

ExitCode verify(const std::filesystem::path& file) {
  const RunVerification found = verify_run(file);
  const std::string read = fmt::format("{} stages, {} datasets read whole", found.n_stages, found.n_datasets);
  if (!found.errors.empty()) {
    throw FileError(fmt::format("{}: is damaged ({} datasets read whole):\n  {}", file.string(), found.n_datasets,
                                fmt::join(found.errors, "\n  ")));
  }
  write_stdout(found.has_checksums
                   ? fmt::format("{}: sound: {}, every checksum right\n", file.string(), read)
                   : fmt::format("{}: readable: {}; format {} has no checksums, so that changed numbers would not be "
                                 "noticed; run again to have them\n",
                                 file.string(), read, found.format_version));
  for (const std::string& remark : found.remarks) write_stdout(fmt::format("  {}\n", remark));
  return ExitCode::done;
}

}  // namespace

void add_info_command(CLI::App& program, Action& action) {
  const auto options = std::make_shared<InfoOptions>();
  CLI::App* command = program.add_subcommand("info", "Say what is in a run file");
  command->add_option("RUN", options->file, "Run file (HDF5)")->required();
  command->add_flag("--verify", options->verify, "Read all of it and compare every checksum; name what is damaged");
  command->footer("\nExamples:\n  gudgeon info runs/press/base.h5\n  gudgeon info runs/press/base.h5 --verify\n");
  command->callback([options, &action] {
    action = [options] { return options->verify ? verify(options->file) : show_content(options->file); };
  });
}

}  // namespace gudgeon
