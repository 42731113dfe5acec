// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// The program's face: help that teaches, suggestions for slips.
#include "gudgeon/app/command_line.h"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>
#include <string>
#include <vector>

#include "gudgeon/app/check_command.h"
#include "gudgeon/app/diagnostics_command.h"
#include "gudgeon/app/draw_command.h"
#include "gudgeon/app/equilibrium_command.h"
#include "gudgeon/app/export_command.h"
#include "gudgeon/app/info_command.h"
#include "gudgeon/app/keys_command.h"
#include "gudgeon/app/kinematics_command.h"
#include "gudgeon/app/laws_command.h"
#include "gudgeon/app/plot_command.h"
#include "gudgeon/app/report_command.h"
#include "gudgeon/app/run_command.h"
#include "gudgeon/app/text_output.h"
#include "gudgeon/base/diagnostics.h"

namespace gudgeon {
namespace {

constexpr const char* kExamples = R"(
A first session:
  gudgeon check press.toml                    what is in the model, is it sound?
  gudgeon draw press.toml -o press.svg        is it the mechanism I mean?
  gudgeon kinematics press.toml               how does it move with ideal joints?
  gudgeon equilibrium press.toml              where does it stay at rest?
  gudgeon run press.toml                      simulate, wear, summarise
  gudgeon report runs/press                   the study as one page to look at
  gudgeon plot runs/press -o figures          its figures for print
  gudgeon info runs/press/base.h5             look at a run again
  gudgeon export runs/press/base.h5 -o csv    its channels as CSV
  gudgeon keys joints                         what may stand in a model file?
  gudgeon laws friction                       what laws are there?

Any value of the model can be changed from the command line:
  gudgeon run press.toml --set joints.A.radial_clearance="0.8 mm"

Exit codes: 0 done, 2 usage, 3 model, 4 numerical, 5 file, 6 finished, but an energy balance does not close,
  130 Ctrl-C, 143 SIGTERM.
`gudgeon COMMAND --help` explains a command.
)";

std::vector<std::string> list_commands(const CLI::App& program) {
  std::vector<std::string> names;
  for (const CLI::App* command : program.get_subcommands({})) names.push_back(command->get_name());
  return names;
}

std::vector<std::string> list_options(const CLI::App& command) {
  std::vector<std::string> names;
  for (const CLI::Option* option : command.get_options()) {
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
    for (const std::string& name : option->get_snames()) names.push_back("-" + name);
  }
  return names;
}

/// "unknown option '--thread'. Did you mean '--threads'?" for the first such argument; empty when all are known.
std::string find_unknown(std::string_view kind, const std::string& word, const std::vector<std::string>& known) {
  if (std::ranges::find(known, word) != known.end()) return {};
  const std::string suggestion = suggest(word, known);
  return fmt::format("unknown {} '{}'{}{}", kind, word, suggestion.empty() ? "" : ". ", suggestion);
}

std::string find_unknown_option(const CLI::App& command, const std::vector<std::string>& arguments) {
  const std::vector<std::string> known = list_options(command);
  for (const std::string& argument : arguments) {
    if (!argument.starts_with("-") || argument == "-" || argument == "--") continue;
    // "--name=value" and "-xvalue" carry their value with them.
    const std::string name =
        argument.starts_with("--") ? argument.substr(0, argument.find('=')) : argument.substr(0, 2);
    if (const std::string message = find_unknown("option", name, known); !message.empty()) return message;
  }
  return {};
}

/// What is wrong, in our words where we have better ones than the parser.
std::string explain_error(const CLI::App& program, const CLI::ParseError& error,
                          const std::vector<std::string>& arguments) {
  if (arguments.empty()) return "a command is missing";
  const auto parsed = program.get_subcommands();
  const std::string message = !parsed.empty() ? find_unknown_option(*parsed.front(), arguments)
                              : arguments.front().starts_with("-")
                                  ? find_unknown_option(program, arguments)
                                  : find_unknown("command", arguments.front(), list_commands(program));
  return message.empty() ? error.what() : message;
}

void print_usage_error(const CLI::App& program, const CLI::ParseError& error,
                       const std::vector<std::string>& arguments) {
  const auto parsed = program.get_subcommands();
  const std::string command = parsed.empty() ? "gudgeon" : "gudgeon " + parsed.front()->get_name();
  write_stderr(fmt::format("gudgeon: {}\n", explain_error(program, error, arguments)));
  if (parsed.empty()) write_stderr(fmt::format("  commands are: {}\n", fmt::join(list_commands(program), ", ")));
  write_stderr(fmt::format("  `{} --help` tells more\n", command));
}

}  // namespace

void add_commands(CLI::App& program, Action& action) {
  program.description("gudgeon: planar mechanisms with clearance joints, how they move and how they wear.");
  program.footer(kExamples);
  program.set_version_flag("--version", "gudgeon " GUDGEON_VERSION, "Print the version");
  program.set_help_flag("-h,--help", "Print this help");
  program.require_subcommand(1);
  program.get_formatter()->column_width(34);
  add_check_command(program, action);
  add_draw_command(program, action);
  add_kinematics_command(program, action);
  add_equilibrium_command(program, action);
  add_run_command(program, action);
  add_info_command(program, action);
  add_export_command(program, action);
  add_report_command(program, action);
  add_plot_command(program, action);
  add_laws_command(program, action);
  add_keys_command(program, action);
  add_diagnostics_command(program, action);
}

std::optional<ExitCode> read_command_line(CLI::App& program, int argc, const char* const* argv) {
  const std::vector<std::string> arguments(argv + std::min(argc, 1), argv + argc);
  try {
    program.parse(argc, argv);
    return std::nullopt;
  } catch (const CLI::Success& success) {
    // Help and version leave the parser as exceptions.
    std::ostringstream out;
    program.exit(success, out, out);
    write_stdout(out.str());
    return ExitCode::done;
  } catch (const CLI::ParseError& error) {
    print_usage_error(program, error, arguments);
    return ExitCode::usage;
  }
}

}  // namespace gudgeon
