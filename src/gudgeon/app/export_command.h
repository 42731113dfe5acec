// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// gudgeon export: a run file's channels as CSV.
#pragma once

#include <CLI/CLI.hpp>

#include "gudgeon/app/exit_code.h"

namespace gudgeon {

void add_export_command(CLI::App& program, Action& action);

}  // namespace gudgeon
