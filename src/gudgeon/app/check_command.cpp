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
#include "gudgeon/app/text_output.h"
#include "gudgeon/io/explain.h"
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
  bool explain = false;
};

// Adds remarks on the start to those of the model.
std::string render_model(ModelFile& model) {
  const Assembly assembly = assemble(model.mechanism);
  require_start(model.mechanism, assembly);
  model.diagnostics.append(remark_start(model.mechanism, assembly));
  model.diagnostics.append(remark_ideal_start(model.mechanism, model.study));
  model.diagnostics.append(remark_pinned_bodies(model.mechanism));
  const bool color = find_color_wanted();
  return render_counts(model.mechanism, find_mobility(model.mechanism, assembly), color) +
         render_start(model.mechanism, assembly, color) + render_loops(assembly, color) +
         render_joints(model.mechanism, color) + render_loads(model.mechanism, color) +
         render_drivers(model.mechanism, color) + render_cycle(model.study);
}

ExitCode run_check(const CheckOptions& options) {
  ModelFile model = read_case(options.model, options.case_name);
  require_sound(model);
  const std::string tables = with_source(model, [&] { return render_model(model); });
  write_stdout(render(model.diagnostics, model.source));
  write_stdout(render_model_title(model) + "\n");
  write_stdout(tables);
  if (options.explain) write_stdout("\n" + explain(model.mechanism, model.study));
  return ExitCode::done;
}

}  // namespace

void add_check_command(CLI::App& program, Action& action) {
  const auto options = std::make_shared<CheckOptions>();
  CLI::App* command =
      program.add_subcommand("check", "Find all that is wrong in a model; count bodies, rows, degrees of freedom");
  add_model_options(*command, options->model);
  add_case_option(*command, options->case_name);
  command->add_flag("--explain", options->explain, "Also print the model in SI with every default");
  command->footer("\nExample:\n  gudgeon check press.toml --case wide --explain\n");
  command->callback([options, &action] { action = [options] { return run_check(*options); }; });
}

}  // namespace gudgeon
