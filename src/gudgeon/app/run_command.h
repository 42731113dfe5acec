// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// gudgeon run: the study of one or more cases, from the model file to run files.
#pragma once

#include <CLI/CLI.hpp>

#include "gudgeon/app/exit_code.h"

namespace gudgeon {

void add_run_command(CLI::App& program, Action& action);

}  // namespace gudgeon
