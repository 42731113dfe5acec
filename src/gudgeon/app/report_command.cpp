// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// gudgeon report.
#include "gudgeon/app/report_command.h"

#include <fmt/format.h>

#include <memory>

#include "gudgeon/app/case_groups.h"
#include "gudgeon/app/report_runs.h"
#include "gudgeon/app/text_output.h"
#include "gudgeon/io/safe_file.h"
#include "gudgeon/report/html/page.h"

namespace gudgeon {
namespace {

struct ReportOptions {
  std::filesystem::path runs;
  std::filesystem::path output;
  bool overwrite = false;
};

ExitCode run_report(const ReportOptions& options) {
  const std::filesystem::path output = options.output.empty() ? find_report_file(options.runs) : options.output;
  check_target(output, options.overwrite);
  return write_report(options.runs, output);
}

}  // namespace

std::filesystem::path find_report_file(const std::filesystem::path& directory) {
  std::error_code ignored;
  const bool is_directory = std::filesystem::is_directory(directory, ignored);
  return is_directory ? directory / "report.html" : std::filesystem::path(directory).replace_extension(".html");
}

ExitCode write_report(const std::filesystem::path& runs, const std::filesystem::path& output) {
  const ReadRuns read = read_runs(runs);
  ReportPage page(read.runs.size());
  for (const std::string& error : read.errors) {
    write_stderr(fmt::format("gudgeon: {}\n", error));
    page.add_warning("Not in this report: " + error);
  }
  for (const ReadRun& one : read.runs) page.add_case(read_report_case(one, page.has_room()));
  page.add_comparisons(group_cases(read.runs));
  write_whole(output, page.render());
  write_receipt(fmt::format("{}\n", output.string()));
  return read.errors.empty() ? ExitCode::done : ExitCode::file;
}

void add_report_command(CLI::App& program, Action& action) {
  const auto options = std::make_shared<ReportOptions>();
  CLI::App* command = program.add_subcommand("report", "Write one HTML file that shows a study, figures and all");
  command->add_option("DIR", options->runs, "Directory of run files, or one run file (HDF5)")->required();
  command->add_option("-o,--output", options->output, "HTML file to write; DIR/report.html unless given");
  command->add_flag("--overwrite", options->overwrite, "Replace an existing file");
  command->footer(
      "\nExample:\n  gudgeon report runs/press\n\nThe file needs nothing else: mail it, open it offline.\n");
  command->callback([options, &action] { action = [options] { return run_report(*options); }; });
}

}  // namespace gudgeon
