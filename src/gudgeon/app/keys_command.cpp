// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// gudgeon keys.
#include "gudgeon/app/keys_command.h"

#include <fmt/format.h>

#include <memory>
#include <string>

#include "gudgeon/app/key_tables.h"
#include "gudgeon/app/model_schema.h"
#include "gudgeon/app/text_output.h"
#include "gudgeon/base/diagnostics.h"

namespace gudgeon {

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
      if (text.empty()) {
        write_stderr(fmt::format("gudgeon: no section, type or key has the name '{}'. {}\n", options->name,
                                 suggest(options->name, list_key_names())));
        return ExitCode::usage;
      }
      write_stdout(text);
      return ExitCode::done;
    };
  });
}

}  // namespace gudgeon
