// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// gudgeon export.
#include "gudgeon/app/export_command.h"

#include <fmt/format.h>

#include <fnmatch.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <set>
#include <string>
#include <variant>
#include <vector>

#include "gudgeon/app/command_line.h"
#include "gudgeon/app/text_output.h"
#include "gudgeon/base/quantity.h"
#include "gudgeon/io/csv_export.h"
#include "gudgeon/io/run_reader.h"

namespace gudgeon {
namespace {

struct ExportOptions {
  std::filesystem::path file;
  std::filesystem::path directory;
  std::vector<std::string> channels;
  std::vector<std::string> stages;
  std::vector<std::string> units;
  CsvOptions csv;
  bool overwrite = false;
};

CsvUnit read_unit(const std::string& text) {
  const std::variant<Quantity, QuantityError> one = parse_quantity("1 " + text);
  if (const auto* error = std::get_if<QuantityError>(&one)) {
    throw UsageError(fmt::format("--unit {}: {}", text, error->message));
  }
  const auto& quantity = std::get<Quantity>(one);
  // Energies and torques have one dimension and are told apart by what they are written in.
  const bool is_energy = quantity.dimension == dimension::kTorque && text.find('J') != std::string::npos;
  return {is_energy ? "J" : si_unit(quantity.dimension), text, quantity.value};
}

/// Leaves the stages that are asked for.
void select_stages(RunRecord& run, const std::vector<std::string>& wanted) {
  for (const std::string& name : wanted) {
    if (find_stage(run, name) != nullptr) continue;
    std::vector<std::string> names;
    for (const StageRecord& stage : run.stages) names.push_back(stage.name);
    throw UsageError(fmt::format("--stage {}: unknown stage; possible: {}", name, fmt::join(names, ", ")));
  }
  if (wanted.empty()) return;
  std::erase_if(run.stages, [&](const StageRecord& s) { return std::ranges::find(wanted, s.name) == wanted.end(); });
}

/// The stage's channels that any of the patterns, as a shell has them, fits.
std::vector<std::string> find_channels(const StageRecord& stage, const std::vector<std::string>& patterns) {
  std::vector<std::string> names;
  for (const Channel& channel : stage.channels) {
    const bool fits = std::ranges::any_of(
        patterns, [&](const std::string& pattern) { return ::fnmatch(pattern.c_str(), channel.name.c_str(), 0) == 0; });
    if (fits || patterns.empty()) names.push_back(channel.name);
  }
  return names;
}

/// Reads only what is asked for.
void read_samples(const ExportOptions& options, RunRecord& run) {
  for (const std::string& pattern : options.channels) {
    const bool fits = std::ranges::any_of(
        run.stages, [&](const StageRecord& stage) { return !find_channels(stage, {pattern}).empty(); });
    if (fits) continue;
    throw UsageError(fmt::format("--channel {}: no channel has such a name; 'gudgeon info {}' lists them", pattern,
                                 options.file.string()));
  }
  const auto choose = [&](const StageRecord& stage) { return find_channels(stage, options.channels); };
  read_channels(options.file, run.stages, choose);
  for (StageRecord& stage : run.stages) {
    const std::vector<std::string> names = choose(stage);
    const std::set<std::string> wanted(names.begin(), names.end());
    std::erase_if(stage.statistics, [&](const ChannelStatistics& s) { return !wanted.contains(s.channel); });
  }
}

/// UsageError for a unit that no column has, or that another one takes the place of.
void check_units(const RunRecord& run, const std::vector<CsvUnit>& units) {
  const std::set<std::string> written = list_csv_units(run);
  for (auto unit = units.begin(); unit != units.end(); ++unit) {
    if (!written.contains(unit->si)) {
      throw UsageError(fmt::format("--unit {}: no column is of its dimension; in SI there are {}", unit->text,
                                   fmt::join(written, ", ")));
    }
    const auto before = std::find_if(units.begin(), unit, [&](const CsvUnit& u) { return u.si == unit->si; });
    if (before == unit) continue;
    throw UsageError(
        fmt::format("--unit {}: --unit {} is of the same dimension; give one of them", unit->text, before->text));
  }
}

ExitCode run_export(ExportOptions& options) {
  for (const std::string& unit : options.units) options.csv.units.push_back(read_unit(unit));
  RunRecord run = read_run_outline(options.file);
  select_stages(run, options.stages);
  read_samples(options, run);
  check_units(run, options.csv.units);
  for (const auto& path : export_csv(run, options.directory, options.overwrite, options.csv)) {
    write_stdout(fmt::format("{}\n", path.string()));
  }
  return ExitCode::done;
}

}  // namespace

void add_export_command(CLI::App& program, Action& action) {
  const auto options = std::make_shared<ExportOptions>();
  CLI::App* command = program.add_subcommand("export", "Write a run file's channels and wear profiles as CSV");
  command->add_option("RUN", options->file, "Run file (HDF5)")->required();
  command->add_option("-o,--output", options->directory, "Output directory (created if missing)")->required();
  command
      ->add_option("--channel", options->channels,
                   "Only channels of that name or shell pattern, 'A.*' (may be repeated)")
      ->type_name("NAME")
      ->allow_extra_args(false);
  command->add_option("--stage", options->stages, "Only that stage (may be repeated)")
      ->type_name("NAME")
      ->allow_extra_args(false);
  command->add_option("--unit", options->units, "Values of its dimension in that unit, 'mm', 'deg' (may be repeated)")
      ->type_name("UNIT")
      ->allow_extra_args(false);
  command->add_option("--every", options->csv.every, "One sample of so many")
      ->type_name("N")
      ->check(CLI::Range(std::size_t{1}, std::size_t{1} << 40U));
  command->add_flag("--decimal-comma", options->csv.decimal_comma, "0,5 instead of 0.5, and semicolons between cells");
  command->add_flag("--overwrite", options->overwrite, "Replace existing files");
  command->footer(
      "\nExamples:\n  gudgeon export runs/press/base.h5 -o csv\n"
      "  gudgeon export runs/press/base.h5 -o csv --channel 'A.*' --stage wear_1 --unit mm --unit deg --every 10\n");
  command->callback([options, &action] { action = [options] { return run_export(*options); }; });
}

}  // namespace gudgeon
