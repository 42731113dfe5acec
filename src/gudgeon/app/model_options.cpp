// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Which model is meant, and reading it.
#include "gudgeon/app/model_options.h"

#include <fmt/format.h>

#include "gudgeon/app/command_line.h"
#include "gudgeon/system/characteristic_length.h"
#include "gudgeon/system/mobility.h"

namespace gudgeon {
namespace {

Override make_override(const std::string& setting) {
  const std::size_t equals = setting.find('=');
  if (equals == std::string::npos || equals == 0 || equals + 1 == setting.size()) {
    throw UsageError(fmt::format(
        "--set takes a path and a value, such as --set joints.A.radial_clearance=\"0.3 mm\"; it was given '{}'",
        setting));
  }
  return {setting.substr(0, equals), setting.substr(equals + 1)};
}

}  // namespace

void add_model_options(CLI::App& command, ModelOptions& options) {
  command.add_option("FILE", options.file, "Model file (TOML)")->required();
  command.add_option("--set", options.settings, "Change a value of the model: PATH=VALUE (may be repeated)")
      ->type_name("PATH=VALUE")
      ->allow_extra_args(false);
}

void add_case_option(CLI::App& command, std::string& case_name) {
  command.add_option("--case", case_name, "One of the model's cases; without it, the model as it stands")
      ->type_name("NAME");
}

std::vector<Override> make_overrides(const ModelOptions& options) {
  std::vector<Override> overrides;
  for (const std::string& setting : options.settings) overrides.push_back(make_override(setting));
  return overrides;
}

ModelFile read_case(const ModelOptions& options, std::string_view case_name) {
  return read_model(options.file, case_name == kBaseCase ? std::string_view{} : case_name, make_overrides(options));
}

void require_sound(const ModelFile& model) {
  if (model.diagnostics.has_errors()) throw RejectedModel(render(model.diagnostics, model.source));
}

void require_sound_mechanism(const ModelFile& model) {
  Diagnostics diagnostics;
  for (const Diagnostic& one : model.diagnostics.items()) {
    if (!one.code.starts_with("E-STUDY")) diagnostics.add(one);
  }
  if (diagnostics.has_errors()) throw RejectedModel(render(diagnostics, model.source));
}

std::string render_model_title(const ModelFile& model) {
  return fmt::format("{}{}{}\n", model.mechanism.name, model.case_name.empty() ? "" : ", case ", model.case_name);
}

std::string name_closed_joints(const Mechanism& mechanism) {
  std::vector<std::string> names;
  for (const Joint& joint : mechanism.joints) {
    if (has_clearance(joint.kind)) names.push_back(joint.name);
  }
  if (names.empty()) return {};
  const bool one = names.size() == 1;
  return fmt::format("The clearance joint{} {} {} taken as ideal.\n", one ? "" : "s", join_names(names),
                     one ? "is" : "are");
}

std::string tell_redundancy(const Mechanism& mechanism) {
  const int n_redundant = find_mobility(make_ideal(mechanism)).n_redundant_rows;
  if (n_redundant == 0) return {};
  return fmt::format(
      "{} redundant constraint{}: of the many ways to share the load, joint forces are the least (moments as forces at "
      "{:.6g} mm).\n",
      n_redundant, n_redundant == 1 ? "" : "s", 1e3 * find_characteristic_length(mechanism));
}

void reject(const ModelError& error, const ModelFile& model) {
  throw RejectedModel(render(error.diagnostics(), model.source));
}

}  // namespace gudgeon
