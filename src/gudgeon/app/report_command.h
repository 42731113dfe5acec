// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// gudgeon report: one HTML file about the run files of a directory.
#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>

#include "gudgeon/app/exit_code.h"

namespace gudgeon {

void add_report_command(CLI::App& program, Action& action);

/// Where the report of a directory goes unless told otherwise.
std::filesystem::path find_report_file(const std::filesystem::path& directory);

/// Writes the report and prints its path. Files that cannot be read are named on standard error and in the report; then
/// the code is ExitCode::file.
ExitCode write_report(const std::filesystem::path& runs, const std::filesystem::path& output);

}  // namespace gudgeon
