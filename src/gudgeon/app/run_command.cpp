// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// gudgeon run.
#include "gudgeon/app/run_command.h"

#include <fmt/format.h>

#include <algorithm>
#include <csignal>
#include <map>
#include <memory>
#include <set>
#include <thread>

#include "gudgeon/app/case_check.h"
#include "gudgeon/app/case_results.h"
#include "gudgeon/app/case_runner.h"
#include "gudgeon/app/command_line.h"
#include "gudgeon/app/file_names.h"
#include "gudgeon/app/model_options.h"
#include "gudgeon/app/report_command.h"
#include "gudgeon/app/text_output.h"
#include "gudgeon/base/diagnostics.h"
#include "gudgeon/io/run_lock.h"
#include "gudgeon/io/safe_file.h"

namespace gudgeon {
namespace {

struct RunOptions {
  ModelOptions model;
  std::filesystem::path directory;
  std::vector<std::string> case_names;
  bool all_cases = false;
  int n_threads = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  bool overwrite = false;
  bool resume = false;
  double checkpoint_interval = 60.0;  // [s]
  bool quiet = false;
  bool report = false;
};

/// runs/<name of the model> unless a directory is asked for; the name may not have been checked yet.
std::filesystem::path find_directory(const RunOptions& options, std::string name) {
  if (!options.directory.empty()) return options.directory;
  name = make_file_name(std::move(name));
  return std::filesystem::path("runs") / (name.starts_with('.') ? "_" + name : name);
}

std::vector<std::string> find_case_names(const RunOptions& options, const ModelDocument& document) {
  std::vector<std::string> names = options.case_names;
  if (options.all_cases) {
    names.emplace_back(kBaseCase);
    for (const Case& one : document.cases()) {
      if (one.name == kBaseCase)
        throw UsageError("a case is named 'base', as the model without any case is; rename it");
      names.push_back(one.name);
    }
  }
  if (names.empty()) names.emplace_back(kBaseCase);
  // A case asked for twice is run once.
  std::set<std::string> known;
  std::erase_if(names, [&known](const std::string& name) { return !known.insert(name).second; });
  return names;
}

std::string_view find_document_case(std::string_view name) { return name == kBaseCase ? std::string_view{} : name; }

/// Gives each case its file: runs/<name of the model>/<name of the case>.h5 unless a directory is asked for.
std::vector<CaseRun> place_outputs(const RunOptions& options, const ModelDocument& document,
                                   const std::vector<Override>& overrides) {
  std::vector<CaseRun> cases;
  std::map<std::filesystem::path, std::string> names;
  for (std::string& name : find_case_names(options, document)) {
    CaseRun& one = cases.emplace_back();
    one.name = std::move(name);
    const std::string model_name = document.find_name(find_document_case(one.name), overrides);
    one.file = find_directory(options, model_name) / (make_file_name(one.name) + ".h5");
    one.wants_summary = !options.quiet;
    const auto [known, is_new] = names.emplace(one.file, one.name);
    if (is_new) continue;
    throw UsageError(fmt::format("cases '{}' and '{}' would both be written to {}; run them into different directories",
                                 known->second, one.name, one.file.string()));
  }
  return cases;
}

using RunLocks = std::vector<std::unique_ptr<RunLock>>;

/// No other run writes the files of these cases while the locks live.
RunLocks lock_outputs(const std::vector<CaseRun>& cases) {
  std::map<std::filesystem::path, std::vector<std::filesystem::path>> directories;
  for (const CaseRun& one : cases) directories[one.file.parent_path()].push_back(one.file);
  RunLocks locks;
  for (const auto& [directory, files] : directories) locks.push_back(std::make_unique<RunLock>(directory, files));
  return locks;
}

/// Throws FileError when any output cannot be written, before anything is computed.
RunLocks prepare_outputs(const std::vector<CaseRun>& cases, Existing existing) {
  std::error_code failure;
  std::filesystem::path made;
  for (const CaseRun& one : cases) {
    const std::filesystem::path directory = one.file.parent_path();
    if (directory == made) continue;
    made = directory;
    std::filesystem::create_directories(directory, failure);
    if (failure)
      throw FileError(fmt::format("directory '{}' cannot be made: {}", directory.string(), failure.message()));
  }
  RunLocks locks = lock_outputs(cases);  // which also proves that files can be made there
  std::vector<std::string> errors;
  for (const CaseRun& one : cases) {
    try {
      check_target(one.file, existing != Existing::refuse);
    } catch (const FileError& error) {
      errors.emplace_back(error.what());
    }
  }
  if (!errors.empty()) {
    throw FileError(fmt::format(
        "{}{}", fmt::join(errors, "\n  "),
        existing == Existing::refuse ? "\n  --overwrite replaces run files, --resume goes on with them" : ""));
  }
  return locks;
}

/// The signal first; then what the user can mend soonest: file, model, numbers; and what finished all the same.
ExitCode find_exit_code(const std::vector<CaseRun>& cases, int signal) {
  const auto any = [&](ExitCode code) { return std::ranges::find(cases, code, &CaseRun::code) != cases.end(); };
  if (any(ExitCode::interrupted)) return signal == SIGTERM ? ExitCode::terminated : ExitCode::interrupted;
  for (const ExitCode code : {ExitCode::file, ExitCode::model, ExitCode::numerical, ExitCode::unbalanced}) {
    if (any(code)) return code;
  }
  return ExitCode::done;
}

/// The report of the directory, when any case left something in it. The run's own failure goes before the report's, but
/// a run that finished all the same does not.
ExitCode add_report(const std::vector<CaseRun>& cases, ExitCode code) {
  if (std::ranges::none_of(cases, &CaseRun::is_written)) return code;
  const std::filesystem::path directory = cases.front().file.parent_path();
  const ExitCode report = write_report(directory, find_report_file(directory));
  const bool finished = code == ExitCode::done || (code == ExitCode::unbalanced && report != ExitCode::done);
  return finished ? report : code;
}

ExitCode run_run(const RunOptions& options) {
  const Existing existing =
      options.resume ? Existing::resume : (options.overwrite ? Existing::replace : Existing::refuse);
  const ModelDocument document = read_model_document(options.model.file);
  const std::vector<Override> overrides = make_overrides(options.model);
  std::vector<CaseRun> cases = place_outputs(options, document, overrides);
  std::vector<std::string> names;
  for (const CaseRun& one : cases) names.push_back(one.name);
  ProgressDisplay display(options.quiet ? ProgressStyle::silent : find_progress_style(), names);
  CaseCheck check([&](const std::string& name) { return document.read(find_document_case(name), overrides); }, names);
  const std::string warnings = check.require_first();
  const RunLocks locks = prepare_outputs(cases, existing);
  if (options.report) check_target(find_report_file(cases.front().file.parent_path()), existing != Existing::refuse);
  if (!options.quiet) write_stderr(warnings);
  // A closed pipe must not end a long computation; what it loses is only text.
  std::signal(SIGPIPE, SIG_IGN);
  check.begin_rest([&display](const std::string& text) { display.add_message(text); });
  const int signal = run_cases(
      cases, [&](const std::string& name) { return check.take(name); }, options.n_threads, existing,
      options.checkpoint_interval, display);
  check.end_rest();
  print_results(cases, options.quiet);
  const ExitCode code = find_exit_code(cases, signal);
  return options.report ? add_report(cases, code) : code;
}

}  // namespace

void add_run_command(CLI::App& program, Action& action) {
  const auto options = std::make_shared<RunOptions>();
  CLI::App* command = program.add_subcommand("run", "Simulate, wear, and summarise; one HDF5 file a case");
  add_model_options(*command, options->model);
  command->add_option("-o,--output", options->directory, "Directory to write to [runs/<name of the model>]")
      ->type_name("DIR");
  CLI::Option* one = command->add_option("--case", options->case_names, "Run this case of the model (may be repeated)");
  one->type_name("NAME")->allow_extra_args(false);
  command->add_flag("--all-cases", options->all_cases, "Run the model as it stands and every case of it")
      ->excludes(one);
  command->add_option("--threads", options->n_threads, "Cases that run side by side; results do not depend on it")
      ->type_name("N")
      ->check(CLI::Range(1, 1024))
      ->capture_default_str();
  CLI::Option* overwrite = command->add_flag("--overwrite", options->overwrite, "Replace existing run files");
  command->add_flag("--resume", options->resume, "Go on from the last checkpoint, or after the last finished stage")
      ->excludes(overwrite);
  command
      ->add_option("--checkpoint-interval", options->checkpoint_interval,
                   "Seconds between two checkpoints of a stage, from which --resume goes on")
      ->type_name("S")
      ->check(CLI::Range(0.1, 1e9))
      ->capture_default_str();
  command->add_flag("--report", options->report, "Also write the report of the directory, report.html");
  command->add_flag("--quiet", options->quiet, "Print only the paths written and what went wrong");
  command->footer(
      "\nExamples:\n  gudgeon run press.toml -o runs/first\n  gudgeon run press.toml --all-cases --threads 4\n"
      "  gudgeon run press.toml --set study.cycles=10 --overwrite\n\n"
      "Ctrl-C stops at the next step and keeps what was finished; a second Ctrl-C ends at once.\n");
  command->callback([options, &action] { action = [options] { return run_run(*options); }; });
}

}  // namespace gudgeon
