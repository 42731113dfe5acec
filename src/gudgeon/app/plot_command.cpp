// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// gudgeon plot.
#include "gudgeon/app/plot_command.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>

#include "gudgeon/app/case_groups.h"
#include "gudgeon/app/command_line.h"
#include "gudgeon/app/picture_converter.h"
#include "gudgeon/app/picture_files.h"
#include "gudgeon/app/report_runs.h"
#include "gudgeon/app/text_output.h"
#include "gudgeon/base/diagnostics.h"
#include "gudgeon/io/safe_file.h"
#include "gudgeon/report/figures/case_figures.h"
#include "gudgeon/report/figures/function_figures.h"
#include "gudgeon/report/plot/plot_figure.h"

namespace gudgeon {
namespace {

struct PlotOptions {
  std::filesystem::path runs;
  std::filesystem::path directory;
  std::vector<std::string> names;
  std::vector<std::string> formats{"svg"};
  double cycles = 2.0;
  bool list = false;
  bool overwrite = false;
};

struct NamedFigure {
  std::string name;  ///< "base.A.wear_depth"
  Figure figure;
};

std::vector<NamedFigure> make_all_figures(const ReadRuns& read) {
  std::vector<NamedFigure> figures;
  for (const ReadRun& one : read.runs) {
    const RunRecord run = read_figure_channels(one);
    Signals signals(run);
    const auto add = [&](std::vector<Figure> made) {
      for (Figure& figure : made) {
        std::string name = one.outline.case_name + "." + figure.id;
        figures.push_back({std::move(name), std::move(figure)});
      }
    };
    add(make_case_figures(signals));
    add(make_function_figures(read_functions(one)));
  }
  for (Figure& figure : make_comparison_figures(group_cases(read.runs))) {
    const std::string name = figure.id;
    figures.push_back({name, std::move(figure)});
  }
  return figures;
}

/// Keeps those that are asked for, by their whole name or by its last part.
std::vector<NamedFigure> select_figures(std::vector<NamedFigure> figures, const std::vector<std::string>& wanted) {
  if (wanted.empty()) return figures;
  std::vector<std::string> known;
  for (const NamedFigure& one : figures) known.push_back(one.name);
  const auto is_meant = [](const std::string& name, const std::string& word) {
    return name == word || name.ends_with("." + word);
  };
  for (const std::string& word : wanted) {
    if (std::ranges::any_of(known, [&](const std::string& name) { return is_meant(name, word); })) continue;
    throw UsageError(
        fmt::format("--figure: unknown figure '{}'. {} --list names them all", word, suggest(word, known)));
  }
  std::erase_if(figures, [&](const NamedFigure& one) {
    return std::ranges::none_of(wanted, [&](const std::string& word) { return is_meant(one.name, word); });
  });
  return figures;
}

void write_figure(const PlotOptions& options, const NamedFigure& one) {
  const std::filesystem::path svg = make_picture_path(options.directory, one.name, "svg");
  write_whole(svg, plot_figure(one.figure, {.cycles = options.cycles}));
  write_receipt(fmt::format("{}\n", svg.string()));
  for (const std::string& format : options.formats) {
    if (format == "svg") continue;
    const std::filesystem::path output = make_picture_path(options.directory, one.name, format);
    convert_picture(svg, output, format);
    write_receipt(fmt::format("{}\n", output.string()));
  }
}

ExitCode run_plot(const PlotOptions& options) {
  if (!options.list && options.directory.empty()) throw UsageError("plot needs -o DIR, where the pictures go");
  const ReadRuns read = read_runs(options.runs);
  for (const std::string& error : read.errors) write_stderr(fmt::format("gudgeon: {}\n", error));
  const std::vector<NamedFigure> figures = select_figures(make_all_figures(read), options.names);
  if (options.list) {
    for (const NamedFigure& one : figures) write_stdout(fmt::format("{}\n", one.name));
    return read.errors.empty() ? ExitCode::done : ExitCode::file;
  }
  make_picture_directory(options.directory);
  for (const NamedFigure& one : figures) {
    check_target(make_picture_path(options.directory, one.name, "svg"), options.overwrite);
    for (const std::string& format : options.formats) {
      check_target(make_picture_path(options.directory, one.name, format), options.overwrite);
    }
  }
  for (const NamedFigure& one : figures) write_figure(options, one);
  return read.errors.empty() ? ExitCode::done : ExitCode::file;
}

}  // namespace

void add_plot_command(CLI::App& program, Action& action) {
  const auto options = std::make_shared<PlotOptions>();
  CLI::App* command = program.add_subcommand("plot", "Write each figure of a study as SVG, PNG or PDF");
  command->add_option("DIR", options->runs, "Directory of run files, or one run file (HDF5)")->required();
  command->add_option("-o,--output", options->directory, "Output directory (created if missing)");
  command
      ->add_option("--figure", options->names, "Only this figure: CASE.NAME, or NAME in every case (may be repeated)")
      ->type_name("NAME")
      ->allow_extra_args(false);
  command->add_option("--format", options->formats, "svg, png or pdf (may be repeated); the SVG is always written")
      ->type_name("FORMAT")
      ->allow_extra_args(false)
      ->check(CLI::IsMember({"svg", "png", "pdf"}));
  command->add_option("--cycles", options->cycles, "Cycles shown of a recorded signal, the last ones; 0 for all")
      ->type_name("N")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
  command->add_flag("--list", options->list, "Only print the figures' names");
  command->add_flag("--overwrite", options->overwrite, "Replace existing files");
  command->footer(
      "\nExamples:\n  gudgeon plot runs/press -o figures\n  gudgeon plot runs/press --list\n"
      "  gudgeon plot runs/press -o figures --figure A.wear_depth --format pdf\n");
  command->callback([options, &action] { action = [options] { return run_plot(*options); }; });
}

}  // namespace gudgeon
