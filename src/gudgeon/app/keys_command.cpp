// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// gudgeon keys.
#include "gudgeon/app/keys_command.h"

#include <fmt/format.h>

#include <memory>
#include <string>

#include "gudgeon/app/key_tables.h"
#include "gudgeon/app/law_tables.h"
#include "gudgeon/app/model_schema.h"
#include "gudgeon/app/text_output.h"
#include "gudgeon/base/diagnostics.h"
#include "gudgeon/io/old_keys.h"

namespace gudgeon {

namespace {

bool is_law_parameter(const std::string& name) {
  if (name == "law") return true;
  for (const LawEntry& law : list_laws()) {
    for (const auto& row : law.parameters) {
      if (row.front() == name) return true;
    }
  }
  return false;
}

/// Where a name that is no key leads to: laws have a list of their own, old names a present one.
std::string find_next_step(const std::string& name) {
  for (const OldKey& old : list_old_keys()) {
    if (name == old.old_key) return fmt::format("It is an old name of '{}'.", old.key);
  }
  if (!render_laws(name).empty() || is_law_parameter(name)) return "`gudgeon laws` has the laws and their keys.";
  return suggest(name, list_key_names());
}

}  // namespace

void add_keys_command(CLI::App& program, Action& action) {
  struct Options {
    std::string name;
    bool markdown = false;
    bool schema = false;
  };
  const auto options = std::make_shared<Options>();
  CLI::App* command =
      program.add_subcommand("keys", "Print every key of a model file with its unit, range, default and meaning");
  CLI::Option* name = command->add_option("NAME", options->name, "A section (joints), a type (prismatic) or a key");
  CLI::Option* markdown = command->add_flag("--markdown", options->markdown, "All of them as the page of the manual");
  CLI::Option* schema =
      command->add_flag("--schema", options->schema, "All of them as a JSON schema, for editors that read one");
  markdown->excludes(name)->excludes(schema);
  schema->excludes(name);
  command->footer(
      "\nExamples:\n  gudgeon keys joints\n  gudgeon keys relative_tolerance\n"
      "  gudgeon keys --schema > gudgeon.schema.json\n");
  command->callback([options, &action] {
    action = [options] {
      std::string text = options->markdown ? render_keys_page() : "";
      if (options->schema) text = render_model_schema();
      if (text.empty()) text = render_keys(options->name);
      if (text.empty()) text = render_keys(options->name.substr(options->name.rfind('.') + 1));
      return print_listing(text, fmt::format("no section, type or key has the name '{}'.", options->name),
                           find_next_step(options->name));
    };
  });
}

}  // namespace gudgeon
