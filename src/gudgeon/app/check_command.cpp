// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// gudgeon check.
#include "gudgeon/app/check_command.h"

#include <fmt/format.h>

#include <memory>

#include "gudgeon/app/check_tables.h"
#include "gudgeon/app/model_options.h"
#include "gudgeon/app/model_tables.h"
#include "gudgeon/app/picture_files.h"
#include "gudgeon/app/text_output.h"
#include "gudgeon/io/resolved_model.h"
#include "gudgeon/io/safe_file.h"
#include "gudgeon/report/figures/function_figures.h"
#include "gudgeon/report/plot/plot_figure.h"
#include "gudgeon/sim/function_samples.h"
#include "gudgeon/system/assembly.h"
#include "gudgeon/system/mobility.h"
#include "gudgeon/system/pinned_remarks.h"
#include "gudgeon/system/start_check.h"
#include "gudgeon/system/start_remarks.h"

namespace gudgeon {
namespace {

struct CheckOptions {
  ModelOptions model;
  std::string case_name;
  bool resolved = false;
  std::filesystem::path plots;
  bool overwrite = false;
};

// Adds remarks on the start to those of the model.
std::string render_model(ModelFile& model) {
  const Assembly assembly = assemble(model.mechanism);
  require_start(model.mechanism, assembly);
  require_ideal_start(model.mechanism, model.study);
  model.diagnostics.append(remark_start(model.mechanism, assembly));
  model.diagnostics.append(remark_ideal_start(model.mechanism, model.study));
  model.diagnostics.append(remark_pinned_bodies(model.mechanism));
  const bool color = find_color_wanted();
  return render_counts(model.mechanism, find_mobility(model.mechanism, assembly), color) +
         render_start(model.mechanism, assembly, color) + render_loops(assembly, color) +
         render_joints(model.mechanism, color) + render_loads(model.mechanism, color) +
         render_drivers(model.mechanism, color) + render_cycle(model.study);
}

// One picture a formula or curve that loads and drivers are given.
void write_plots(const CheckOptions& options, const ModelFile& model) {
  const std::vector<Figure> figures =
      make_function_figures(sample_functions(model.mechanism, model.study, assemble(model.mechanism)));
  if (figures.empty()) {
    write_stdout("\nNo load or driver is given a formula or curve: there is nothing to plot.\n");
    return;
  }
  const auto find_path = [&](const Figure& figure) { return make_picture_path(options.plots, figure.id, "svg"); };
  make_picture_directory(options.plots);
  for (const Figure& figure : figures) check_target(find_path(figure), options.overwrite);
  write_stdout("\n");
  for (const Figure& figure : figures) {
    write_whole(find_path(figure), plot_figure(figure, {}));
    write_stdout(fmt::format("{}\n", find_path(figure).string()));
  }
}

ExitCode run_check(const CheckOptions& options) {
  ModelFile model = read_case(options.model, options.case_name);
  require_sound(model);
  const std::string tables = with_source(model, [&] { return render_model(model); });
  write_stdout(render(model.diagnostics, model.source));
  write_stdout(render_model_title(model) + "\n");
  write_stdout(tables);
  if (options.resolved) write_stdout("\n" + write_resolved_model(model.mechanism, model.study));
  if (!options.plots.empty()) write_plots(options, model);
  return ExitCode::done;
}

}  // namespace

void add_check_command(CLI::App& program, Action& action) {
  const auto options = std::make_shared<CheckOptions>();
  CLI::App* command =
      program.add_subcommand("check", "Find all that is wrong in a model; count bodies, rows, degrees of freedom");
  add_model_options(*command, options->model);
  add_case_option(*command, options->case_name);
  command->add_flag("--resolved,--explain", options->resolved,
                    "Also print the resolved model: in SI, with every default");
  command
      ->add_option("--plots", options->plots, "Draw every formula and curve of loads and drivers into this directory")
      ->type_name("DIR");
  command->add_flag("--overwrite", options->overwrite, "Replace existing pictures");
  command->footer(
      "\nExamples:\n  gudgeon check press.toml --case wide --resolved\n  gudgeon check press.toml --plots curves\n");
  command->callback([options, &action] { action = [options] { return run_check(*options); }; });
}

}  // namespace gudgeon
