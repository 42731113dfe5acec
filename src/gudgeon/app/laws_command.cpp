// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// gudgeon laws.
#include "gudgeon/app/laws_command.h"

#include <fmt/format.h>

#include <memory>
#include <string>
#include <vector>

#include "gudgeon/app/law_tables.h"
#include "gudgeon/app/text_output.h"
#include "gudgeon/base/diagnostics.h"

namespace gudgeon {

namespace {

std::string suggest_law(const std::string& name) {
  std::vector<std::string> names;
  for (const LawEntry& law : list_laws()) {
    names.push_back(law.name);
    names.push_back(law.family);
  }
  return suggest(name, names);
}

}  // namespace

void add_laws_command(CLI::App& program, Action& action) {
  struct Options {
    std::string name;
    bool markdown = false;
  };
  const auto options = std::make_shared<Options>();
  CLI::App* command = program.add_subcommand("laws", "Print every law with formula, parameters, ranges and defaults");
  command->add_option("NAME", options->name, "A family (normal_force, damping, friction, wear) or a law");
  command->add_flag("--markdown", options->markdown, "All of them as the page of the manual");
  command->footer("\nExamples:\n  gudgeon laws\n  gudgeon laws friction\n  gudgeon laws lankarani_nikravesh\n");
  command->callback([options, &action] {
    action = [options] {
      const std::string text = options->markdown ? render_laws_page() : render_laws(options->name);
      return print_listing(text, fmt::format("unknown law or family '{}'.", options->name), suggest_law(options->name));
    };
  });
}

}  // namespace gudgeon
