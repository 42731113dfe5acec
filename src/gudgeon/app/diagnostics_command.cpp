// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// gudgeon diagnostics.
#include "gudgeon/app/diagnostics_command.h"

#include <fmt/format.h>

#include <memory>
#include <string>
#include <vector>

#include "gudgeon/app/diagnostics_page.h"
#include "gudgeon/app/text_output.h"
#include "gudgeon/base/diagnostic_list.h"
#include "gudgeon/base/diagnostics.h"

namespace gudgeon {

namespace {

std::string suggest_code(const std::string& code) {
  std::vector<std::string> codes;
  for (const DiagnosticEntry& entry : list_diagnostics()) codes.emplace_back(entry.code);
  return suggest(code, codes);
}

}  // namespace

void add_diagnostics_command(CLI::App& program, Action& action) {
  struct Options {
    std::string code;
    bool markdown = false;
  };
  const auto options = std::make_shared<Options>();
  CLI::App* command = program.add_subcommand("diagnostics", "Print what the codes of messages mean");
  CLI::Option* code = command->add_option("CODE", options->code, "A code, or the beginning of several (E-NUM)");
  command->add_flag("--markdown", options->markdown, "All of them as the page of the manual")->excludes(code);
  command->footer("\nExamples:\n  gudgeon diagnostics E-MODEL-013\n  gudgeon diagnostics E-NUM\n");
  command->callback([options, &action] {
    action = [options] {
      const std::string text = options->markdown ? render_diagnostics_page() : render_diagnostics(options->code);
      return print_listing(text, fmt::format("no diagnostic has the code '{}'.", options->code),
                           suggest_code(options->code));
    };
  });
}

}  // namespace gudgeon
