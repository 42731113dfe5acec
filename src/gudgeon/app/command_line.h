// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Reads the command line, and explains what is wrong with one.
#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <stdexcept>

#include "gudgeon/app/exit_code.h"

namespace gudgeon {

/// An argument that was understood as text but not as what it should mean.
class UsageError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Names the program, its version, its help, and every command; a parsed command puts its work into `action`.
void add_commands(CLI::App& program, Action& action);

/// Parses; nothing when the action is ready, an exit code when help or version was printed or the line was wrong.
std::optional<ExitCode> read_command_line(CLI::App& program, int argc, const char* const* argv);

}  // namespace gudgeon
