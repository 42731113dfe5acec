// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// The arguments that say which model is meant, and reading it.
#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "gudgeon/io/model_reader.h"

namespace gudgeon {

/// The name of the model as its file has it, without any case.
inline constexpr std::string_view kBaseCase = "base";

struct ModelOptions {
  std::filesystem::path file;
  std::vector<std::string> settings;  ///< "path=value"
};

/// A model that cannot be used; what() is the finished message, all diagnostics with their source lines.
class RejectedModel : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// FILE and --set.
void add_model_options(CLI::App& command, ModelOptions& options);
/// --case for the commands that take one.
void add_case_option(CLI::App& command, std::string& case_name);

/// What --set asks for; UsageError when one has no value.
std::vector<Override> make_overrides(const ModelOptions& options);
/// Reads the model in one case ("" and "base": none), whatever is wrong with it.
ModelFile read_case(const ModelOptions& options, std::string_view case_name);
/// Throws RejectedModel when the model has errors.
void require_sound(const ModelFile& model);
/// The same where the study does not matter: its errors are left out.
void require_sound_mechanism(const ModelFile& model);
/// "press, case wide", a line.
std::string render_model_title(const ModelFile& model);
/// "The clearance joints A, B are taken as ideal.", a line; nothing without such joints.
std::string name_closed_joints(const Mechanism& mechanism);
/// That joint forces are the least of many ways to share the load, a line; nothing where no constraint is redundant.
std::string tell_redundancy(const Mechanism& mechanism);
/// A ModelError met later, told in terms of the model's file.
[[noreturn]] void reject(const ModelError& error, const ModelFile& model);

/// Calls work() so that a ModelError in it becomes a RejectedModel.
template <class Work>
auto with_source(const ModelFile& model, const Work& work) {
  try {
    return work();
  } catch (const ModelError& error) {
    reject(error, model);
  }
}

}  // namespace gudgeon
